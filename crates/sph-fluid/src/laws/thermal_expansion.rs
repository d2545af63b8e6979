//! The density without pressure of a fluid that warmth expands.

use crate::error::{Error, require};

/// rho_ref(T) = rho_0 exp(-beta (T - T_0)), for which beta = -(1/rho) d rho/dT at all temperatures. Pressure and diffusion of density
/// see rho/rho_ref(T) only, so that warm fluid at rest has no pressure of its own and is lighter: buoyancy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThermalExpansion {
    coefficient: f64,
    reference_temperature: f64,
}

impl ThermalExpansion {
    /// beta \[1/K\], three times the linear expansion, and the temperature T_0 \[K\] at which the equation of state's reference density
    /// holds.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value that is not finite.
    pub fn new(coefficient: f64, reference_temperature: f64) -> Result<Self, Error> {
        require(true, "coefficient", coefficient, "finite, in one over kelvin")?;
        require(true, "reference_temperature", reference_temperature, "finite, in kelvin")?;
        Ok(Self { coefficient, reference_temperature })
    }

    /// rho_0/rho_ref(T) \[-\] at a temperature \[K\].
    #[inline]
    #[must_use]
    pub fn stretch(&self, temperature: f64) -> f64 {
        (self.coefficient * (temperature - self.reference_temperature)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn volume_grows_by_beta_of_itself_at_each_kelvin() {
        let law = ThermalExpansion::new(1.2e-4, 933.0).unwrap();
        assert_eq!(law.stretch(933.0), 1.0);
        for temperature in [300.0, 933.0, 2000.0] {
            let slope =
                (law.stretch(temperature + 0.5) - law.stretch(temperature - 0.5)) / law.stretch(temperature);
            assert!((slope / 1.2e-4 - 1.0).abs() < 1e-6, "{slope}");
        }
        assert!(ThermalExpansion::new(f64::NAN, 0.0).is_err());
    }
}
