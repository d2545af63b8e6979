//! Determinant and inverse of a matrix of two or three rows, where a generic dimension leaves nalgebra's out of reach.

use nalgebra::SMatrix;

/// det A of a 2 x 2 or 3 x 3 matrix.
#[inline]
pub(crate) fn determinant<const D: usize>(a: &SMatrix<f64, D, D>) -> f64 {
    if D == 2 {
        return a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(1, 0)];
    }
    a[(0, 0)] * (a[(1, 1)] * a[(2, 2)] - a[(1, 2)] * a[(2, 1)])
        - a[(0, 1)] * (a[(1, 0)] * a[(2, 2)] - a[(1, 2)] * a[(2, 0)])
        + a[(0, 2)] * (a[(1, 0)] * a[(2, 1)] - a[(1, 1)] * a[(2, 0)])
}

/// A^-1 from the adjugate; entries are not finite if A is singular.
#[inline]
pub(crate) fn inverse<const D: usize>(a: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    let scale = 1.0 / determinant(a);
    SMatrix::from_fn(|row, column| {
        if D == 2 {
            let sign = if row == column { scale } else { -scale };
            return sign * a[(1 - column, 1 - row)];
        }
        // Cyclic neighbours give the cofactor with its sign.
        let (r1, r2) = ((column + 1) % 3, (column + 2) % 3);
        let (c1, c2) = ((row + 1) % 3, (row + 2) % 3);
        scale * (a[(r1, c1)] * a[(r2, c2)] - a[(r1, c2)] * a[(r2, c1)])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Matrix3};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agree_with_nalgebra(entries in prop::array::uniform9(-0.3..0.3_f64)) {
            let solid = Matrix3::identity() + Matrix3::from_row_slice(&entries);
            prop_assert!((inverse(&solid) * solid - Matrix3::identity()).norm() < 1e-12);
            prop_assert!((determinant(&solid) - solid.determinant()).abs() < 1e-13);
            let flat = Matrix2::identity() + Matrix2::from_row_slice(&entries[..4]);
            prop_assert!((inverse(&flat) * flat - Matrix2::identity()).norm() < 1e-12);
            prop_assert!((determinant(&flat) - flat.determinant()).abs() < 1e-13);
        }
    }
}
