//! The top-hat beam: uniform intensity in a disc.

use std::f64::consts::PI;

use crate::error::{Error, require_length};

/// A beam of uniform intensity P / (pi R^2) inside a disc of radius R, nothing outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopHat {
    /// Radius R of the disc (m).
    pub radius_m: f64,
}

impl TopHat {
    /// Intensity per watt at `(x_m, y_m)` from the centre (1/m^2); the rim counts as inside.
    #[must_use]
    pub fn intensity_per_watt(&self, x_m: f64, y_m: f64) -> f64 {
        let square = self.radius_m * self.radius_m;
        if x_m * x_m + y_m * y_m <= square { 1.0 / (PI * square) } else { 0.0 }
    }

    /// Share of the power in a rectangle relative to the centre: the exact area of its intersection with the
    /// disc over the area of the disc.
    #[must_use]
    pub fn fraction_in_rectangle(&self, x0_m: f64, x1_m: f64, y0_m: f64, y1_m: f64) -> f64 {
        let [x0, x1, y0, y1] = [x0_m, x1_m, y0_m, y1_m].map(|side| (side / self.radius_m).clamp(-1.0, 1.0));
        let area = corner_area(x1, y1) - corner_area(x0, y1) - corner_area(x1, y0) + corner_area(x0, y0);
        (area / PI).clamp(0.0, 1.0)
    }

    /// Checks the radius.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius is not a positive length.
    pub fn validate(&self) -> Result<(), Error> {
        require_length("radius_m", self.radius_m)
    }
}

/// Signed area of the unit disc between the axes and `(x, y)`, both in -1..=1; odd in each argument.
fn corner_area(x: f64, y: f64) -> f64 {
    let (a, b) = (x.abs(), y.abs());
    let area = if a * a + b * b <= 1.0 {
        a * b
    } else {
        // A rectangle up to where the side y = b leaves the disc, and the area under the arc from there to a.
        let exit = (1.0 - b * b).sqrt();
        b * exit + area_under_arc(a) - area_under_arc(exit)
    };
    area.copysign(x * y)
}

/// Integral of sqrt(1 - t^2) from 0 to `x`.
fn area_under_arc(x: f64) -> f64 {
    0.5 * (x * (1.0 - x * x).sqrt() + x.asin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Area of disc and rectangle by the midpoint rule over exact vertical chords.
    fn reference(radius: f64, x0: f64, x1: f64, y0: f64, y1: f64) -> f64 {
        let n = 20_000;
        let step = (x1 - x0) / f64::from(n);
        let chord = |i: i32| {
            let x = x0 + (f64::from(i) + 0.5) * step;
            let half = (radius * radius - x * x).max(0.0).sqrt();
            (half.min(y1) - (-half).max(y0)).max(0.0)
        };
        (0..n).map(chord).sum::<f64>() * step / (PI * radius * radius)
    }

    proptest! {
        #[test]
        fn fraction_is_the_area_of_the_intersection(
            radius in 0.5..2.0_f64, x in -2.5..2.0_f64, y in -2.5..2.0_f64,
            w in 0.01..3.0_f64, h in 0.01..3.0_f64,
        ) {
            let fraction = TopHat { radius_m: radius }.fraction_in_rectangle(x, x + w, y, y + h);
            let expected = reference(radius, x, x + w, y, y + h);
            prop_assert!((fraction - expected).abs() < 2e-6, "{fraction} {expected}");
        }
    }

    #[test]
    fn known_areas() {
        let beam = TopHat { radius_m: 2.0 };
        let quarter = beam.fraction_in_rectangle(0.0, 5.0, 0.0, 5.0);
        assert!((quarter - 0.25).abs() < 1e-15);
        // Inscribed square: 2 R^2 / (pi R^2).
        let side = 2.0_f64.sqrt();
        let square = beam.fraction_in_rectangle(-side, side, -side, side);
        assert!((square - 2.0 / PI).abs() < 1e-15);
        // Segment beyond half the radius: (pi/3 - sqrt(3)/4) R^2.
        let segment = beam.fraction_in_rectangle(1.0, 9.0, -9.0, 9.0);
        assert!((segment - (PI / 3.0 - 3.0_f64.sqrt() / 4.0) / PI).abs() < 1e-15);
        assert_eq!(beam.fraction_in_rectangle(2.0, 3.0, 2.0, 3.0), 0.0);
    }

    #[test]
    fn intensity_is_uniform_inside() {
        let beam = TopHat { radius_m: 2.0 };
        assert_eq!(beam.intensity_per_watt(1.4, -1.4), 1.0 / (4.0 * PI));
        assert_eq!(beam.intensity_per_watt(1.5, -1.4), 0.0);
    }
}
