//! St. Venant-Kirchhoff elasticity with a multiplicative thermal part: F = F_e theta, for the total-Lagrangian form.
//!
//! The energy of a unit of reference volume is theta^3 w(E_e), w = K/2 tr(E_e)^2 + mu dev(E_e) : dev(E_e), and the stresses
//! below are its derivatives, so that forces from them keep energy. Plane strain: F_zz = 1.

use super::small::{determinant, inverse};
use crate::{IsotropicModuli, SymmetricTensor};
use nalgebra::SMatrix;

/// E_e = (F^T F/theta^2 - 1)/2 \[-\]: the strain beyond free thermal expansion, in the axes of the reference.
///
/// `stretch` theta as from [`ThermalExpansion::stretch`](crate::ThermalExpansion::stretch). A body that expands freely has
/// F = theta Q and therefore no strain, however large theta is.
#[inline]
#[must_use]
pub fn elastic_strain<const D: usize>(deformation: &SMatrix<f64, D, D>, stretch: f64) -> SymmetricTensor<D> {
    let inverse_square = 1.0 / (stretch * stretch);
    let squared = deformation.transpose() * deformation * inverse_square;
    let out_of_plane = if D == 2 { 0.5 * (inverse_square - 1.0) } else { 0.0 };
    SymmetricTensor { in_plane: (squared - SMatrix::identity()) * 0.5, out_of_plane }
}

/// S = K tr(E) + 2 mu dev(E) \[Pa\], the second Piola-Kirchhoff stress (St. Venant and Kirchhoff; Bonet and Wood 2008, 6.3).
#[inline]
#[must_use]
pub fn second_stress<const D: usize>(
    strain: &SymmetricTensor<D>,
    moduli: &IsotropicModuli,
) -> SymmetricTensor<D> {
    SymmetricTensor::isotropic(moduli.lambda_pa() * strain.trace()) + *strain * (2.0 * moduli.shear_pa())
}

/// The strain E with S = C : E for a given stress S \[-\]: the inverse of [`second_stress`].
///
/// The negative of it, as inelastic strain, puts a body under the stress S in its reference: so is stress carried over when
/// a body gets a new reference.
#[inline]
#[must_use]
pub fn strain_of_stress<const D: usize>(
    stress: &SymmetricTensor<D>,
    moduli: &IsotropicModuli,
) -> SymmetricTensor<D> {
    SymmetricTensor::isotropic(stress.trace() / (9.0 * moduli.bulk_pa()))
        + stress.deviator() * (0.5 / moduli.shear_pa())
}

/// P = theta F S \[Pa\], the first Piola-Kirchhoff stress: force per reference area, the derivative of the energy to F.
#[inline]
#[must_use]
pub fn first_stress<const D: usize>(
    deformation: &SMatrix<f64, D, D>,
    stretch: f64,
    second_stress: &SymmetricTensor<D>,
) -> SMatrix<f64, D, D> {
    deformation * second_stress.in_plane * stretch
}

/// sigma = theta F S F^T/det F \[Pa\], the Cauchy stress: force per present area; zz with F_zz = 1 in plane strain.
#[inline]
#[must_use]
pub fn cauchy_stress<const D: usize>(
    deformation: &SMatrix<f64, D, D>,
    stretch: f64,
    second_stress: &SymmetricTensor<D>,
) -> SymmetricTensor<D> {
    let scale = stretch / determinant(deformation);
    SymmetricTensor {
        in_plane: deformation * second_stress.in_plane * deformation.transpose() * scale,
        out_of_plane: second_stress.out_of_plane * scale,
    }
}

/// S = det F F^-1 sigma F^-T/theta \[Pa\]: the inverse of [`cauchy_stress`].
#[inline]
#[must_use]
pub fn second_stress_of_cauchy<const D: usize>(
    deformation: &SMatrix<f64, D, D>,
    stretch: f64,
    cauchy_stress: &SymmetricTensor<D>,
) -> SymmetricTensor<D> {
    let back = inverse(deformation);
    let scale = determinant(deformation) / stretch;
    SymmetricTensor {
        in_plane: back * cauchy_stress.in_plane * back.transpose() * scale,
        out_of_plane: cauchy_stress.out_of_plane * scale,
    }
}

