//! The faces of the part.

use super::super::scene::{Face, Scene};
use super::findings::Findings;
use super::plausible::{CONVECTION, FLUX, SHARE, TEMPERATURE};

/// Checks what the scene says of each face.
pub fn check(findings: &mut Findings, scene: &Scene) {
    for (name, face) in scene.part.faces.named() {
        check_face(findings, name, &face);
    }
    let held = matches!(scene.part.faces.top, Face::FixedTemperature { .. });
    let remedy = "accepted with a laser: Adiabatic, Flux(..), Losses(..)";
    let reason = "the laser meets this face, and a held temperature would swallow its heat";
    findings.require(!(held && scene.laser.is_some()), "part.faces.top", reason, remedy);
}

fn check_face(findings: &mut Findings, name: &str, face: &Face) {
    let field = format!("part.faces.{name}");
    match *face {
        Face::Adiabatic => {}
        Face::Symmetry => {
            let remedy = "accepted here: Adiabatic, FixedTemperature(..), Flux(..), Losses(..)";
            let sideways = name.starts_with(['x', 'y']);
            findings.require(sideways, &field, "only faces in x and y can be mirror planes", remedy);
        }
        Face::FixedTemperature { temperature_k } => {
            findings.within(&format!("{field}.temperature_k"), temperature_k, &TEMPERATURE);
        }
        Face::Flux { flux_w_m2 } => {
            findings.within(&format!("{field}.flux_w_m2"), flux_w_m2, &FLUX);
        }
        Face::Losses { convection_w_m2_k, emissivity, ambient_k } => {
            findings.within(&format!("{field}.convection_w_m2_k"), convection_w_m2_k, &CONVECTION);
            findings.within(&format!("{field}.emissivity"), emissivity, &SHARE);
            findings.within(&format!("{field}.ambient_k"), ambient_k, &TEMPERATURE);
        }
    }
}
