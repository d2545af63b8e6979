//! Speeds of elastic waves in an isotropic material; Landau and Lifshitz, Theory of Elasticity (1986),
//! sections 22, 25.

use crate::moduli::IsotropicModuli;

/// Speed of a longitudinal wave in a thin bar, sqrt(E/rho) (m/s); `density` in kg/m^3, positive.
#[must_use]
pub fn bar_speed(moduli: &IsotropicModuli, density: f64) -> f64 {
    (moduli.young_pa() / density).sqrt()
}

/// Speed c_P = sqrt((K + 4 mu/3)/rho) of a pressure wave in the bulk (m/s); `density` in kg/m^3, positive.
/// The fastest of all waves: an explicit step is limited by it, not by sqrt(K/rho).
#[must_use]
pub fn pressure_wave_speed(moduli: &IsotropicModuli, density: f64) -> f64 {
    ((moduli.bulk_pa() + 4.0 / 3.0 * moduli.shear_pa()) / density).sqrt()
}

/// Speed c_S = sqrt(mu/rho) of a shear wave (m/s); `density` in kg/m^3, positive.
#[must_use]
pub fn shear_wave_speed(moduli: &IsotropicModuli, density: f64) -> f64 {
    (moduli.shear_pa() / density).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn aluminium() {
        let moduli = IsotropicModuli::from_young_and_poisson(70e9, 0.33).unwrap();
        assert!((bar_speed(&moduli, 2700.0) - 5091.8).abs() < 0.05);
        assert!((pressure_wave_speed(&moduli, 2700.0) - 6197.8).abs() < 0.05);
        assert!((shear_wave_speed(&moduli, 2700.0) - 3122.0).abs() < 0.05);
    }

    proptest! {
        #[test]
        fn ratio_of_wave_speeds_follows_from_poisson(young in 1e5..1e12_f64, poisson in -0.9..0.49_f64) {
            // (c_P/c_S)^2 = 2 (1 - nu)/(1 - 2 nu).
            let moduli = IsotropicModuli::from_young_and_poisson(young, poisson).unwrap();
            let ratio = pressure_wave_speed(&moduli, 2700.0) / shear_wave_speed(&moduli, 2700.0);
            let expected = 2.0 * (1.0 - poisson) / (1.0 - 2.0 * poisson);
            prop_assert!((ratio * ratio / expected - 1.0).abs() < 1e-12);
        }

        #[test]
        fn pressure_wave_is_the_fastest(
            young in 1e5..1e12_f64, poisson in -0.9..0.49_f64, density in 1.0..2e4_f64,
        ) {
            let moduli = IsotropicModuli::from_young_and_poisson(young, poisson).unwrap();
            let fastest = pressure_wave_speed(&moduli, density) * (1.0 + 1e-14);
            prop_assert!(fastest >= bar_speed(&moduli, density));
            prop_assert!(fastest > shear_wave_speed(&moduli, density));
        }
    }
}
