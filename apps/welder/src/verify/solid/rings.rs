//! Rubber rings that collide.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, updated_outcome};
use sph_solid::benchmarks::rings::{Rings, collide};

/// At 0.06 c0. At 0.12 c0 rings of the same rubber break into 8 pieces, which the example `rings` of the crate shows.
pub(in super::super) const RINGS: Benchmark = Benchmark {
    name: "solid/rings",
    tested_crate: "sph-solid",
    reference: "Gray, Monaghan, Swift (2001), nu = 0.3975, 0.06 c0: two rings part whole, momentum zero",
    quantities: &[
        Quantity {
            suffix: "pieces",
            text: "pieces more or less than two, 14 ms after the start; resolution: particles to the wall",
            marks: &[Mark { resolution: 6.0, error: 0.0 }, Mark { resolution: 10.0, error: 0.0 }],
        },
        Quantity {
            suffix: "momentum",
            text: "momentum over that of one ring; resolution: particles to the wall",
            marks: &[Mark { resolution: 6.0, error: 1e-10 }, Mark { resolution: 10.0, error: 1e-10 }],
        },
    ],
    resolutions: [6.0, 8.0, 10.0],
    quick: 1,
    run: |resolution| {
        let rings =
            Rings { cells: resolution as usize, poisson: 0.3975, speed: 0.06, artificial_stress: 0.3 };
        let end = collide(&rings, find)?;
        Ok(updated_outcome(&end.patch, vec![end.pieces.abs_diff(2) as f64, end.momentum]))
    },
};
