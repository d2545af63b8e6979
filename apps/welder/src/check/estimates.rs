//! Estimates of a weld by formulas: constant properties of the solid at the start, no latent heat, a half space or a slab.
//!
//! They say what an effect can cost at most, relative to the rise under the beam, before anything is run.

use crate::verify::exact::{SurfaceGaussian, plane_flux_rise, top_hat_rise};
use libm::erfc;
use std::f64::consts::PI;

/// Stefan-Boltzmann constant \[W/(m² K⁴)\].
const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// What the estimates are made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scales {
    /// Temperature at the start \[K\].
    pub(super) start: f64,
    /// Conductivity \[W/(m K)\].
    pub(super) conductivity: f64,
    /// Diffusivity \[m²/s\].
    pub(super) diffusivity: f64,
    /// Largest absorbed power \[W\].
    pub(super) power: f64,
    /// 1/e radius of a Gaussian beam, radius of a top-hat \[m\].
    pub(super) radius: f64,
    /// Whether the beam is a top-hat.
    pub(super) top_hat: bool,
    /// How long the light is on \[s\].
    pub(super) lit: f64,
    /// Largest speed of the beam \[m/s\].
    pub(super) speed: f64,
    /// Thickness of the part \[m\].
    pub(super) thickness: f64,
}

impl Scales {
    /// Rise under the resting beam when the light goes off: Carslaw and Jaeger (1959), 10.4 and 10.5.
    pub(super) fn peak_rise(&self) -> f64 {
        let Self { power, radius, conductivity, diffusivity, lit, .. } = *self;
        if self.top_hat {
            top_hat_rise(power / (PI * radius.powi(2)), radius, conductivity, diffusivity, lit)
        } else {
            SurfaceGaussian { power, radius, conductivity, diffusivity }.centre_rise(lit)
        }
    }

    /// What an adiabatic bottom adds to the rise under the beam, by mirror images of a point source at 2 n L:
    /// P/(2 pi k L) sum_n erfc(n L / sqrt(a t)) / n (Carslaw and Jaeger (1959), 10.4 eq. 2). A bottom that is
    /// held at its temperature takes less than that away, because the signs alternate.
    pub(super) fn bottom_rise(&self) -> f64 {
        let reach = (self.diffusivity * self.lit).sqrt();
        let images = (1..).map(f64::from).map(|n| erfc(n * self.thickness / reach) / n);
        // The images end where heat has not come yet; each adds less than the one before.
        let sum: f64 = images.take_while(|&image| image > 1e-12).sum();
        self.power / (2.0 * PI * self.conductivity * self.thickness) * sum
    }

    /// Largest share of the rise that a coefficient of heat transfer \[W/(m² K)\] of the top face takes away: the whole face
    /// loses what its hottest point does, the flux h times the peak rise. Half space, Carslaw and Jaeger (1959), 2.9 eq. 8;
    /// where the heat has come through, a slab with an adiabatic bottom, 3.8 eq. 3, without its decaying terms.
    pub(super) fn losses_share(&self, coefficient: f64) -> f64 {
        let fourier = self.diffusivity * self.lit / self.thickness.powi(2);
        if fourier < 0.3 {
            plane_flux_rise(coefficient, self.conductivity, self.diffusivity, self.lit)
        } else {
            coefficient * self.thickness / self.conductivity * (fourier + 1.0 / 3.0)
        }
    }

    /// Biot number h r / k of the beam.
    pub(super) fn biot(&self, coefficient: f64) -> f64 {
        coefficient * self.radius / self.conductivity
    }

    /// Peclet number v r / a of the beam.
    pub(super) fn peclet(&self) -> f64 {
        self.speed * self.radius / self.diffusivity
    }

    /// Rise one radius ahead of a moving point source over that one radius behind it, exp(-Pe): Rosenthal, Trans. ASME 68,
    /// 849-866 (1946).
    pub(super) fn ahead_over_behind(&self) -> f64 {
        (-self.peclet()).exp()
    }
}

