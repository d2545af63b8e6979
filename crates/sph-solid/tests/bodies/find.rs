//! Neighbours for the patches of the crate.

use nalgebra::SVector;
use sph_neighbors::{PairReach, SearchMethod};

pub fn find<const D: usize>(positions: &[SVector<f64, D>], reach: f64) -> (Vec<usize>, Vec<u32>) {
    let list = SearchMethod::default().find(positions, PairReach::Uniform(reach)).unwrap();
    (list.starts().to_vec(), list.indices().to_vec())
}
