//! Elastic bodies that are stepped, kick-drift-kick.

use super::model::SolidModel;
use crate::model::ModelError;
use crate::observe::{Checkpoint, CheckpointError};
use crate::particles::bounding_box;
use crate::physics::{Column, Cost, Failure};
use crate::run::StepReport;
use nalgebra::{SMatrix, SVector};
use serde::{Deserialize, Serialize};
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::{SymmetricTensor, UpdatedPatch};
use std::collections::BTreeMap;

/// Part of h/c_P that a step takes.
const STEP_FACTOR: f64 = 0.4;

/// Steps of a stride.
const MOST_STEPS: usize = 20;

/// Particles nearer than this many spacings hang together.
const LINK: f64 = 1.7;

/// Bodies that have gained this share of the energy that there was have run away.
const LARGEST_GIFT: f64 = 0.1;

/// Largest of what was measured over a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SolidRecords {
    /// Largest speed of a particle \[m/s\].
    pub speed: f64,
    /// Largest von Mises stress \[Pa\].
    pub von_mises: f64,
}

/// Energies of the bodies \[J; J/m in the plane\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SolidLedger {
    /// Of motion.
    pub kinetic: f64,
    /// Of elastic strain, taken as small.
    pub elastic: f64,
    /// Of height over the start.
    pub potential: f64,
    /// Taken since the start by artificial viscosity and the scheme itself; negative where it has given.
    pub lost: f64,
    /// `lost` over the largest of the energies, that of the start included.
    pub residual: f64,
}

impl SolidLedger {
    /// What is wrong with it, if anything: energy from nowhere.
    pub fn fault(&self) -> Option<String> {
        let made = self.residual.is_nan() || self.residual < -LARGEST_GIFT;
        made.then(|| {
            format!(
                "the scheme itself gave {:.1e} of the largest energy; accepted: {LARGEST_GIFT}",
                -self.residual
            )
        })
    }
}

/// What a checkpoint holds beside the columns.
#[derive(Serialize, Deserialize)]
struct Saved {
    limits: BTreeMap<String, u64>,
    pair_visits: u64,
    records: SolidRecords,
}

/// A scene of elastic bodies at some time. Each stride begins with a
/// patch and an evaluation of its own, so that the columns are the whole state.
pub struct SolidBody<const D: usize> {
    model: SolidModel<D>,
    patch: UpdatedPatch<D>,
    spacings: Vec<f64>,
    start_energy: f64,
    time: f64,
    steps: u64,
    limits: BTreeMap<String, u64>,
    cost: Cost,
    records: SolidRecords,
}

/// Neighbours for the patch. Positions that are no numbers any more find nobody; the run is stopped after the stride.
fn find<const D: usize>(positions: &[SVector<f64, D>], reach: f64) -> (Vec<usize>, Vec<u32>) {
    let found = SearchMethod::default().find(positions, PairReach::Uniform(reach));
    found.map_or_else(
        |_| (vec![0; positions.len() + 1], Vec::new()),
        |list| (list.starts().to_vec(), list.indices().to_vec()),
    )
}

impl<const D: usize> SolidBody<D> {
    /// The bodies at their start.
    ///
    /// # Errors
    /// [`ModelError`] when the solid crate refuses the particles.
    pub fn new(model: SolidModel<D>) -> Result<Self, ModelError> {
        let (positions, material) = (model.positions.clone(), model.material.clone());
        let mut patch = UpdatedPatch::new(positions, material, model.controls, find)?;
        patch.velocities.clone_from(&model.velocities);
        for (i, held) in model.held.iter().enumerate() {
            if *held {
                patch.free[i] = SVector::zeros();
                patch.velocities[i] = SVector::zeros();
            }
        }
        let mut body = Self {
            spacings: vec![model.case.scene.spacing_m; patch.positions.len()],
            model,
            patch,
            start_energy: 0.0,
            time: 0.0,
            steps: 0,
            limits: BTreeMap::new(),
            cost: Cost::default(),
            records: SolidRecords::default(),
        };
        body.start_energy = body.patch.kinetic_energy() + body.patch.elastic_energy();
        body.record();
        Ok(body)
    }

