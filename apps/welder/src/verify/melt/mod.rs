//! The melt: flows of `sph-fluid` whose answer is known.

pub(super) mod channels;
pub(super) mod drops;
pub(super) mod layers;
pub(super) mod vortices;
pub(super) mod waters;

use super::Outcome;
use nalgebra::SVector;
use sph_fluid::FluidPatch;
use sph_neighbors::{PairReach, SearchMethod};

/// Neighbours for a patch of fluid. A search that is refused, because positions are no numbers any more, finds nobody: the
/// run goes on to an answer that is no number, and misses its mark.
fn find<const D: usize>(positions: &[SVector<f64, D>], reach: f64) -> (Vec<usize>, Vec<u32>) {
    match SearchMethod::default().find(positions, PairReach::Uniform(reach)) {
        Ok(list) => (list.starts().to_vec(), list.indices().to_vec()),
        Err(_) => (vec![0; positions.len() + 1], Vec::new()),
    }
}

/// The errors of one patch, with its cost.
fn outcome<const D: usize>(patch: &FluidPatch<D>, errors: Vec<f64>) -> Outcome {
    Outcome { errors, particles: patch.positions().len(), pair_visits: patch.pair_visits() }
}
