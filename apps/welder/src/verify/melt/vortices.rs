//! Vortices that friction slows.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::vortices::{SCHEME, vortices};

pub(in super::super) const TAYLOR_GREEN: Benchmark = Benchmark {
    name: "melt/taylor-green",
    tested_crate: "sph-fluid",
    reference: "Taylor and Green (1937): decay exp(-8 pi^2 t/Re) at Re 100, doubly periodic",
    quantities: &[
        Quantity {
            suffix: "speed",
            text: "largest speed, relative, mean over 20 times until t = 2 L/U; resolution: particles to the side",
            marks: &[
                Mark { resolution: 25.0, error: 0.042 },
                Mark { resolution: 50.0, error: 0.03 },
                Mark { resolution: 100.0, error: 0.03 },
            ],
        },
        Quantity {
            suffix: "voids",
            text: "largest 1 - sum V W of a particle at those times, where a hole of one particle takes 0.09 from its \
                   neighbours; resolution: particles to the side",
            marks: &[
                Mark { resolution: 25.0, error: 0.045 },
                Mark { resolution: 50.0, error: 0.045 },
                Mark { resolution: 100.0, error: 0.045 },
            ],
        },
    ],
    resolutions: [25.0, 50.0, 100.0],
    quick: 2,
    run: |resolution| {
        let vortices = vortices(resolution as usize, SCHEME, find)?;
        Ok(outcome(&vortices.patch, vec![vortices.speed_error, vortices.emptiness]))
    },
};
