//! Thermal stress: what it needs of the scene and of the material.

use super::super::card::CardSource;
use super::super::problem::Problem;
use super::super::scene::{Face, Levels, Scene, Stress};
use super::findings::Findings;
use super::plausible::{CROSSINGS, number};

/// Spacings that a stressed part is thick at least: rows reach that far beyond mirror planes and clamps.
const LEAST_LAYERS: f64 = 5.0;

/// Checks the settings of `stress`, which stand at `field`, against the scene.
pub fn check(findings: &mut Findings, scene: &Scene, field: &str, stress: &Stress) {
    findings.within(&format!("{field}.crossings"), stress.crossings, &CROSSINGS);
    let reason = "Stress follows the temperatures of Heat, which the scene does not list";
    findings.require(scene.heat().is_some(), field, reason, "list both: physics: [Heat(), Stress()]");
    let reason = "a stressed body is not in equilibrium where the spacing jumps: Stress takes one spacing";
    let one = !matches!(scene.resolution.levels, Levels::FineBox { .. });
    findings.require(
        one,
        "resolution.levels",
        reason,
        "accepted with Stress: Uniform, or Auto, which is then Uniform",
    );
    for (index, region) in scene.part.regions.iter().enumerate() {
        let reason = "Stress takes one material in the whole part";
        let same = region.material.as_ref().is_none_or(|material| *material == scene.part.material);
        let remedy = "leave the region's material out, or Stress";
        findings.require(same, &format!("part.regions.{index}.material"), reason, remedy);
    }
    for (axis, size_m) in scene.part.size_m.into_iter().enumerate() {
        let count = size_m / scene.resolution.spacing_m;
        let reason = format!("{} spacings thick, where Stress needs {LEAST_LAYERS}", number(count));
        let remedy = format!("accepted: resolution.spacing_m at most {}", number(size_m / LEAST_LAYERS));
        findings.require(count > LEAST_LAYERS - 1e-6, &format!("part.size_m.{axis}"), &reason, remedy);
    }
    let faces = scene.part.faces.named();
    for (name, _) in stress.clamped.named().into_iter().filter(|(_, clamped)| *clamped) {
        let mirrors = faces.iter().any(|(face, kind)| *face == name && *kind == Face::Symmetry);
        let reason = format!("part.faces.{name} is a mirror plane, which moves in itself");
        let remedy = "clamp another face, or make this one no mirror plane";
        findings.require(!mirrors, &format!("{field}.clamped.{name}"), &reason, remedy);
    }
}

/// Checks that a card has what Stress needs, and that its material yields before it melts.
pub fn check_card(card: &CardSource) -> Vec<Problem> {
    let mut findings = Findings::new(&card.source, &card.prefix);
    let values = &card.card;
    let given = [
        ("young_pa", values.young_pa.is_some()),
        ("poisson", values.poisson.is_some()),
        ("expansion_1_k", values.expansion_1_k.is_some()),
        ("yield_pa", values.yield_pa.is_some()),
    ];
    for (name, given) in given {
        let reason = format!("Stress needs {name} of {}, which the card does not give", card.name);
        let remedy =
            "add young_pa, poisson, expansion_1_k and yield_pa, each with its source, or leave out Stress";
        findings.require(given, name, &reason, remedy);
    }
    let Some(strength) = &values.yield_pa else { return findings.into_problems() };
    let whole = strength.value.is_some() || strength.table.as_ref().is_some_and(|table| !table.is_empty());
    let at_solidus = if whole { strength.at(values.solidus_k.value) } else { 0.0 };
    let reason = format!(
        "{} Pa are left at the solidus of {} K: what melts would carry shear",
        number(at_solidus),
        number(values.solidus_k.value)
    );
    findings.require(at_solidus == 0.0, "yield_pa", &reason, "let the table end with (solidus_k, 0.0)");
    findings.into_problems()
}
