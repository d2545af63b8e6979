//! The state of a fluid in a checkpoint.

use super::{FluidFlow, FluidRecords};
use crate::fluid::ledger::Work;
use crate::observe::{Checkpoint, CheckpointError};
use crate::physics::Cost;
use nalgebra::SVector;
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

const POSITION: [&str; 3] = ["position_x_m", "position_y_m", "position_z_m"];
const VELOCITY: [&str; 3] = ["velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s"];
const DENSITY: &str = "density_kg_m3";

impl<const D: usize> FluidFlow<D> {
    /// Everything that changes, for a checkpoint of the case with this digest.
    ///
    /// # Errors
    /// [`CheckpointError`] when a column cannot be encoded.
    pub fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        let mut checkpoint = Checkpoint {
            version: env!("CARGO_PKG_VERSION").to_string(),
            case_digest,
            time_s: self.time,
            step: self.steps,
            state: Vec::new(),
            columns: Vec::new(),
        };
        let (limits, cost, records, work) = (self.limits.clone(), self.cost, self.records, self.work);
        checkpoint.put_state(&Saved { limits, cost, records, work })?;
        for axis in 0..D {
            let along = |column: &[SVector<f64, D>]| column.iter().map(|x| x[axis]).collect::<Vec<f64>>();
            checkpoint.put_column(POSITION[axis], &along(self.positions()))?;
            checkpoint.put_column(VELOCITY[axis], &along(self.velocities()))?;
        }
        checkpoint.put_column(DENSITY, &self.densities[..self.fluid])?;
        Ok(checkpoint)
    }

    /// Takes up the state of a checkpoint of the same case.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is of other particles.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        let column = |name: &str| -> Result<Vec<f64>, CheckpointError> {
            let column: Vec<f64> = checkpoint.column(name)?;
            let reason = format!("it is of {} particles; the case has {}", column.len(), self.fluid);
            let fits = column.len() == self.fluid;
            fits.then_some(column).ok_or(CheckpointError::Content { name: name.into(), reason })
        };
        let saved: Saved = checkpoint.state()?;
        let densities = column(DENSITY)?;
        let (mut positions, mut velocities) = (Vec::new(), Vec::new());
        for axis in 0..D {
            positions.push(column(POSITION[axis])?);
            velocities.push(column(VELOCITY[axis])?);
        }
        let joined = |columns: &[Vec<f64>], i: usize| SVector::from_fn(|axis, _| columns[axis][i]);
        self.columns.positions = (0..self.fluid).map(|i| joined(&positions, i)).collect();
        self.columns.velocities = (0..self.fluid).map(|i| joined(&velocities, i)).collect();
        self.densities = densities;
        self.begin().map_err(|error| CheckpointError::Content {
            name: POSITION[0].into(),
            reason: error.to_string(),
        })?;
        (self.time, self.steps) = (checkpoint.time_s, checkpoint.step);
        (self.limits, self.cost) = (saved.limits, saved.cost);
        (self.records, self.work) = (saved.records, saved.work);
        Ok(())
    }
}
