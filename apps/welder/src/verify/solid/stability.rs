//! The longest stable step.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::stability::longest_step;

const MARKS: &[Mark] = &[Mark { resolution: 6.0, error: 1.0 }, Mark { resolution: 10.0, error: 1.0 }];

pub(in super::super) const PLANE: Benchmark = Benchmark {
    name: "solid/step/plane",
    tested_crate: "sph-solid",
    reference: "steps of h/c_P must be stable with the default scheme, in plane strain",
    quantities: &[Quantity {
        suffix: "",
        text: "h/c_P over the longest step that keeps the energy of noise for 600 steps; resolution: particles to an edge",
        marks: MARKS,
    }],
    resolutions: [6.0, 8.0, 10.0],
    quick: 3,
    run: |resolution| {
        let (factor, patch) = longest_step::<2>(resolution as usize, find)?;
        Ok(outcome(&patch, vec![1.0 / factor]))
    },
};

pub(in super::super) const SPACE: Benchmark = Benchmark {
    name: "solid/step/space",
    reference: "steps of h/c_P must be stable with the default scheme, in space",
    quick: 1,
    run: |resolution| {
        let (factor, patch) = longest_step::<3>(resolution as usize, find)?;
        Ok(outcome(&patch, vec![1.0 / factor]))
    },
    ..PLANE
};
