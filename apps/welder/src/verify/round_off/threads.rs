//! The same bits on one and on two threads.

use super::super::scene::{block, reference_aluminium, run, spot, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::{BEAM_RADIUS, share_of_other_bits};
use crate::model::{Model, ModelError};
use crate::run::Ledger;
use laser_source::{Beam, Gaussian};
use rayon::ThreadPoolBuilder;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
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
    let same = one.steps == two.steps && one.ledger == two.ledger;
    let share = if same { share_of_other_bits(&one.enthalpy, &two.enthalpy) } else { 1.0 };
    Ok(Outcome { errors: vec![share], ..two.outcome })
}
