//! What a scene must satisfy beyond its form: plausible values, a geometry that particles can carry, a laser that meets
//! the part, a size that the machine can hold. Each section has its file.

mod faces;
mod findings;
mod flow;
mod fluid;
mod laser;
mod lattice;
mod material;
mod part;
mod plausible;
mod run;
mod size;
mod solid;
mod stress;
mod symmetry;

use super::card::CardSource;
use super::problem::Problem;
use super::scene::Scene;
use super::source::Source;
use findings::Findings;
pub(crate) use size::memory;

pub use fluid::validate_fluid;
pub use solid::validate_solid;

/// All findings, in the order of the sections; the materials' own come last.
pub fn validate(
    source: &Source,
    scene: &Scene,
    cards: &[CardSource],
    region_materials: &[usize],
) -> Vec<Problem> {
    let mut findings = Findings::new(source, "");
    let part_is_fine = part::check(&mut findings, scene);
    faces::check(&mut findings, scene);
    part::check_start(&mut findings, scene, cards, region_materials);
    let lattice_is_fine = lattice::check(&mut findings, scene, part_is_fine);
    if let Some(laser) = &scene.laser {
        laser::check(&mut findings, scene, laser, lattice_is_fine);
    }
    run::check(&mut findings, scene);
    // A size worked out from wrong numbers would only add noise.
    let mut problems = findings.into_problems();
    if problems.is_empty() {
        problems.extend(size::check(source, scene));
    }
    for card in cards {
        problems.extend(material::check(card));
        if scene.flow().is_some() {
            problems.extend(flow::check_card(card));
        }
        if faces::evaporates(scene) {
            problems.extend(faces::check_card(card));
        }
        if scene.stress().is_some() {
            problems.extend(stress::check_card(card));
        }
    }
    problems
}
