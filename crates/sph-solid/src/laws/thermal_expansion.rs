//! Free thermal expansion: one function rho_ref(T), from which everything thermal follows.

use super::table::Table;
use crate::error::{Error, require};

/// Density of the unstressed material over temperature, from its linear expansion coefficient.
///
/// With A(T) the integral of alpha over temperature, rho_ref(T) = rho_0 exp(-3 (A(T) - A(T_0))): a free body stretches by
/// exp(A(T) - A(T_0)) in every direction and its mass stays. The paper's 3 K alpha (T - T_0) (Hu and Eberhard 2015,
/// eq. 5) is the first order of K ln of this density.
#[derive(Debug, Clone, PartialEq)]
pub struct ThermalExpansion {
    density: f64,
    reference_integral: f64,
    coefficient: Table,
}

impl ThermalExpansion {
    /// From the density rho_0 \[kg/m^3\] at `temperature_k` T_0 and nodes (temperature \[K\], alpha \[1/K\]); alpha is
    /// the slope d ln(length)/dT at that temperature, linear between nodes and constant beyond them.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a density that is not positive, an alpha that is negative or above 1e-2;
    /// [`Error::Table`] without nodes or where temperatures do not rise.
    pub fn new(density: f64, temperature_k: f64, nodes: &[(f64, f64)]) -> Result<Self, Error> {
        require(density > 0.0, "density", density, "positive, in kg/m^3")?;
        require(temperature_k >= 0.0, "temperature_k", temperature_k, "a temperature in kelvin")?;
        let accepted = |alpha: f64| (0.0..=1e-2).contains(&alpha);
        let coefficient =
            Table::new("expansion_coefficient", nodes, accepted, "between 0 and 1e-2 per kelvin")?;
        Ok(Self { density, reference_integral: coefficient.integral_to(temperature_k), coefficient })
    }

    /// With the same alpha \[1/K\] at all temperatures.
    ///
    /// # Errors
    /// As [`ThermalExpansion::new`].
    pub fn constant(density: f64, temperature_k: f64, alpha: f64) -> Result<Self, Error> {
        Self::new(density, temperature_k, &[(temperature_k, alpha)])
    }

    /// rho_0 \[kg/m^3\]: the density at the temperature that it was given for.
    #[must_use]
    pub fn density(&self) -> f64 {
        self.density
    }

    /// alpha at `temperature_k` \[1/K\].
    #[must_use]
    pub fn coefficient(&self, temperature_k: f64) -> f64 {
        self.coefficient.at(temperature_k)
    }

    /// rho_ref \[kg/m^3\]: the density of the unstressed material at `temperature_k`.
    #[must_use]
    pub fn reference_density(&self, temperature_k: f64) -> f64 {
        self.density * (-3.0 * self.logarithmic_stretch(temperature_k)).exp()
    }

    /// ln(length at `temperature_k` / length at T_0) \[-\] of the unstressed material.
    #[must_use]
    pub fn logarithmic_stretch(&self, temperature_k: f64) -> f64 {
        self.coefficient.integral_to(temperature_k) - self.reference_integral
    }

    /// theta = (rho_ref(`from_k`)/rho_ref(`to_k`))^(1/3) \[-\]: how much longer the unstressed material is at `to_k`.
    #[must_use]
    pub fn stretch(&self, from_k: f64, to_k: f64) -> f64 {
        (self.logarithmic_stretch(to_k) - self.logarithmic_stretch(from_k)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn aluminium() -> ThermalExpansion {
        ThermalExpansion::new(2700.0, 293.0, &[(293.0, 23.1e-6), (500.0, 26e-6), (850.0, 33e-6)]).unwrap()
    }

    #[test]
    fn the_reference_state_is_met() {
        assert_eq!(aluminium().reference_density(293.0), 2700.0);
        assert_eq!(aluminium().stretch(293.0, 293.0), 1.0);
        assert_eq!(aluminium().coefficient(396.5), 24.55e-6);
    }

    #[test]
    fn a_hundred_kelvin_make_aluminium_longer_by_two_per_mille() {
        let steady = ThermalExpansion::constant(2700.0, 293.0, 23.1e-6).unwrap();
        assert!((steady.stretch(293.0, 393.0) - 1.0 - 2.31e-3 * (1.0 + 0.5 * 2.31e-3)).abs() < 1e-8);
        assert!((steady.reference_density(393.0) - 2700.0 * (1.0 - 3.0 * 2.31e-3)).abs() < 0.1);
    }

    #[test]
    fn bad_values_are_named() {
        let message = |result: Result<ThermalExpansion, Error>| result.unwrap_err().to_string();
        assert!(message(ThermalExpansion::constant(0.0, 293.0, 1e-5)).starts_with("density is 0"));
        assert!(message(ThermalExpansion::constant(1.0, -1.0, 1e-5)).starts_with("temperature_k is -1"));
        let found = message(ThermalExpansion::constant(1.0, 293.0, 23.1));
        assert!(found.starts_with("expansion_coefficient is 23.1"), "{found}");
    }

    proptest! {
        #[test]
        fn mass_stays_when_the_free_body_grows(from in 200.0..900.0_f64, to in 200.0..900.0_f64) {
            let material = aluminium();
            let volume_ratio = material.stretch(from, to).powi(3);
            let mass_ratio = volume_ratio * material.reference_density(to) / material.reference_density(from);
            prop_assert!((mass_ratio - 1.0).abs() < 1e-13);
        }

        #[test]
        fn the_slope_of_the_length_is_alpha(temperature in 200.0..900.0_f64) {
            let step = 1e-3;
            let slope = (aluminium().stretch(temperature - step, temperature + step) - 1.0) / (2.0 * step);
            prop_assert!((slope / aluminium().coefficient(temperature) - 1.0).abs() < 1e-5);
        }
    }
}
