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

use super::PairTable;
use super::pairs::NO_IMAGE;
use crate::error::Error;
use nalgebra::{Matrix4, Vector4};
use rayon::prelude::*;

/// Iterations beyond which the fit is given up; 20 to 80 are usual.
const LARGEST_ITERATION_COUNT: usize = 400;

/// Particles below which the solve stays on one thread.
const PARALLEL_PARTICLES: usize = 20_000;

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
}

struct System<'a, 'b, const D: usize> {
    pairs: &'a PairTable<'b, D>,
    entries: Vec<Entry>,
    preconditioner: Vec<Matrix4<f64>>,
    moments: Vec<f64>,
    unit: f64,
}

impl<'a, 'b, const D: usize> System<'a, 'b, D> {
    fn new(pairs: &'a PairTable<'b, D>) -> Self {
        let smallest = pairs.volume.iter().copied().fold(f64::INFINITY, f64::min);
        let unit = smallest.powf(1.0 / D as f64);
        let entries: Vec<Entry> = (0..pairs.entries()).map(|e| entry(pairs, e, unit)).collect();
        let block = |i: usize| {
            let mut sum = Matrix4::zeros();
            for entry in &entries[pairs.starts[i]..pairs.starts[i + 1]] {
                sum += entry.weight * entry.own * entry.own.transpose();
            }
            (D..3).for_each(|unused| sum[(unused, unused)] = 1.0);
            sum.try_inverse().unwrap_or_else(Matrix4::identity)
        };
        let preconditioner = (0..pairs.particles()).map(block).collect();
        Self { pairs, entries, preconditioner, moments: pairs.moments(), unit }
    }

    fn row(&self, i: usize) -> &[Entry] {
        &self.entries[self.pairs.starts[i]..self.pairs.starts[i + 1]]
    }

    /// A column computed per particle, in parallel where that pays.
    fn column<T: Send>(&self, of: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
        let particles = self.pairs.particles();
        if particles < PARALLEL_PARTICLES {
            (0..particles).map(of).collect()
        } else {
            (0..particles).into_par_iter().map(of).collect()
        }
    }

    /// What the moments of the plain weights lack.
    fn right_hand_side(&self) -> Vec<Vector4<f64>> {
        let cell = self.unit.powi(D as i32);
        self.column(|i| {
            let target = Vector4::new(0.0, 0.0, 0.0, 2.0 * D as f64 * self.pairs.volume[i] / cell);
            self.row(i).iter().fold(target, |sum, entry| sum - entry.weight * entry.own)
        })
    }

    fn apply(&self, phi: &[Vector4<f64>]) -> Vec<Vector4<f64>> {
        self.column(|i| {
            let own = phi[i];
            let mut sum = Vector4::zeros();
            for entry in self.row(i) {
                let change = own.dot(&entry.own) + phi[entry.index as usize].dot(&entry.other);
                sum += entry.weight * change * entry.own;
            }
            sum
        })
    }

    fn precondition(&self, residual: &[Vector4<f64>]) -> Vec<Vector4<f64>> {
        self.column(|i| self.preconditioner[i] * residual[i])
    }

    /// Multipliers, iterations, and the residual over that of the plain weights.
    fn solve(&self, tolerance: f64) -> (Vec<Vector4<f64>>, usize, f64) {
        let right_hand_side = self.right_hand_side();
        let scale = dot(&right_hand_side, &self.precondition(&right_hand_side)).sqrt();
        let mut phi = self.lattice_guess();
        let applied = self.apply(&phi);
        let mut residual: Vec<_> = right_hand_side.iter().zip(&applied).map(|(b, a)| b - a).collect();
        let mut conditioned = self.precondition(&residual);
        let mut direction = conditioned.clone();
        let mut square = dot(&residual, &conditioned);
        let relative = |square: f64| if scale > 0.0 { square.max(0.0).sqrt() / scale } else { 0.0 };
        let mut iterations = 0;
        // Where the plain weights are exact already there is nothing to compare with but round-off.
        let floor = 1e-24 * self.pairs.particles() as f64;
        while relative(square) > tolerance && square > floor && iterations < LARGEST_ITERATION_COUNT {
            let image = self.apply(&direction);
            let step = square / dot(&direction, &image);
            axpy(&mut phi, step, &direction);
            axpy(&mut residual, -step, &image);
            conditioned = self.precondition(&residual);
            let next = dot(&residual, &conditioned);
            let ratio = next / square;
            direction.iter_mut().zip(&conditioned).for_each(|(d, c)| *d = c + ratio * *d);
            square = next;
            iterations += 1;
        }
        let reached = if square <= floor { 0.0 } else { relative(square) };
        (phi, iterations, reached)
    }

    /// The multipliers that are exact on a perfect lattice: g = w/M.
    fn lattice_guess(&self) -> Vec<Vector4<f64>> {
        let guess = |i: usize| {
            let row = self.row(i);
            let weight: f64 = row.iter().map(|e| e.weight).sum();
            let second: f64 = row.iter().map(|e| e.weight * e.own.w).sum();
            let fourth: f64 = row.iter().map(|e| e.weight * e.own.w * e.own.w).sum();
            let share = 0.5 * (1.0 / self.moments[i] - 1.0) * second / fourth;
            Vector4::new(0.0, 0.0, 0.0, if weight > 0.0 { share } else { 0.0 })
        };
        self.column(guess)
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
    Entry { own, other, weight: pairs.weight[e] / unit.powi(D as i32 - 2), index: pairs.other[e] }
}

fn dot(a: &[Vector4<f64>], b: &[Vector4<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

fn axpy(y: &mut [Vector4<f64>], factor: f64, x: &[Vector4<f64>]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += factor * x);
}
