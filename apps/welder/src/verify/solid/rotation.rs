//! Blocks that turn or are sheared: stress must not see the turn.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome, updated_outcome};
use sph_solid::Controls;
use sph_solid::benchmarks::rotation::{sheared_updated, spin, turned, turned_updated, updated_controls};

pub(in super::super) const TURNED: Benchmark = Benchmark {
    name: "solid/rotation/total",
    tested_crate: "sph-solid",
    reference: "a stressed block turned ten times: S = Q S0 Q^T",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error over the stress, total Lagrangian; resolution: particles to an edge",
        marks: &[Mark { resolution: 8.0, error: 1e-6 }],
    }],
    resolutions: [8.0, 12.0, 16.0],
    quick: 3,
    run: |resolution| {
        let (error, patch) = turned(resolution as usize, 10.0, find)?;
        Ok(outcome(&patch, vec![error]))
    },
};

pub(in super::super) const TURNED_UPDATED: Benchmark = Benchmark {
    name: "solid/rotation/updated",
    tested_crate: "sph-solid",
    reference: "a stressed block turned ten times in 10 000 straight drifts: S = S0",
    quantities: &[
        Quantity {
            suffix: "stress",
            text: "largest error over the stress, updated Lagrangian, corrected; resolution: particles to an edge",
            marks: &[Mark { resolution: 6.0, error: 1e-6 }],
        },
        Quantity {
            suffix: "density",
            text: "largest error of density, relative; resolution: particles to an edge",
            marks: &[Mark { resolution: 6.0, error: 1e-6 }],
        },
    ],
    resolutions: [6.0, 8.0, 12.0],
    quick: 1,
    run: |resolution| {
        let (stress, density, patch) =
            turned_updated(resolution as usize, 10, updated_controls(false), find)?;
        Ok(updated_outcome(&patch, vec![stress, density]))
    },
};

pub(in super::super) const SHEARED: Benchmark = Benchmark {
    name: "solid/rotation/shear",
    tested_crate: "sph-solid",
    reference: "simple shear by 0.5 under Jaumann's rate: S_xy = G sin(0.5), S_xx = G (1 - cos(0.5)) (Dienes 1979)",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error over G, updated Lagrangian, corrected; resolution: particles to an edge",
        marks: &[Mark { resolution: 8.0, error: 0.01 }],
    }],
    resolutions: [8.0, 12.0, 16.0],
    quick: 1,
    run: |resolution| {
        let (error, patch) = sheared_updated(resolution as usize, 0.5, updated_controls(false), find)?;
        Ok(updated_outcome(&patch, vec![error]))
    },
};

pub(in super::super) const SPIN: Benchmark = Benchmark {
    name: "solid/spin",
    tested_crate: "sph-solid",
    reference: "a free cube turns twice: angular momentum and energy stay",
    quantities: &[
        Quantity {
            suffix: "momentum",
            text: "change of angular momentum, relative; resolution: particles to an edge",
            marks: &[Mark { resolution: 6.0, error: 1e-10 }, Mark { resolution: 8.0, error: 1e-10 }],
        },
        Quantity {
            suffix: "energy",
            text: "change of total energy, relative; resolution: particles to an edge",
            marks: &[Mark { resolution: 6.0, error: 1e-4 }, Mark { resolution: 8.0, error: 1e-4 }],
        },
    ],
    resolutions: [6.0, 8.0, 12.0],
    quick: 1,
    run: |resolution| {
        let spin = spin::<3>(resolution as usize, Controls::default(), find)?;
        Ok(outcome(&spin.patch, vec![spin.momentum.abs(), spin.energy.abs()]))
    },
};
