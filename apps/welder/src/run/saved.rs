//! The state of a simulation in a checkpoint: what it takes to go on with the same bits.

use super::{Records, Simulation};
use crate::observe::{Checkpoint, CheckpointError};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

#[derive(Serialize, Deserialize)]
struct Saved {
    /// By how much the fine box was grown \[m\]: without it the particles would be others.
    grown: f64,
    /// The state of each physics, under its name.
    physics: Vec<(String, Vec<u8>)>,
    gauge: (Vec<f64>, Vec<f64>),
    limits: BTreeMap<String, u64>,
    records: Records,
}

const ENTHALPY: &str = "enthalpy_j_kg";
const POSITION: &str = "position_m";
const PEAK_ENTHALPY: &str = "peak_enthalpy_j_kg";

impl Simulation {
    /// Everything that changes, for a checkpoint of the case with this digest.
    ///
    /// # Errors
    /// [`CheckpointError`] when a column cannot be encoded.
    pub fn save(&self, case_digest: u32, grown: f64) -> Result<Checkpoint, CheckpointError> {
        let mut checkpoint = Checkpoint::new(case_digest, self.time, self.steps);
        checkpoint.put_state(&Saved {
            grown,
            physics: self.physics.iter().map(|p| (p.name().to_string(), p.save())).collect(),
            gauge: self.gauge.save(),
            limits: self.limits.clone(),
            records: self.records.clone(),
        })?;
        checkpoint.put_column(ENTHALPY, &self.workpiece.particles.enthalpy)?;
        checkpoint.put_column(PEAK_ENTHALPY, &self.workpiece.particles.peak_enthalpy)?;
        if self.model.flow.is_some() {
            checkpoint.put_vectors(POSITION, &self.workpiece.particles.position)?;
        }
        Ok(checkpoint)
    }

    /// By how much the fine box of a checkpoint was grown \[m\].
    ///
    /// # Errors
    /// [`CheckpointError`] when the state cannot be decoded.
    pub fn grown_of(checkpoint: &Checkpoint) -> Result<f64, CheckpointError> {
        Ok(checkpoint.state::<Saved>()?.grown)
    }

    /// Takes up the state of a checkpoint of the same case.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is of other particles or other physics.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        let wrong = |reason: String| CheckpointError::Content { name: "state".into(), reason };
        let saved: Saved = checkpoint.state()?;
        let count = self.workpiece.particles.len();
        let (enthalpy, peak_enthalpy) =
            (checkpoint.numbers(ENTHALPY, count)?, checkpoint.numbers(PEAK_ENTHALPY, count)?);
        let (found, listed) = (saved.physics.len(), self.physics.len());
        if found != listed {
            return Err(wrong(format!("it is of {found} physics; the case lists {listed}")));
        }
        self.workpiece.particles.enthalpy = enthalpy;
        self.workpiece.particles.peak_enthalpy = peak_enthalpy;
        if self.model.flow.is_some() {
            self.workpiece.particles.position = checkpoint.vectors(POSITION, count)?;
        }
        for (physics, (name, state)) in self.physics.iter_mut().zip(&saved.physics) {
            if physics.name() != name {
                return Err(wrong(format!("it holds {name} where the case has {}", physics.name())));
            }
            physics.restore(&self.workpiece.particles, state).map_err(wrong)?;
        }
        if self.model.flow.is_some() {
            self.rearrange().map_err(|error| wrong(error.to_string()))?;
        }
        self.gauge.restore(saved.gauge).map_err(wrong)?;
        (self.time, self.steps) = (checkpoint.time_s, checkpoint.step);
        (self.limits, self.records) = (saved.limits, saved.records);
        Ok(())
    }
}
