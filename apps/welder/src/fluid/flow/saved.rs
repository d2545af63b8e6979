//! The state of a fluid in a checkpoint.

use super::{FluidFlow, FluidRecords};
use crate::fluid::ledger::Work;
use crate::observe::{Checkpoint, CheckpointError};
use crate::physics::Cost;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a checkpoint holds beside the columns.
#[derive(Serialize, Deserialize)]
struct Saved {
    limits: BTreeMap<String, u64>,
    cost: Cost,
    records: FluidRecords,
    work: Work,
}

const POSITION: &str = "position_m";
const VELOCITY: &str = "velocity_m_s";
const DENSITY: &str = "density_kg_m3";

impl<const D: usize> FluidFlow<D> {
    /// Everything that changes, for a checkpoint of the case with this digest.
    ///
    /// # Errors
    /// [`CheckpointError`] when a column cannot be encoded.
    pub fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        let mut checkpoint = Checkpoint::new(case_digest, self.time, self.steps);
        let (limits, cost, records, work) = (self.limits.clone(), self.cost, self.records, self.work);
        checkpoint.put_state(&Saved { limits, cost, records, work })?;
        checkpoint.put_vectors(POSITION, self.positions())?;
        checkpoint.put_vectors(VELOCITY, self.velocities())?;
        checkpoint.put_column(DENSITY, &self.densities[..self.fluid])?;
        Ok(checkpoint)
    }

    /// Takes up the state of a checkpoint of the same case.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is of other particles.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        let saved: Saved = checkpoint.state()?;
        let densities = checkpoint.numbers(DENSITY, self.fluid)?;
        self.columns.velocities = checkpoint.vectors(VELOCITY, self.fluid)?;
        self.columns.positions = checkpoint.vectors(POSITION, self.fluid)?;
        self.densities = densities;
        self.begin()
            .map_err(|error| CheckpointError::Content { name: POSITION.into(), reason: error.to_string() })?;
        (self.time, self.steps) = (checkpoint.time_s, checkpoint.step);
        (self.limits, self.cost) = (saved.limits, saved.cost);
        (self.records, self.work) = (saved.records, saved.work);
        Ok(())
    }
}
