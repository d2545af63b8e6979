//! The first pass: moments and velocity gradients at the present positions, and which pairs are near.

use super::near::NearPairs;
use super::quads::{LANES, QuadKernel, VECTOR, for_each_quad, turned};
use nalgebra::SMatrix;
use sph_kernel::Shape;
use wide::f64x4;

/// What velocity gradients read of one particle: one line of cache.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    /// Position \[m\] and volume \[m^D\].
    pub position: f64x4,
    /// Velocity \[m/s\].
    pub velocity: f64x4,
}

/// The sums of one row.
#[derive(Clone, Copy, Debug)]
pub(super) struct RowSums<const D: usize> {
    /// sum_j V_j (x_j - x_i) (x) grad_i W \[-\]; zero where it is not wanted.
    pub moment: SMatrix<f64, D, D>,
    /// sum_j V_j (v_j - v_i) (x) grad_i W \[1/s\].
    pub gradient: SMatrix<f64, D, D>,
}

/// Sums over full rows, so that a particle writes to itself only: what a pair costs is less than handing on both sums
/// would.
pub(super) struct GradientPass<'p, S, const CORRECTED: bool> {
    pub kernel: QuadKernel<S>,
    /// Square of the support radius \[m^2\].
    pub limit: f64,
    pub places: &'p [Place],
}

impl<S: Shape, const CORRECTED: bool> GradientPass<'_, S, CORRECTED> {
    /// The sums of particle `own` over its list, whose entries inside the support become the next row of `near`.
    pub fn row<const D: usize>(&self, own: usize, list: &[u32], near: &mut NearPairs) -> RowSums<D> {
        let here = &self.places[own];
        let position = here.position * VECTOR;
        let (mut moment, mut gradient) = ([[f64x4::ZERO; D]; D], [[f64x4::ZERO; D]; D]);
        near.begin_row(list.len());
        for_each_quad(list, own, |indices| {
            let there = indices.map(|index| &self.places[index as usize]);
            // Differences are taken first, or compilers gather the records number by number.
            let apart = turned(there, |place| place.position - position);
            let change = turned(there, |place| place.velocity - here.velocity);
            let mut square = f64x4::ZERO;
            for axis in 0..D {
                square = apart[axis].mul_add(apart[axis], square);
            }
            near.append(own, indices, square.simd_lt(f64x4::splat(self.limit)).to_bitmask());
            let weight = self.kernel.evaluate(square).1 * apart[LANES - 1];
            for column in 0..D {
                let slope = apart[column] * weight;
                for row in 0..D {
                    gradient[column][row] = change[row].mul_neg_add(slope, gradient[column][row]);
                    if CORRECTED && row <= column {
                        moment[column][row] = apart[row].mul_neg_add(slope, moment[column][row]);
                    }
                }
            }
        });
        RowSums {
            moment: SMatrix::from_fn(|row, column| moment[row.max(column)][row.min(column)].reduce_add()),
            gradient: SMatrix::from_fn(|row, column| gradient[column][row].reduce_add()),
        }
    }
}
