//! The second pass: the divergence of stress and what is added to it.

use super::UpdatedControls;
use super::near::NearPairs;
use super::quads::{LANES, QuadKernel, SCALAR, VECTOR, for_each_quad, joined, turned};
use crate::{ARTIFICIAL_STRESS_EXPONENT, ArtificialViscosity};
use nalgebra::{SMatrix, SVector};
use sph_kernel::Shape;
use wide::f64x4;

/// What forces read of one particle, together in memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<const D: usize> {
    /// Position \[m\] and mass \[kg\].
    place: f64x4,
    /// Velocity \[m/s\] and density \[kg/m^3\].
    speed: f64x4,
    /// A - b/2 L \[m^4/(kg s^2) in 3-D\], with A the tensor of the stress, L the velocity gradient and b the coefficient of
    /// the viscosity on what gradients do not see; off-diagonal entries of the artificial stress R beside.
    pull: [f64x4; D],
    /// Diagonal of the artificial stress R.
    repulsion: f64x4,
}

/// The column of [`Point::pull`] that entry (row, column) of R, off its diagonal, stands beside.
const fn carrier(row: usize, column: usize) -> usize {
    row + column - 1
}

impl<const D: usize> Point<D> {
    /// A particle at the origin without mass.
    pub fn nothing() -> Self {
        let zero = f64x4::ZERO;
        Self { place: zero, speed: zero, pull: [zero; D], repulsion: zero }
    }

    pub fn new(
        (position, mass): (&SVector<f64, D>, f64),
        (velocity, density): (&SVector<f64, D>, f64),
        pull: &SMatrix<f64, D, D>,
        repulsion: &SMatrix<f64, D, D>,
    ) -> Self {
        let mut beside = [0.0; D];
        for row in 0..D {
            for column in row + 1..D {
                beside[carrier(row, column)] = repulsion[(row, column)];
            }
        }
        Self {
            place: joined(position, mass),
            speed: joined(velocity, density),
            pull: std::array::from_fn(|column| joined(&pull.column(column).into_owned(), beside[column])),
            repulsion: joined(&repulsion.diagonal(), 0.0),
        }
    }
}

/// Constants of all pairs; whether there is artificial stress (`REPULSIVE`) is known to the compiler.
#[derive(Clone, Copy, Debug)]
pub(super) struct ForcePass<S, const D: usize, const REPULSIVE: bool> {
    kernel: QuadKernel<S>,
    /// Viscosity on what gradients do not see, b = coefficient c_P h/rho_0 \[m^5/(kg s) in 3-D\].
    damping: f64,
    viscosity: ArtificialViscosity,
    smoothing_length: f64,
    wave_speed: f64,
    /// 1/W of the initial spacing \[m^D\].
    inverse_value_at_spacing: f64,
}

impl<S: Shape, const D: usize, const REPULSIVE: bool> ForcePass<S, D, REPULSIVE> {
    /// `shape` must be that of the controls' kernel; `damping` as in [`Point`].
    pub fn new(shape: S, controls: &UpdatedControls<D>, wave_speed: f64, damping: f64) -> Self {
        Self {
            kernel: QuadKernel::new(shape, &controls.kernel),
            damping,
            viscosity: controls.viscosity,
            smoothing_length: controls.kernel.smoothing_length(),
            wave_speed,
            inverse_value_at_spacing: 1.0 / controls.kernel.value(controls.spacing),
        }
    }

    /// Accelerations \[m/s^2\] of the particles of a block.
    pub fn block(&self, points: &[Point<D>], pairs: &NearPairs, accelerations: &mut [f64x4]) {
        accelerations.fill(f64x4::ZERO);
        let first = pairs.particles().start;
        for k in 0..accelerations.len() {
            let own = first + k;
            let here = &points[own];
            let mass = here.place.to_array()[LANES - 1];
            let mut sum = [f64x4::ZERO; D];
            for_each_quad(pairs.within(k), own, |indices| {
                let pull = self.visit(here, points, indices, &mut sum);
                give(&pull, -mass, indices, first, accelerations);
            });
            for_each_quad(pairs.across(k), own, |indices| {
                self.visit(here, points, indices, &mut sum);
            });
            accelerations[k] += joined(&SVector::<f64, D>::from_fn(|axis, _| sum[axis].reduce_add()), 0.0);
        }
    }

