//! The Jaumann rate of the deviatoric stress and its finite step.

use super::rotation::incremental_rotation;
use crate::SymmetricTensor;
use nalgebra::SMatrix;

/// eps_dot = (L + L^T)/2 \[1/s\], plane strain: no rate out of the plane.
#[inline]
#[must_use]
pub fn strain_rate<const D: usize>(velocity_gradient: &SMatrix<f64, D, D>) -> SymmetricTensor<D> {
    let in_plane = (velocity_gradient + velocity_gradient.transpose()) * 0.5;
    SymmetricTensor { in_plane, out_of_plane: 0.0 }
}

/// dS/dt = 2 mu dev(eps_dot) + S Omega^T + Omega S \[Pa/s\] (Hu and Eberhard 2015, eq. 7; Jaumann 1911), Omega the skew part
/// of the velocity gradient L_ij = dv_i/dx_j.
#[inline]
#[must_use]
pub fn deviator_rate<const D: usize>(
    deviator: &SymmetricTensor<D>,
    velocity_gradient: &SMatrix<f64, D, D>,
    shear_pa: f64,
) -> SymmetricTensor<D> {
    let spin = (velocity_gradient - velocity_gradient.transpose()) * 0.5;
    let turned = spin * deviator.in_plane - deviator.in_plane * spin;
    let elastic = strain_rate(velocity_gradient).deviator() * (2.0 * shear_pa);
    elastic + SymmetricTensor { in_plane: turned, out_of_plane: 0.0 }
}

/// S at the end of a step \[Pa\]: half of 2 mu dt dev(eps_dot) at mid-step, the incremental rotation, and the other half
/// (Hughes and Winget 1980, with the increment split so that the step is of second order).
///
/// Exact for rotations of any size, where adding dt times [`deviator_rate`] makes S grow.
#[inline]
#[must_use]
pub fn advanced_deviator<const D: usize>(
    deviator: &SymmetricTensor<D>,
    mid_gradient: &SMatrix<f64, D, D>,
    shear_pa: f64,
    dt_s: f64,
) -> SymmetricTensor<D> {
    let rotation = incremental_rotation(mid_gradient, dt_s);
    let half = strain_rate(mid_gradient).deviator() * (shear_pa * dt_s);
    let start = *deviator + half;
    let turned = rotation * start.in_plane * rotation.transpose();
    SymmetricTensor { in_plane: turned, out_of_plane: start.out_of_plane } + half
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Matrix3};
    use proptest::prelude::*;

    #[test]
    fn simple_shear_gives_the_sine() {
        // Jaumann's rate under a constant shear rate: S_xy = G sin(gamma), S_xx = G (1 - cos(gamma)) (Dienes 1979).
        let (shear, steps, end) = (26e9, 2000, 3.0);
        let gradient = Matrix2::new(0.0, 1.0, 0.0, 0.0);
        let mut stress = SymmetricTensor::<2>::zero();
        for _ in 0..steps {
            stress = advanced_deviator(&stress, &gradient, shear, end / f64::from(steps));
        }
        assert!((stress.in_plane[(0, 1)] / shear - end.sin()).abs() < 1e-6);
        assert!((stress.in_plane[(0, 0)] / shear - (1.0 - end.cos())).abs() < 1e-6);
        assert_eq!(stress.out_of_plane, 0.0);
    }

    #[test]
    fn plane_compression_loads_the_third_axis() {
        let gradient = Matrix2::new(-1e-3, 0.0, 0.0, 0.0);
        let stress = advanced_deviator(&SymmetricTensor::zero(), &gradient, 1.0, 1.0);
        assert!((stress.out_of_plane - 2.0 / 3.0 * 1e-3).abs() < 1e-18 && stress.trace().abs() < 1e-18);
    }

    proptest! {
        #[test]
        fn the_step_follows_the_rate(
            gradient in prop::array::uniform9(-1.0..1.0_f64), stress in prop::array::uniform6(-1.0..1.0_f64),
        ) {
            let gradient = Matrix3::from_row_slice(&gradient);
            let [xx, yy, zz, xy, xz, yz] = stress;
            let in_plane = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let stress = SymmetricTensor { in_plane, out_of_plane: 0.0 };
            let dt = 1e-6;
            let change = (advanced_deviator(&stress, &gradient, 0.7, dt) - stress) * (1.0 / dt);
            let rate = deviator_rate(&stress, &gradient, 0.7);
            prop_assert!((change - rate).norm_squared().sqrt() < 1e-4);
        }
    }
}
