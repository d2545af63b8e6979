//! Estimates of a weld by formulas: constant properties of the solid at the start, no latent heat, a half space or a slab.
//!
//! They say what an effect can cost at most, relative to the rise under the beam, before anything is run.

use crate::verify::exact::{SurfaceGaussian, top_hat_rise};
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
    /// Distance of the beam from the low and the high side of the part, in x and in y \[m\].
    pub(super) walls: [[f64; 2]; 2],
}

/// Images below this share of the source end a sum.
const FAINT: f64 = 1e-12;

/// Square of the distance over a t from which on an image is that faint.
const FAINTEST: f64 = 28.0;

/// Rings of an integral over the top face.
const RINGS: u32 = 2000;

/// Intervals of an integral over time, an even number.
const INTERVALS: u32 = 400;

/// Heat of a unit source between two adiabatic walls, at the source, when it has spread for a t = `spread` \[m²\]: images at
/// 2 m (d1 + d2) and 2 m (d1 + d2) + 2 d1 (Carslaw and Jaeger (1959), 10.10) \[1/m\].
fn between_walls([low, high]: [f64; 2], spread: f64) -> f64 {
    let image = |distance: f64| (-distance.powi(2) / (4.0 * spread)).exp();
    let period = 2.0 * (low + high);
    let pairs = (0..).map(|m| {
        let shift = f64::from(m) * period;
        image(shift + 2.0 * low) + image(shift + 2.0 * high) + 2.0 * image(shift + period)
    });
    let sum: f64 = pairs.take_while(|&pair| pair > FAINT).sum();
    (1.0 + sum) / (4.0 * PI * spread).sqrt()
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

    /// What an adiabatic bottom adds to the rise under a resting point of heat on the top face of the box, by mirror images in
    /// all faces (Carslaw and Jaeger (1959), 10.4): P a/k times the integral over time of what the sides leave, G_x G_y, and
    /// what the bottom's images add, 2/sqrt(pi a t) sum_n exp(-n²L²/(a t)). A bottom that is held at its temperature takes
    /// less than that away, because the signs alternate.
    pub(super) fn bottom_rise(&self) -> f64 {
        self.images(self.thickness, |spread| {
            let images = (1..).map(|n| (-(f64::from(n) * self.thickness).powi(2) / spread).exp());
            let sum: f64 = images.take_while(|&image| image > FAINT).sum();
            self.between_sides(spread) * 2.0 / (PI * spread).sqrt() * sum
        })
    }

    /// What the sides add to it on a half space: G_x G_y less that of the source itself, times 1/sqrt(pi a t).
    fn sides_rise(&self) -> f64 {
        let nearest = self.walls.as_flattened().iter().fold(f64::INFINITY, |least, &wall| least.min(wall));
        // On an edge the image is the other half of the beam.
        self.images(nearest.max(self.radius), |spread| {
            (self.between_sides(spread) - 1.0 / (4.0 * PI * spread)) / (PI * spread).sqrt()
        })
    }

    fn between_sides(&self, spread: f64) -> f64 {
        self.walls.iter().map(|&walls| between_walls(walls, spread)).product()
    }

    /// P a/k times the integral over time of what images give for a t = `spread` \[m²\], the nearest in a plane at a distance.
    fn images(&self, distance: f64, of: impl Fn(f64) -> f64) -> f64 {
        // Earlier than that no image is felt.
        let first = distance.powi(2) / (FAINTEST * self.diffusivity);
        if first >= self.lit {
            return 0.0;
        }
        // Simpson's rule in the logarithm of time.
        let width = (self.lit / first).ln() / f64::from(INTERVALS);
        let weight = |n: u32| if n == 0 || n == INTERVALS { 1.0 } else { f64::from(2 + 2 * (n % 2)) };
        let node = |n: u32| {
            let time = first * (width * f64::from(n)).exp();
            weight(n) * time * of(self.diffusivity * time)
        };
        self.power * self.diffusivity / self.conductivity * (0..=INTERVALS).map(node).sum::<f64>() * width
            / 3.0
    }

    /// Fall of the rise under the beam by what the top face loses, at most, for the flux \[W/m²\] that it loses at a rise \[K\]: all
    /// the time as hot as when the light goes off. Each ring takes away what an instantaneous source of its strength would
    /// give, erfc(r / sqrt(4 a t)) / (2 pi k r) (Carslaw and Jaeger (1959), 10.4 eq. 2); what bottom and sides add to the
    /// beam's rise they take away by its.
    pub(super) fn losses_fall(&self, flux: impl Fn(f64) -> f64) -> f64 {
        let width = |[low, high]: [f64; 2]| low + high;
        let edge = (width(self.walls[0]) * width(self.walls[1]) / PI).sqrt();
        let (peak, images) = (self.peak_rise(), self.bottom_rise() + self.sides_rise());
        let ring = |n: u32| {
            // Narrow rings near the beam.
            let share = (f64::from(n) + 0.5) / f64::from(RINGS);
            let (radius, ring) = (edge * share.powi(2), 2.0 * edge * share / f64::from(RINGS));
            let away = erfc(radius / (4.0 * self.diffusivity * self.lit).sqrt());
            let lost = flux(self.rise_at_most(radius, away).min(peak) + images);
            ring * lost * (away / self.conductivity + 2.0 * PI * radius * images / self.power)
        };
        (0..RINGS).map(ring).sum()
    }

    /// Rise of the top face at a radius, that of a point with the first correction for the width of the beam.
    fn rise_at_most(&self, radius: f64, away: f64) -> f64 {
        let wider = 1.0 + 0.25 * (self.radius / radius).powi(2);
        self.power * wider * away / (2.0 * PI * self.conductivity * radius)
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
        walls: [[1.0; 2]; 2],
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

    /// Without sides the images are those of a point source, P/(2 pi k L) sum_n erfc(n L/sqrt(a t))/n (Carslaw and Jaeger
    /// (1959), 10.4 eq. 2); a bar that is thin takes up all heat: P t/(rho c V) of the whole less that of a long one.
    #[test]
    fn the_bottom_between_sides_has_its_limits() {
        let thin = Scales { thickness: 0.4e-3, ..SPOT };
        let reach = (thin.diffusivity * thin.lit).sqrt();
        let images = (1..200).map(f64::from).map(|n| erfc(n * thin.thickness / reach) / n);
        let open = thin.power / (2.0 * PI * thin.conductivity * thin.thickness) * images.sum::<f64>();
        assert!((thin.bottom_rise() / open - 1.0).abs() < 1e-4, "{} {open}", thin.bottom_rise());
        let dice = Scales { thickness: 1e-4, walls: [[0.5e-4; 2], [0.3e-4, 0.7e-4]], lit: 1.0, ..SPOT };
        let capacity = dice.conductivity / dice.diffusivity * 1e-12;
        let bar = 2.0 * (dice.diffusivity * dice.lit / PI).sqrt() / dice.conductivity / 1e-8;
        let whole = dice.power * (dice.lit / capacity - bar);
        assert!((dice.bottom_rise() / whole - 1.0).abs() < 1e-3, "{} {whole}", dice.bottom_rise());
    }

    /// A face that loses the same everywhere: a plane source, 2 q sqrt(a t/pi)/k (Carslaw and Jaeger (1959), 2.9 eq. 8); of a
    /// dice of metal the heat is gone from all of it.
    #[test]
    fn even_losses_have_their_limits() {
        let plane = 2.0 * 1000.0 * (8e-5f64 * 0.015 / PI).sqrt() / 200.0;
        let thick = Scales { thickness: 1.0, ..SPOT };
        assert!((thick.losses_fall(|_| 1000.0) / plane - 1.0).abs() < 1e-3);
        let dice = Scales { thickness: 1e-4, walls: [[0.5e-4; 2]; 2], lit: 1.0, ..SPOT };
        let whole = 1000.0 * 1e-8 * dice.lit / (dice.conductivity / dice.diffusivity * 1e-12);
        assert!((dice.losses_fall(|_| 1000.0) / whole - 1.0).abs() < 1e-2);
    }

    #[test]
    fn losses_fall_off_with_the_heat() {
        let thick = Scales { thickness: 1.0, ..SPOT };
        let (peak, even) = (thick.peak_rise(), thick.losses_fall(|_| 1.0));
        let real = thick.losses_fall(|rise| rise / peak);
        assert!(real > 0.1 * even && real < 0.9 * even, "{real} {even}");
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