/// theta^3 w(E) \[J/m^3\]: elastic energy of a unit of reference volume.
#[inline]
#[must_use]
pub fn elastic_energy<const D: usize>(
    strain: &SymmetricTensor<D>,
    stretch: f64,
    moduli: &IsotropicModuli,
) -> f64 {
    let trace = strain.trace();
    let density = 0.5 * moduli.lambda_pa() * trace * trace + moduli.shear_pa() * strain.norm_squared();
    stretch.powi(3) * density
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Matrix3};
    use proptest::prelude::*;

    fn moduli() -> IsotropicModuli {
        IsotropicModuli::from_young_and_poisson(70e9, 0.33).unwrap()
    }

    fn cauchy<const D: usize>(deformation: &SMatrix<f64, D, D>, stretch: f64) -> SymmetricTensor<D> {
        cauchy_stress(deformation, stretch, &second_stress(&elastic_strain(deformation, stretch), &moduli()))
    }

    #[test]
    fn a_free_hot_and_turned_block_has_no_stress() {
        let turn = Matrix3::new(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);
        let stretch = 1.0129;
        assert!(cauchy(&(turn * stretch), stretch).norm_squared().sqrt() < 1e-13 * 70e9);
    }

    #[test]
    fn held_block_and_held_plane_have_the_stress_of_linear_theory() {
        // alpha dT = 1e-6: held in all directions -E e/(1 - 2 nu); free in the plane, held across it -E e.
        let e: f64 = 1e-6;
        let held = cauchy(&Matrix2::identity(), 1.0 + e);
        let expected = -70e9 * e / 0.34;
        assert!((held.in_plane[(0, 0)] / expected - 1.0).abs() < 1e-5);
        assert!((held.out_of_plane / expected - 1.0).abs() < 1e-5);
        let free = cauchy(&(Matrix2::identity() * (1.0 + 1.33 * e)), 1.0 + e);
        assert!(free.in_plane.norm() < 1e-4 * 70e9 * e);
        assert!((free.out_of_plane / (-70e9 * e) - 1.0).abs() < 1e-4);
    }

    proptest! {
        #[test]
        fn the_first_stress_is_the_slope_of_the_energy(
            entries in prop::array::uniform9(-0.05..0.05_f64), stretch in 0.97..1.03_f64,
        ) {
            let moduli = moduli();
            let energy = |f: &Matrix3<f64>| elastic_energy(&elastic_strain(f, stretch), stretch, &moduli);
            let f = Matrix3::identity() + Matrix3::from_row_slice(&entries);
            let stress = first_stress(&f, stretch, &second_stress(&elastic_strain(&f, stretch), &moduli));
            let step = 1e-5;
            for k in 0..9 {
                let (mut above, mut below) = (f, f);
                above[k] += step;
                below[k] -= step;
                let slope = (energy(&above) - energy(&below)) / (2.0 * step);
                prop_assert!((slope - stress[k]).abs() < 1e-8 * 70e9);
            }
        }

        #[test]
        fn strain_and_stress_lead_to_each_other(entries in prop::array::uniform4(-1e-3..1e-3_f64)) {
            let [xx, yy, xy, out_of_plane] = entries;
            let strain = SymmetricTensor { in_plane: Matrix2::new(xx, xy, xy, yy), out_of_plane };
            let back = strain_of_stress(&second_stress(&strain, &moduli()), &moduli());
            prop_assert!((back - strain).norm_squared().sqrt() < 1e-17);
            let f = Matrix2::new(1.1, 0.2, -0.3, 0.9);
            let again = second_stress_of_cauchy(&f, 1.02, &cauchy_stress(&f, 1.02, &strain));
            prop_assert!((again - strain).norm_squared().sqrt() < 1e-17);
        }

        #[test]
        fn cauchy_stress_turns_with_the_body(entries in prop::array::uniform4(-0.05..0.05_f64), angle in 0.0..6.0_f64) {
            let turn = Matrix2::new(angle.cos(), -angle.sin(), angle.sin(), angle.cos());
            let f = Matrix2::identity() + Matrix2::from_row_slice(&entries);
            let expected = turn * cauchy(&f, 1.01).in_plane * turn.transpose();
            prop_assert!((cauchy(&(turn * f), 1.01).in_plane - expected).norm() < 1e-14 * 70e9);
        }
    }
}
