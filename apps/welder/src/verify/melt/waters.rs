//! Water under gravity: at rest, in a small wave, and falling.

use super::super::benchmark::relative;
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::Friction;
use sph_fluid::benchmarks::dam::DamBreak;
use sph_fluid::benchmarks::tank::tank;
use sph_fluid::benchmarks::wave::{EXACT_DECAY, standing_wave};

pub(in super::super) const TANK: Benchmark = Benchmark {
    name: "melt/tank",
    tested_crate: "sph-fluid",
    reference: "p = rho g (H - z), and no flow, for 100 sqrt(H/g) after 50 of damping; nu = 0.02 H sqrt(g H)",
    quantities: &[
        Quantity {
            suffix: "pressure",
            text: "largest error of a particle's pressure, over rho g H; resolution: rows. 1 % takes 20 rows: the \
                   surface and the corners of the floor settle by a share of the spacing",
            marks: &[
                Mark { resolution: 10.0, error: 0.019 },
                Mark { resolution: 20.0, error: 0.01 },
                Mark { resolution: 30.0, error: 0.01 },
            ],
        },
        Quantity {
            suffix: "speed",
            text: "largest speed, over sqrt(g H); resolution: rows",
            marks: &[
                Mark { resolution: 10.0, error: 1e-3 },
                Mark { resolution: 20.0, error: 1e-3 },
                Mark { resolution: 30.0, error: 1e-3 },
            ],
        },
    ],
    resolutions: [10.0, 20.0, 30.0],
    quick: 1,
    run: |resolution| {
        let tank = tank(resolution as usize, 100.0, find)?;
        Ok(outcome(&tank.patch, vec![tank.pressure_error, tank.largest_speed]))
    },
};

pub(in super::super) const STANDING_WAVE: Benchmark = Benchmark {
    name: "melt/standing-wave",
    tested_crate: "sph-fluid",
    reference: "Airy's period 2 pi/sqrt(g k tanh(k H)) and Lamb's rate 2 nu k^2 of a wave of length 2 H at Re 500",
    quantities: &[
        Quantity {
            suffix: "period",
            text: "period over three periods, relative; resolution: rows",
            marks: &[Mark { resolution: 20.0, error: 0.0125 }, Mark { resolution: 100.0, error: 0.01 }],
        },
        Quantity {
            suffix: "decay",
            text: "rate of decay of the amplitude against Lamb's, relative, friction along pairs; resolution: rows",
            marks: &[Mark { resolution: 20.0, error: 0.1 }, Mark { resolution: 100.0, error: 0.1 }],
        },
        Quantity {
            suffix: "exact-decay",
            text: "the same against the root of the linear problem with the layer at the floor, 6.3 % below Lamb's rate, \
                   which is its first order in nu",
            marks: &[
                Mark { resolution: 20.0, error: 0.13 },
                Mark { resolution: 40.0, error: 0.045 },
                Mark { resolution: 100.0, error: 0.01 },
            ],
        },
    ],
    resolutions: [20.0, 40.0, 100.0],
    quick: 1,
    run: |resolution| {
        let wave = standing_wave(resolution as usize, Friction::Strain, find)?;
        let decays = [1.0, EXACT_DECAY].map(|exact| relative(wave.decay_rate, exact));
        Ok(outcome(&wave.patch, vec![relative(wave.period, 1.0), decays[0], decays[1]]))
    },
};

pub(in super::super) const DAM_BREAK: Benchmark = Benchmark {
    name: "melt/dam-break",
    tested_crate: "sph-fluid",
    reference: "experiment of Martin and Moyce (1952), column twice as high as wide",
    quantities: &[
        Quantity {
            suffix: "front",
            text: "place of the front, relative, mean over seven times; resolution: particles across the column. \
                   Without a gate the front is early: 7, 12, 14 % ahead at t sqrt(2 g/a) = 1.219 with 10, 20, 40, then less",
            marks: &[
                Mark { resolution: 10.0, error: 0.1 },
                Mark { resolution: 20.0, error: 0.1 },
                Mark { resolution: 40.0, error: 0.1 },
            ],
        },
        Quantity {
            suffix: "lost",
            text: "share of particles half a spacing or more behind a wall at t = 8 sqrt(a/g), after the far wall was hit",
            marks: &[Mark { resolution: 10.0, error: 0.0 }, Mark { resolution: 40.0, error: 0.0 }],
        },
    ],
    resolutions: [10.0, 20.0, 40.0],
    quick: 1,
    run: |resolution| {
        let mut dam = DamBreak::new(resolution as usize, find)?;
        let errors = dam.front_errors();
        let front = errors.iter().map(|error| error.abs()).sum::<f64>() / errors.len() as f64;
        dam.run_to(8.0);
        let lost = dam.lost() as f64 / dam.patch.positions().len() as f64;
        Ok(outcome(&dam.patch, vec![front, lost]))
    },
};