    /// Takes a stride that does not pass `stop` \[s\].
    ///
    /// # Errors
    /// [`Failure`] of bodies whose numbers are none any more, or that move faster than waves in them.
    pub fn stride(&mut self, stop: f64) -> Result<StepReport, Failure> {
        self.renew()?;
        let longest = self.patch.stable_step(STEP_FACTOR);
        let mut report = StepReport { step: 0.0, limit: "none" };
        for _ in 0..MOST_STEPS {
            let left = stop - self.time;
            let parts = (left / longest).ceil().max(1.0);
            report = StepReport { step: left / parts, limit: if parts > 1.0 { "sound" } else { "event" } };
            self.weigh(0.5 * report.step);
            self.patch.step(report.step);
            self.weigh(0.5 * report.step);
            self.time = if parts > 1.0 { self.time + report.step } else { stop };
            self.steps += 1;
            *self.limits.entry(report.limit.to_string()).or_default() += 1;
            if parts == 1.0 {
                break;
            }
        }
        self.cost.pair_visits += self.patch.pair_visits();
        self.record();
        self.broken().map_or(Ok(report), Err)
    }

    /// A patch that remembers nothing but the columns, and one evaluation.
    fn renew(&mut self) -> Result<(), Failure> {
        let old = &mut self.patch;
        let (positions, material) = (std::mem::take(&mut old.positions), self.model.material.clone());
        let fresh = UpdatedPatch::new(positions, material, self.model.controls, find);
        let mut patch = fresh.map_err(|error| Failure {
            physics: "solid",
            what: error.to_string(),
            time: self.time,
            at: None,
            advice: "this is a fault of the program".into(),
        })?;
        patch.velocities = std::mem::take(&mut old.velocities);
        patch.densities = std::mem::take(&mut old.densities);
        patch.deviators = std::mem::take(&mut old.deviators);
        patch.free = std::mem::take(&mut old.free);
        self.patch = patch;
        self.patch.evaluate(0.0);
        Ok(())
    }

    /// The kick of gravity, which the patch does not know.
    fn weigh(&mut self, dt: f64) {
        for (velocity, free) in self.patch.velocities.iter_mut().zip(&self.patch.free) {
            *velocity += self.model.gravity.component_mul(free) * dt;
        }
    }

    fn broken(&self) -> Option<Failure> {
        let finite = |x: &SVector<f64, D>| x.iter().all(|x| x.is_finite());
        let bad = |&i: &usize| {
            let (position, velocity) = (&self.patch.positions[i], &self.patch.velocities[i]);
            !finite(position) || !finite(velocity) || velocity.norm() > self.model.wave_speed
        };
        let i = (0..self.patch.positions.len()).find(bad)?;
        let at = Some(self.patch.positions[i]).filter(finite);
        let what = match at {
            Some(_) => "a particle moves faster than waves of pressure do",
            None => "a position is no number any more",
        };
        Some(Failure {
            physics: "solid",
            what: what.into(),
            time: self.time,
            at: at.map(|x| std::array::from_fn(|axis| if axis < D { x[axis] } else { 0.0 })),
            advice: "try scheme.form: Paper where bodies meet, more scheme.artificial_stress, lower speeds, or a finer spacing_m"
                .into(),
        })
    }

    fn record(&mut self) {
        self.records.speed = self.records.speed.max(self.largest_speed());
        self.records.von_mises = self.records.von_mises.max(self.largest_von_mises());
    }

    /// Speed of the fastest particle \[m/s\].
    pub fn largest_speed(&self) -> f64 {
        self.patch.velocities.iter().map(SVector::norm).fold(0.0, f64::max)
    }

    fn von_mises(&self) -> impl Iterator<Item = f64> {
        self.patch.deviators.iter().map(SymmetricTensor::von_mises)
    }

    /// Largest von Mises stress \[Pa\].
    pub fn largest_von_mises(&self) -> f64 {
        self.von_mises().fold(0.0, f64::max)
    }

    /// The energy ledger now.
    pub fn ledger(&self) -> SolidLedger {
        let (kinetic, elastic) = (self.patch.kinetic_energy(), self.patch.elastic_energy());
        let fallen = |i: usize| self.model.gravity.dot(&(self.patch.positions[i] - self.model.positions[i]));
        let potential = -(0..self.spacings.len()).map(|i| self.patch.masses()[i] * fallen(i)).sum::<f64>();
        let lost = self.start_energy - kinetic - elastic - potential;
        let energies = [self.start_energy, kinetic, elastic, potential];
        let scale = energies.into_iter().fold(0.0, |largest: f64, energy| largest.max(energy.abs()));
        let residual = if scale > 0.0 { lost / scale } else { lost };
        SolidLedger { kinetic, elastic, potential, lost, residual }
    }

