//! The gradient of the smoothed colour.

use crate::Row;
use nalgebra::SVector;

/// grad C_i = sum_j V_j grad_i W_ij \[1/m\], uncorrected: zero inside, pointing into the body near a face.
///
/// `volumes` \[m^D\] of all particles. Source: Morris 2000, for a colour of one.
#[inline]
pub fn colour_gradient<const D: usize>(row: &Row<'_, D>, volumes: &[f64]) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        sum += row.separations[k] * (volumes[neighbor as usize] * row.gradient_factors[k]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        KernelKind,
        test_points::{middle, perturbed_lattice, with_row},
    };

    #[test]
    fn vanishes_inside_a_lattice() {
        let positions = perturbed_lattice::<3>(5, 0.0);
        let volumes = vec![1.0; positions.len()];
        let gradient = with_row(&positions, middle::<3>(5), 1.2, |row| colour_gradient(row, &volumes));
        assert!(gradient.norm() < 1e-15);
    }

    #[test]
    fn points_into_the_body_at_a_face() {
        let positions = perturbed_lattice::<2>(9, 0.0);
        let volumes = vec![1.0; positions.len()];
        let bottom = 4;
        let gradient = with_row(&positions, bottom, 1.3, |row| colour_gradient(row, &volumes));
        assert!(gradient.x.abs() < 1e-15 && gradient.y > 0.3);
    }

    #[test]
    fn is_the_slope_of_the_colour_sum() {
        let mut positions = perturbed_lattice::<2>(7, 0.2);
        let volumes: Vec<f64> = (0..positions.len()).map(|k| 1.0 + 0.01 * k as f64).collect();
        let kernel = KernelKind::WendlandC2.with_smoothing_length::<2>(1.5);
        let (index, step) = (middle::<2>(7), 1e-6);
        let gradient = with_row(&positions, index, 1.5, |row| colour_gradient(row, &volumes));
        for axis in 0..2 {
            let start = positions[index][axis];
            let mut sum_at = |shift: f64| {
                positions[index][axis] = start + shift;
                with_row(&positions, index, 1.5, |row| {
                    crate::operators::summation(row, &volumes, kernel.value(0.0))
                })
            };
            let slope = (sum_at(step) - sum_at(-step)) / (2.0 * step);
            positions[index][axis] = start;
            assert!((slope - gradient[axis]).abs() < 1e-8);
        }
    }
}
