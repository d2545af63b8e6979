//! The Gaussian beam: I = P / (pi r_s^2) exp(-r^2 / r_s^2).

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use crate::error::{Error, require_length};

/// Distance in 1/e radii beyond which `erf` is one to the last bit (1 - erf(6) = 2e-17).
pub(crate) const REACH: f64 = 6.0;

/// A Gaussian beam that integrates to one: I = P / (pi r_s^2) exp(-(x^2 + y^2) / r_s^2).
///
/// r_s is the radius at which the intensity has fallen to 1/e; the radius w of the 1/e^2 convention of beam
/// makers is sqrt(2) r_s. The exponential is that of Hu and Eberhard (2015), eq. 23, with the factor that
/// makes the integral one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaussian {
    /// Radius r_s at which the intensity is 1/e of that in the centre (m).
    pub radius_1e_m: f64,
}

impl Gaussian {
    /// The beam with the 1/e^2 radius w = sqrt(2) r_s (m).
    #[must_use]
    pub fn from_radius_1e2(radius_1e2_m: f64) -> Self {
        Self { radius_1e_m: radius_1e2_m * FRAC_1_SQRT_2 }
    }

    /// Intensity per watt at `(x_m, y_m)` from the centre (1/m^2).
    #[must_use]
    pub fn intensity_per_watt(&self, x_m: f64, y_m: f64) -> f64 {
        let square = self.radius_1e_m * self.radius_1e_m;
        (-(x_m * x_m + y_m * y_m) / square).exp() / (PI * square)
    }

    /// Share of the power in a rectangle relative to the centre, exactly:
    /// (erf(x1/r_s) - erf(x0/r_s)) (erf(y1/r_s) - erf(y0/r_s)) / 4.
    #[must_use]
    pub fn fraction_in_rectangle(&self, x0_m: f64, x1_m: f64, y0_m: f64, y1_m: f64) -> f64 {
        let share = |low: f64, high: f64| {
            (libm::erf(high / self.radius_1e_m) - libm::erf(low / self.radius_1e_m)).max(0.0)
        };
        0.25 * share(x0_m, x1_m) * share(y0_m, y1_m)
    }

    /// Checks the radius.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius is not a positive length.
    pub fn validate(&self) -> Result<(), Error> {
        require_length("radius_1e_m", self.radius_1e_m)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Composite Simpson rule in two dimensions; an independent reference for smooth profiles.
    pub(crate) fn simpson(f: impl Fn(f64, f64) -> f64, x0: f64, x1: f64, y0: f64, y1: f64) -> f64 {
        let n = 200;
        let weight = |i: usize| if i == 0 || i == n { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
        let (hx, hy) = ((x1 - x0) / n as f64, (y1 - y0) / n as f64);
        let mut sum = 0.0;
        for i in 0..=n {
            for j in 0..=n {
                sum += weight(i) * weight(j) * f(x0 + hx * i as f64, y0 + hy * j as f64);
            }
        }
        sum * hx * hy / 9.0
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn fraction_is_the_integral_of_the_intensity(
            radius in 0.5..2.0_f64, x in -2.0..2.0_f64, y in -2.0..2.0_f64,
            w in 0.01..2.0_f64, h in 0.01..2.0_f64,
        ) {
            let beam = Gaussian { radius_1e_m: radius };
            let reference = simpson(|x, y| beam.intensity_per_watt(x, y), x, x + w, y, y + h);
            let fraction = beam.fraction_in_rectangle(x, x + w, y, y + h);
            prop_assert!((fraction - reference).abs() < 1e-9, "{fraction} {reference}");
        }
    }

    #[test]
    fn square_of_side_two_radii_holds_erf_one_squared() {
        let beam = Gaussian { radius_1e_m: 3e-4 };
        let erf_one = 0.842_700_792_949_714_9_f64; // Abramowitz and Stegun, table 7.1
        let fraction = beam.fraction_in_rectangle(-3e-4, 3e-4, -3e-4, 3e-4);
        assert!((fraction - erf_one * erf_one).abs() < 1e-15);
    }

    #[test]
    fn intensity_falls_to_the_named_share_at_the_named_radius() {
        let beam = Gaussian::from_radius_1e2(0.6e-3);
        let ratio = beam.intensity_per_watt(0.0, 0.6e-3) / beam.intensity_per_watt(0.0, 0.0);
        assert!((ratio - (-2.0_f64).exp()).abs() < 1e-14);
        let ratio = beam.intensity_per_watt(beam.radius_1e_m, 0.0) / beam.intensity_per_watt(0.0, 0.0);
        assert!((ratio - (-1.0_f64).exp()).abs() < 1e-14);
    }

    #[test]
    fn beyond_the_reach_erf_is_one() {
        assert_eq!(libm::erf(REACH), 1.0);
        assert_eq!(libm::erf(f64::INFINITY), 1.0);
    }
}
