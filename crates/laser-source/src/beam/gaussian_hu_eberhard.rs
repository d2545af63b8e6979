//! The Gaussian beam with the normalisation of Hu and Eberhard (2015), eq. 23.

use crate::beam::Gaussian;
use crate::error::Error;

/// The Gaussian beam as printed: I = P / (e^-0.5 pi r_s^2) exp(-r^2 / r_s^2).
///
/// Hu and Eberhard (2015), eq. 23, choose the factor such that the intensity at r_s / sqrt(2) equals
/// P / (pi r_s^2). The integral over the plane is then e^0.5 = 1.6487 P: more heat arrives than is commanded.
/// Use it to compare with the paper only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussianHuEberhard {
    /// Radius r_s at which the intensity is 1/e of that in the centre (m).
    pub radius_1e_m: f64,
}

impl GaussianHuEberhard {
    /// Power in the whole plane over commanded power, e^0.5.
    pub const TOTAL: f64 = 1.648_721_270_700_128_2;

    /// Intensity per watt of commanded power at `(x_m, y_m)` from the centre (1/m^2).
    #[must_use]
    pub fn intensity_per_watt(&self, x_m: f64, y_m: f64) -> f64 {
        Self::TOTAL * self.shape().intensity_per_watt(x_m, y_m)
    }

    /// Power in a rectangle relative to the centre over commanded power; up to [`Self::TOTAL`].
    #[must_use]
    pub fn fraction_in_rectangle(&self, x0_m: f64, x1_m: f64, y0_m: f64, y1_m: f64) -> f64 {
        Self::TOTAL * self.shape().fraction_in_rectangle(x0_m, x1_m, y0_m, y1_m)
    }

    /// Checks the radius.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius is not a positive length.
    pub fn validate(&self) -> Result<(), Error> {
        self.shape().validate()
    }

    fn shape(&self) -> Gaussian {
        Gaussian { radius_1e_m: self.radius_1e_m }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beam::gaussian::tests::simpson;
    use std::f64::consts::{FRAC_1_SQRT_2, PI};

    #[test]
    fn intensity_at_radius_over_root_two_is_the_mean_of_the_disc() {
        // The sentence below eq. 23.
        let beam = GaussianHuEberhard { radius_1e_m: 2e-4 };
        let intensity = beam.intensity_per_watt(2e-4 * FRAC_1_SQRT_2, 0.0);
        assert!((intensity * PI * 4e-8 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn integrates_to_root_e() {
        let beam = GaussianHuEberhard { radius_1e_m: 1.0 };
        let integral = simpson(|x, y| beam.intensity_per_watt(x, y), -6.0, 6.0, -6.0, 6.0);
        assert!((integral - 0.5_f64.exp()).abs() < 1e-12, "{integral}");
        assert!((GaussianHuEberhard::TOTAL - 0.5_f64.exp()).abs() < 1e-15);
        assert_eq!(beam.fraction_in_rectangle(-9.0, 9.0, -9.0, 9.0), GaussianHuEberhard::TOTAL);
    }
}
