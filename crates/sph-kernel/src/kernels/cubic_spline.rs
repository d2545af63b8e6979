//! The cubic B-spline.

use super::Shape;
use std::f64::consts::PI;

/// w(q) = ((2 - q)+^3 - 4 (1 - q)+^3) / 4, support 2 (Monaghan and Lattanzio 1985), where x+ = max(x, 0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CubicSpline;

impl Shape for CubicSpline {
    #[inline]
    fn support(self) -> f64 {
        2.0
    }

    #[inline]
    fn normalisation(self, dimension: usize) -> f64 {
        if dimension == 2 { 10.0 / (7.0 * PI) } else { 1.0 / PI }
    }

    #[inline]
    fn evaluate(self, q: f64) -> (f64, f64) {
        let outer = (2.0 - q).max(0.0);
        let inner = (1.0 - q).max(0.0);
        let value = 0.25 * (outer * outer * outer - 4.0 * inner * inner * inner);
        // Near the centre the quotient is 0/0, so the inner branch is the divided polynomial.
        let slope_over_q = if q < 1.0 { 2.25 * q - 3.0 } else { -0.75 * outer * outer / q };
        (value, slope_over_q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        assert_eq!(CubicSpline.evaluate(0.0), (1.0, -3.0));
        assert_eq!(CubicSpline.evaluate(1.0), (0.25, -0.75));
        assert_eq!(CubicSpline.evaluate(1.5), (0.03125, -0.125));
    }
}
