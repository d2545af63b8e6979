//! The corrected gradient of a scalar.

use crate::Row;
use nalgebra::{SMatrix, SVector};

/// grad u_i = B_i sum_j V_j (u_j - u_i) grad_i W_ij \[unit of u per m\]: exact for linear fields on any point set where
/// `inverse_moment` B is the true inverse of [`moment`](super::moment).
///
/// `volumes` \[m^D\] and `field` u belong to all particles. Source: Chen, Beraun and Carney 1999 (CSPM); Randles
/// and Libersky 1996.
#[inline]
pub fn gradient<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    field: &[f64],
    inverse_moment: &SMatrix<f64, D, D>,
) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        let difference = field[j] - field[row.index];
        sum += row.separations[k] * (volumes[j] * difference * row.gradient_factors[k]);
    }
    inverse_moment * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operators::{moment, regularised_inverse};
    use crate::test_points::{perturbed_lattice, with_row};

    fn largest_error<const D: usize>(count: usize, field_at: impl Fn(&SVector<f64, D>) -> f64) -> f64 {
        let positions = perturbed_lattice::<D>(count, 0.2);
        let volumes: Vec<f64> = (0..positions.len()).map(|k| 1.0 + 0.1 * (k % 3) as f64).collect();
        let field: Vec<f64> = positions.iter().map(field_at).collect();
        let expected = SVector::from_fn(|axis, _| 1.5 - 2.0 * axis as f64);
        let error_at = |index| {
            with_row(&positions, index, 1.5, |row| {
                let inverse = regularised_inverse(&moment(row, &volumes));
                (gradient(row, &volumes, &field, &inverse) - expected).norm()
            })
        };
        (0..positions.len()).map(error_at).fold(0.0, f64::max)
    }

    fn linear<const D: usize>(position: &SVector<f64, D>) -> f64 {
        7.0 + (0..D).map(|axis| (1.5 - 2.0 * axis as f64) * position[axis]).sum::<f64>()
    }

    #[test]
    fn is_exact_for_linear_fields_on_disordered_points_and_their_faces() {
        assert!(largest_error::<2>(7, linear) < 1e-12);
        assert!(largest_error::<3>(5, linear) < 1e-12);
    }

    #[test]
    fn sees_curvature_as_an_error_at_faces() {
        assert!(largest_error::<2>(7, |position| linear(position) + 0.1 * position.x * position.x) > 0.05);
    }
}