    /// Momentum \[kg m/s; per metre in the plane\].
    pub fn momentum(&self) -> SVector<f64, D> {
        let pairs = self.patch.masses().iter().zip(&self.patch.velocities);
        pairs.fold(SVector::zeros(), |sum, (mass, velocity)| sum + velocity * *mass)
    }

    /// Number of pieces that hang together.
    pub fn pieces(&self) -> usize {
        self.patch.pieces(LINK * self.model.case.scene.spacing_m)
    }

    /// Low and high corner of the box around the bodies' cells \[m\].
    pub fn bounds(&self) -> [SVector<f64, D>; 2] {
        let half = SVector::<f64, D>::repeat(0.5 * self.model.case.scene.spacing_m);
        let [low, high] = bounding_box(&self.patch.positions);
        [low - half, high + half]
    }

    /// Total mass \[kg; kg/m in the plane\].
    pub fn mass(&self) -> f64 {
        self.patch.masses().iter().sum()
    }

    /// The model.
    pub fn model(&self) -> &SolidModel<D> {
        &self.model
    }

    /// Positions \[m\].
    pub fn positions(&self) -> &[SVector<f64, D>] {
        &self.patch.positions
    }

    /// Spacing that each particle stands for \[m\].
    pub fn spacings(&self) -> &[f64] {
        &self.spacings
    }

    /// The longest step \[s\].
    pub fn longest_step(&self) -> f64 {
        self.patch.stable_step(STEP_FACTOR)
    }

    /// Time \[s\].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// How often each limit ruled.
    pub fn limits(&self) -> &BTreeMap<String, u64> {
        &self.limits
    }

    /// What the run has cost.
    pub fn cost(&self) -> Cost {
        self.cost
    }

    /// Largest of what was measured.
    pub fn records(&self) -> SolidRecords {
        self.records
    }

    /// Columns to be shown, by name with unit.
    pub fn columns(&self) -> Vec<(&'static str, Column<D>)> {
        let pairs = self.patch.positions.iter().zip(&self.model.positions);
        vec![
            ("velocity_m_s", Column::Vector(self.patch.velocities.clone())),
            ("displacement_m", Column::Vector(pairs.map(|(now, then)| now - then).collect())),
            ("von_mises_pa", Column::Scalar(self.von_mises().collect())),
            ("density_kg_m3", Column::Scalar(self.patch.densities.clone())),
            ("body", Column::Byte(self.model.bodies.clone())),
        ]
    }

    /// Everything that changes, for a checkpoint of the case with this digest.
    ///
    /// # Errors
    /// [`CheckpointError`] when a column cannot be encoded.
    pub fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        let mut checkpoint = Checkpoint::new(case_digest, self.time, self.steps);
        let limits = self.limits.clone();
        checkpoint.put_state(&Saved { limits, pair_visits: self.cost.pair_visits, records: self.records })?;
        checkpoint.put_vectors("position_m", &self.patch.positions)?;
        checkpoint.put_vectors("velocity_m_s", &self.patch.velocities)?;
        checkpoint.put_column("density_kg_m3", &self.patch.densities)?;
        let tensor =
            |s: &SymmetricTensor<D>| s.in_plane.iter().copied().chain([s.out_of_plane]).collect::<Vec<f64>>();
        let deviators: Vec<f64> = self.patch.deviators.iter().flat_map(tensor).collect();
        checkpoint.put_column("deviator_pa", &deviators)?;
        Ok(checkpoint)
    }

    /// Takes up the state of a checkpoint of the same case.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is of other particles.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        let count = self.patch.positions.len();
        let saved: Saved = checkpoint.state()?;
        let (positions, velocities) =
            (checkpoint.vectors("position_m", count)?, checkpoint.vectors("velocity_m_s", count)?);
        let densities = checkpoint.numbers("density_kg_m3", count)?;
        let deviators = checkpoint.numbers("deviator_pa", count * (D * D + 1))?;
        (self.patch.positions, self.patch.velocities, self.patch.densities) =
            (positions, velocities, densities);
        let tensor = |flat: &[f64]| SymmetricTensor {
            in_plane: SMatrix::from_column_slice(&flat[..D * D]),
            out_of_plane: flat[D * D],
        };
        self.patch.deviators = deviators.chunks_exact(D * D + 1).map(tensor).collect();
        (self.time, self.steps) = (checkpoint.time_s, checkpoint.step);
        (self.limits, self.records) = (saved.limits, saved.records);
        self.cost.pair_visits = saved.pair_visits;
        Ok(())
    }
}
