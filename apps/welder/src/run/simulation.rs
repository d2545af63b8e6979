//! A simulation: particles, physics and gauge, advanced step by step.

use super::regime::recoil_over_tension;
use super::{Ledger, level_plan};
use crate::build::{LevelPlan, Workpiece};
use crate::measure::{Extent, Gauge, Measure};
use crate::model::{Model, ModelError};
use crate::particles::Particles;
use crate::physics::{
    Column, Cost, Exchange, Failure, Mechanics, Physics, flow::Flow, heat::Heat, stress::Stress,
};
use serde::{Deserialize, Serialize};
use sph_integrate::{StepLimit, smallest};
use std::collections::BTreeMap;

/// Largest and last of what was measured over a run.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Records {
    /// Largest extents above the liquidus.
    pub liquidus: Extent,
    /// Largest extents above the solidus.
    pub solidus: Extent,
    /// Highest temperature of the top face \[K\].
    pub peak_temperature: f64,
    /// Largest speed of the melt \[m/s\].
    pub largest_speed: f64,
    /// Largest speed of the melt over its artificial sound at the time \[-\].
    pub largest_mach: f64,
    /// Largest recoil of vapour over what tension holds \[-\]; zero where the material does not tell.
    pub recoil_over_tension: f64,
    /// When the last melt froze \[s\].
    pub solidified_at: Option<f64>,
    /// The last measure.
    pub now: Measure,
}

/// What one step did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepReport {
    /// Its length \[s\].
    pub step: f64,
    /// What limited it.
    pub limit: &'static str,
}

/// A model on particles, at some time.
pub struct Simulation {
    pub(super) model: Model,
    pub(super) workpiece: Workpiece,
    pub(super) physics: Vec<Box<dyn Physics<3>>>,
    pub(super) gauge: Gauge,
    pub(super) time: f64,
    pub(super) steps: u64,
    pub(super) limits: BTreeMap<String, u64>,
    pub(super) records: Records,
}

impl Simulation {
    /// Builds the particles and physics of a model.
    ///
    /// # Errors
    /// [`ModelError`] when a crate refuses what the case asks for.
    pub fn new(model: Model) -> Result<Self, ModelError> {
        let plan = level_plan(&model, 0.0)?;
        Self::with_plan(model, &plan)
    }

    /// The same on given levels of spacing.
    ///
    /// # Errors
    /// [`ModelError`] when a crate refuses what the case asks for.
    pub fn with_plan(model: Model, plan: &LevelPlan<3>) -> Result<Self, ModelError> {
        let workpiece = Workpiece::new(&model, plan);
        let heat = Heat::new(&model, &workpiece)?;
        Self::around(model, workpiece, heat)
    }

    /// The same around particles and heat that are built already.
    ///
    /// # Errors
    /// [`ModelError`] when a crate refuses what the case asks for.
    pub(crate) fn around(model: Model, workpiece: Workpiece, heat: Heat) -> Result<Self, ModelError> {
        let mut physics: Vec<Box<dyn Physics<3>>> = vec![Box::new(heat)];
        if let Some(flow) = &model.flow {
            physics.push(Box::new(Flow::new(&model, flow, &workpiece)?));
        }
        if let Some(stress) = &model.stress {
            physics.push(Box::new(Stress::new(&model, stress, &workpiece)?));
        }
        let mut gauge = Gauge::new(&model, &workpiece)?;
        let now = gauge.measure(&model, &workpiece.particles, 0.0, 0.0);
        let records = Records { peak_temperature: now.peak_temperature, now, ..Records::default() };
        Ok(Self { model, workpiece, physics, gauge, time: 0.0, steps: 0, limits: BTreeMap::new(), records })
    }

    /// Advances by one step that does not pass `stop` \[s\].
    ///
    /// # Errors
    /// [`Failure`] of the physics that cannot go on.
    pub fn step(&mut self, stop: f64) -> Result<StepReport, Failure> {
        let event =
            self.physics.iter().filter_map(|physics| physics.next_event(self.time)).fold(stop, f64::min);
        let limit = smallest(self.physics.iter().map(|physics| physics.step_limit(self.time)));
        let (wanted, limit) = self.fit(limit, event);
        let mut taken = wanted;
        for physics in &mut self.physics {
            taken = physics.advance(&mut self.workpiece.particles, self.time, taken)?;
        }
        if self.physics.iter().any(|physics| physics.moves()) {
            self.rearrange().map_err(|error| self.lost_neighbors(&error))?;
        } else if self.physics.iter().any(|physics| physics.warms()) {
            let particles = &self.workpiece.particles;
            self.physics.iter_mut().for_each(|physics| physics.take_heat(particles));
        }
        let start = self.time;
        self.time = if taken == wanted && wanted == event - start { event } else { start + taken };
        self.steps += 1;
        *self.limits.entry(limit.name.to_string()).or_default() += 1;
        self.record(start, taken);
        Ok(StepReport { step: taken, limit: limit.name })
    }

