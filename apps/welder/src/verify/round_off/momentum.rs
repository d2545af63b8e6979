//! Momentum of a free melt.

use super::super::neighbors::find;
use super::super::{Benchmark, Mark, Outcome, Quantity};
use sph_fluid::benchmarks::momentum::{pair_residual, tension_residual};

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "round-off/melt-momentum",
    tested_crate: "sph-fluid",
    reference: "momentum of a free round body that is sheared and squeezed, on which nothing acts from outside",
    quantities: &[
        Quantity {
            suffix: "pairs",
            text: "momentum gained in 200 steps by pressure (plain and corrected), both frictions, artificial viscosity \
                   and density diffusion, over the sum of m |v|, the most; resolution: spacings to the radius",
            marks: &[
                Mark { resolution: 8.0, error: 1e-13 },
                Mark { resolution: 12.0, error: 1e-13 },
                Mark { resolution: 16.0, error: 1e-13 },
            ],
        },
        Quantity {
            suffix: "tension",
            text: "largest speed of the centre of mass in two capillary times, over sqrt(tau/(rho R)): the force of \
                   tension is none of pairs and keeps momentum to an error of its curvature only",
            marks: &[
                Mark { resolution: 8.0, error: 0.01 },
                Mark { resolution: 12.0, error: 0.01 },
                Mark { resolution: 16.0, error: 0.01 },
            ],
        },
    ],
    resolutions: [8.0, 12.0, 16.0],
    quick: 2,
    run: |resolution| {
        let across = resolution as usize;
        let ((pairs, squeezed), (tension, pulled)) =
            (pair_residual(across, find)?, tension_residual(across, find)?);
        Ok(Outcome {
            errors: vec![pairs, tension],
            particles: pulled.positions().len(),
            pair_visits: squeezed.pair_visits() + pulled.pair_visits(),
        })
    },
};
