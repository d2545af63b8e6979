//! Elastic bodies that are stepped, kick-drift-kick.

use super::account::{SolidLedger, SolidRecords};
use super::model::SolidModel;
use super::patch::Patch;
use crate::model::ModelError;
use crate::observe::{Checkpoint, CheckpointError};
use crate::particles::bounding_box;
use crate::physics::{Column, Cost, Failure, principal_extremes};
use crate::run::StepReport;
use nalgebra::SVector;
use serde::{Deserialize, Serialize};
use sph_solid::{START_TEMPERATURE, SymmetricTensor};
use std::collections::BTreeMap;

/// Part of h/c_P that a step takes.
const STEP_FACTOR: f64 = 0.4;

/// Steps of a stride.
const MOST_STEPS: usize = 20;

/// What a checkpoint holds beside the columns.
#[derive(Serialize, Deserialize)]
struct Saved {
    limits: BTreeMap<String, u64>,
    pair_visits: u64,
    records: SolidRecords,
    heated: f64,
    driven: f64,
    plastic: f64,
    damped: f64,
}

/// A scene of elastic bodies at some time. Each stride begins with a
/// patch and an evaluation of its own, so that the columns are the whole state.
pub struct SolidBody<const D: usize> {
    model: SolidModel<D>,
    patch: Patch<D>,
    spacings: Vec<f64>,
    start_energy: f64,
    time: f64,
    steps: u64,
    limits: BTreeMap<String, u64>,
    cost: Cost,
    records: SolidRecords,
    heated: f64,
    /// Work of what is moved, but for that against gravity.
    driven: f64,
    plastic: f64,
    damped: f64,
    /// Equivalent plastic strains whose work is in `plastic`.
    accounted: Vec<f64>,
}

impl<const D: usize> SolidBody<D> {
    /// The bodies at their start.
    ///
    /// # Errors
    /// [`ModelError`] when the solid crate refuses the particles.
    pub fn new(model: SolidModel<D>) -> Result<Self, ModelError> {
        let patch = Patch::new(&model)?;
        let mut body = Self {
            spacings: vec![model.case.scene.spacing_m; model.positions.len()],
            model,
            patch,
            start_energy: 0.0,
            time: 0.0,
            steps: 0,
            limits: BTreeMap::new(),
            cost: Cost::default(),
            records: SolidRecords::default(),
            heated: 0.0,
            driven: 0.0,
            plastic: 0.0,
            damped: 0.0,
            accounted: Vec::new(),
        };
        body.accounted = body.patch.equivalents().to_vec();
        body.start_energy = body.patch.energies().iter().sum();
        body.record();
        Ok(body)
    }

    /// Takes a stride that does not pass `stop` \[s\].
    ///
    /// # Errors
    /// [`Failure`] of bodies whose numbers are none any more, or that move faster than waves in them.
    pub fn stride(&mut self, stop: f64) -> Result<StepReport, Failure> {
        let before = self.renew()?;
        let longest = self.patch.stable_step(STEP_FACTOR);
        let mut report = StepReport { step: 0.0, limit: "none" };
        for _ in 0..MOST_STEPS {
            let left = stop - self.time;
            let parts = (left / longest).ceil().max(1.0);
            report = StepReport { step: left / parts, limit: if parts > 1.0 { "sound" } else { "event" } };
            let next = if parts > 1.0 { self.time + report.step } else { stop };
            if self.model.warms(self.time, next) {
                self.heated += self.patch.set_temperatures(&self.model, next);
            }
            // The kicks of gravity, which the patch does not know.
            self.patch.push(&(self.model.gravity * (0.5 * report.step)));
            self.patch.step(report.step);
            self.patch.push(&(self.model.gravity * (0.5 * report.step)));
            self.damp(report.step);
            self.add_yield();
            self.time = next;
            self.steps += 1;
            *self.limits.entry(report.limit.to_string()).or_default() += 1;
            if parts == 1.0 {
                break;
            }
        }
        self.cost.pair_visits += self.patch.pair_visits() - before;
        self.driven += self.patch.driven_work();
        self.record();
        self.broken().map_or(Ok(report), Err)
    }

