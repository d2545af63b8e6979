//! Stokes flow in a half-disc, driven by the change of tension along its flat top: the exact series.
//!
//! Lengths in radii, speeds in |tau_T| dT/eta, temperature dT exp(-x^2/w^2), tau_T < 0. With the depth z and psi(r, theta), u = d psi/dz,
//! w = -d psi/dx, the shear of the top asks for laplace psi = f(x) = -(2/w^2) x exp(-x^2/w^2) = sum f_m x^m. Each power is met by
//! psi_m = f_m z Im((x + i z)^(m+1))/(2 (m + 1)), which leaves the top alone; the sum over even n of (a_n r^n + b_n r^(n+2)) sin(n theta)
//! has neither normal speed nor shear there and brings the arc to rest, in closed form.

use super::{MODES, POWERS, shear_powers};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// The flow.
#[derive(Clone, Debug)]
pub struct HalfDiscFlow {
    /// (m, factor of r^(m+2) sin(theta) sin((m+1) theta)).
    driven: [(i32, f64); POWERS],
    /// (n, a_n, b_n).
    free: [(i32, f64, f64); MODES],
}

impl HalfDiscFlow {
    /// For a spot of the width w \[radii\].
    #[must_use]
    pub fn new(width: f64) -> Self {
        let driven = shear_powers(width).map(|(m, power)| (m, power / (2.0 * f64::from(m + 1))));
        let free = std::array::from_fn(|k| {
            let n = 2 * (k as i32 + 1);
            // Of psi and of its slope along r on the arc, what sin(n theta) holds.
            let (mut value, mut slope) = (0.0, 0.0);
            for (m, factor) in driven {
                let part = factor * (overlap(m, n) - overlap(m + 2, n)) / PI;
                value += part;
                slope += f64::from(m + 2) * part;
            }
            let b = 0.5 * (f64::from(n) * value - slope);
            (n, -value - b, b)
        });
        Self { driven, free }
    }

    /// Velocity at a place (x, y) of the half-disc below y = 0.
    #[must_use]
    pub fn velocity(&self, place: &Vector2<f64>) -> Vector2<f64> {
        let r = place.norm().max(1e-9);
        let angle = (-place.y).atan2(place.x);
        let (sine, cosine) = angle.sin_cos();
        // d psi/dr and (1/r) d psi/d theta.
        let (mut along, mut around) = (0.0, 0.0);
        for &(m, factor) in &self.driven {
            let (s, c) = (f64::from(m + 1) * angle).sin_cos();
            let size = factor * r.powi(m + 1);
            along += f64::from(m + 2) * size * sine * s;
            around += size * (cosine * s + f64::from(m + 1) * sine * c);
        }
        for &(n, a, b) in &self.free {
            let (s, c) = (f64::from(n) * angle).sin_cos();
            let (low, high) = (a * r.powi(n - 1), b * r.powi(n + 1));
            along += (f64::from(n) * low + f64::from(n + 2) * high) * s;
            around += f64::from(n) * (low + high) * c;
        }
        Vector2::new(along * sine + around * cosine, along * cosine - around * sine)
    }
}

/// int_0^pi cos(k t) sin(n t) dt for odd k and even n.
fn overlap(k: i32, n: i32) -> f64 {
    2.0 * f64::from(n) / f64::from(n * n - k * k)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_top_has_the_published_speeds_and_the_arc_rests() {
        let flow = HalfDiscFlow::new(0.7);
        let published = [0.0532, 0.1001, 0.1353, 0.1552, 0.1585, 0.1458, 0.1194, 0.0830, 0.0409];
        for (k, speed) in published.into_iter().enumerate() {
            let found = flow.velocity(&Vector2::new(0.1 * (k + 1) as f64, 0.0));
            assert!((found.x - speed).abs() < 1e-4 && found.y.abs() < 1e-12, "{found}");
        }
        for angle in [0.3, 1.0, 1.9, 2.8_f64] {
            let found = flow.velocity(&Vector2::new(angle.cos(), -angle.sin()));
            assert!(found.norm() < 1e-3, "{found}");
        }
    }

    #[test]
    fn tension_and_friction_balance_on_the_top() {
        let flow = HalfDiscFlow::new(0.7);
        for x in [0.2, 0.5, 0.8_f64] {
            let below = |depth: f64| flow.velocity(&Vector2::new(x, -depth)).x;
            let shear = (3.0 * below(0.0) - 4.0 * below(1e-3) + below(2e-3)) / 2e-3;
            let exact = 2.0 / 0.49 * x * (-x * x / 0.49).exp();
            assert!((shear / exact - 1.0).abs() < 1e-3, "{shear} {exact}");
        }
    }
}
