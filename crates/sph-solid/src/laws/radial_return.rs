//! J2 plasticity without hardening: the deviatoric stress never exceeds the yield stress.

use crate::SymmetricTensor;

/// What the return to the yield surface did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlasticStep<const D: usize> {
    /// Factor on the trial deviator, 0 to 1 \[-\].
    pub scale: f64,
    /// Increment of the plastic strain tensor \[-\]: deviatoric, along the trial deviator.
    pub strain: SymmetricTensor<D>,
    /// Increment of the equivalent plastic strain sqrt(2/3 e_p : e_p) \[-\].
    pub equivalent: f64,
}

/// Radial return (Wilkins 1964; Simo and Hughes 1998, box 3.1) of the trial deviator S \[Pa\] to sqrt(3/2 S : S) =
/// `yield_pa`, or nothing if it lies inside. The deviator after the step is S less 2 `shear_pa` times the plastic strain.
#[inline]
#[must_use]
pub fn radial_return<const D: usize>(
    trial_deviator: &SymmetricTensor<D>,
    shear_pa: f64,
    yield_pa: f64,
) -> Option<PlasticStep<D>> {
    let norm_squared = 1.5 * trial_deviator.norm_squared();
    if norm_squared <= yield_pa * yield_pa {
        return None;
    }
    let von_mises = norm_squared.sqrt();
    let scale = yield_pa / von_mises;
    let strain = *trial_deviator * ((1.0 - scale) / (2.0 * shear_pa));
    Some(PlasticStep { scale, strain, equivalent: (von_mises - yield_pa) / (3.0 * shear_pa) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix2;
    use proptest::prelude::*;

    const SHEAR: f64 = 26e9;

    fn plane(xx: f64, yy: f64, xy: f64) -> SymmetricTensor<2> {
        SymmetricTensor { in_plane: Matrix2::new(xx, xy, xy, yy), out_of_plane: -xx - yy }
    }

    #[test]
    fn inside_nothing_happens_and_without_strength_all_is_lost() {
        let trial = plane(30e6, -10e6, 5e6);
        assert_eq!(radial_return(&trial, SHEAR, 1.01 * trial.von_mises()), None);
        let step = radial_return(&trial, SHEAR, 0.0).unwrap();
        assert_eq!(step.scale, 0.0);
        assert!((trial - step.strain * (2.0 * SHEAR)).norm_squared() < 1e-12 * trial.norm_squared());
        assert_eq!(radial_return(&SymmetricTensor::<3>::zero(), SHEAR, 0.0), None);
    }

    proptest! {
        #[test]
        fn ends_on_the_surface_with_consistent_strain(
            xx in -1e9..1e9_f64, yy in -1e9..1e9_f64, xy in -1e9..1e9_f64, fraction in 0.01..0.99_f64,
        ) {
            let trial = plane(xx, yy, xy);
            let yield_pa = fraction * trial.von_mises();
            let step = radial_return(&trial, SHEAR, yield_pa).unwrap();
            let end = trial - step.strain * (2.0 * SHEAR);
            prop_assert!((end.von_mises() / yield_pa - 1.0).abs() < 1e-9);
            prop_assert!((end - trial * step.scale).norm_squared() < 1e-18 * trial.norm_squared());
            prop_assert!(step.strain.trace().abs() < 1e-12 * step.equivalent);
            let equivalent = (2.0 / 3.0 * step.strain.norm_squared()).sqrt();
            prop_assert!((equivalent / step.equivalent - 1.0).abs() < 1e-9);
        }
    }
}