    /// Makes the columns the whole state, and returns what the patch counted before.
    fn renew(&mut self) -> Result<u64, Failure> {
        let before = match &self.patch {
            Patch::Updated(_) => 0,
            Patch::Total(patch) => patch.pair_visits(),
        };
        self.patch.renew(&self.model).map_err(|error| Failure {
            physics: "solid",
            what: error.to_string(),
            time: self.time,
            at: None,
            advice: "this is a fault of the program".into(),
        })?;
        Ok(before)
    }

    /// Lets velocities fade over a step \[s\].
    fn damp(&mut self, dt: f64) {
        let rate = self.model.case.scene.damping_1_s;
        if rate > 0.0 {
            let kept = (-rate * dt).exp();
            let free = |i: &usize| !self.model.held[*i];
            let (masses, velocities) = (self.patch.masses(), self.patch.velocities());
            let kinetic: f64 =
                (0..masses.len()).filter(free).map(|i| 0.5 * masses[i] * velocities[i].norm_squared()).sum();
            self.damped += kinetic * (1.0 - kept * kept);
            self.patch.fade(kept);
        }
    }

    /// Adds the work of what has yielded, at the yield stress of the temperatures of the moment.
    fn add_yield(&mut self) {
        let Some(law) = &self.model.material.yield_stress else { return };
        let density = self.model.case.scene.material.density_kg_m3;
        let (strains, temperatures) = (self.patch.equivalents(), self.patch.temperatures());
        for (i, accounted) in self.accounted.iter_mut().enumerate().filter(|(i, now)| strains[*i] != **now) {
            let volume = self.patch.masses()[i] / density;
            self.plastic += volume * law.at(temperatures[i]) * (strains[i] - *accounted);
            *accounted = strains[i];
        }
    }

    fn broken(&self) -> Option<Failure> {
        let finite = |x: &SVector<f64, D>| x.iter().all(|x| x.is_finite());
        let bad = |&i: &usize| {
            let (position, velocity) = (&self.patch.positions()[i], &self.patch.velocities()[i]);
            !finite(position) || !finite(velocity) || velocity.norm() > self.model.wave_speed
        };
        let i = (0..self.spacings.len()).find(bad)?;
        let at = Some(self.patch.positions()[i]).filter(finite);
        let what = match at {
            Some(_) => "a particle moves faster than waves of pressure do",
            None => "a position is no number any more",
        };
        Some(Failure {
            physics: "solid",
            what: what.into(),
            time: self.time,
            at: at.map(|x| std::array::from_fn(|axis| if axis < D { x[axis] } else { 0.0 })),
            advice: "try scheme.form: Total, more scheme.artificial_stress in the paper's form, lower speeds, or a finer spacing_m"
                .into(),
        })
    }

    fn record(&mut self) {
        self.records = self.records.with(&self.largest());
    }

    /// The largest of everything now.
    pub fn largest(&self) -> SolidRecords {
        let stresses = self.patch.stresses();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        SolidRecords {
            speed: largest(&mut self.patch.velocities().iter().map(SVector::norm)),
            von_mises: largest(&mut stresses.iter().map(SymmetricTensor::von_mises)),
            principal: principal_extremes(&stresses),
            displacement: largest(&mut self.displacements().map(|moved| moved.norm())),
            plastic: largest(&mut self.patch.equivalents().iter().copied()),
        }
    }

    /// Displacements from the start \[m\].
    fn displacements(&self) -> impl Iterator<Item = SVector<f64, D>> {
        self.patch.positions().iter().zip(&self.model.positions).map(|(now, then)| now - then)
    }

