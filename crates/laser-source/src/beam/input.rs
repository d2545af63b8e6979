//! How a beam is written in a case file.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::beam::{Beam, Gaussian, GaussianHuEberhard, TopHat};
use crate::error::Error;

/// The written form of a [`Beam`]: a Gaussian names its radius by one of two conventions.
#[derive(Clone, Serialize, Deserialize)]
#[serde(rename = "Beam", deny_unknown_fields)]
pub(crate) enum BeamInput {
    Gaussian {
        #[serde(
            default,
            deserialize_with = "read",
            serialize_with = "write",
            skip_serializing_if = "Option::is_none"
        )]
        radius_1e_m: Option<f64>,
        #[serde(
            default,
            deserialize_with = "read",
            serialize_with = "write",
            skip_serializing_if = "Option::is_none"
        )]
        radius_1e2_m: Option<f64>,
    },
    GaussianHuEberhard {
        #[serde(
            default,
            deserialize_with = "read",
            serialize_with = "write",
            skip_serializing_if = "Option::is_none"
        )]
        radius_1e_m: Option<f64>,
        #[serde(
            default,
            deserialize_with = "read",
            serialize_with = "write",
            skip_serializing_if = "Option::is_none"
        )]
        radius_1e2_m: Option<f64>,
    },
    TopHat {
        radius_m: f64,
    },
}

/// Reads a plain number, so that a case file needs no `Some(..)`.
fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f64>, D::Error> {
    f64::deserialize(deserializer).map(Some)
}

/// Writes a plain number; absent ones are skipped before.
fn write<S: Serializer>(radius_m: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(radius_m.unwrap_or(f64::NAN))
}

/// The Gaussian with whichever radius was given.
fn gaussian(radius_1e_m: Option<f64>, radius_1e2_m: Option<f64>) -> Result<Gaussian, Error> {
    match (radius_1e_m, radius_1e2_m) {
        (Some(radius_1e_m), None) => Ok(Gaussian { radius_1e_m }),
        (None, Some(radius_1e2_m)) => Ok(Gaussian::from_radius_1e2(radius_1e2_m)),
        (first, _) => Err(Error::ExactlyOne {
            first: "radius_1e_m",
            second: "radius_1e2_m",
            found: if first.is_some() { 2 } else { 0 },
        }),
    }
}

impl TryFrom<BeamInput> for Beam {
    type Error = Error;

    fn try_from(input: BeamInput) -> Result<Self, Error> {
        let beam = match input {
            BeamInput::Gaussian { radius_1e_m, radius_1e2_m } => {
                Self::Gaussian(gaussian(radius_1e_m, radius_1e2_m)?)
            }
            BeamInput::GaussianHuEberhard { radius_1e_m, radius_1e2_m } => {
                let radius_1e_m = gaussian(radius_1e_m, radius_1e2_m)?.radius_1e_m;
                Self::GaussianHuEberhard(GaussianHuEberhard { radius_1e_m })
            }
            BeamInput::TopHat { radius_m } => Self::TopHat(TopHat { radius_m }),
        };
        Ok(beam)
    }
}

impl From<Beam> for BeamInput {
    fn from(beam: Beam) -> Self {
        let radius_1e2_m = None;
        match beam {
            Beam::Gaussian(Gaussian { radius_1e_m }) => {
                Self::Gaussian { radius_1e_m: Some(radius_1e_m), radius_1e2_m }
            }
            Beam::GaussianHuEberhard(GaussianHuEberhard { radius_1e_m }) => {
                Self::GaussianHuEberhard { radius_1e_m: Some(radius_1e_m), radius_1e2_m }
            }
            Beam::TopHat(TopHat { radius_m }) => Self::TopHat { radius_m },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Beam, String> {
        ron::from_str(text).map_err(|error| error.to_string())
    }

    #[test]
    fn both_radii_are_read_by_name() {
        let by_1e2 = read("Gaussian(radius_1e2_m: 0.6e-3)").unwrap();
        let by_1e = read("Gaussian(radius_1e_m: 0.42426406871192851e-3)").unwrap();
        assert!((by_1e2.radius_m() - by_1e.radius_m()).abs() < 1e-18);
        assert_eq!(read("TopHat(radius_m: 2.0)").unwrap(), Beam::TopHat(TopHat { radius_m: 2.0 }));
        assert_eq!(read("GaussianHuEberhard(radius_1e_m: 2.0)").unwrap().total(), GaussianHuEberhard::TOTAL);
    }

    #[test]
    fn no_radius_two_radii_and_unknown_names_are_refused() {
        assert!(read("Gaussian()").unwrap_err().contains("0 of them"));
        let both = read("Gaussian(radius_1e_m: 1.0, radius_1e2_m: 1.0)").unwrap_err();
        assert!(both.contains("exactly one of radius_1e_m and radius_1e2_m; 2"), "{both}");
        assert!(read("Gaussian(radius: 1.0)").unwrap_err().contains("radius"));
        assert!(read("Gauss(radius_1e_m: 1.0)").unwrap_err().contains("Gauss"));
    }

    #[test]
    fn what_is_written_is_read_back() {
        for text in [
            "Gaussian(radius_1e_m:0.00042)",
            "GaussianHuEberhard(radius_1e_m:0.00042)",
            "TopHat(radius_m:0.5)",
        ] {
            assert_eq!(ron::to_string(&read(text).unwrap()).unwrap(), text);
        }
    }
}
