//! The kernel chosen by name.

use super::{CubicSpline, Gaussian, QuinticSpline, ScaledKernel, Shape, WendlandC2};
use std::{fmt, str::FromStr};

/// One of the kernels, chosen when the program runs.
///
/// Names, as read by `FromStr` and written by `Display`: `WendlandC2`, `Gaussian`, `CubicSpline`, `QuinticSpline`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KernelKind {
    /// [`WendlandC2`], support 2 h.
    WendlandC2,
    /// [`Gaussian`], cut at 3 h.
    Gaussian,
    /// [`CubicSpline`], support 2 h.
    CubicSpline,
    /// [`QuinticSpline`], support 3 h.
    QuinticSpline,
}

impl KernelKind {
    /// Every kernel there is.
    pub const ALL: [Self; 4] = [Self::WendlandC2, Self::Gaussian, Self::CubicSpline, Self::QuinticSpline];

    /// The kernel for one constant smoothing length \[m\], normalisation computed once.
    ///
    /// # Panics
    /// If the smoothing length is not finite and positive.
    pub fn with_smoothing_length<const D: usize>(self, smoothing_length: f64) -> ScaledKernel<D> {
        ScaledKernel::new(self, smoothing_length)
    }
}

impl Shape for KernelKind {
    #[inline]
    fn support(self) -> f64 {
        match self {
            Self::WendlandC2 => WendlandC2.support(),
            Self::Gaussian => Gaussian.support(),
            Self::CubicSpline => CubicSpline.support(),
            Self::QuinticSpline => QuinticSpline.support(),
        }
    }

    #[inline]
    fn normalisation(self, dimension: usize) -> f64 {
        match self {
            Self::WendlandC2 => WendlandC2.normalisation(dimension),
            Self::Gaussian => Gaussian.normalisation(dimension),
            Self::CubicSpline => CubicSpline.normalisation(dimension),
            Self::QuinticSpline => QuinticSpline.normalisation(dimension),
        }
    }

    #[inline]
    fn evaluate(self, q: f64) -> (f64, f64) {
        match self {
            Self::WendlandC2 => WendlandC2.evaluate(q),
            Self::Gaussian => Gaussian.evaluate(q),
            Self::CubicSpline => CubicSpline.evaluate(q),
            Self::QuinticSpline => QuinticSpline.evaluate(q),
        }
    }
}

impl fmt::Display for KernelKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::WendlandC2 => "WendlandC2",
            Self::Gaussian => "Gaussian",
            Self::CubicSpline => "CubicSpline",
            Self::QuinticSpline => "QuinticSpline",
        })
    }
}

/// A name that is none of [`KernelKind::ALL`]; holds the name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownKernel(pub String);

impl fmt::Display for UnknownKernel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "unknown kernel \"{}\"; known are WendlandC2, Gaussian, CubicSpline, QuinticSpline",
            self.0
        )
    }
}

impl std::error::Error for UnknownKernel {}

impl FromStr for KernelKind {
    type Err = UnknownKernel;

    fn from_str(name: &str) -> Result<Self, UnknownKernel> {
        Self::ALL
            .into_iter()
            .find(|kind| kind.to_string() == name)
            .ok_or_else(|| UnknownKernel(name.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_survive_a_round_trip() {
        for kind in KernelKind::ALL {
            assert_eq!(kind.to_string().parse(), Ok(kind));
            assert_eq!(kind.to_string(), format!("{kind:?}"));
        }
    }

    #[test]
    fn an_unknown_name_is_told() {
        let error = "Wendland".parse::<KernelKind>().unwrap_err();
        assert!(error.to_string().starts_with("unknown kernel \"Wendland\"; known are WendlandC2, "));
        for kind in KernelKind::ALL {
            assert!(error.to_string().contains(&kind.to_string()));
        }
    }

    #[test]
    fn dispatch_reaches_the_shape_of_that_name() {
        for q in [0.0, 0.4, 1.3, 2.5] {
            assert_eq!(KernelKind::WendlandC2.evaluate(q), WendlandC2.evaluate(q));
            assert_eq!(KernelKind::Gaussian.evaluate(q), Gaussian.evaluate(q));
            assert_eq!(KernelKind::CubicSpline.evaluate(q), CubicSpline.evaluate(q));
            assert_eq!(KernelKind::QuinticSpline.evaluate(q), QuinticSpline.evaluate(q));
        }
    }
}
