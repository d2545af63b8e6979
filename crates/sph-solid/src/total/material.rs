//! What a body is made of, and how its numerics are tuned.

use crate::error::{Error, require};
use crate::{IsotropicModuli, ReducedSound, ThermalExpansion, YieldStress};

/// A thermoelastic, optionally yielding material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Density and expansion over temperature.
    pub expansion: ThermalExpansion,
    /// True and computed moduli.
    pub sound: ReducedSound,
    /// True yield stress \[Pa\] over temperature; `None` is elastic for ever.
    pub yield_stress: Option<YieldStress>,
}

impl Material {
    /// An elastic material with its true sound speed that does not expand with temperature.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the density \[kg/m^3\] is not positive.
    pub fn elastic(moduli: IsotropicModuli, density: f64) -> Result<Self, Error> {
        let expansion = ThermalExpansion::constant(density, 293.0, 0.0)?;
        Ok(Self { expansion, sound: ReducedSound::none(moduli), yield_stress: None })
    }

    /// The moduli that the solver computes with.
    #[must_use]
    pub fn solver_moduli(&self) -> &IsotropicModuli {
        self.sound.effective()
    }

    /// Yield stress of the solver at `temperature_k`: the true one times K_eff/K \[Pa\]; infinite without a law.
    #[must_use]
    pub fn solver_yield_pa(&self, temperature_k: f64) -> f64 {
        self.yield_stress.as_ref().map_or(f64::INFINITY, |law| law.at(temperature_k) * self.sound.scale())
    }
}

/// Coefficients that belong to the method, not to the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controls {
    /// Stiffness against zero-energy modes as a share of K + 4 mu/3, or of 6 mu where that is less \[-\]; 0 is none.
    pub hourglass: f64,
    /// Linear artificial viscosity alpha \[-\]; 0 is none and costs nothing.
    pub viscosity: f64,
}

impl Default for Controls {
    /// Hourglass stiffness 0.4, no viscosity: for a Gaussian kernel with h/dx 0.8, in 2-D and 3-D.
    ///
    /// Measured there with 0.1, 0.4 and 0.7 (`tests/bodies`, `examples`): plate between strips, 10 across, 4.9, 2.9, 1.2 % slow;
    /// disc with a hot centre, 10 over the radius, 4.3, 3.6, 5.0 % wrong, 20 over it 1.6, 1.3, 1.5 %. A sphere, 15 over the
    /// radius, is 2.9, 2.8, 2.8 % wrong with 0.3, 0.4, 0.5. From 1 on it is too stiff.
    fn default() -> Self {
        Self { hourglass: 0.4, viscosity: 0.0 }
    }
}

impl Controls {
    /// Refuses coefficients that are negative, and a hourglass stiffness that is known to be too stiff.
    pub(crate) fn check(&self) -> Result<(), Error> {
        require((0.0..=2.0).contains(&self.hourglass), "hourglass", self.hourglass, "from 0 to 2")?;
        require(self.viscosity >= 0.0, "viscosity", self.viscosity, "zero or above")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn yield_stress_is_reduced_with_the_moduli() {
        let moduli = IsotropicModuli::from_young_and_poisson(70e9, 0.33).unwrap();
        let mut material = Material::elastic(moduli, 2700.0).unwrap();
        assert_eq!(material.solver_yield_pa(300.0), f64::INFINITY);
        material.yield_stress = Some(YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap());
        material.sound = ReducedSound::to_speed(moduli, 2700.0, 50.0).unwrap();
        let strain = material.solver_yield_pa(293.0) / material.solver_moduli().young_pa();
        assert!((strain / (90e6 / 70e9) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn controls_out_of_range_are_named() {
        let bad = Controls { hourglass: 3.0, viscosity: 0.0 };
        assert_eq!(bad.check().unwrap_err().to_string(), "hourglass is 3, but must be from 0 to 2");
        assert!(Controls::default().check().is_ok());
    }
}
