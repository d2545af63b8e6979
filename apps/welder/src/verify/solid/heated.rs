//! Blocks of aluminium that are warmed as a whole, and the heat of stretching.

use super::super::benchmark::{larger, relative};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::gough_joule::stretched;
use sph_solid::benchmarks::thermal::{free_expansion, held};

pub(in super::super) const FREE: Benchmark = Benchmark {
    name: "solid/free-expansion",
    tested_crate: "sph-solid",
    reference: "a free cube, alpha dT = 1e-3: no stress, u = (exp(alpha dT) - 1) x",
    quantities: &[
        Quantity {
            suffix: "stress",
            text: "largest stress of all particles over E alpha dT; resolution: particles to an edge",
            marks: &[Mark { resolution: 8.0, error: 1e-3 }, Mark { resolution: 16.0, error: 1e-3 }],
        },
        Quantity {
            suffix: "displacement",
            text: "largest error of displacement, relative; resolution: particles to an edge",
            marks: &[Mark { resolution: 8.0, error: 1e-3 }, Mark { resolution: 16.0, error: 1e-3 }],
        },
    ],
    resolutions: [8.0, 12.0, 16.0],
    quick: 1,
    run: |resolution| {
        let block = free_expansion::<3>(resolution as usize, 0.8, 1e-3, find)?;
        Ok(outcome(&block.patch, vec![block.stress, block.displacement]))
    },
};

/// Aluminium, 100 K, alpha = 23.1e-6/K \[Pa\].
const BAR_STRESS: f64 = -161.7e6;
const PLATE_STRESS: f64 = BAR_STRESS / (1.0 - 0.33);
const BLOCK_STRESS: f64 = BAR_STRESS / (1.0 - 2.0 * 0.33);

pub(in super::super) const BAR: Benchmark =
    constrained("solid/constrained/bar", "-E alpha dT in a bar held at its ends, 100 K", |resolution| {
        let across = resolution as usize;
        let (stress, patch) = held([2 * across + 8, across, across], 1, 100.0, find)?;
        Ok(outcome(&patch, vec![relative(stress.in_plane[(0, 0)], BAR_STRESS)]))
    });

pub(in super::super) const PLATE: Benchmark = constrained(
    "solid/constrained/plate",
    "-E alpha dT/(1 - nu) in a plate held in its plane, 100 K",
    |resolution| {
        let across = resolution as usize;
        // Plane strain holds the second direction.
        let (stress, patch) = held([2 * across + 8, across], 1, 100.0, find)?;
        let [along, out] =
            [stress.in_plane[(0, 0)], stress.out_of_plane].map(|found| relative(found, PLATE_STRESS));
        Ok(outcome(&patch, vec![larger(along, out)]))
    },
);

pub(in super::super) const BLOCK: Benchmark = constrained(
    "solid/constrained/block",
    "-E alpha dT/(1 - 2 nu) in a block held on all sides, 100 K",
    |resolution| {
        let (stress, patch) = held([resolution as usize + 8; 3], 3, 100.0, find)?;
        Ok(outcome(&patch, vec![relative(stress.trace() / 3.0, BLOCK_STRESS)]))
    },
);

const fn constrained(
    name: &'static str,
    reference: &'static str,
    run: fn(f64) -> Result<Outcome, BenchmarkError>,
) -> Benchmark {
    Benchmark {
        name,
        tested_crate: "sph-solid",
        reference,
        quantities: &[Quantity {
            suffix: "",
            text: "stress in the middle, relative; resolution: free particles across",
            marks: &[Mark { resolution: 6.0, error: 0.01 }, Mark { resolution: 10.0, error: 0.01 }],
        }],
        resolutions: [6.0, 8.0, 10.0],
        quick: 1,
        run,
    }
}

/// Change of temperature of aluminium that is stretched by a thousandth at 293 K, c = 897 J/(kg K) \[K\].
const STRETCHED: f64 = -0.5754;

pub(in super::super) const GOUGH_JOULE: Benchmark = Benchmark {
    name: "solid/gough-joule",
    tested_crate: "sph-solid",
    reference: "dT = -3 K alpha T e/(rho c) = -0.5754 K",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error of the change of temperature, relative; resolution: particles to an edge",
        marks: &[Mark { resolution: 8.0, error: 0.01 }],
    }],
    resolutions: [8.0, 12.0, 16.0],
    quick: 1,
    run: |resolution| {
        let (changes, patch) = stretched(resolution as usize, 1e-3, find)?;
        let worst = changes.iter().map(|change| relative(*change, STRETCHED)).fold(0.0, larger);
        Ok(outcome(&patch, vec![worst]))
    },
};
