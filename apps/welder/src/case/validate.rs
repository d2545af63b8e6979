//! What a scene must satisfy beyond its form.

use super::card::CardSource;
use super::problem::Problem;
use super::scene::Scene;
use super::source::Source;

/// All findings, in the order of the sections.
pub fn validate(
    _source: &Source,
    _scene: &Scene,
    _cards: &[CardSource],
    _region_materials: &[usize],
) -> Vec<Problem> {
    Vec::new()
}
