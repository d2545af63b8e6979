//! Fitted pair weights: symmetric, and exact for linear fields at size jumps, faces and disorder.
//!
//! Each particle has D + 1 multipliers phi_i in
//!
//! ```text
//! g_ij = w_ij (1 + phi_i . p(r_ij) + phi_j . p(r_ji)),     p(r) = (r, r²)
//! sum_j g_ij r_ij = 0,     sum_j g_ij r_ij² = 2 D V_i      for every i, images included
//! ```
//!
//! g is symmetric whatever phi is, so energy is exchanged exactly. The conditions form one symmetric positive
//! semi-definite system, solved without a matrix by conjugate gradients with a block-Jacobi preconditioner. On a perfect
//! lattice one constant solves it; jumps, faces and disorder are what the iterations are for.

mod conjugate_gradients;
mod moment_rows;

use super::PairTable;
use super::matrix::LANES;
use super::pairs::NO_IMAGE;
use crate::error::Error;
use conjugate_gradients::conjugate_gradients;
use moment_rows::{Four, MomentRows};
use nalgebra::Vector4;

/// How the fit went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitReport {
    /// Conjugate-gradient iterations.
    pub iterations: usize,
    /// Residual of the moment conditions over the residual of the plain weights.
    pub residual: f64,
    /// Share of weights that came out negative (a few percent are harmless; many mean too narrow a kernel).
    pub negative_share: f64,
}

/// Weights per entry of `pairs` that satisfy the moment conditions of the module to `tolerance`.
///
/// # Errors
/// [`Error::FitDidNotConverge`] when conjugate gradients stall above `tolerance`.
pub fn fitted_weights<const D: usize>(
    pairs: &PairTable<'_, D>,
    tolerance: f64,
) -> Result<(Vec<f64>, FitReport), Error> {
    let system = System::new(pairs);
    let (multipliers, iterations, residual) = system.solve(tolerance);
    if residual > tolerance {
        return Err(Error::FitDidNotConverge { residual, tolerance, iterations });
    }
    let weights = system.weights(&multipliers);
    let negative = weights.iter().filter(|&&g| g < 0.0).count();
    let negative_share = negative as f64 / weights.len().max(1) as f64;
    Ok((weights, FitReport { iterations, residual, negative_share }))
}

/// One entry of the system in lengths of the unit: moment vector p(r_ij), mirrored other end's, and weight.
#[derive(Clone, Copy)]
struct Entry {
    /// p(r_ij) = (r, r²) at this end.
    own: Vector4<f64>,
    /// p(r_ji), with the mirror of an image folded in, to meet the other end's multipliers.
    other: Vector4<f64>,
    weight: f64,
    index: u32,
    /// Whether the other end is an image.
    image: bool,
}

impl Entry {
    /// Whether it is particle `i`'s own mirror image, across planes that meet at right angles.
    fn is_own_image(&self, i: usize) -> bool {
        self.image && self.index as usize == i && self.own == self.other
    }
}

struct System<'a, 'b, const D: usize> {
    pairs: &'a PairTable<'b, D>,
    entries: Vec<Entry>,
    rows: MomentRows,
    moments: Vec<f64>,
    unit: f64,
}

impl<'a, 'b, const D: usize> System<'a, 'b, D> {
    fn new(pairs: &'a PairTable<'b, D>) -> Self {
        let smallest = pairs.volume.iter().copied().fold(f64::INFINITY, f64::min);
        let unit = smallest.powf(1.0 / D as f64);
        let entries: Vec<Entry> = (0..pairs.entries()).map(|e| entry(pairs, e, unit)).collect();
        let row = |i: usize| &entries[pairs.starts[i]..pairs.starts[i + 1]];
        let rows = MomentRows::new(pairs.particles(), D, row);
        Self { pairs, entries, rows, moments: pairs.moments(), unit }
    }

    fn row(&self, i: usize) -> &[Entry] {
        &self.entries[self.pairs.starts[i]..self.pairs.starts[i + 1]]
    }

    /// What the moments of the plain weights lack.
    fn right_hand_side(&self, i: usize) -> Vector4<f64> {
        let cell = self.unit.powi(D as i32);
        let target = Vector4::new(0.0, 0.0, 0.0, 2.0 * D as f64 * self.pairs.volume[i] / cell);
        self.row(i).iter().fold(target, |sum, entry| sum - entry.weight * entry.own)
    }

    /// Multipliers, iterations, and the residual over that of the plain weights.
    fn solve(&self, tolerance: f64) -> (Vec<Vector4<f64>>, usize, f64) {
        let right_hand_side = self.fours(|i| self.right_hand_side(i));
        let guess = self.fours(|i| self.lattice_guess(i));
        // Where the plain weights are exact already there is nothing to compare with but round-off.
        let floor = 1e-24 * self.pairs.particles() as f64;
        let solution = conjugate_gradients(&self.rows, &right_hand_side, guess, tolerance, floor);
        let multiplier = |i: usize| Vector4::from_fn(|part, _| solution.unknowns[i / LANES][part][i % LANES]);
        let multipliers = (0..self.pairs.particles()).map(multiplier).collect();
        (multipliers, solution.iterations, solution.residual)
    }

    /// Four numbers a particle, in chunks.
    fn fours(&self, of: impl Fn(usize) -> Vector4<f64>) -> Vec<Four> {
        let mut fours = vec![[[0.0; LANES]; 4]; self.rows.chunks()];
        for i in 0..self.pairs.particles() {
            let value = of(i);
            (0..4).for_each(|part| fours[i / LANES][part][i % LANES] = value[part]);
        }
        fours
    }

    /// The multipliers that are exact on a perfect lattice: g = w/M.
    fn lattice_guess(&self, i: usize) -> Vector4<f64> {
        let row = self.row(i);
        let weight: f64 = row.iter().map(|e| e.weight).sum();
        let second: f64 = row.iter().map(|e| e.weight * e.own.w).sum();
        let fourth: f64 = row.iter().map(|e| e.weight * e.own.w * e.own.w).sum();
        let share = 0.5 * (1.0 / self.moments[i] - 1.0) * second / fourth;
        Vector4::new(0.0, 0.0, 0.0, if weight > 0.0 { share } else { 0.0 })
    }

    fn weights(&self, phi: &[Vector4<f64>]) -> Vec<f64> {
        let mut weights = self.pairs.weight.clone();
        for i in 0..self.pairs.particles() {
            for (e, entry) in (self.pairs.starts[i]..).zip(self.row(i)) {
                // Both ends add the same two products; their order must not differ, or symmetry is lost to round-off.
                let (own, other) = (phi[i].dot(&entry.own), phi[entry.index as usize].dot(&entry.other));
                weights[e] *= 1.0 + (own + other);
            }
        }
        weights
    }
}

fn entry<const D: usize>(pairs: &PairTable<'_, D>, e: usize, unit: f64) -> Entry {
    let separation = pairs.separation[e] / unit;
    let square = separation.norm_squared();
    let image = pairs.image[e];
    let mirror = if image == NO_IMAGE { [1.0; D] } else { pairs.images.mirror[image as usize] };
    let mut own = Vector4::new(0.0, 0.0, 0.0, square);
    let mut other = own;
    for axis in 0..D {
        own[axis] = separation[axis];
        other[axis] = -mirror[axis] * separation[axis];
    }
    let weight = pairs.weight[e] / unit.powi(D as i32 - 2);
    Entry { own, other, weight, index: pairs.other[e], image: image != NO_IMAGE }
}
