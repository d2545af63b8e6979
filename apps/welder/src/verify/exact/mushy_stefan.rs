//! Melting of a half space from a hot wall over a mushy range: three zones with constant properties each, each with the
//! similarity solution of Neumann (Carslaw and Jaeger, 11.2), joined by temperature and flux.

use super::numeric::root;
use libm::{erf, erfc};
use std::f64::consts::PI;

/// A solid at one temperature whose wall is held above the liquidus from time zero on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MushyStefan {
    /// Temperature of the wall.
    pub wall: f64,
    /// Liquidus.
    pub liquidus: f64,
    /// Solidus.
    pub solidus: f64,
    /// Start.
    pub start: f64,
    /// Conductivity of solid, mush and liquid.
    pub conductivity: [f64; 3],
    /// Specific heat capacity of solid, mush (without latent heat) and liquid.
    pub heat_capacity: [f64; 3],
    /// Density, one for all.
    pub density: f64,
    /// Latent heat, released evenly over the mushy range.
    pub latent_heat: f64,
}

impl MushyStefan {
    /// sqrt(a) of solid, mush and liquid.
    fn roots_of_diffusivity(&self) -> [f64; 3] {
        let [solid, mush, liquid] = self.heat_capacity;
        let mush = mush + self.latent_heat / (self.liquidus - self.solidus);
        let capacity = [solid, mush, liquid];
        std::array::from_fn(|zone| (self.conductivity[zone] / (self.density * capacity[zone])).sqrt())
    }

    /// (x/(2 sqrt(t)) of the liquidus, and of the solidus): each flux that leaves one zone enters the next.
    fn similarity(&self) -> (f64, f64) {
        let [solid, mush, liquid] = self.roots_of_diffusivity();
        let flux = |zone: usize, drop: f64, root: f64, at: f64, change: f64| {
            self.conductivity[zone] * drop * 2.0 / (PI.sqrt() * root) * (-(at / root).powi(2)).exp() / change
        };
        let from_liquid = |x: f64| flux(2, self.wall - self.liquidus, liquid, x, erf(x / liquid));
        let mushy = |x: f64, y: f64, at: f64| {
            flux(1, self.liquidus - self.solidus, mush, at, erf(y / mush) - erf(x / mush))
        };
        let into_solid = |y: f64| flux(0, self.solidus - self.start, solid, y, erfc(y / solid));
        let far = 5.0 * mush;
        let solidus_of = |x: f64| root(|y| mushy(x, y, x) - from_liquid(x), x, x + far);
        let surplus = |x: f64| {
            let y = solidus_of(x);
            mushy(x, y, y) - into_solid(y)
        };
        let x = root(surplus, 1e-3 * mush, far);
        (x, solidus_of(x))
    }

    /// Depth of the liquidus and of the solidus at a time.
    pub fn fronts(&self, time: f64) -> [f64; 2] {
        let (liquidus, solidus) = self.similarity();
        [liquidus, solidus].map(|x| 2.0 * x * time.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Stefan;
    use super::*;
    use crate::verify::heat::mushy_stefan::ALUMINIUM;

    #[test]
    fn printed_values() {
        let [liquidus, solidus] = ALUMINIUM.fronts(1e-3);
        assert!((liquidus - 132.93e-6).abs() < 6e-9, "{liquidus}");
        assert!((solidus - 157.70e-6).abs() < 6e-9, "{solidus}");
    }

    #[test]
    fn a_narrow_range_is_the_sharp_front() {
        let sharp = Stefan {
            wall: 1500.0,
            melting: 933.0,
            start: 293.0,
            conductivity: [210.0, 95.0],
            heat_capacity: [1080.0, 1180.0],
            density: 2500.0,
            latent_heat: 3.97e5,
        };
        let narrow = MushyStefan {
            wall: 1500.0,
            liquidus: 933.05,
            solidus: 932.95,
            start: 293.0,
            conductivity: [210.0, 150.0, 95.0],
            heat_capacity: [1080.0, 1130.0, 1180.0],
            density: 2500.0,
            latent_heat: 3.97e5,
        };
        for front in narrow.fronts(1e-3) {
            assert!((front / sharp.front(1e-3) - 1.0).abs() < 1e-3, "{front}");
        }
    }
}
