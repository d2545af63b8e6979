//! The solid: bodies of `sph-solid` whose answer is known.

pub(super) mod clamped_plate;
pub(super) mod heated;
pub(super) mod rings;
pub(super) mod rotation;
pub(super) mod round;
pub(super) mod stability;
pub(super) mod swings;
pub(super) mod waves;

use super::Outcome;
use super::neighbors::find;
use sph_solid::{SolidPatch, UpdatedPatch};

/// The errors of one patch, with its cost.
fn outcome<const D: usize>(patch: &SolidPatch<D>, errors: Vec<f64>) -> Outcome {
    Outcome { errors, particles: patch.positions().len(), pair_visits: patch.pair_visits() }
}

/// The same of a patch in the updated-Lagrangian form.
fn updated_outcome<const D: usize>(patch: &UpdatedPatch<D>, errors: Vec<f64>) -> Outcome {
    Outcome { errors, particles: patch.positions.len(), pair_visits: patch.pair_visits() }
}
