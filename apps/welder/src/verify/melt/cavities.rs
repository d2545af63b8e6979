//! Melt between a hot and a cold side, driven by the tension of its flat top.

use super::super::benchmark::{larger, relative};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::cavity::{CASES, Cavity, CavityCase, CavityReference};

/// When it is measured \[H/U\].
const TIMES: [f64; 3] = [30.0, 60.0, 90.0];
/// Intervals of the finite differences that the field is held against.
const INTERVALS: usize = 64;

pub(in super::super) const RE_100: Benchmark = Benchmark {
    name: "melt/cavity",
    tested_crate: "sph-fluid",
    reference: "thermocapillary cavity, flat top, Re 100, Pr 1: steady state by finite differences, 97 x 97 nodes",
    quantities: &[
        Quantity {
            suffix: "speed",
            text: "speed in the middle of the top, mean over five time units before t = 30, 60, 90, the worst of the \
                   three, relative; resolution: rows",
            marks: &[
                Mark { resolution: 16.0, error: 0.1 },
                Mark { resolution: 24.0, error: 0.08 },
                Mark { resolution: 36.0, error: 0.04 },
            ],
        },
        Quantity {
            suffix: "stream",
            text: "largest stream function, likewise",
            marks: &[
                Mark { resolution: 16.0, error: 0.1 },
                Mark { resolution: 24.0, error: 0.1 },
                Mark { resolution: 36.0, error: 0.07 },
            ],
        },
        Quantity {
            suffix: "nusselt",
            text: "heat through the hot and the cold side, likewise, the worse of the two",
            marks: &[
                Mark { resolution: 16.0, error: 0.07 },
                Mark { resolution: 24.0, error: 0.07 },
                Mark { resolution: 36.0, error: 0.07 },
            ],
        },
        Quantity {
            suffix: "steady",
            text: "spread of the speed over the three times, over their mean",
            marks: &[
                Mark { resolution: 16.0, error: 0.08 },
                Mark { resolution: 24.0, error: 0.04 },
                Mark { resolution: 36.0, error: 0.04 },
            ],
        },
        Quantity {
            suffix: "field",
            text: "L2 error of the velocities of all particles against finite differences of this project, 65 x 65 \
                   nodes, over their L2 norm, the worst of the three times",
            marks: &[Mark { resolution: 16.0, error: 0.35 }, Mark { resolution: 36.0, error: 0.1 }],
        },
    ],
    resolutions: [16.0, 24.0, 36.0],
    quick: 1,
    run: |resolution| run(resolution, CASES[0]),
};

fn run(resolution: f64, case: CavityCase) -> Result<Outcome, BenchmarkError> {
    let reference = CavityReference::new(INTERVALS, case.reynolds, case.prandtl);
    let mut cavity = Cavity::new(resolution as usize, case, true, find)?;
    let means = TIMES.map(|time| cavity.means(time, &reference));
    let speeds = means.map(|means| means.speed);
    let (least, most) =
        (speeds.into_iter().fold(f64::INFINITY, f64::min), speeds.into_iter().fold(0.0, larger));
    let worst = |errors: [f64; 3]| errors.into_iter().fold(0.0, larger);
    let sides =
        |nusselt: [f64; 2]| larger(relative(nusselt[0], case.nusselt), relative(nusselt[1], case.nusselt));
    let errors = vec![
        worst(speeds.map(|speed| relative(speed, case.speed))),
        worst(means.map(|means| relative(means.stream, case.stream))),
        worst(means.map(|means| sides(means.nusselt))),
        (most - least) / (speeds.iter().sum::<f64>() / 3.0),
        worst(means.map(|means| means.field)),
    ];
    Ok(outcome(&cavity.patch, errors))
}
