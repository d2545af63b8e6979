//! The melt: flows of `sph-fluid` whose answer is known.

pub(super) mod cavities;
pub(super) mod channels;
pub(super) mod drops;
pub(super) mod layers;
pub(super) mod pools;
pub(super) mod squares;
pub(super) mod surfaces;
pub(super) mod vortices;
pub(super) mod warmths;
pub(super) mod waters;

use super::Outcome;
use super::neighbors::find;
use sph_fluid::FluidPatch;

/// The errors of one patch, with its cost.
fn outcome<const D: usize>(patch: &FluidPatch<D>, errors: Vec<f64>) -> Outcome {
    Outcome { errors, particles: patch.positions().len(), pair_visits: patch.pair_visits() }
}
