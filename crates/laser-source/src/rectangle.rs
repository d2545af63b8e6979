//! A rectangle in the plane of the surface.

use serde::{Deserialize, Serialize};

use crate::error::{Error, require};

/// An axis-aligned rectangle in the plane of the surface (m). Sides may lie at infinity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// Smallest x (m).
    pub x_min_m: f64,
    /// Largest x (m).
    pub x_max_m: f64,
    /// Smallest y (m).
    pub y_min_m: f64,
    /// Largest y (m).
    pub y_max_m: f64,
}

impl Rectangle {
    /// The whole plane.
    pub const PLANE: Self = Self {
        x_min_m: f64::NEG_INFINITY,
        x_max_m: f64::INFINITY,
        y_min_m: f64::NEG_INFINITY,
        y_max_m: f64::INFINITY,
    };

    /// The square around `(x_m, y_m)` whose sides are `2 half_width_m` long.
    #[must_use]
    pub fn square(x_m: f64, y_m: f64, half_width_m: f64) -> Self {
        Self {
            x_min_m: x_m - half_width_m,
            x_max_m: x_m + half_width_m,
            y_min_m: y_m - half_width_m,
            y_max_m: y_m + half_width_m,
        }
    }

    /// Checks that the sides are in order.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if a maximum is not above its minimum, or a side is not a number.
    pub fn validate(&self) -> Result<(), Error> {
        require(self.x_max_m > self.x_min_m, "x_max_m", self.x_max_m, "a length in metres above x_min_m")?;
        require(self.y_max_m > self.y_min_m, "y_max_m", self.y_max_m, "a length in metres above y_min_m")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn square_is_centred() {
        let square = Rectangle::square(1.0, -2.0, 0.5);
        assert_eq!(square, Rectangle { x_min_m: 0.5, x_max_m: 1.5, y_min_m: -2.5, y_max_m: -1.5 });
        assert!(square.validate().is_ok());
    }

    #[test]
    fn sides_out_of_order_are_refused() {
        assert!(Rectangle::PLANE.validate().is_ok());
        assert!(Rectangle { x_max_m: -1.0, ..Rectangle::square(0.0, 0.0, 1.0) }.validate().is_err());
        assert!(Rectangle { y_max_m: f64::NAN, ..Rectangle::PLANE }.validate().is_err());
    }
}
