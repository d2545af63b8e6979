//! Point sets that the tests of rows and operators share.

use crate::{KernelKind, RowBuffer, row::Row};
use nalgebra::SVector;

/// `count` points a side at unit spacing, each coordinate moved by up to `amplitude` (deterministic).
pub fn perturbed_lattice<const D: usize>(count: usize, amplitude: f64) -> Vec<SVector<f64, D>> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut offset = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        amplitude * (2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0)
    };
    (0..count.pow(D as u32))
        .map(|k| SVector::from_fn(|axis, _| (k / count.pow(axis as u32) % count) as f64 + offset()))
        .collect()
}

/// The index of the point in the middle of a lattice with an odd `count` a side.
pub fn middle<const D: usize>(count: usize) -> usize {
    count.pow(D as u32) / 2
}

/// Calls `check` with the Wendland row of particle `index` among all `positions`.
pub fn with_row<const D: usize, T>(
    positions: &[SVector<f64, D>],
    index: usize,
    smoothing_length: f64,
    check: impl FnOnce(&Row<'_, D>) -> T,
) -> T {
    let others: Vec<u32> = (0..positions.len() as u32).filter(|&j| j as usize != index).collect();
    let kernel = KernelKind::WendlandC2.with_smoothing_length::<D>(smoothing_length);
    check(&RowBuffer::default().fill(index, &others, positions, &kernel))
}
