//! Evaporation from a free face into air.

use crate::error::Error;

/// Molar gas constant \[J/(mol K)\] (CODATA 2018).
const GAS_CONSTANT: f64 = 8.314_462_618;

/// Pressure at which a boiling point is given \[Pa\].
const ATMOSPHERE: f64 = 101_325.0;

/// Share of the vapour that does not come back (Knight 1979, for vapour that leaves with the speed of sound).
const ESCAPING: f64 = 0.82;

/// Recoil of the vapour over its saturation pressure (Anisimov 1968).
const RECOIL: f64 = 0.54;

/// A melt that evaporates: p_sat(T) = p_0 exp(L M/R (1/T_b - 1/T)) (Clausius and Clapeyron), of which
/// j = 0.82 p_sat sqrt(M/(2 pi R T)) leaves (Hertz 1882, Knudsen 1915, Knight 1979) and takes L j of heat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaporation {
    boiling: f64,
    heat: f64,
    /// L M/R \[K\].
    steepness: f64,
    /// 0.82 sqrt(M/(2 pi R)).
    flow: f64,
}

impl Evaporation {
    /// Evaporation of a melt with a boiling point T_b \[K\] at one atmosphere, a heat of evaporation L \[J/kg\] and a molar mass M
    /// \[kg/mol\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value that is not positive and finite.
    pub fn new(boiling: f64, heat: f64, molar_mass: f64) -> Result<Self, Error> {
        let checks = [
            ("boiling", boiling, "a temperature above 0 K"),
            ("heat", heat, "a heat above 0 J/kg"),
            ("molar_mass", molar_mass, "a mass above 0 kg/mol"),
        ];
        if let Some(&(field, found, accepted)) =
            checks.iter().find(|(_, value, _)| !(*value > 0.0 && value.is_finite()))
        {
            return Err(Error::OutOfRange { field, found, accepted });
        }
        Ok(Self {
            boiling,
            heat,
            steepness: heat * molar_mass / GAS_CONSTANT,
            flow: ESCAPING * (molar_mass / (2.0 * std::f64::consts::PI * GAS_CONSTANT)).sqrt(),
        })
    }

    /// Boiling point at one atmosphere \[K\].
    pub fn boiling(&self) -> f64 {
        self.boiling
    }

    /// L M/R \[K\]: by how much p_sat changes with temperature, d ln p_sat/dT = L M/(R T²).
    pub fn steepness(&self) -> f64 {
        self.steepness
    }

    /// Saturation pressure \[Pa\] at a temperature \[K\].
    #[inline]
    pub fn saturation_pressure(&self, temperature: f64) -> f64 {
        ATMOSPHERE * (self.steepness * (1.0 / self.boiling - 1.0 / temperature)).exp()
    }

    /// Mass that leaves an area \[kg/(m² s)\] at a temperature \[K\].
    #[inline]
    pub fn mass_flux(&self, temperature: f64) -> f64 {
        self.flow * self.saturation_pressure(temperature) / temperature.sqrt()
    }

    /// Heat that it takes \[W/m²\].
    #[inline]
    pub fn flux(&self, temperature: f64) -> f64 {
        self.heat * self.mass_flux(temperature)
    }

    /// d(flux)/dT \[W/(m² K)\].
    #[inline]
    pub fn slope(&self, temperature: f64) -> f64 {
        self.flux(temperature) * (self.steepness / temperature - 0.5) / temperature
    }

    /// Pressure of the leaving vapour on the melt \[Pa\].
    #[inline]
    pub fn recoil_pressure(&self, temperature: f64) -> f64 {
        RECOIL * self.saturation_pressure(temperature)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn aluminium() -> Evaporation {
        Evaporation::new(2790.0, 1.09e7, 0.02698).unwrap()
    }

    #[test]
    fn a_boiling_surface_has_the_pressure_of_the_air() {
        let law = aluminium();
        assert!((law.saturation_pressure(2790.0) / 101_325.0 - 1.0).abs() < 1e-14);
        // 0.82 p sqrt(M/(2 pi R T)): 35.74 kg/(m2 s), and 390 MW/m2.
        assert!((law.mass_flux(2790.0) - 35.743).abs() < 0.02, "{}", law.mass_flux(2790.0));
        assert!((law.flux(2790.0) / 3.896e8 - 1.0).abs() < 1e-3);
        assert!((law.flux(2000.0) / 3.08e6 - 1.0).abs() < 1e-3);
        assert!((law.recoil_pressure(2790.0) - 0.54 * 101_325.0).abs() < 1e-9);
        // Tables of vapour pressure: 100 Pa at 1817 K, 10 kPa at 2364 K.
        assert!((law.saturation_pressure(1817.0) / 100.0 - 1.0).abs() < 0.2);
        assert!((law.saturation_pressure(2364.0) / 1e4 - 1.0).abs() < 0.05);
    }

    #[test]
    fn what_is_not_positive_is_refused_by_name() {
        for (field, law) in [
            ("boiling", Evaporation::new(0.0, 1e7, 0.027)),
            ("heat", Evaporation::new(2790.0, -1e7, 0.027)),
            ("molar_mass", Evaporation::new(2790.0, 1e7, f64::NAN)),
        ] {
            assert!(law.unwrap_err().to_string().contains(field));
        }
    }

    proptest! {
        #[test]
        fn slope_is_the_derivative(t in 1200.0..4000.0f64) {
            let (law, step) = (aluminium(), 1e-2);
            let numeric = (law.flux(t + step) - law.flux(t - step)) / (2.0 * step);
            prop_assert!((law.slope(t) / numeric - 1.0).abs() < 1e-6);
        }
    }
}
