//! Promises that hold to the last bits: the energy ledger, and the same bits on any number of threads.

use super::scene::{block, reference_aluminium, run, spot, uniform_start};
use super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Levels};
use crate::model::{Model, ModelError};
use crate::run::Ledger;
use laser_source::{Beam, Gaussian};
use rayon::ThreadPoolBuilder;

/// 1/e² radius of the beam \[m\].
const BEAM_RADIUS: f64 = 0.6e-3;

pub(super) const LEDGER: Benchmark = Benchmark {
    name: "round-off/energy-ledger",
    tested_crate: "sph-thermal",
    reference: "absorbed laser energy = rise of stored enthalpy (closed scene that melts and freezes, disordered, levels)",
    quantities: &[Quantity {
        suffix: "",
        text: "what is missing over the energy turned over; resolution: spacings to the 1/e² radius",
        marks: &[
            Mark { resolution: 6.0, error: 1e-12 },
            Mark { resolution: 8.0, error: 1e-12 },
            Mark { resolution: 12.0, error: 1e-12 },
        ],
    }],
    resolutions: [6.0, 8.0, 12.0],
    quick: 3,
    run: |resolution| {
        let simulation = run(closed_spot(resolution)?)?;
        let residual = simulation.ledger().residual.abs();
        Ok(Outcome::of(&simulation, vec![residual]))
    },
};

pub(super) const THREADS: Benchmark = Benchmark {
    name: "round-off/threads",
    tested_crate: "sph-thermal",
    reference: "the same run on one thread",
    quantities: &[Quantity {
        suffix: "",
        text: "share of particles whose enthalpy has other bits on two threads; resolution: particles along an edge",
        marks: &[
            Mark { resolution: 44.0, error: 0.0 },
            Mark { resolution: 52.0, error: 0.0 },
            Mark { resolution: 60.0, error: 0.0 },
        ],
    }],
    resolutions: [44.0, 52.0, 60.0],
    quick: 1,
    run: two_threads,
};

/// A quarter of a 500 W spot on aluminium that freezes before the run ends.
fn closed_spot(resolution: f64) -> Result<Model, ModelError> {
    let count = |radii: f64| (radii * resolution).round() as usize;
    let counts = [count(4.0), count(4.0), count(3.0)];
    let mut model = block(counts, BEAM_RADIUS / resolution, vec![reference_aluminium()])?;
    model.start = uniform_start(293.0);
    (model.faces.x_min, model.faces.y_min) = (Face::Symmetry, Face::Symmetry);
    (model.resolution.disorder, model.resolution.levels) = (0.2, Levels::Auto);
    model.laser = Some(spot(Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS)), 500.0, 5e-3)?);
    (model.end, model.stop_when_solid) = (20e-3, true);
    Ok(model)
}

/// A cube of enough particles that every pass goes parallel, for a few steps.
fn large_cube(resolution: f64) -> Result<Model, ModelError> {
    let mut model = block([resolution as usize; 3], 50e-6, vec![reference_aluminium()])?;
    model.start = uniform_start(800.0);
    model.resolution.disorder = 0.1;
    model.laser = Some(spot(Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS)), 2000.0, 1e-3)?);
    model.end = 0.2e-3;
    Ok(model)
}

/// What a run on some threads leaves.
struct Trace {
    enthalpy: Vec<f64>,
    ledger: Ledger,
    steps: u64,
    outcome: Outcome,
}

fn trace(resolution: f64, threads: usize) -> Result<Trace, BenchmarkError> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
    let model = large_cube(resolution)?;
    pool.install(|| {
        let simulation = run(model)?;
        Ok(Trace {
            enthalpy: simulation.particles().enthalpy.clone(),
            ledger: simulation.ledger(),
            steps: simulation.steps(),
            outcome: Outcome::of(&simulation, Vec::new()),
        })
    })
}

fn two_threads(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let (one, two) = (trace(resolution, 1)?, trace(resolution, 2)?);
    let pairs = one.enthalpy.iter().zip(&two.enthalpy);
    let differing = pairs.filter(|(a, b)| a.to_bits() != b.to_bits()).count();
    let same = one.steps == two.steps && one.ledger == two.ledger;
    let share = if same { differing as f64 / one.enthalpy.len() as f64 } else { 1.0 };
    Ok(Outcome { errors: vec![share], ..two.outcome })
}
