//! The faces of the part.

use super::super::card::CardSource;
use super::super::problem::Problem;
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
        Face::Losses { convection_w_m2_k, emissivity, ambient_k, evaporation: _ } => {
            findings.within(&format!("{field}.convection_w_m2_k"), convection_w_m2_k, &CONVECTION);
            findings.within(&format!("{field}.emissivity"), emissivity, &SHARE);
            findings.within(&format!("{field}.ambient_k"), ambient_k, &TEMPERATURE);
        }
    }
}

/// Whether a face of the scene lets the melt evaporate.
pub fn evaporates(scene: &Scene) -> bool {
    scene.part.faces.named().iter().any(|(_, face)| matches!(face, Face::Losses { evaporation: true, .. }))
}

/// Checks that a card has what evaporation needs.
pub fn check_card(card: &CardSource) -> Vec<Problem> {
    let mut findings = Findings::new(&card.source, &card.prefix);
    let values = &card.card;
    let given = [
        ("boiling_k", values.boiling_k.is_some()),
        ("heat_of_evaporation_j_kg", values.heat_of_evaporation_j_kg.is_some()),
        ("molar_mass_kg_mol", values.molar_mass_kg_mol.is_some()),
    ];
    for (name, given) in given {
        let reason =
            format!("a face with evaporation needs {name} of {}, which the card does not give", card.name);
        let remedy = "add boiling_k, heat_of_evaporation_j_kg and molar_mass_kg_mol, each with its source, or evaporation: false";
        findings.require(given, name, &reason, remedy);
    }
    findings.into_problems()
}
