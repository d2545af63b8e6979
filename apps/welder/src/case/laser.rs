//! The laser of a scene, in the words of the crate laser-source.

use laser_source::{Absorption, Beam, Error, LaserSource, Path};
use serde::{Deserialize, Serialize};

/// The laser: a beam that goes along a path and is partly absorbed by the top face. Its power is that of the whole
/// beam, also where symmetry planes cut the part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Laser {
    /// The profile: Gaussian(radius_1e2_m or radius_1e_m), GaussianHuEberhard(..), TopHat(radius_m).
    pub beam: Beam,
    /// Which share stays, and at which depth: Surface(absorptivity) or BeerLambert(..).
    pub absorption: Absorption,
    /// Where and when: Spot(..), Straight(..), Polyline(..), with the power in watts.
    pub path: Path,
}

impl Laser {
    /// The source that the laser stands for.
    ///
    /// # Errors
    /// The first number that the crate laser-source refuses; none in a loaded case.
    pub fn source(&self) -> Result<LaserSource, Error> {
        LaserSource::new(self.beam, self.path.clone(), self.absorption)
    }
}
