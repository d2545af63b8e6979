//! A square of fluid that turns and flies apart.

use super::super::benchmark::relative;
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::square::{SCHEME, rotating_square};

/// When it ends \[1/omega\].
const END: f64 = 4.0;

pub(in super::super) const ROTATING: Benchmark = Benchmark {
    name: "melt/rotating-square",
    tested_crate: "sph-fluid",
    reference: "a square that turns (Colagrossi 2005), without viscosity, until omega t = 4: no clumps, no void of more than a particle, energy and angular \
                momentum kept, corners in free flight",
    quantities: &[
        Quantity {
            suffix: "clumps",
            text: "largest sum V W of a particle, less one, at 16 times: one where particles lie in pairs; resolution: particles to the \
                   side. 30 leave two rows to an arm",
            marks: &[Mark { resolution: 30.0, error: 0.25 }, Mark { resolution: 60.0, error: 0.15 }],
        },
        Quantity {
            suffix: "voids",
            text: "radius of the largest enclosed void over the spacing, less the 0.71 of a lattice, at those times: 0.29 where one particle \
                   is missing, 0.41 where two are",
            marks: &[Mark { resolution: 30.0, error: 0.35 }, Mark { resolution: 60.0, error: 0.35 }],
        },
        Quantity {
            suffix: "energy",
            text: "kinetic energy lost, over that of the start",
            marks: &[Mark { resolution: 30.0, error: 0.005 }, Mark { resolution: 60.0, error: 0.002 }],
        },
        Quantity {
            suffix: "spin",
            text: "angular momentum lost, over that of the start",
            marks: &[Mark { resolution: 30.0, error: 0.08 }, Mark { resolution: 60.0, error: 0.03 }],
        },
        Quantity {
            suffix: "corner",
            text: "distance of the farthest particle from the centre against that of a corner in free flight, relative",
            marks: &[Mark { resolution: 30.0, error: 0.2 }, Mark { resolution: 60.0, error: 0.15 }],
        },
    ],
    resolutions: [30.0, 42.0, 60.0],
    quick: 2,
    run: |resolution| {
        let square = rotating_square(resolution as usize, END, SCHEME, find)?;
        let errors = vec![
            square.crowding - 1.0,
            square.void - std::f64::consts::FRAC_1_SQRT_2,
            square.energy_lost.abs(),
            square.spin_lost.abs(),
            relative(square.reach, 1.0),
        ];
        Ok(outcome(&square.patch, errors))
    },
};
