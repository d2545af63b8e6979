//! A Gaussian spot that moves over a half space, in its steady state (Eagar and Tsai, Welding Journal 62, 1983).

use super::numeric::integral;
use std::f64::consts::{PI, TAU};

/// Decades of time do not matter beyond this many times a/v²: the integrand has fallen to exp(-t v²/(4 a)).
const LONGEST: f64 = 200.0;

/// q = Q/(2 pi s²) exp(-r²/(2 s²)), moving along +x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingGaussian {
    /// Power Q.
    pub power: f64,
    /// Standard deviation s.
    pub deviation: f64,
    /// Speed v.
    pub speed: f64,
    /// Conductivity k.
    pub conductivity: f64,
    /// Diffusivity a.
    pub diffusivity: f64,
}

impl MovingGaussian {
    /// Rise at a place relative to the beam, x ahead of it and z below the surface.
    pub fn rise(&self, place: [f64; 3]) -> f64 {
        let seconds = LONGEST * self.diffusivity / (self.speed * self.speed);
        self.rise_after(place, seconds)
    }

    /// The same when the beam has moved for `time` only.
    ///
    /// Heat left `t` ago at x = -v t has spread to s² + 2 a t along the surface and 2 a t below it; t = u².
    pub fn rise_after(&self, [x, y, z]: [f64; 3], time: f64) -> f64 {
        let integrand = |u: f64| {
            let age = u * u;
            let spread = self.deviation * self.deviation + 2.0 * self.diffusivity * age;
            let along = ((x + self.speed * age).powi(2) + y * y) / (2.0 * spread);
            let below = z * z / (4.0 * self.diffusivity * age);
            2.0 * (-along - below).exp() / (TAU * spread)
        };
        let capacity = self.conductivity / self.diffusivity;
        let layer = 2.0 / (4.0 * PI * self.diffusivity).sqrt();
        self.power / capacity * layer * integral(integrand, 0.0, time.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::super::SurfaceGaussian;
    use super::*;

    const UNIT: MovingGaussian =
        MovingGaussian { power: 1.0, deviation: 1.0, speed: 1.0, conductivity: 1.0, diffusivity: 1.0 };

    #[test]
    fn printed_values() {
        let printed = [
            ([0.0, 0.0, 0.0], 0.14562044),
            ([-1.0, 0.0, 0.0], 0.13072460),
            ([0.0, 1.0, 0.0], 0.10630917),
            ([0.0, 0.0, 1.0], 0.05375322),
        ];
        for (place, value) in printed {
            assert!((UNIT.rise(place) - value).abs() < 6e-9, "{place:?}: {}", UNIT.rise(place));
        }
    }

    #[test]
    fn at_rest_it_is_the_spot() {
        let slow = MovingGaussian { speed: 1e-9, ..UNIT };
        let spot =
            SurfaceGaussian { power: 1.0, radius: 2f64.sqrt(), conductivity: 1.0, diffusivity: 1.0 };
        let found = slow.rise_after([0.3, 0.4, 0.2], 2.0);
        assert!((found / spot.rise(0.5, 0.2, 2.0) - 1.0).abs() < 1e-8);
    }
}
