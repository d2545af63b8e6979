//! Beam profiles: how the power is spread in the plane of the surface.

mod gaussian;
mod gaussian_hu_eberhard;
mod input;
mod top_hat;

use serde::{Deserialize, Serialize};

use crate::error::Error;

pub use gaussian::Gaussian;
pub(crate) use gaussian::REACH;
pub use gaussian_hu_eberhard::GaussianHuEberhard;
pub use top_hat::TopHat;

use input::BeamInput;

/// A beam profile in the plane of the surface, at normal incidence, relative to the beam's centre.
///
/// In a case file: `Gaussian(radius_1e2_m: 0.6e-3)`, `Gaussian(radius_1e_m: 0.42e-3)`,
/// `GaussianHuEberhard(radius_1e_m: 0.42e-3)`, `TopHat(radius_m: 0.5e-3)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "BeamInput", into = "BeamInput")]
pub enum Beam {
    /// The Gaussian that integrates to one.
    Gaussian(Gaussian),
    /// The Gaussian with the normalisation of Hu and Eberhard (2015), eq. 23: integrates to e^0.5.
    GaussianHuEberhard(GaussianHuEberhard),
    /// Uniform intensity in a disc.
    TopHat(TopHat),
}

impl Beam {
    /// Intensity per watt of commanded power at `(x_m, y_m)` from the centre (1/m^2).
    #[must_use]
    pub fn intensity_per_watt(&self, x_m: f64, y_m: f64) -> f64 {
        match self {
            Self::Gaussian(beam) => beam.intensity_per_watt(x_m, y_m),
            Self::GaussianHuEberhard(beam) => beam.intensity_per_watt(x_m, y_m),
            Self::TopHat(beam) => beam.intensity_per_watt(x_m, y_m),
        }
    }

    /// Power in the rectangle `x0_m <= x <= x1_m`, `y0_m <= y <= y1_m` (relative to the centre) over
    /// commanded power, between 0 and [`Beam::total`]. Exact; a side may lie at infinity.
    #[must_use]
    pub fn fraction_in_rectangle(&self, x0_m: f64, x1_m: f64, y0_m: f64, y1_m: f64) -> f64 {
        match self {
            Self::Gaussian(beam) => beam.fraction_in_rectangle(x0_m, x1_m, y0_m, y1_m),
            Self::GaussianHuEberhard(beam) => beam.fraction_in_rectangle(x0_m, x1_m, y0_m, y1_m),
            Self::TopHat(beam) => beam.fraction_in_rectangle(x0_m, x1_m, y0_m, y1_m),
        }
    }

    /// Power in the whole plane over commanded power: 1, or e^0.5 for [`GaussianHuEberhard`].
    #[must_use]
    pub fn total(&self) -> f64 {
        match self {
            Self::Gaussian(_) | Self::TopHat(_) => 1.0,
            Self::GaussianHuEberhard(_) => GaussianHuEberhard::TOTAL,
        }
    }

    /// The length over which the profile changes (m): the 1/e radius of a Gaussian, the radius of a top-hat.
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        match self {
            Self::Gaussian(beam) => beam.radius_1e_m,
            Self::GaussianHuEberhard(beam) => beam.radius_1e_m,
            Self::TopHat(beam) => beam.radius_m,
        }
    }

    /// Distance from the centre beyond which nothing arrives to round-off (m): six 1/e radii of a Gaussian
    /// (where erf is 1 to the last bit), the radius of a top-hat.
    #[must_use]
    pub fn reach_m(&self) -> f64 {
        match self {
            Self::TopHat(beam) => beam.radius_m,
            _ => REACH * self.radius_m(),
        }
    }

    /// The length along which the time quadrature takes the profile for smooth (m). The rim of a top-hat is
    /// sharp: it gets fifty times as many points.
    pub(crate) fn smooth_length_m(&self) -> f64 {
        match self {
            Self::TopHat(beam) => 0.02 * beam.radius_m,
            _ => self.radius_m(),
        }
    }

    /// The 1/e radius (m) and the total of a beam that is a product of a function of x and one of y.
    pub(crate) fn separable(&self) -> Option<(f64, f64)> {
        match self {
            Self::TopHat(_) => None,
            _ => Some((self.radius_m(), self.total())),
        }
    }

    /// Checks the radius.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius is not a positive length.
    pub fn validate(&self) -> Result<(), Error> {
        match self {
            Self::Gaussian(beam) => beam.validate(),
            Self::GaussianHuEberhard(beam) => beam.validate(),
            Self::TopHat(beam) => beam.validate(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_beam() -> impl Strategy<Value = Beam> {
        (0..3, 0.7_f64..3.0).prop_map(|(kind, radius)| match kind {
            0 => Beam::Gaussian(Gaussian { radius_1e_m: radius }),
            1 => Beam::GaussianHuEberhard(GaussianHuEberhard { radius_1e_m: radius }),
            _ => Beam::TopHat(TopHat { radius_m: radius }),
        })
    }

    proptest! {
        #[test]
        fn fractions_add_up_over_a_tiling(
            beam in any_beam(), x in -0.6..0.6_f64, y in -0.6..0.6_f64, n in 1..9_usize,
        ) {
            let (reach, count) = (beam.reach_m(), 2 * n + 1);
            let edge = |centre: f64, i: usize| centre + reach * (4.0 * i as f64 / count as f64 - 2.0);
            let mut sum = 0.0;
            for i in 0..count {
                for j in 0..count {
                    sum += beam.fraction_in_rectangle(edge(x, i), edge(x, i + 1), edge(y, j), edge(y, j + 1));
                }
            }
            // The tiling is shifted by 0.6 at most, less than its margin of one reach.
            prop_assert!((sum - beam.total()).abs() < 1e-13, "{sum}");
        }

        #[test]
        fn fraction_is_between_zero_and_total(

            beam in any_beam(), x in -5.0..5.0_f64, y in -5.0..5.0_f64,
            w in 0.0..5.0_f64, h in 0.0..5.0_f64,
        ) {
            let fraction = beam.fraction_in_rectangle(x, x + w, y, y + h);
            prop_assert!(fraction >= 0.0 && fraction <= beam.total() * (1.0 + 1e-15), "{fraction}");
        }

        #[test]
        fn a_larger_rectangle_holds_more(

            beam in any_beam(), x in -3.0..3.0_f64, y in -3.0..3.0_f64,
            w in 0.0..3.0_f64, more in 0.0..1.0_f64,
        ) {
            let small = beam.fraction_in_rectangle(x, x + w, y, y + w);
            let large = beam.fraction_in_rectangle(x - more, x + w, y, y + w + more);
            prop_assert!(large >= small - 1e-15);
        }

        #[test]
        fn half_plane_through_the_centre_holds_half(beam in any_beam()) {
            let far = f64::INFINITY;
            let half = beam.fraction_in_rectangle(0.0, far, -far, far);
            prop_assert!((half - 0.5 * beam.total()).abs() < 1e-15);
            prop_assert!((beam.fraction_in_rectangle(-far, far, -far, far) - beam.total()).abs() < 1e-15);
        }
    }
}
