//! Melting of a half space from a hot wall, two phases (Neumann; Carslaw and Jaeger, 11.2).

use super::numeric::root;
use libm::{erf, erfc};
use std::f64::consts::PI;

/// A solid at one temperature whose wall is held above the melting point from time zero on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stefan {
    /// Temperatures of wall, melting point, and start.
    pub wall: f64,
    /// Melting point.
    pub melting: f64,
    /// Start.
    pub start: f64,
    /// Conductivity of solid and liquid.
    pub conductivity: [f64; 2],
    /// Specific heat capacity of solid and liquid.
    pub heat_capacity: [f64; 2],
    /// Density, one for both.
    pub density: f64,
    /// Latent heat.
    pub latent_heat: f64,
}

impl Stefan {
    fn diffusivity(&self, phase: usize) -> f64 {
        self.conductivity[phase] / (self.density * self.heat_capacity[phase])
    }

    /// lambda of the front X = 2 lambda sqrt(a_l t).
    pub fn lambda(&self) -> f64 {
        let (solid, liquid) = (self.diffusivity(0), self.diffusivity(1));
        let ratio = (liquid / solid).sqrt();
        let supplied = |x: f64| {
            let gradient = (self.wall - self.melting) / (PI * liquid).sqrt();
            self.conductivity[1] * gradient * (-x * x).exp() / erf(x)
        };
        let passed_on = |x: f64| {
            let (gradient, y) = ((self.melting - self.start) / (PI * solid).sqrt(), x * ratio);
            self.conductivity[0] * gradient * (-y * y).exp() / erfc(y)
        };
        let taken = |x: f64| self.density * self.latent_heat * x * liquid.sqrt();
        root(|x| supplied(x) - passed_on(x) - taken(x), 1e-9, 4.0)
    }

    /// Depth of the front at a time.
    pub fn front(&self, time: f64) -> f64 {
        2.0 * self.lambda() * (self.diffusivity(1) * time).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::heat::stefan::ALUMINIUM;

    #[test]
    fn printed_values() {
        assert!((ALUMINIUM.lambda() - 0.34310416).abs() < 6e-9, "{}", ALUMINIUM.lambda());
        assert!((ALUMINIUM.front(1e-3) - 123.14e-6).abs() < 6e-9, "{}", ALUMINIUM.front(1e-3));
    }

    #[test]
    fn one_phase_obeys_its_own_equation() {
        // With the solid at the melting point: sqrt(pi) lambda exp(lambda²) erf(lambda) = c_l (T_w - T_m)/H_f.
        let one_phase = Stefan { start: ALUMINIUM.melting, ..ALUMINIUM };
        let x = one_phase.lambda();
        let number = 1180.0 * (1500.0 - 933.0) / 3.97e5;
        assert!((PI.sqrt() * x * (x * x).exp() * erf(x) / number - 1.0).abs() < 1e-12);
    }
}