    /// The energy ledger now.
    pub fn ledger(&self) -> SolidLedger {
        let ([kinetic, elastic], masses) = (self.patch.energies(), self.patch.masses());
        let fallen =
            |i: usize| self.model.gravity.dot(&(self.patch.positions()[i] - self.model.positions[i]));
        let weight = |i: usize| -masses[i] * fallen(i);
        let potential = (0..self.spacings.len()).map(weight).sum::<f64>();
        // What is moved is carried as well.
        let carried = (0..self.spacings.len()).filter(|&i| self.model.held[i]).map(weight).sum::<f64>();
        let (heated, driven) = (self.heated, self.driven + carried);
        let (plastic, damped) = (self.plastic, self.damped);
        let lost = self.start_energy + heated + driven - kinetic - elastic - potential - plastic - damped;
        let energies = [self.start_energy, kinetic, elastic, potential, heated, driven, plastic, damped];
        let scale = energies.into_iter().fold(0.0, |largest: f64, energy| largest.max(energy.abs()));
        let residual = if scale > 0.0 { lost / scale } else { lost };
        SolidLedger { kinetic, elastic, potential, heated, driven, plastic, damped, lost, residual }
    }

    /// Momentum \[kg m/s; per metre in the plane\].
    pub fn momentum(&self) -> SVector<f64, D> {
        let pairs = self.patch.masses().iter().zip(self.patch.velocities());
        pairs.fold(SVector::zeros(), |sum, (mass, velocity)| sum + velocity * *mass)
    }

    /// Number of pieces that hang together.
    pub fn pieces(&self) -> usize {
        self.patch.pieces(self.model.case.scene.spacing_m)
    }

    /// Low and high corner of the box around the bodies' cells \[m\].
    pub fn bounds(&self) -> [SVector<f64, D>; 2] {
        let half = SVector::<f64, D>::repeat(0.5 * self.model.case.scene.spacing_m);
        let [low, high] = bounding_box(self.patch.positions());
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
        self.patch.positions()
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
        let stresses = self.patch.stresses();
        let rises = self.patch.temperatures().iter().map(|temperature| temperature - START_TEMPERATURE);
        vec![
            ("velocity_m_s", Column::Vector(self.patch.velocities().to_vec())),
            ("displacement_m", Column::Vector(self.displacements().collect())),
            ("von_mises_pa", Column::Scalar(stresses.iter().map(SymmetricTensor::von_mises).collect())),
            (
                "principal_stress_pa",
                Column::Triple(stresses.iter().map(SymmetricTensor::principal).collect()),
            ),
            ("pressure_pa", Column::Scalar(stresses.iter().map(|stress| -stress.trace() / 3.0).collect())),
            ("plastic_strain", Column::Scalar(self.patch.equivalents().to_vec())),
            ("temperature_rise_k", Column::Scalar(rises.collect())),
            ("density_kg_m3", Column::Scalar(self.patch.densities())),
            ("body", Column::Byte(self.model.bodies.clone())),
        ]
    }

    /// Everything that changes, for a checkpoint of the case with this digest.
    ///
    /// # Errors
    /// [`CheckpointError`] when a column cannot be encoded.
    pub fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        let mut checkpoint = Checkpoint::new(case_digest, self.time, self.steps);
        checkpoint.put_state(&Saved {
            limits: self.limits.clone(),
            pair_visits: self.cost.pair_visits,
            records: self.records,
            heated: self.heated,
            driven: self.driven,
            plastic: self.plastic,
            damped: self.damped,
        })?;
        self.patch.save(&mut checkpoint)?;
        Ok(checkpoint)
    }

    /// Takes up the state of a checkpoint of the same case.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is of other particles.
    pub fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        let saved: Saved = checkpoint.state()?;
        self.patch.restore(checkpoint, &self.model, checkpoint.time_s)?;
        (self.time, self.steps) = (checkpoint.time_s, checkpoint.step);
        (self.limits, self.records) = (saved.limits, saved.records);
        self.cost.pair_visits = saved.pair_visits;
        (self.heated, self.driven) = (saved.heated, saved.driven);
        (self.plastic, self.damped) = (saved.plastic, saved.damped);
        self.accounted = self.patch.equivalents().to_vec();
        Ok(())
    }
}