    /// Finds neighbours, weights and the gauge's nodes anew, after particles have moved.
    pub(super) fn rearrange(&mut self) -> Result<(), ModelError> {
        for physics in &mut self.physics {
            physics.rearrange(&self.model, &self.workpiece)?;
        }
        self.gauge.rearrange(&self.model, &self.workpiece);
        Ok(())
    }

    fn lost_neighbors(&self, error: &ModelError) -> Failure {
        Failure {
            physics: "heat",
            what: format!("the particles that have moved cannot be taken up: {error}"),
            time: self.time,
            at: None,
            advice: "see the dossier for where the melt has gone".into(),
        }
    }

    /// Cuts a step to end on `event`, or halves what is left so that no sliver remains.
    fn fit(&self, limit: StepLimit, event: f64) -> (f64, StepLimit) {
        let left = event - self.time;
        if limit.dt_s >= left {
            (left, StepLimit { name: "event", dt_s: left })
        } else if limit.dt_s > 0.5 * left {
            (0.5 * left, limit)
        } else {
            (limit.dt_s, limit)
        }
    }

    fn record(&mut self, start: f64, step: f64) {
        let before = self.records.now.over_solidus;
        let now = self.gauge.measure(&self.model, &self.workpiece.particles, self.time, step);
        let flow = if self.model.flow.is_some() { self.mechanics() } else { None };
        let recoil = self.recoil_over_tension(&now);
        let records = &mut self.records;
        records.recoil_over_tension = records.recoil_over_tension.max(recoil);
        if before > 0.0 && now.over_solidus <= 0.0 {
            records.solidified_at = Some(start + step * before / (before - now.over_solidus));
        } else if now.over_solidus > 0.0 {
            records.solidified_at = None;
        }
        records.liquidus = records.liquidus.max(&now.liquidus);
        records.solidus = records.solidus.max(&now.solidus);
        records.peak_temperature = records.peak_temperature.max(now.peak_temperature);
        records.now = now;
        if let Some(flow) = flow {
            records.largest_speed = records.largest_speed.max(flow.largest_speed);
            records.largest_mach = records.largest_mach.max(flow.largest_speed / flow.sound_speed);
        }
    }

    /// Recoil of vapour over what tension holds at a measure, by the tension of the part's own material.
    fn recoil_over_tension(&self, now: &Measure) -> f64 {
        let (Some(vapour), Some(tension)) = (&self.model.evaporation[0], &self.model.tension) else {
            return 0.0;
        };
        let (radius, rim) = (0.5 * now.liquidus.width, self.model.materials[0].liquidus);
        recoil_over_tension(vapour, tension.at(now.peak_temperature), radius, now.peak_temperature, rim)
    }

    /// Whether there is nothing left to do.
    pub fn finished(&self) -> bool {
        let dark = self.model.laser.as_ref().is_none_or(|laser| self.time >= laser.track().end_time());
        let frozen = self.model.stop_when_solid && dark && self.records.now.over_solidus <= 0.0;
        self.time >= self.model.end || frozen
    }

    /// Runs to the end without anyone watching.
    ///
    /// # Errors
    /// [`Failure`] of the physics that cannot go on.
    pub fn run_quietly(&mut self) -> Result<(), Failure> {
        while !self.finished() {
            self.step(self.model.end)?;
        }
        Ok(())
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The workpiece.
    pub fn workpiece(&self) -> &Workpiece {
        &self.workpiece
    }

    /// The particles.
    pub fn particles(&self) -> &Particles<3> {
        &self.workpiece.particles
    }

    /// The gauge.
    pub fn gauge(&self) -> &Gauge {
        &self.gauge
    }

    /// What was measured.
    pub fn records(&self) -> &Records {
        &self.records
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

    /// What the physics have cost.
    pub fn cost(&self) -> Cost {
        let mut total = Cost::default();
        for cost in self.physics.iter().map(|physics| physics.cost()) {
            total.sweeps += cost.sweeps;
            total.pair_visits += cost.pair_visits;
            total.rejected_steps += cost.rejected_steps;
            total.melt_steps += cost.melt_steps;
        }
        total
    }

    /// Flow, stress and deformation now, where the scene computes them.
    pub fn mechanics(&self) -> Option<Mechanics> {
        self.physics.iter().filter_map(|physics| physics.mechanics()).reduce(Mechanics::with)
    }

    /// Columns that physics have of their own, by name with unit; to be shown.
    pub fn columns(&self) -> Vec<(&'static str, Column<3>)> {
        self.physics.iter().flat_map(|physics| physics.columns()).collect()
    }

    /// The energy ledger now.
    pub fn ledger(&self) -> Ledger {
        let mut exchange = Exchange::default();
        self.physics.iter().for_each(|physics| exchange.add(&physics.energy()));
        let mechanics = self.mechanics().unwrap_or_default();
        Ledger::new(&self.model, &self.workpiece.particles, &exchange, &mechanics, self.gauge.copies())
    }
}
