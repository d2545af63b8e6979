//! The quintic B-spline.

use super::Shape;
use std::f64::consts::PI;

/// w(q) = (3 - q)+^5 - 6 (2 - q)+^5 + 15 (1 - q)+^5, support 3 (Morris, Fox and Zhu 1997), where x+ = max(x, 0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuinticSpline;

#[inline]
fn fourth_power(x: f64) -> f64 {
    let squared = x * x;
    squared * squared
}

impl Shape for QuinticSpline {
    #[inline]
    fn support(self) -> f64 {
        3.0
    }

    #[inline]
    fn normalisation(self, dimension: usize) -> f64 {
        if dimension == 2 { 7.0 / (478.0 * PI) } else { 1.0 / (120.0 * PI) }
    }

    #[inline]
    fn evaluate(self, q: f64) -> (f64, f64) {
        let (outer, middle, inner) = ((3.0 - q).max(0.0), (2.0 - q).max(0.0), (1.0 - q).max(0.0));
        let (outer_fourth, middle_fourth) = (fourth_power(outer), fourth_power(middle));
        let value = outer_fourth * outer - 6.0 * middle_fourth * middle + 15.0 * fourth_power(inner) * inner;
        // Near the centre the quotient is 0/0, so the inner branch is the divided polynomial.
        let slope_over_q = if q < 1.0 {
            -120.0 + q * q * (120.0 - 50.0 * q)
        } else {
            -5.0 * (outer_fourth - 6.0 * middle_fourth) / q
        };
        (value, slope_over_q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        assert_eq!(QuinticSpline.evaluate(0.0), (66.0, -120.0));
        assert_eq!(QuinticSpline.evaluate(1.0), (26.0, -50.0));
        assert_eq!(QuinticSpline.evaluate(2.0), (1.0, -2.5));
    }
}