    /// What four neighbours pull i with, over m_i m_j; their sum times m_j is added to `sum`.
    ///
    /// Differences and sums are taken before the records are turned about, or compilers gather them number by number.
    #[inline(always)]
    fn visit(
        &self,
        here: &Point<D>,
        points: &[Point<D>],
        indices: [u32; LANES],
        sum: &mut [f64x4; D],
    ) -> [f64x4; D] {
        let there = indices.map(|index| &points[index as usize]);
        let apart = turned(there, |point| point.place - here.place * VECTOR);
        let change = turned(there, |point| point.speed - here.speed * (VECTOR - SCALAR));
        let (mut square, mut closing) = (f64x4::ZERO, f64x4::ZERO);
        for axis in 0..D {
            square = apart[axis].mul_add(apart[axis], square);
            closing = change[axis].mul_add(apart[axis], closing);
        }
        let (value, factor) = self.kernel.evaluate(square);
        let columns: [[f64x4; LANES]; D] =
            std::array::from_fn(|column| turned(there, |point| point.pull[column] + here.pull[column]));
        let central = -self.viscous(square, closing, change[LANES - 1]);
        let mut pull: [f64x4; D] =
            std::array::from_fn(|axis| apart[axis].mul_add(central, change[axis] * self.damping));
        if REPULSIVE {
            let share = power(value * self.inverse_value_at_spacing);
            let diagonal = turned(there, |point| point.repulsion + here.repulsion);
            for row in 0..D {
                for column in 0..D {
                    let repulsion =
                        if row == column { diagonal[row] } else { columns[carrier(row, column)][LANES - 1] };
                    let tensor = repulsion.mul_add(share, columns[column][row]);
                    pull[row] = tensor.mul_add(apart[column], pull[row]);
                }
            }
        } else {
            for row in 0..D {
                for column in 0..D {
                    pull[row] = columns[column][row].mul_add(apart[column], pull[row]);
                }
            }
        }
        for axis in 0..D {
            pull[axis] *= -factor;
            sum[axis] = pull[axis].mul_add(apart[LANES - 1], sum[axis]);
        }
        pull
    }

    /// Pi of four pairs with `densities` rho_i + rho_j, as [`ArtificialViscosity::pair`] has it, with one division.
    #[inline(always)]
    fn viscous(&self, square: f64x4, closing: f64x4, densities: f64x4) -> f64x4 {
        let ArtificialViscosity { alpha, beta } = self.viscosity;
        if alpha == 0.0 && beta == 0.0 {
            return f64x4::ZERO;
        }
        let length = self.smoothing_length;
        let density = densities * 0.5;
        let approach = closing.min(f64x4::ZERO) * length;
        let reciprocal = 1.0 / ((square + 0.01 * length * length) * density);
        let rate = approach * density * reciprocal;
        (rate * beta - alpha * self.wave_speed) * approach * reciprocal
    }
}

/// Phi^n of the artificial stress.
#[inline(always)]
fn power(ratio: f64x4) -> f64x4 {
    const { assert!(ARTIFICIAL_STRESS_EXPONENT == 4, "two squarings") };
    let squared = ratio * ratio;
    squared * squared
}

/// Gives four particles of a block their share of the pairs: the opposite pull times `factor`.
#[inline(always)]
fn give<const D: usize>(
    pull: &[f64x4; D],
    factor: f64,
    indices: [u32; LANES],
    first: usize,
    accelerations: &mut [f64x4],
) {
    let rows: [f64x4; LANES] = std::array::from_fn(|axis| match pull.get(axis) {
        Some(pull) => *pull * factor,
        None => f64x4::ZERO,
    });
    let shares = turned(rows.each_ref(), |row| *row);
    for (index, share) in indices.into_iter().zip(shares) {
        accelerations[index as usize - first] += share;
    }
}
