//! Artificial stress against the tensile instability of the updated-Lagrangian form.

use nalgebra::SMatrix;
use sph_kernel::operators::symmetric_eigen;

/// Factor epsilon of Gray, Monaghan and Swift (2001) \[-\].
pub const ARTIFICIAL_STRESS_FACTOR: f64 = 0.3;

/// Exponent n of Gray, Monaghan and Swift (2001).
pub const ARTIFICIAL_STRESS_EXPONENT: i32 = 4;

/// R of one particle \[Pa m^6/kg^2\]: in the principal axes of the stress, -`factor` sigma/rho^2 where sigma pulls, else
/// zero (Gray, Monaghan and Swift 2001; R_ij = R_i + R_j in Hu and Eberhard 2015, eq. 4).
///
/// It enters the force times ([`artificial_stress_weight`]) and repels particles that tension draws together. It is not a
/// law of nature: it lowers frequencies by 3 to 4 % and may feed energy in.
#[must_use]
pub fn artificial_stress<const D: usize>(
    stress: &SMatrix<f64, D, D>,
    density: f64,
    factor: f64,
) -> SMatrix<f64, D, D> {
    let scale = -factor / (density * density);
    // Where all of it pulls, or nothing does, there is no need for axes.
    if factor == 0.0 || (-stress).cholesky().is_some() {
        return SMatrix::zeros();
    }
    if stress.cholesky().is_some() {
        return stress * scale;
    }
    let (values, axes) = symmetric_eigen(*stress);
    let mut sum = SMatrix::zeros();
    for k in 0..D {
        let axis = axes.column(k).into_owned();
        sum += axis * axis.transpose() * (values[k].max(0.0) * scale);
    }
    sum
}

/// Phi^n = (W(r)/W(dx))^n \[-\], with dx the initial spacing (Monaghan 2000).
#[inline]
#[must_use]
pub fn artificial_stress_weight(value: f64, value_at_spacing: f64, exponent: i32) -> f64 {
    (value / value_at_spacing).powi(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Matrix3};
    use proptest::prelude::*;

    #[test]
    fn only_tension_is_countered() {
        let stress = Matrix2::new(4e6, 0.0, 0.0, -9e6);
        let expected = Matrix2::new(-0.3 * 4e6 / 1e6, 0.0, 0.0, 0.0);
        assert!((artificial_stress(&stress, 1000.0, 0.3) - expected).norm() < 1e-12);
        assert_eq!(artificial_stress(&Matrix3::from_diagonal_element(-1.0), 1.0, 0.3), Matrix3::zeros());
    }

    #[test]
    fn the_weight_is_one_at_the_spacing_and_steep() {
        assert_eq!(artificial_stress_weight(0.2, 0.2, ARTIFICIAL_STRESS_EXPONENT), 1.0);
        assert!((artificial_stress_weight(0.1, 0.2, ARTIFICIAL_STRESS_EXPONENT) - 0.0625).abs() < 1e-16);
    }

    proptest! {
        #[test]
        fn turns_with_the_stress(xx in -1.0..1.0_f64, yy in -1.0..1.0_f64, xy in -1.0..1.0_f64, angle in 0.0..6.0_f64) {
            let turn = Matrix2::new(angle.cos(), -angle.sin(), angle.sin(), angle.cos());
            let stress = Matrix2::new(xx, xy, xy, yy);
            let turned = artificial_stress(&(turn * stress * turn.transpose()), 1.0, 0.3);
            let expected = turn * artificial_stress(&stress, 1.0, 0.3) * turn.transpose();
            prop_assert!((turned - expected).norm() < 1e-13);
        }
    }
}
