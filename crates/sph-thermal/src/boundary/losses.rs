//! What a free face loses to its surroundings.

use super::Evaporation;
use crate::error::Error;
use crate::phase::EnthalpyCurve;

/// Newton steps to a surface temperature; three to six are usual.
const LARGEST_ITERATION_COUNT: usize = 60;

/// Stefan-Boltzmann constant \[W/(m² K⁴)\] (CODATA 2018).
pub const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// Heat that a face loses to its surroundings: q = h (T - T_a) + epsilon sigma (T⁴ - T_a⁴), and what evaporates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceLoss {
    convection: f64,
    radiation: f64,
    ambient: f64,
    evaporation: Option<Evaporation>,
}

impl SurfaceLoss {
    /// Losses by a heat transfer coefficient \[W/(m² K)\] and an emissivity (0 to 1) to an ambient temperature \[K\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a negative coefficient, an emissivity outside 0 to 1, or an ambient that is not positive.
    pub fn new(convection: f64, emissivity: f64, ambient: f64) -> Result<Self, Error> {
        let checks = [
            ("convection", convection, convection >= 0.0 && convection.is_finite(), "a number, 0 or above"),
            ("emissivity", emissivity, (0.0..=1.0).contains(&emissivity), "a number from 0 to 1"),
            ("ambient", ambient, ambient > 0.0 && ambient.is_finite(), "a temperature above 0 K"),
        ];
        match checks.iter().find(|check| !check.2) {
            Some(&(field, found, _, accepted)) => Err(Error::OutOfRange { field, found, accepted }),
            None => {
                Ok(Self { convection, radiation: emissivity * STEFAN_BOLTZMANN, ambient, evaporation: None })
            }
        }
    }

    /// The same with evaporation.
    #[must_use]
    pub fn with_evaporation(self, evaporation: Evaporation) -> Self {
        Self { evaporation: Some(evaporation), ..self }
    }

    /// What evaporates, where it does.
    pub fn evaporation(&self) -> Option<&Evaporation> {
        self.evaporation.as_ref()
    }

    /// Heat lost per area \[W/m²\] at a surface temperature \[K\].
    #[inline]
    pub fn flux(&self, temperature: f64) -> f64 {
        let fourth = |t: f64| (t * t) * (t * t);
        self.convection * (temperature - self.ambient)
            + self.radiation * (fourth(temperature) - fourth(self.ambient))
            + self.evaporation.map_or(0.0, |evaporation| evaporation.flux(temperature))
    }

    /// d(flux)/dT \[W/(m² K)\] at a surface temperature \[K\]: what bounds an explicit step.
    #[inline]
    pub fn slope(&self, temperature: f64) -> f64 {
        self.convection
            + 4.0 * self.radiation * temperature.powi(3)
            + self.evaporation.map_or(0.0, |evaporation| evaporation.slope(temperature))
    }
}

/// Surface temperature \[K\] of a body that takes up `entering` and loses heat by `law`: the root of
/// theta(T) = `potential` + (`entering` - q(T)) `depth`, which is one since both sides are monotone.
///
/// `potential` \[W/m\] is what the surface would have without any flux, `depth` \[m\] by how much a flux \[W/m²\] lifts it.
pub fn surface_temperature(
    curve: &EnthalpyCurve,
    potential: f64,
    entering: f64,
    depth: f64,
    law: &SurfaceLoss,
) -> f64 {
    let mut temperature = curve.temperature_at_potential(potential);
    for _ in 0..LARGEST_ITERATION_COUNT {
        let enthalpy = curve.enthalpy_at(temperature);
        let excess = curve.potential(enthalpy) - potential - (entering - law.flux(temperature)) * depth;
        let step = excess / (curve.conductivity(enthalpy) + law.slope(temperature).max(0.0) * depth);
        // Never more than half way down: the fourth power must not be left below zero.
        temperature = (temperature - step).max(0.5 * temperature);
        if step.abs() < 1e-9 * temperature {
            break;
        }
    }
    temperature
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_black_body_at_1000_kelvin() {
        let loss = SurfaceLoss::new(0.0, 1.0, 300.0).unwrap();
        assert!((loss.flux(1000.0) - 5.670_374_419e-8 * (1e12 - 8.1e9)).abs() < 1e-6);
        assert!(SurfaceLoss::new(-1.0, 0.5, 300.0).is_err());
        assert!(SurfaceLoss::new(1.0, 1.5, 300.0).unwrap_err().to_string().contains("emissivity"));
        assert!(SurfaceLoss::new(1.0, 0.5, 0.0).is_err());
    }

    #[test]
    fn a_surface_under_a_strong_beam_stays_near_its_boiling_point() {
        let curve = EnthalpyCurve::continuous(&crate::phase::tests_material()).unwrap();
        let vapour = Evaporation::new(2790.0, 1.09e7, 0.02698).unwrap();
        let dry = SurfaceLoss::new(0.0, 0.0, 293.0).unwrap();
        let (own, entering, depth) = (curve.potential_at(2000.0), 5e9, 5e-5);
        let surface = |law: &SurfaceLoss| surface_temperature(&curve, own, entering, depth, law);
        let (steaming, without) = (surface(&dry.with_evaporation(vapour)), surface(&dry));
        assert!(without > 4500.0 && (2790.0..3500.0).contains(&steaming), "{without} {steaming}");
        let conducted = (curve.potential_at(steaming) - own) / depth;
        assert!(((entering - vapour.flux(steaming)) / conducted - 1.0).abs() < 1e-8);
    }

    proptest! {
        #[test]
        fn the_surface_balances_what_enters_conducts_and_leaves(
            h in 0.0..1e7f64, e in 0.0..1.0f64, own in 300.0..2500.0f64, q in 0.0..5e8f64, z in 1e-6..1e-3f64,
        ) {
            let curve = EnthalpyCurve::continuous(&crate::phase::tests_material()).unwrap();
            let law = SurfaceLoss::new(h, e, 293.0).unwrap();
            let potential = curve.potential_at(own);
            let surface = surface_temperature(&curve, potential, q, z, &law);
            let conducted = (curve.potential_at(surface) - potential) / z;
            let balance = q - law.flux(surface) - conducted;
            let scale = q + law.flux(own).abs() + conducted.abs() + curve.potential_at(own).abs() / z;
            prop_assert!(balance.abs() < 1e-7 * scale, "{surface} K leaves {balance} of {scale}");
            // However strong the loss, it cannot cool the surface below its surroundings.
            prop_assert!(surface > 292.99);
        }

        #[test]
        fn slope_is_the_derivative_and_equilibrium_loses_nothing(
            h in 0.0..1e4f64, e in 0.0..1.0f64, ambient in 200.0..500.0f64, t in 250.0..3000.0f64,
        ) {
            let loss = SurfaceLoss::new(h, e, ambient).unwrap();
            prop_assert!(loss.flux(ambient).abs() < 1e-9);
            let step = 1e-3;
            let numeric = (loss.flux(t + step) - loss.flux(t - step)) / (2.0 * step);
            prop_assert!((loss.slope(t) - numeric).abs() <= 1e-5 * loss.slope(t) + 1e-6);
        }
    }
}
