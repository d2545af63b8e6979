//! The Tait equation of state of a weakly compressible fluid.

use crate::error::{Error, require};

/// Pressure (Pa) at a density: p = (rho_0 c^2 / gamma) ((rho/rho_0)^gamma - 1); Tait's law as Monaghan (1994)
/// writes it.
///
/// Densities in kg/m^3, `sound_speed_m_s` is that at the reference density; `gamma` has no unit (7 for a
/// liquid, 1 makes the law linear).
#[inline]
#[must_use]
pub fn tait_pressure(density: f64, reference_density: f64, sound_speed_m_s: f64, gamma: f64) -> f64 {
    // exp_m1 of the logarithm keeps the digits of densities close to the reference.
    let compression = (gamma * (density / reference_density).ln()).exp_m1();
    reference_density * sound_speed_m_s * sound_speed_m_s / gamma * compression
}

/// Density (kg/m^3) at a pressure (Pa), the inverse of [`tait_pressure`]; NaN at or below the pressure of the
/// void,
/// -rho_0 c^2 / gamma.
#[inline]
#[must_use]
pub fn tait_density(pressure_pa: f64, reference_density: f64, sound_speed_m_s: f64, gamma: f64) -> f64 {
    let compression = pressure_pa * gamma / (reference_density * sound_speed_m_s * sound_speed_m_s);
    reference_density * (compression.ln_1p() / gamma).exp()
}

/// Speed of sound sqrt(dp/drho) (m/s) at a density: c (rho/rho_0)^((gamma - 1)/2).
#[inline]
#[must_use]
pub fn tait_sound_speed(density: f64, reference_density: f64, sound_speed_m_s: f64, gamma: f64) -> f64 {
    sound_speed_m_s * (density / reference_density).powf(0.5 * (gamma - 1.0))
}

/// The Tait law with its constants checked once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tait {
    reference_density: f64,
    sound_speed_m_s: f64,
    gamma: f64,
}

impl Tait {
    /// The law for a density without pressure (kg/m^3), the speed of sound there (m/s), and the exponent.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if one of them is not positive and finite, or the exponent below one.
    pub fn new(reference_density: f64, sound_speed_m_s: f64, gamma: f64) -> Result<Self, Error> {
        let accepted = "a positive density in kilograms per cubic metre";
        require(reference_density > 0.0, "reference_density", reference_density, accepted)?;
        let accepted = "a positive speed in metres per second";
        require(sound_speed_m_s > 0.0, "sound_speed_m_s", sound_speed_m_s, accepted)?;
        require(gamma >= 1.0, "gamma", gamma, "an exponent of one or more")?;
        Ok(Self { reference_density, sound_speed_m_s, gamma })
    }

    /// Pressure (Pa) at a density (kg/m^3).
    #[inline]
    #[must_use]
    pub fn pressure(&self, density: f64) -> f64 {
        tait_pressure(density, self.reference_density, self.sound_speed_m_s, self.gamma)
    }

    /// Density (kg/m^3) at a pressure (Pa).
    #[inline]
    #[must_use]
    pub fn density(&self, pressure_pa: f64) -> f64 {
        tait_density(pressure_pa, self.reference_density, self.sound_speed_m_s, self.gamma)
    }

    /// Energy of compression per mass (J/kg) at a density (kg/m^3): the integral of p/rho^2 from the density without
    /// pressure, (c^2/gamma) ((x^(gamma - 1) - 1)/(gamma - 1) + 1/x - 1) for x = rho/rho_0.
    #[must_use]
    pub fn energy(&self, density: f64) -> f64 {
        let (logarithm, less) = ((density / self.reference_density).ln(), self.gamma - 1.0);
        // At gamma = 1 the first term is the logarithm itself.
        let power = if less > 0.0 { (less * logarithm).exp_m1() / less } else { logarithm };
        self.sound_speed_m_s * self.sound_speed_m_s / self.gamma * (power + (-logarithm).exp_m1())
    }

