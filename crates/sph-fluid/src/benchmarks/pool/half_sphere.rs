//! Stokes flow in a half-sphere, driven by the change of tension along its flat top: the exact axisymmetric series.
//!
//! As in [`HalfDiscFlow`](super::HalfDiscFlow), with Stokes' psi(r, zeta), zeta = z/r, u = (1/rho) d psi/dz, w = -(1/rho) d psi/d rho, and
//! E^2 psi = rho f(rho) on the top. Gegenbauer's I_n = (P_(n-2) - P_n)/(2n - 1) makes r^n I_n a solution of E^2 psi = 0; since
//! d/dz(r^n I_n) = (n - 2) r^(n-1) I_(n-1), each power of f is met by f_m z r^(m+2) I_(m+2)/(2 m I_(m+1)(0)), which leaves the top alone. The
//! sum over odd n of (a_n r^n + b_n r^(n+2)) I_n brings the shell to rest (Happel and Brenner 1983, section 4-23).

use super::{MODES, POWERS, shear_powers};
use nalgebra::Vector3;

/// Points of the quadrature over zeta.
const POINTS: usize = 20_000;
/// Degrees of Legendre polynomials that are used.
const DEGREES: usize = 2 * MODES + 2;

/// The flow.
#[derive(Clone, Debug)]
pub struct HalfSphereFlow {
    /// (m, factor of r^(m+3) zeta I_(m+2)).
    driven: [(i32, f64); POWERS],
    /// (n, a_n, b_n).
    free: [(i32, f64, f64); MODES],
}

impl HalfSphereFlow {
    /// For a spot of the width w \[radii\].
    #[must_use]
    pub fn new(width: f64) -> Self {
        let flat = legendre(0.0);
        let driven = shear_powers(width)
            .map(|(m, power)| (m, power / (2.0 * f64::from(m) * gegenbauer(&flat, m as usize + 1))));
        let mut free: [(i32, f64, f64); MODES] = std::array::from_fn(|k| (2 * k as i32 + 3, 0.0, 0.0));
        for point in 0..POINTS {
            let zeta = (point as f64 + 0.5) / POINTS as f64;
            let table = legendre(zeta);
            // psi and its slope along r on the shell, over 1 - zeta^2: the weight in which all I_n are orthogonal.
            let (mut value, mut slope) = (0.0, 0.0);
            for (m, factor) in driven {
                let part = factor * zeta * gegenbauer(&table, m as usize + 2);
                value += part;
                slope += f64::from(m + 3) * part;
            }
            let weight = 1.0 / (POINTS as f64 * (1.0 - zeta * zeta));
            for (n, value_part, slope_part) in &mut free {
                let n = f64::from(*n);
                let scale = n * (n - 1.0) * (2.0 * n - 1.0) * weight * gegenbauer(&table, n as usize);
                *value_part += scale * value;
                *slope_part += scale * slope;
            }
        }
        let free = free.map(|(n, value, slope)| {
            let b = 0.5 * (f64::from(n) * value - slope);
            (n, -value - b, b)
        });
        Self { driven, free }
    }

    /// Velocity at a place (x, y, z) of the half-sphere below z = 0.
    #[must_use]
    pub fn velocity(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let aside = place.xy().norm().max(1e-9);
        let r = aside.hypot(place.z);
        let (sine, zeta) = (aside / r, -place.z / r);
        let table = legendre(zeta);
        // d psi/dr and (1/r) d psi/d zeta; d I_n/d zeta = -P_(n-1).
        let (mut along, mut around) = (0.0, 0.0);
        for &(m, factor) in &self.driven {
            let (degree, size) = (m as usize + 2, factor * r.powi(m + 2));
            let value = gegenbauer(&table, degree);
            along += f64::from(m + 3) * size * zeta * value;
            around += size * (value - zeta * table[degree - 1]);
        }
        for &(n, a, b) in &self.free {
            let (low, high) = (a * r.powi(n - 1), b * r.powi(n + 1));
            along += (f64::from(n) * low + f64::from(n + 2) * high) * gegenbauer(&table, n as usize);
            around -= (low + high) * table[n as usize - 1];
        }
        let outward = (along * zeta + around * sine * sine) / aside;
        let down = -(along - around * zeta) * sine / aside;
        Vector3::new(outward * place.x / aside, outward * place.y / aside, -down)
    }
}

/// P_0 to P_(DEGREES-1).
fn legendre(zeta: f64) -> [f64; DEGREES] {
    let mut table = [1.0; DEGREES];
    table[1] = zeta;
    for n in 2..DEGREES {
        let k = n as f64;
        table[n] = ((2.0 * k - 1.0) * zeta * table[n - 1] - (k - 1.0) * table[n - 2]) / k;
    }
    table
}

fn gegenbauer(legendre: &[f64; DEGREES], n: usize) -> f64 {
    (legendre[n - 2] - legendre[n]) / (2 * n - 1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_top_has_the_published_speeds_and_the_shell_rests() {
        let flow = HalfSphereFlow::new(0.7);
        let published = [0.0471, 0.0885, 0.1196, 0.1372, 0.1402, 0.1292, 0.1063, 0.0747, 0.0377];
        for (k, speed) in published.into_iter().enumerate() {
            let found = flow.velocity(&Vector3::new(0.0, 0.1 * (k + 1) as f64, 0.0));
            assert!((found.y - speed).abs() < 1e-4 && found.z.abs() < 1e-12, "{found}");
        }
        // On the axis itself the slope of the series converges too slowly to be of use.
        for angle in [0.3, 0.6, 0.9_f64] {
            let found = flow.velocity(&Vector3::new(angle.cos(), 0.0, -angle.sin()));
            assert!(found.norm() < 4e-3, "{found}");
        }
    }

    #[test]
    fn nothing_is_gained_or_lost_on_the_way() {
        let flow = HalfSphereFlow::new(0.7);
        let (place, step) = (Vector3::new(0.3, 0.2, -0.4), 1e-4);
        let slope = |axis: usize| {
            let aside = Vector3::ith(axis, step);
            (flow.velocity(&(place + aside)) - flow.velocity(&(place - aside)))[axis] / (2.0 * step)
        };
        let parts = [0, 1, 2].map(slope);
        assert!(parts.iter().sum::<f64>().abs() < 1e-6 && parts[2].abs() > 1e-2, "{parts:?}");
    }
}
