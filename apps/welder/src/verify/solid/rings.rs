//! Rubber rings that collide.

use super::super::{Benchmark, Mark, Outcome, Quantity};
use super::{find, outcome, updated_outcome};
use sph_solid::Controls;
use sph_solid::benchmarks::rings::{Rings, collide, collide_updated};

/// What is asked for: Poisson's ratios and speeds over c0.
const CASES: [(f64, f64); 4] = [(0.3975, 0.06), (0.3975, 0.12), (0.47, 0.06), (0.47, 0.12)];

/// A tenth of a spacing can be seen.
const ZIGZAG: &[Mark] = &[Mark { resolution: 6.0, error: 0.1 }, Mark { resolution: 10.0, error: 0.1 }];

pub(in super::super) const RINGS: Benchmark = Benchmark {
    name: "solid/rings",
    tested_crate: "sph-solid",
    reference: "two rings part whole, momentum and loss zero (after Gray, Monaghan, Swift 2001); worst of nu = 0.3975, 0.47 at 0.06, 0.12 c0",
    quantities: &[
        Quantity {
            suffix: "pieces",
            text: "pieces more or less than two, 14 ms after the start; resolution: particles to the wall",
            marks: &[Mark { resolution: 6.0, error: 0.0 }, Mark { resolution: 10.0, error: 0.0 }],
        },
        Quantity {
            suffix: "momentum",
            text: "momentum over that of one ring; resolution: particles to the wall",
            marks: &[Mark { resolution: 6.0, error: 1e-12 }, Mark { resolution: 10.0, error: 1e-12 }],
        },
        Quantity {
            suffix: "energy",
            text: "energy that the scheme itself takes or gives, relative; resolution: particles to the wall",
            marks: &[Mark { resolution: 6.0, error: 5e-3 }, Mark { resolution: 10.0, error: 5e-3 }],
        },
        Quantity {
            suffix: "zigzag",
            text: "largest displacement that changes its sign from neighbour to neighbour, in spacings (fourth difference over 16), 14 ms after the start, but for nu = 0.47 at 0.12 c0; resolution: particles to the wall",
            marks: ZIGZAG,
        },
        Quantity {
            suffix: "zigzag-hardest",
            text: "the same for nu = 0.47 at 0.12 c0; resolution: particles to the wall",
            marks: ZIGZAG,
        },
    ],
    resolutions: [6.0, 8.0, 10.0],
    quick: 1,
    run: |resolution| {
        let mut worst = Outcome { errors: vec![0.0; 5], particles: 0, pair_visits: 0 };
        for (poisson, speed) in CASES {
            let end =
                collide(&Rings { cells: resolution as usize, poisson, speed }, Controls::default(), find)?;
            let hardest = (poisson, speed) == CASES[3];
            let [zigzag, hard] = if hardest { [0.0, end.zigzag] } else { [end.zigzag, 0.0] };
            let pieces = end.pieces.abs_diff(2) as f64;
            let one = outcome(&end.patch, vec![pieces, end.momentum, end.lost.abs(), zigzag, hard]);
            worst = worst.worst(&one);
        }
        Ok(worst)
    },
};

/// At 0.06 c0. At 0.12 c0 rings of the same rubber break in this form, which the example `rings` of the crate shows.
pub(in super::super) const PAPER_RINGS: Benchmark = Benchmark {
    name: "solid/rings-paper",
    tested_crate: "sph-solid",
    reference: "Gray, Monaghan, Swift (2001), in the paper's form, nu = 0.3975, 0.06 c0: two rings part whole, momentum zero",
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
        let rings = Rings { cells: resolution as usize, poisson: 0.3975, speed: 0.06 };
        let end = collide_updated(&rings, 0.3, find)?;
        Ok(updated_outcome(&end.patch, vec![end.pieces.abs_diff(2) as f64, end.momentum]))
    },
};
