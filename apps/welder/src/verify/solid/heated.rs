//! Blocks of aluminium that are warmed as a whole, and the heat of stretching.

use super::super::benchmark::{larger, relative};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::gough_joule::{exact_change, stretched};
use sph_solid::benchmarks::thermal::{free_expansion, held, held_stress};

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

/// Warming \[K\].
const WARMING: f64 = 100.0;

pub(in super::super) const BAR: Benchmark = constrained(
    "solid/constrained/bar",
    "a bar held at its ends, 100 K: St. Venant-Kirchhoff, exact, 0.6 % from -E alpha dT",
    |resolution| {
        let across = resolution as usize;
        let (stress, patch) = held([2 * across + 8, across, across], 1, WARMING, find)?;
        Ok(outcome(&patch, vec![relative(stress.in_plane[(0, 0)], held_stress(1, WARMING))]))
    },
);

pub(in super::super) const PLATE: Benchmark = constrained(
    "solid/constrained/plate",
    "a plate held in its plane, 100 K: St. Venant-Kirchhoff, exact, 0.5 % from -E alpha dT/(1 - nu)",
    |resolution| {
        let across = resolution as usize;
        // Plane strain holds the second direction.
        let (stress, patch) = held([2 * across + 8, across], 1, WARMING, find)?;
        let [along, out] = [stress.in_plane[(0, 0)], stress.out_of_plane]
            .map(|found| relative(found, held_stress(2, WARMING)));
        Ok(outcome(&patch, vec![larger(along, out)]))
    },
);

pub(in super::super) const BLOCK: Benchmark = constrained(
    "solid/constrained/block",
    "a block held on all sides, 100 K: St. Venant-Kirchhoff, exact, 1e-6 from -E alpha dT/(1 - 2 nu)",
    |resolution| {
        let (stress, patch) = held([resolution as usize + 8; 3], 3, WARMING, find)?;
        Ok(outcome(&patch, vec![relative(stress.trace() / 3.0, held_stress(3, WARMING))]))
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
            marks: &[Mark { resolution: 6.0, error: 3e-3 }, Mark { resolution: 10.0, error: 3e-3 }],
        }],
        resolutions: [6.0, 8.0, 10.0],
        quick: 1,
        run,
    }
}

pub(in super::super) const GOUGH_JOULE: Benchmark = Benchmark {
    name: "solid/gough-joule",
    tested_crate: "sph-solid",
    reference: "T = T0 exp(-3 K alpha (J - 1)/(rho c)), J = 1.001 and 0.999: -0.5748 and 0.5760 K (first order: 0.5754 K)",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error of the change of temperature, relative; resolution: particles to an edge",
        marks: &[Mark { resolution: 8.0, error: 1e-3 }, Mark { resolution: 16.0, error: 1e-3 }],
    }],
    resolutions: [8.0, 12.0, 16.0],
    quick: 1,
    run: |resolution| {
        let run = |strain: f64| -> Result<Outcome, BenchmarkError> {
            let (changes, patch) = stretched(resolution as usize, strain, find)?;
            let exact = exact_change(strain)?;
            let worst = changes.iter().map(|change| relative(*change, exact)).fold(0.0, larger);
            Ok(outcome(&patch, vec![worst]))
        };
        Ok(run(1e-3)?.worst(&run(-1e-3)?))
    },
};
