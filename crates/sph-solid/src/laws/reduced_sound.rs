//! Slower sound for longer steps, with the stress reported in true units.

use crate::error::{Error, require};
use crate::{IsotropicModuli, SymmetricTensor};

/// True moduli beside those that the solver computes with.
///
/// K_eff = rho_0 c_0^2 stands in every mechanical term, thermal expansion included, and mu_eff keeps Poisson's ratio.
/// Thermal strain and everything that is driven by it alone is then right, stress comes out smaller by K_eff/K and is scaled
/// back for output; gravity, pressure of the melt and other loads make K/K_eff times too much strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedSound {
    real: IsotropicModuli,
    effective: IsotropicModuli,
}

impl ReducedSound {
    /// Nothing reduced: the solver computes with the true moduli.
    #[must_use]
    pub fn none(moduli: IsotropicModuli) -> Self {
        Self { real: moduli, effective: moduli }
    }

    /// Reduces sqrt(K/rho) to `sound_speed` c_0 \[m/s\] at `density` \[kg/m^3\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the speed is not positive or above the true one, or the density not positive.
    pub fn to_speed(moduli: IsotropicModuli, density: f64, sound_speed: f64) -> Result<Self, Error> {
        require(density > 0.0, "density", density, "positive, in kg/m^3")?;
        let scale = density * sound_speed * sound_speed / moduli.bulk_pa();
        let holds = sound_speed > 0.0 && scale <= 1.0 + 1e-12;
        require(holds, "sound_speed", sound_speed, "above 0 and at most sqrt(K/rho), in m/s")?;
        let effective =
            IsotropicModuli::from_bulk_and_shear(scale * moduli.bulk_pa(), scale * moduli.shear_pa())?;
        Ok(Self { real: moduli, effective })
    }

    /// The true moduli: for the heat of deformation and for reports.
    #[must_use]
    pub fn real(&self) -> &IsotropicModuli {
        &self.real
    }

    /// The moduli of the solver.
    #[must_use]
    pub fn effective(&self) -> &IsotropicModuli {
        &self.effective
    }

    /// K_eff/K \[-\], at most 1. A true stress times it is the solver's: so for the yield stress.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.effective.bulk_pa() / self.real.bulk_pa()
    }

    /// The true stress \[Pa\] for a stress of the solver.
    #[must_use]
    pub fn reported<const D: usize>(&self, stress: &SymmetricTensor<D>) -> SymmetricTensor<D> {
        *stress * (1.0 / self.scale())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pressure_wave_speed;

    fn aluminium() -> IsotropicModuli {
        IsotropicModuli::from_young_and_poisson(70e9, 0.33).unwrap()
    }

    #[test]
    fn poisson_stays_and_all_waves_slow_down_alike() {
        let reduced = ReducedSound::to_speed(aluminium(), 2700.0, 50.0).unwrap();
        assert!((reduced.effective().bulk_pa() - 6.75e6).abs() < 1e-6);
        assert!((reduced.effective().poisson() - 0.33).abs() < 1e-12);
        let ratio =
            pressure_wave_speed(reduced.effective(), 2700.0) / pressure_wave_speed(&aluminium(), 2700.0);
        assert!((ratio * ratio / reduced.scale() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_held_body_reports_its_true_thermal_stress() {
        let reduced = ReducedSound::to_speed(aluminium(), 2700.0, 50.0).unwrap();
        let solver = SymmetricTensor::<2>::isotropic(-3.0 * reduced.effective().bulk_pa() * 2.31e-3);
        let reported = reduced.reported(&solver);
        assert!((reported.out_of_plane + 475.6e6).abs() < 0.1e6, "{reported:?}");
        assert_eq!(ReducedSound::none(aluminium()).reported(&solver), solver);
    }

    #[test]
    fn a_speed_above_the_true_one_is_refused() {
        let error = ReducedSound::to_speed(aluminium(), 2700.0, 6000.0).unwrap_err().to_string();
        assert!(error.starts_with("sound_speed is 6000"), "{error}");
        assert!(ReducedSound::to_speed(aluminium(), 2700.0, 0.0).is_err());
    }
}
