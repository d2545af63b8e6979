//! Heat that friction makes, and flow that heat makes.

use super::super::benchmark::{larger, relative};
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::convection::{NUSSELT, SPEED, convection};
use sph_fluid::benchmarks::warm_shear::warm_shear;

pub(in super::super) const SHEAR: Benchmark = Benchmark {
    name: "melt/viscous-heating",
    tested_crate: "sph-fluid",
    reference: "Brinkman (1951): T = eta U^2 z (H - z)/(2 k H^2) between plates of one temperature, one of which moves",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error of a particle's temperature, over the largest temperature; resolution: rows",
        marks: &[Mark { resolution: 8.0, error: 0.05 }, Mark { resolution: 16.0, error: 0.02 }],
    }],
    resolutions: [8.0, 16.0, 24.0],
    quick: 2,
    run: |resolution| {
        let (error, patch) = warm_shear(resolution as usize, find)?;
        Ok(outcome(&patch, vec![error]))
    },
};

pub(in super::super) const CONVECTION: Benchmark = Benchmark {
    name: "melt/convection",
    tested_crate: "sph-fluid",
    reference: "de Vahl Davis (1983): a closed square between a hot and a cold side, Ra 1e4, Pr 0.71 (beta dT = 0.1), t = 20",
    quantities: &[
        Quantity {
            suffix: "nusselt",
            text: "heat through the hot and the cold side, mean over five time units, relative, the worse of the two; \
                   resolution: rows",
            marks: &[Mark { resolution: 16.0, error: 0.1 }],
        },
        Quantity {
            suffix: "speed",
            text: "largest horizontal speed on the upright middle line, likewise",
            marks: &[Mark { resolution: 16.0, error: 0.1 }],
        },
    ],
    resolutions: [16.0, 20.0, 24.0],
    quick: 1,
    run: |resolution| {
        let ([hot, cold], speed, patch) = convection(resolution as usize, 20.0, find)?;
        let nusselt = larger(relative(hot, NUSSELT), relative(cold, NUSSELT));
        Ok(outcome(&patch, vec![nusselt, relative(speed, SPEED)]))
    },
};
