//! Neighbours for the patches of the crates that are not in the program yet.

use nalgebra::SVector;
use sph_neighbors::{PairReach, SearchMethod};

/// A full neighbour list. A search that is refused, because positions are no numbers any more, finds nobody: the run goes on
/// to an answer that is no number, and misses its mark.
pub(super) fn find<const D: usize>(positions: &[SVector<f64, D>], reach: f64) -> (Vec<usize>, Vec<u32>) {
    match SearchMethod::default().find(positions, PairReach::Uniform(reach)) {
        Ok(list) => (list.starts().to_vec(), list.indices().to_vec()),
        Err(_) => (vec![0; positions.len() + 1], Vec::new()),
    }
}
