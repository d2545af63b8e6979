//! Flow of the melt: what it needs of the scene and of the material.

use super::super::card::CardSource;
use super::super::problem::Problem;
use super::super::scene::{Face, Flow, FlowSchedule, Levels, Scene, Weights};
use super::findings::Findings;
use super::plausible::{ARTIFICIAL_VISCOSITY, MELT_SOUND, VISCOSITY_FACTOR};

/// Checks the settings of `flow`, which stand at `field`, against the scene.
pub fn check(findings: &mut Findings, scene: &Scene, field: &str, flow: &Flow) {
    if let Some(speed) = flow.sound_speed_m_s {
        findings.within(&format!("{field}.sound_speed_m_s"), speed, &MELT_SOUND);
    }
    findings.within(&format!("{field}.viscosity_factor"), flow.viscosity_factor, &VISCOSITY_FACTOR);
    findings.within(
        &format!("{field}.artificial_viscosity"),
        flow.artificial_viscosity,
        &ARTIFICIAL_VISCOSITY,
    );
    let reason = "the melt flows where Heat melts it, and the scene does not list Heat";
    findings.require(scene.heat().is_some(), field, reason, "list both: physics: [Heat(), Flow()]");
    for (name, face) in scene.part.faces.named() {
        let place = format!("part.faces.{name}");
        let held = matches!(face, Face::FixedTemperature { .. });
        let reason = "a face of fixed temperature does not go with particles that move";
        findings.require(!held, &place, reason, "accepted with Flow: Adiabatic, Symmetry, Flux or Losses");
    }
    let uniform = scene.resolution.levels == Levels::Uniform;
    let reason = "the reference that steps everything together takes one spacing";
    let place = format!("{field}.schedule");
    findings.require(
        flow.schedule == FlowSchedule::Split || uniform,
        &place,
        reason,
        "accepted with levels of spacing: Split; accepted with levels: Uniform: Split and Together",
    );
    let weights = scene.heat().map_or(Weights::Auto, |heat| heat.weights);
    let reason = "rows are renewed with normalized weights where the melt moves, which these are not";
    let fine = !matches!(weights, Weights::Plain | Weights::Moving);
    findings.require(fine, "physics", reason, "accepted with Flow: weights: Auto, Fitted or Normalized");
    for (index, region) in scene.part.regions.iter().enumerate() {
        let same = region.material.as_ref().is_none_or(|material| *material == scene.part.material);
        let remedy = "leave the region's material out, or Flow";
        let reason = "Flow takes one material in the whole part";
        findings.require(same, &format!("part.regions.{index}.material"), reason, remedy);
    }
}

/// Checks that a card has what Flow needs.
pub fn check_card(card: &CardSource) -> Vec<Problem> {
    let mut findings = Findings::new(&card.source, &card.prefix);
    let values = &card.card;
    let given = [
        ("viscosity_pa_s", values.viscosity_pa_s.is_some()),
        ("surface_tension_n_m", values.surface_tension_n_m.is_some()),
    ];
    for (name, given) in given {
        let reason = format!("Flow needs {name} of {}, which the card does not give", card.name);
        let remedy = "add viscosity_pa_s and surface_tension_n_m (and, unless that is a table, surface_tension_slope_n_m_k), each \
                      with its source, or leave out Flow";
        findings.require(given, name, &reason, remedy);
    }
    findings.into_problems()
}