/// Coefficient of radiation \[W/(m² K)\] between a surface and its surroundings, eps sigma (T⁴ - Ta⁴) / (T - Ta).
pub(super) fn radiation_coefficient(emissivity: f64, surface: f64, ambient: f64) -> f64 {
    emissivity * STEFAN_BOLTZMANN * (surface.powi(2) + ambient.powi(2)) * (surface + ambient)
}

/// Thermoelastic coupling E alpha² T (1 + nu) / (rho c (1 - nu) (1 - 2 nu)), the share by which a body that strains stores
/// more heat: Boley and Weiner, Theory of Thermal Stresses (1960).
pub(super) fn coupling(young: f64, poisson: f64, expansion: f64, temperature: f64, heat: f64) -> f64 {
    young * expansion.powi(2) * temperature * (1.0 + poisson)
        / (heat * (1.0 - poisson) * (1.0 - 2.0 * poisson))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPOT: Scales = Scales {
        start: 293.0,
        conductivity: 200.0,
        diffusivity: 8e-5,
        power: 500.0,
        radius: 0.4e-3,
        top_hat: false,
        lit: 0.015,
        speed: 0.0,
        thickness: 3e-3,
    };

    #[test]
    fn a_long_gaussian_and_a_long_top_hat_reach_their_steady_rises() {
        let long = Scales { lit: 1e6, ..SPOT };
        let steady = 500.0 / (2.0 * PI.sqrt() * 0.4e-3 * 200.0);
        assert!((long.peak_rise() / steady - 1.0).abs() < 1e-4);
        let disc = Scales { top_hat: true, ..long };
        assert!((disc.peak_rise() / (500.0 / (PI * 0.4e-3 * 200.0)) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_bottom_counts_when_heat_has_come_back_from_it() {
        assert!(Scales { thickness: 0.03, ..SPOT }.bottom_rise() < 1e-6);
        // Once through, a thin slab heats up as the logarithm of time: it doubles where the square of time is passed.
        let thin = |lit: f64| Scales { thickness: 0.3e-3, lit, ..SPOT }.bottom_rise();
        let slope = (thin(4.0) - thin(1.0)) / (500.0 / (4.0 * PI * 200.0 * 0.3e-3)) / 4.0f64.ln();
        assert!((slope - 1.0).abs() < 0.02, "{slope}");
    }

    #[test]
    fn the_two_forms_of_the_losses_meet() {
        let at = |fourier: f64| Scales { lit: fourier * 9e-6 / 8e-5, ..SPOT }.losses_share(1000.0);
        assert!((at(0.2999999) / at(0.3000001) - 1.0).abs() < 0.03);
        let plane = 2.0 * 1000.0 * (8e-5f64 * 0.01 / PI).sqrt() / 200.0;
        assert!((Scales { lit: 0.01, ..SPOT }.losses_share(1000.0) / plane - 1.0).abs() < 1e-12);
    }

    #[test]
    fn radiation_is_its_difference_over_the_difference_of_temperatures() {
        let (surface, ambient) = (1800.0f64, 300.0f64);
        let flux = 0.3 * STEFAN_BOLTZMANN * (surface.powi(4) - ambient.powi(4));
        assert!(
            (radiation_coefficient(0.3, surface, ambient) * (surface - ambient) / flux - 1.0).abs() < 1e-12
        );
    }

    /// (3 lambda + 2 mu)² alpha² T / ((lambda + 2 mu) rho c), the form in Lame's constants.
    #[test]
    fn the_coupling_has_two_forms() {
        let (young, poisson) = (7.0e10, 0.33);
        let mu = young / (2.0 * (1.0 + poisson));
        let lambda = 2.0 * mu * poisson / (1.0 - 2.0 * poisson);
        let expected =
            ((3.0 * lambda + 2.0 * mu) * 2.35e-5f64).powi(2) * 293.0 / ((lambda + 2.0 * mu) * 2.43e6);
        assert!((coupling(young, poisson, 2.35e-5, 293.0, 2.43e6) / expected - 1.0).abs() < 1e-12);
    }
}
