//! The first-moment matrix of a row and its regularised inverse.

use super::symmetric_eigen;
use crate::Row;
use nalgebra::SMatrix;

/// M_i = sum_j V_j (r_j - r_i) (x) grad_i W_ij = -sum_j V_j f_ij r_ij (x) r_ij \[-\]: symmetric, positive
/// semi-definite, about the identity inside a body.
///
/// `volumes` \[m^D\] of all particles. Source: Randles and Libersky 1996; Bonet and Lok 1999.
#[inline]
pub fn moment<const D: usize>(row: &Row<'_, D>, volumes: &[f64]) -> SMatrix<f64, D, D> {
    let mut sum = SMatrix::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let separation = row.separations[k];
        let weighted = separation * (-volumes[neighbor as usize] * row.gradient_factors[k]);
        sum += weighted * separation.transpose();
    }
    sum
}

/// B = M^-1, with directions of too few neighbours faded out instead of amplified.
///
/// In the eigenbasis of the symmetric M, an eigenvalue l at or above the limit (0.12 in 2-D, 0.05 in 3-D) becomes 1/l;
/// below it x = l/limit gives (4 x^2 - 3 x^3)/limit, which meets 1/l with equal value and slope and goes smoothly to
/// zero. A particle alone or in a line therefore gets a finite B. Corners of blocks have l >= 0.14, so that B is the exact
/// inverse there; a limit of 0.3 already spoils them (measured in trials of this project).
///
/// Eigenvectors by [`symmetric_eigen`], and only where an eigenvalue lies below the limit: elimination is far cheaper.
pub fn regularised_inverse<const D: usize>(moment: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    let limit = if D == 2 { 0.12 } else { 0.05 };
    if is_positive_definite(moment - SMatrix::from_diagonal_element(limit)) {
        return definite_inverse(*moment);
    }
    let (eigenvalues, vectors) = symmetric_eigen(*moment);
    let mut inverse = SMatrix::zeros();
    for k in 0..D {
        let vector = vectors.column(k).into_owned();
        inverse += vector * vector.transpose() * faded_reciprocal(eigenvalues[k], limit);
    }
    inverse
}

/// Whether a symmetric matrix has positive pivots only.
#[inline]
fn is_positive_definite<const D: usize>(mut matrix: SMatrix<f64, D, D>) -> bool {
    for k in 0..D {
        if matrix[(k, k)] <= 0.0 {
            return false;
        }
        for row in k + 1..D {
            let factor = matrix[(row, k)] / matrix[(k, k)];
            for column in k + 1..D {
                matrix[(row, column)] -= factor * matrix[(k, column)];
            }
        }
    }
    true
}

/// A^-1 of a symmetric, positive definite matrix, by elimination in place, which needs no other pivots then.
#[inline]
fn definite_inverse<const D: usize>(mut matrix: SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    for k in 0..D {
        let reciprocal = 1.0 / matrix[(k, k)];
        matrix[(k, k)] = 1.0;
        for column in 0..D {
            matrix[(k, column)] *= reciprocal;
        }
        for row in (0..D).filter(|&row| row != k) {
            let factor = matrix[(row, k)];
            matrix[(row, k)] = 0.0;
            for column in 0..D {
                matrix[(row, column)] -= factor * matrix[(k, column)];
            }
        }
    }
    matrix
}

fn faded_reciprocal(eigenvalue: f64, limit: f64) -> f64 {
    if eigenvalue >= limit {
        return 1.0 / eigenvalue;
    }
    let x = (eigenvalue / limit).max(0.0);
    x * x * (4.0 - 3.0 * x) / limit
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_points::{middle, perturbed_lattice, with_row};
    use nalgebra::{Matrix2, Matrix3};
    use proptest::prelude::*;

    fn moment_at<const D: usize>(count: usize, amplitude: f64, index: usize) -> SMatrix<f64, D, D> {
        let positions = perturbed_lattice::<D>(count, amplitude);
        let volumes = vec![1.0; positions.len()];
        with_row(&positions, index, 2.0, |row| moment(row, &volumes))
    }

    #[test]
    fn is_the_identity_inside_a_lattice() {
        assert!((moment_at::<2>(9, 0.0, middle::<2>(9)) - Matrix2::identity()).norm() < 5e-3);
        assert!((moment_at::<3>(9, 0.0, middle::<3>(9)) - Matrix3::identity()).norm() < 5e-3);
    }

    #[test]
    fn inverse_is_exact_at_the_corner_of_a_disordered_block() {
        let flat = moment_at::<2>(5, 0.1, 0);
        assert!((flat * regularised_inverse(&flat) - Matrix2::identity()).norm() < 1e-13);
        let solid = moment_at::<3>(5, 0.1, 0);
        assert!((solid * regularised_inverse(&solid) - Matrix3::identity()).norm() < 1e-13);
    }

    #[test]
    fn a_particle_alone_and_a_line_stay_finite() {
        assert_eq!(regularised_inverse(&Matrix3::<f64>::zeros()), Matrix3::zeros());
        let line = Matrix3::from_diagonal(&[0.5, 0.0, 1e-9].into());
        let expected = Matrix3::from_diagonal(&[2.0, 0.0, 4.0 * (1e-9 / 0.05_f64).powi(2) / 0.05].into());
        assert!((regularised_inverse(&line) - expected).norm() < 1e-20);
    }

    #[test]
    fn the_fade_meets_the_reciprocal_with_equal_slope() {
        for limit in [0.12, 0.05] {
            let step = 1e-6 * limit;
            let below = (faded_reciprocal(limit, limit) - faded_reciprocal(limit - step, limit)) / step;
            let above = (faded_reciprocal(limit + step, limit) - faded_reciprocal(limit, limit)) / step;
            assert!((below / above - 1.0).abs() < 1e-5);
            assert_eq!(faded_reciprocal(-1e-3, limit), 0.0);
        }
    }

    proptest! {
        #[test]
        fn elimination_and_eigenvectors_agree(
            values in prop::array::uniform3(0.0..1.5_f64),
            angles in prop::array::uniform3(-3.0..3.0_f64),
        ) {
            let turn = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]).into_inner();
            let diagonal = |values: [f64; 3]| turn * Matrix3::from_diagonal(&values.into()) * turn.transpose();
            let expected = diagonal(values.map(|value| faded_reciprocal(value, 0.05)));
            prop_assert!((regularised_inverse(&diagonal(values)) - expected).norm() < 1e-12 * expected.norm());
        }

        #[test]
        fn jacobi_restores_the_matrix(entries in prop::array::uniform6(-2.0..2.0)) {
            let [xx, yy, zz, xy, xz, yz]: [f64; 6] = entries;
            let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let (eigenvalues, vectors) = symmetric_eigen(matrix);
            let restored = vectors * Matrix3::from_diagonal(&eigenvalues.into()) * vectors.transpose();
            prop_assert!((restored - matrix).norm() < 1e-13);
            prop_assert!((vectors.transpose() * vectors - Matrix3::identity()).norm() < 1e-13);
        }
    }
}
