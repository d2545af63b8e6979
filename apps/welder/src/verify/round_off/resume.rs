//! The same bits for a run and for one that was stopped, written to bytes, read and gone on with.

use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::ledger::closed_spot;
use super::share_of_other_bits;
use crate::observe::Checkpoint;
use crate::run::Simulation;
use std::path::Path;

/// When the run is stopped \[s\]: while there is light and melt.
const STOP: f64 = 3e-3;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "round-off/resume",
    tested_crate: "welder",
    reference: "the same run without a stop",
    quantities: &[Quantity {
        suffix: "",
        text: "share of particles whose enthalpy has other bits after a stop and a resumption; resolution: spacings to \
               the 1/e² radius",
        marks: &[
            Mark { resolution: 6.0, error: 0.0 },
            Mark { resolution: 8.0, error: 0.0 },
            Mark { resolution: 12.0, error: 0.0 },
        ],
    }],
    resolutions: [6.0, 8.0, 12.0],
    quick: 2,
    run: stopped_and_resumed,
};

fn stopped_and_resumed(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let model = closed_spot(resolution)?;
    let mut unbroken = Simulation::new(model.clone())?;
    while unbroken.time() < STOP {
        unbroken.step(model.end)?;
    }
    let bytes = unbroken.save(0, 0.0)?.to_bytes()?;
    unbroken.run_quietly()?;
    let mut resumed = Simulation::new(model)?;
    resumed.restore(&Checkpoint::from_bytes(&bytes, Path::new("memory"))?)?;
    resumed.run_quietly()?;
    let same = unbroken.steps() == resumed.steps()
        && unbroken.ledger() == resumed.ledger()
        && unbroken.records() == resumed.records();
    let share = share_of_other_bits(&unbroken.particles().enthalpy, &resumed.particles().enthalpy);
    Ok(Outcome::of(&resumed, vec![if same { share } else { 1.0 }]))
}
