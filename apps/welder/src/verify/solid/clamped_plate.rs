//! Residual stress of a clamped plate that is melted in a spot.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::clamped_plate::clamped_plate;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "solid/clamped-plate",
    tested_crate: "sph-solid",
    reference: "axisymmetric finite elements of this project (clamped_plate_reference.py; 1.4 % from 40 to 64 cells)",
    quantities: &[Quantity {
        suffix: "",
        text: "L2 error of residual stress within 0.85 R, relative; resolution: spacings to the radius",
        marks: &[
            Mark { resolution: 6.0, error: 0.35 },
            Mark { resolution: 12.0, error: 0.2 },
            Mark { resolution: 16.0, error: 0.15 },
        ],
    }],
    resolutions: [6.0, 12.0, 16.0],
    quick: 1,
    run: |resolution| {
        let plate = clamped_plate(resolution as usize, find)?;
        Ok(outcome(&plate.patch, vec![plate.error]))
    },
};
