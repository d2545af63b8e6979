//! How finely the part is cut into particles.

use serde::{Deserialize, Serialize};

/// Spacing, levels of spacing and disorder of the particles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Resolution {
    /// Distance of neighbouring particles where the laser works, in metres.
    pub spacing_m: f64,
    /// Where coarser particles take over. Default: Auto.
    #[serde(default)]
    pub levels: Levels,
    /// Uniform random shift of each particle along each axis, in spacings, 0 to 0.3. Default: 0.
    #[serde(default)]
    pub disorder: f64,
    /// Seed of the random shifts. Default: 1.
    #[serde(default = "first_seed")]
    pub seed: u64,
}

pub(super) fn first_seed() -> u64 {
    1
}

/// Where the spacing grows to 2, 4, 8 ... times `spacing_m`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Levels {
    /// Nested boxes around the expected pool, chosen by the program.
    #[default]
    Auto,
    /// One spacing everywhere.
    Uniform,
    /// `spacing_m` inside the given box; coarser levels around it.
    FineBox {
        /// Low corner (x, y, z) in metres.
        low_m: [f64; 3],
        /// High corner (x, y, z) in metres.
        high_m: [f64; 3],
    },
}
