//! Wendland's C2 function.

use super::Shape;
use std::f64::consts::PI;

/// w(q) = (1 - q/2)^4 (2 q + 1) for q < 2 (Wendland 1995, phi_{3,1}; Dehnen and Aly 2012, table 1).
///
/// Its Fourier transform is positive in 2-D and 3-D, so it resists pairing at any number of neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WendlandC2;

impl Shape for WendlandC2 {
    #[inline]
    fn support(self) -> f64 {
        2.0
    }

    #[inline]
    fn normalisation(self, dimension: usize) -> f64 {
        if dimension == 2 { 7.0 / (4.0 * PI) } else { 21.0 / (16.0 * PI) }
    }

    #[inline]
    fn evaluate(self, q: f64) -> (f64, f64) {
        let remainder = (1.0 - 0.5 * q).max(0.0);
        let cubed = remainder * remainder * remainder;
        (cubed * remainder * (2.0 * q + 1.0), -5.0 * cubed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        assert_eq!(WendlandC2.evaluate(0.0), (1.0, -5.0));
        assert_eq!(WendlandC2.evaluate(1.0), (3.0 / 16.0, -5.0 / 8.0));
    }
}