    /// Density (kg/m^3) without pressure.
    #[inline]
    #[must_use]
    pub fn reference_density(&self) -> f64 {
        self.reference_density
    }

    /// Speed of sound (m/s) at the reference density.
    #[inline]
    #[must_use]
    pub fn reference_sound_speed(&self) -> f64 {
        self.sound_speed_m_s
    }

    /// Speed of sound (m/s) at a density (kg/m^3).
    #[inline]
    #[must_use]
    pub fn sound_speed(&self, density: f64) -> f64 {
        tait_sound_speed(density, self.reference_density, self.sound_speed_m_s, self.gamma)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_law() -> impl Strategy<Value = Tait> {
        (100.0..9000.0_f64, 1.0..5000.0_f64, 1.0..7.5_f64)
            .prop_map(|(rho, c, gamma)| Tait::new(rho, c, gamma).unwrap())
    }

    proptest! {
        #[test]
        fn density_inverts_pressure(law in any_law(), ratio in 0.7..1.4_f64) {
            let density = ratio * law.reference_density;
            prop_assert!((law.density(law.pressure(density)) / density - 1.0).abs() < 1e-13);
        }

        #[test]
        fn pressure_rises_with_density(law in any_law(), ratio in 0.5..1.5_f64, step in 1e-8..0.1_f64) {
            let density = ratio * law.reference_density;
            prop_assert!(law.pressure(density * (1.0 + step)) > law.pressure(density));
        }

        #[test]
        fn the_slope_of_energy_is_pressure_over_the_square_of_density(law in any_law(), ratio in 0.7..1.4_f64) {
            let density = ratio * law.reference_density;
            let step = 1e-4 * density;
            let slope = (law.energy(density + step) - law.energy(density - step)) / (2.0 * step);
            let scale = law.sound_speed_m_s.powi(2) / density;
            prop_assert!((slope - law.pressure(density) / density.powi(2)).abs() < 1e-6 * scale);
            prop_assert!(law.energy(density) >= 0.0);
        }

        #[test]
        fn square_of_sound_speed_is_the_slope(law in any_law(), ratio in 0.7..1.4_f64) {
            let density = ratio * law.reference_density;
            let step = 1e-5 * density;
            let slope = (law.pressure(density + step) - law.pressure(density - step)) / (2.0 * step);
            prop_assert!((slope / law.sound_speed(density).powi(2) - 1.0).abs() < 1e-8);
        }
    }

    #[test]
    fn water_at_one_percent_compression() {
        // (1000 * 1480^2 / 7) (1.01^7 - 1), with 1.01^7 = 1.07213535210701 exactly.
        let pressure = tait_pressure(1010.0, 1000.0, 1480.0, 7.0);
        assert!((pressure / (1000.0 * 1480.0 * 1480.0 / 7.0 * 0.072_135_352_107_01) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn tiny_compressions_keep_their_digits() {
        // p = c^2 (drho) (1 + 3 drho/rho + ...) for gamma = 7.
        let pressure = tait_pressure(1000.0 * (1.0 + 2.0_f64.powi(-40)), 1000.0, 1.0, 7.0);
        assert!((pressure / (1000.0 * 2.0_f64.powi(-40)) - 1.0).abs() < 1e-11);
    }

    #[test]
    fn bad_constants_are_named() {
        let message = |rho, c, gamma| Tait::new(rho, c, gamma).unwrap_err().to_string();
        assert!(message(0.0, 1.0, 7.0).starts_with("reference_density is 0"));
        assert!(message(1.0, f64::NAN, 7.0).starts_with("sound_speed_m_s is NaN"));
        assert!(message(1.0, 1.0, 0.5).starts_with("gamma is 0.5"));
        assert!(tait_density(-1.0, 1.0, 1.0, 7.0).is_nan());
    }
}
