//! Principal values and axes of a symmetric matrix.

use nalgebra::SMatrix;

/// Sweeps of the cyclic Jacobi method: 3 x 3 matrices reach round-off in five or six.
const JACOBI_SWEEPS: usize = 12;

/// Eigenvalues and, as columns, eigenvectors of a symmetric matrix; in no particular order.
///
/// Cyclic Jacobi rotations with the small angle (Golub and Van Loan 2013, algorithm 8.5.1).
#[must_use]
pub fn symmetric_eigen<const D: usize>(mut matrix: SMatrix<f64, D, D>) -> ([f64; D], SMatrix<f64, D, D>) {
    let mut vectors = SMatrix::identity();
    for _ in 0..JACOBI_SWEEPS {
        for p in 0..D {
            for q in p + 1..D {
                rotate(&mut matrix, &mut vectors, p, q);
            }
        }
    }
    (std::array::from_fn(|k| matrix[(k, k)]), vectors)
}

/// One rotation that makes entry (p, q) zero, by an angle of at most 45 degrees: the large one need not converge.
fn rotate<const D: usize>(
    matrix: &mut SMatrix<f64, D, D>,
    vectors: &mut SMatrix<f64, D, D>,
    p: usize,
    q: usize,
) {
    if matrix[(p, q)] == 0.0 {
        return;
    }
    let ratio = (matrix[(q, q)] - matrix[(p, p)]) / (2.0 * matrix[(p, q)]);
    // A ratio whose square overflows gives an angle of zero, which it is to round-off.
    let tangent = ratio.signum() / (ratio.abs() + (ratio * ratio + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    for k in 0..D {
        let (at_p, at_q) = (matrix[(k, p)], matrix[(k, q)]);
        matrix[(k, p)] = cosine * at_p - sine * at_q;
        matrix[(k, q)] = sine * at_p + cosine * at_q;
    }
    for k in 0..D {
        let (at_p, at_q) = (matrix[(p, k)], matrix[(q, k)]);
        matrix[(p, k)] = cosine * at_p - sine * at_q;
        matrix[(q, k)] = sine * at_p + cosine * at_q;
        let (at_p, at_q) = (vectors[(k, p)], vectors[(k, q)]);
        vectors[(k, p)] = cosine * at_p - sine * at_q;
        vectors[(k, q)] = sine * at_p + cosine * at_q;
    }
    matrix[(p, q)] = 0.0;
    matrix[(q, p)] = 0.0;
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Matrix3};
    use proptest::prelude::*;

    #[test]
    fn pure_shear_pulls_along_the_diagonal() {
        let (values, axes) = symmetric_eigen(Matrix2::new(0.0, 3.0, 3.0, 0.0));
        let pulled = usize::from(values[1] > values[0]);
        assert!((values[pulled] - 3.0).abs() < 1e-15 && (values[1 - pulled] + 3.0).abs() < 1e-15);
        assert!((axes[(0, pulled)] - axes[(1, pulled)]).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn values_and_axes_restore_the_matrix(entries in prop::array::uniform6(-2.0..2.0_f64)) {
            let [xx, yy, zz, xy, xz, yz] = entries;
            let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let (values, axes) = symmetric_eigen(matrix);
            let restored = axes * Matrix3::from_diagonal(&values.into()) * axes.transpose();
            prop_assert!((restored - matrix).norm() < 1e-13);
            let flat = Matrix2::new(xx, xy, xy, yy);
            let (values, axes) = symmetric_eigen(flat);
            let restored = axes * Matrix2::from_diagonal(&values.into()) * axes.transpose();
            prop_assert!((restored - flat).norm() < 1e-13);
        }
    }
}
