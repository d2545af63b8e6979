//! Absorption: which share of the light stays, and at which depth.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use crate::error::{Error, require};

/// Where the light is absorbed that is not reflected. Depth z is counted from the surface into the material.
///
/// In a case file: `Surface(absorptivity: 0.35)` or
/// `BeerLambert(absorptivity: 0.35, absorption_coefficient_per_m: 1e4)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Absorption {
    /// At the surface itself; right for metals, which absorb 95 % within a micrometre (Hu and Eberhard 2015,
    /// 2.4).
    Surface {
        /// Absorbed over incident power, 1 - Gamma, between 0 and 1.
        absorptivity: f64,
    },
    /// In depth, I(z) = (1 - Gamma) I_0 exp(-A z) (Beer-Lambert; Hu and Eberhard 2015, eq. 22).
    BeerLambert {
        /// Power that enters over incident power, 1 - Gamma, between 0 and 1.
        absorptivity: f64,
        /// Absorption coefficient A (1/m).
        absorption_coefficient_per_m: f64,
    },
}

impl Absorption {
    /// Share of the incident power that is not reflected, 1 - Gamma.
    #[must_use]
    pub fn absorptivity(&self) -> f64 {
        match *self {
            Self::Surface { absorptivity } | Self::BeerLambert { absorptivity, .. } => absorptivity,
        }
    }

    /// Share of the incident power that is reflected, Gamma.
    #[must_use]
    pub fn reflectivity(&self) -> f64 {
        1.0 - self.absorptivity()
    }

    /// Share of the entering power that is absorbed between the depths `z0_m` and `z1_m`, `z0_m <= z1_m`:
    /// exp(-A z0) - exp(-A z1), or all of it in the layer that holds z = 0 from above, `z0_m <= 0 < z1_m`.
    /// Depths above the surface (negative) absorb nothing.
    #[must_use]
    pub fn share_between(&self, z0_m: f64, z1_m: f64) -> f64 {
        match *self {
            Self::Surface { .. } => f64::from(u8::from(z0_m <= 0.0 && z1_m > 0.0)),
            Self::BeerLambert { absorption_coefficient_per_m, .. } => {
                let (z0_m, z1_m) = (z0_m.max(0.0), z1_m.max(0.0));
                // expm1 keeps all digits in layers much thinner than 1/A.
                let beyond = -(-absorption_coefficient_per_m * (z1_m - z0_m)).exp_m1();
                (-absorption_coefficient_per_m * z0_m).exp() * beyond
            }
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the absorptivity is not in 0..=1 or the coefficient is not positive.
    pub fn validate(&self) -> Result<(), Error> {
        let absorptivity = self.absorptivity();
        let accepted = "a share between 0 and 1";
        require((0.0..=1.0).contains(&absorptivity), "absorptivity", absorptivity, accepted)?;
        if let Self::BeerLambert { absorption_coefficient_per_m: found, .. } = *self {
            let accepted = "a positive number per metre";
            require(found.is_finite() && found > 0.0, "absorption_coefficient_per_m", found, accepted)?;
        }
        Ok(())
    }
}

/// Absorption coefficient A = 4 pi n kappa / lambda_0 (1/m) (Hu and Eberhard 2015, below eq. 22).
///
/// `refractive_index` is n, `absorbance` is kappa as the paper writes it (extinction coefficient k = n
/// kappa), and `wavelength_m` the wavelength in vacuum (m), not zero.
#[must_use]
pub fn absorption_coefficient_per_m(refractive_index: f64, absorbance: f64, wavelength_m: f64) -> f64 {
    4.0 * PI * refractive_index * absorbance / wavelength_m
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const DEEP: Absorption = Absorption::BeerLambert { absorptivity: 0.4, absorption_coefficient_per_m: 1e4 };

    proptest! {
        #[test]
        fn layers_add_up(coefficient in 1e2..1e7_f64, thickness in 1e-7..1e-3_f64, layers in 1..40_usize) {
            let absorption_coefficient_per_m = coefficient;
            let law = Absorption::BeerLambert { absorptivity: 1.0, absorption_coefficient_per_m };
            let depth = |i: usize| thickness * i as f64;
            let sum: f64 = (0..layers).map(|i| law.share_between(depth(i), depth(i + 1))).sum();
            prop_assert!((sum - (1.0 - (-coefficient * depth(layers)).exp())).abs() < 1e-13);
        }
    }

    #[test]
    fn thin_layer_absorbs_a_times_thickness() {
        // 1 - exp(-x) = x - x^2/2 for x = 1e-9; a plain difference would keep only seven digits.
        let share = DEEP.share_between(0.0, 1e-13);
        assert!((share / (1e-9 - 0.5e-18) - 1.0).abs() < 1e-14, "{share}");
    }

    #[test]
    fn ninety_five_percent_within_three_lengths() {
        assert!((DEEP.share_between(0.0, 20.0_f64.ln() * 1e-4) - 0.95).abs() < 1e-14);
        assert_eq!(DEEP.share_between(-1.0, f64::INFINITY), 1.0);
        assert_eq!(DEEP.share_between(-1.0, -0.5), 0.0);
    }

    #[test]
    fn surface_deposit_is_in_the_top_layer() {
        let law = Absorption::Surface { absorptivity: 0.35 };
        assert_eq!([law.share_between(0.0, 1e-5), law.share_between(1e-5, 2e-5)], [1.0, 0.0]);
        assert_eq!([law.share_between(-1e-5, 0.0), law.share_between(-1e-5, 1e-5)], [0.0, 1.0]);
        assert!((law.absorptivity() + law.reflectivity() - 1.0).abs() < 1e-16);
    }

    #[test]
    fn metals_absorb_95_percent_within_a_micrometre() {
        // n kappa = 10 at 1.064 um, as of a good metal: A = 40 pi / 1.064e-6 = 1.18105e8 1/m.
        let coefficient = absorption_coefficient_per_m(2.0, 5.0, 1.064e-6);
        assert!((coefficient / 1.181_050e8 - 1.0).abs() < 1e-6, "{coefficient}");
        let law = Absorption::BeerLambert { absorptivity: 1.0, absorption_coefficient_per_m: coefficient };
        assert!(law.share_between(0.0, 1e-6) > 0.95);
    }

    #[test]
    fn bad_numbers_are_named() {
        let message = Absorption::Surface { absorptivity: 1.2 }.validate().unwrap_err().to_string();
        assert_eq!(message, "absorptivity is 1.2, but must be a share between 0 and 1");
        let law = Absorption::BeerLambert { absorptivity: 0.5, absorption_coefficient_per_m: 0.0 };
        assert!(law.validate().unwrap_err().to_string().starts_with("absorption_coefficient_per_m is 0"));
        assert!(Absorption::Surface { absorptivity: f64::NAN }.validate().is_err());
        assert!(ron::from_str::<Absorption>("Surface(absorptivity: 0.3, depth: 1)").is_err());
    }
}
