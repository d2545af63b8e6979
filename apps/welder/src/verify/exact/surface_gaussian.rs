//! A Gaussian spot of constant power on the surface of a half space (Carslaw and Jaeger, 10.4, integrated over sources).

use super::numeric::integral;
use std::f64::consts::PI;

/// q = P/(pi w²) exp(-r²/w²), from time zero on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceGaussian {
    /// Power P.
    pub power: f64,
    /// 1/e radius w.
    pub radius: f64,
    /// Conductivity k.
    pub conductivity: f64,
    /// Diffusivity a.
    pub diffusivity: f64,
}

impl SurfaceGaussian {
    /// Rise of the centre: P/(pi^1.5 k w) atan(sqrt(4 a t)/w).
    pub fn centre_rise(&self, time: f64) -> f64 {
        let reach = (4.0 * self.diffusivity * time).sqrt();
        self.power / (PI.powf(1.5) * self.conductivity * self.radius) * (reach / self.radius).atan()
    }

    /// Rise at radius `r` and depth `z`:
    /// (P/(pi k)) sqrt(a/pi) int_0^t exp(-z²/(4 a s) - r²/(w² + 4 a s))/(sqrt(s) (w² + 4 a s)) ds, with s = u².
    pub fn rise(&self, r: f64, z: f64, time: f64) -> f64 {
        let a = self.diffusivity;
        let integrand = |u: f64| {
            let (spread, deep) = (self.radius * self.radius + 4.0 * a * u * u, z * z / (4.0 * a * u * u));
            2.0 * (-deep - r * r / spread).exp() / spread
        };
        self.power / (PI * self.conductivity) * (a / PI).sqrt() * integral(integrand, 0.0, time.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPOT: SurfaceGaussian =
        SurfaceGaussian { power: 1000.0, radius: 0.5e-3, conductivity: 210.0, diffusivity: 210.0 / 2.43e6 };

    #[test]
    fn the_printed_value() {
        assert!((SPOT.centre_rise(15e-3) - 2316.93).abs() < 5e-3, "{}", SPOT.centre_rise(15e-3));
    }

    #[test]
    fn the_integral_is_the_closed_form_at_the_centre() {
        for time in [1e-5, 1e-3, 15e-3] {
            assert!((SPOT.rise(0.0, 0.0, time) / SPOT.centre_rise(time) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_integral_obeys_the_equation() {
        // dT/dt = a (T_rr + T_r/r + T_zz), by central differences.
        let (r, z, t, d) = (0.4e-3, 0.3e-3, 5e-3, 2e-5);
        let at = |dr: f64, dz: f64| SPOT.rise(r + dr, z + dz, t);
        let rate = (SPOT.rise(r, z, t + 1e-5) - SPOT.rise(r, z, t - 1e-5)) / 2e-5;
        let bend = (at(d, 0.0) + at(-d, 0.0) + at(0.0, d) + at(0.0, -d) - 4.0 * at(0.0, 0.0)) / (d * d);
        let slope = (at(d, 0.0) - at(-d, 0.0)) / (2.0 * d * r);
        assert!((rate / (SPOT.diffusivity * (bend + slope)) - 1.0).abs() < 5e-3);
    }
}
