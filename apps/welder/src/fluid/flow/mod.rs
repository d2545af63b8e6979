//! A fluid that is stepped: kick-drift-kick over strides that one list of neighbours serves.

mod failure;
mod measure;
mod saved;

use super::SKIN;
use super::ledger::Work;
use super::model::FluidModel;
use super::place::Placed;
use crate::model::ModelError;
use crate::physics::{Cost, Failure};
use crate::run::StepReport;
use nalgebra::SVector;
use serde::{Deserialize, Serialize};
use sph_fluid::{FluidFields, FluidSweep, Powers};
use sph_integrate::{StepLimit, smallest};
use sph_neighbors::{NeighborList, PairReach, Parts, SearchMethod};
use std::collections::BTreeMap;

/// Share of the spacing that a particle may move in one step.
const LARGEST_MOVE: f64 = 0.15;

/// A stride ends where a particle has moved this share of the spacing: less than half of the skin by more than a step's move.
const STRIDE_MOVE: f64 = 0.3;

/// A stride of more steps than this ends as well, so that the ledger samples work and the run loop gets its turn.
const MOST_STEPS: u32 = 20;

/// Largest of what was measured over a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct FluidRecords {
    /// Largest speed of a particle \[m/s\].
    pub speed: f64,
    /// Largest change of a density over the one without pressure \[-\].
    pub density_change: f64,
}

/// What the sweep reads; the particles of the fluid stand first, then copies, then walls.
struct Columns<const D: usize> {
    positions: Vec<SVector<f64, D>>,
    velocities: Vec<SVector<f64, D>>,
    masses: Vec<f64>,
    temperatures: Vec<f64>,
    /// For each copy the particle that it shows.
    copies: Vec<u32>,
    list: NeighborList,
}

impl<const D: usize> Columns<D> {
    fn fields(&self) -> FluidFields<'_, D> {
        FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.temperatures,
            copies: &self.copies,
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
            ..FluidFields::default()
        }
    }
}

/// A scene of fluid at some time.
///
/// Between strides it is always as if it had just begun: positions within their periods, copies and list new, and one evaluation
/// by a sweep that remembers nothing. So positions, velocities and densities are the whole of its state, and a run that was
/// stopped goes on with the same bits.
pub struct FluidFlow<const D: usize> {
    model: FluidModel<D>,
    /// Particles of the fluid; in all columns they stand before copies and walls.
    fluid: usize,
    placed: Placed<D>,
    columns: Columns<D>,
    densities: Vec<f64>,
    accelerations: Vec<SVector<f64, D>>,
    spacings: Vec<f64>,
    /// How far each copy stands from the particle that it shows \[m\].
    shifts: Vec<SVector<f64, D>>,
    /// Positions of the fluid when the list was made.
    listed: Vec<SVector<f64, D>>,
    fresh: FluidSweep<D>,
    sweep: FluidSweep<D>,
    powers: Powers,
    start_energy: f64,
    work: Work,
    time: f64,
    steps: u64,
    limits: BTreeMap<String, u64>,
    cost: Cost,
    records: FluidRecords,
}

impl<const D: usize> FluidFlow<D> {
    /// The fluid of a model at its start.
    ///
    /// # Errors
    /// [`ModelError`] when a crate refuses the particles or the constants.
    pub fn new(model: FluidModel<D>) -> Result<Self, ModelError> {
        let placed = Placed::new(&model);
        let (fluid, fresh) = (placed.positions.len(), FluidSweep::new(model.controls)?);
        let mut flow = Self {
            columns: Columns {
                positions: placed.positions.clone(),
                velocities: placed.velocities.clone(),
                masses: placed.masses.clone(),
                temperatures: Vec::new(),
                copies: Vec::new(),
                list: NeighborList::default(),
            },
            densities: placed.densities.clone(),
            spacings: vec![model.spacing(); fluid],
            accelerations: vec![SVector::zeros(); fluid],
            sweep: fresh.clone(),
            model,
            fluid,
            placed,
            shifts: Vec::new(),
            listed: Vec::new(),
            fresh,
            powers: Powers::default(),
            start_energy: 0.0,
            work: Work::default(),
            time: 0.0,
            steps: 0,
            limits: BTreeMap::new(),
            cost: Cost::default(),
            records: FluidRecords::default(),
        };
        flow.begin()?;
        flow.start_energy = flow.energies().iter().sum();
        flow.record();
        Ok(flow)
    }

    /// Copies, list and sweep anew, and one evaluation.
    fn begin(&mut self) -> Result<(), ModelError> {
        self.columns.positions.truncate(self.fluid);
        self.columns.velocities.truncate(self.fluid);
        self.densities.truncate(self.fluid);
        self.columns.masses.truncate(self.fluid);
        self.find_copies();
        for &source in &self.columns.copies {
            self.columns.positions.push(self.columns.positions[source as usize]);
            self.columns.velocities.push(self.columns.velocities[source as usize]);
            self.columns.masses.push(self.columns.masses[source as usize]);
        }
        self.columns.positions.extend_from_slice(&self.placed.walls);
        self.columns.velocities.extend_from_slice(&self.placed.wall_velocities);
        let cell = self.model.density() * self.model.spacing().powi(D as i32);
        self.columns.masses.resize(self.columns.positions.len(), cell);
        self.densities.resize(self.columns.positions.len(), self.model.density());
        self.move_copies();
        let reach = self.model.controls.kernel.support_radius() + SKIN * self.model.spacing();
        let parts = Parts { owned: self.fluid, copies: self.columns.copies.len() };
        self.columns.list =
            SearchMethod::default().find_for(&self.columns.positions, PairReach::Uniform(reach), parts)?;
        self.listed.clear();
        self.listed.extend_from_slice(&self.columns.positions[..self.fluid]);
        self.sweep = self.fresh.clone();
        self.evaluate(0.0);
        self.powers = self.sweep.powers(&self.columns.masses, &self.columns.velocities);
        Ok(())
    }

    /// Puts the fluid into its periods, and finds who is seen across their ends until the list is made anew.
    fn find_copies(&mut self) {
        self.columns.copies.clear();
        self.shifts.clear();
        let (reach, spacing) = (self.model.controls.kernel.support_radius(), self.model.spacing());
        // What walls see counts as well: fluid sees a wall at a support's distance, which sees as far again.
        let margin = 2.0 * (reach + SKIN * spacing) + SKIN * spacing;
        for axis in 0..D {
            let (Some(period), low) = (self.model.period(axis), self.model.low[axis]) else { continue };
            let high = low + period;
            // A position inside keeps its bits, or a resumed run would have others.
            let outside = self.columns.positions.iter_mut().filter(|x| !(low..high).contains(&x[axis]));
            for position in outside {
                let wrapped = low + (position[axis] - low).rem_euclid(period);
                position[axis] = if wrapped < high { wrapped } else { low };
            }
            // Copies along the axes before have copies too: the corners.
            for k in 0..self.fluid + self.columns.copies.len() {
                let (source, moved) = match k.checked_sub(self.fluid) {
                    Some(copy) => (self.columns.copies[copy], self.shifts[copy]),
                    None => (k as u32, SVector::zeros()),
                };
                let x = self.columns.positions[source as usize][axis] - low;
                for shift in [(x < margin).then_some(period), (x > period - margin).then_some(-period)] {
                    let Some(shift) = shift else { continue };
                    let mut moved = moved;
                    moved[axis] += shift;
                    self.columns.copies.push(source);
                    self.shifts.push(moved);
                }
            }
        }
    }

    fn move_copies(&mut self) {
        for (k, &source) in self.columns.copies.iter().enumerate() {
            self.columns.positions[self.fluid + k] = self.columns.positions[source as usize] + self.shifts[k];
            self.columns.velocities[self.fluid + k] = self.columns.velocities[source as usize];
        }
    }

    /// Advances the densities over `dt` \[s\] and writes the accelerations.
    fn evaluate(&mut self, dt: f64) {
        self.move_copies();
        self.warm();
        let fields = self.columns.fields();
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
        self.cost.sweeps += 2;
        self.cost.pair_visits += 2 * self.columns.list.starts()[self.fluid] as u64;
    }

    /// Gives all particles the temperatures of their places; what that does to their energy of compression is the
    /// work of expansion.
    fn warm(&mut self) {
        let places = self.columns.positions.iter();
        let temperatures: Vec<f64> = places.filter_map(|x| self.model.temperature_at(x)).collect();
        if self.model.controls.thermal_expansion.is_some() {
            let before = &self.columns.temperatures;
            let gained = |i: usize| {
                self.columns.masses[i]
                    * (self.compression(i, temperatures.get(i)) - self.compression(i, before.get(i)))
            };
            self.work.expansion += (0..self.fluid.min(before.len())).map(gained).sum::<f64>();
        }
        self.columns.temperatures = temperatures;
    }

    fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.columns.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    fn drift(&mut self, dt: f64) {
        for i in 0..self.fluid {
            self.columns.positions[i] += self.columns.velocities[i] * dt;
        }
        for (position, shift) in self.columns.positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
    }

    /// Takes a stride that does not pass `stop` \[s\]: steps until the list is used up.
    ///
    /// # Errors
    /// [`Failure`] of fluid that has left its domain, or has become too wild to be stepped.
    pub fn stride(&mut self, stop: f64) -> Result<StepReport, Failure> {
        let (start, before) = (self.time, self.powers);
        let mut report = StepReport { step: 0.0, limit: "none" };
        for _ in 0..MOST_STEPS {
            let limit = self.step_limit();
            let left = stop - self.time;
            if limit.dt_s.is_nan() || limit.dt_s < self.model.controls.wild_step() {
                return Err(self.wild());
            }
            let parts = (left / limit.dt_s).ceil().max(1.0);
            report = StepReport { step: left / parts, limit: if parts > 1.0 { limit.name } else { "event" } };
            self.kick(0.5 * report.step);
            self.drift(report.step);
            self.evaluate(report.step);
            self.kick(0.5 * report.step);
            self.time = if parts > 1.0 { self.time + report.step } else { stop };
            self.steps += 1;
            *self.limits.entry(report.limit.to_string()).or_default() += 1;
            if parts == 1.0 || self.list_is_used_up() {
                break;
            }
        }
        self.lost().map_or(Ok(()), Err)?;
        self.begin()
            .map_err(|error| self.failure(format!("the neighbours cannot be found: {error}"), None))?;
        let after = self.powers;
        self.work.add(&before, &after, self.time - start);
        self.record();
        Ok(report)
    }

    fn list_is_used_up(&self) -> bool {
        let far = (STRIDE_MOVE * self.model.spacing()).powi(2);
        self.columns.positions[..self.fluid]
            .iter()
            .zip(&self.listed)
            .any(|(now, then)| (now - then).norm_squared() > far)
    }

    /// The longest step and what limits it.
    pub fn step_limit(&self) -> StepLimit {
        smallest(self.step_limits(self.largest_speed()))
    }

    /// The limits of sound, friction, tension, force and motion at a largest speed \[m/s\].
    pub fn step_limits(&self, fastest: f64) -> [StepLimit; 5] {
        let (controls, spacing) = (&self.model.controls, self.model.spacing());
        let strongest = largest(self.accelerations.iter());
        let [sound, friction, tension, force] =
            controls.longest_steps(fastest, strongest).map(|(name, dt_s)| StepLimit { name, dt_s });
        // Shifts are at most a quarter of their strength.
        let shifting = 1.0 + 0.25 * controls.renewal.map_or(0.0, |renewal| renewal.shifting);
        let motion = StepLimit { name: "motion", dt_s: LARGEST_MOVE * spacing / (shifting * fastest) };
        [sound, friction, tension, force, motion]
    }

    fn record(&mut self) {
        self.records.speed = self.records.speed.max(self.largest_speed());
        self.records.density_change = self.records.density_change.max(self.density_change());
    }

    /// Speed of the fastest particle \[m/s\].
    pub fn largest_speed(&self) -> f64 {
        largest(self.columns.velocities[..self.fluid].iter())
    }

    /// The model.
    pub fn model(&self) -> &FluidModel<D> {
        &self.model
    }

    /// Positions of the fluid \[m\].
    pub fn positions(&self) -> &[SVector<f64, D>] {
        &self.columns.positions[..self.fluid]
    }

    /// Velocities of the fluid \[m/s\].
    pub fn velocities(&self) -> &[SVector<f64, D>] {
        &self.columns.velocities[..self.fluid]
    }

    /// Pressures of the fluid \[Pa\].
    pub fn pressures(&self) -> &[f64] {
        &self.sweep.pressures()[..self.fluid]
    }

    /// Spacing that each particle stands for \[m\].
    pub fn spacings(&self) -> &[f64] {
        &self.spacings
    }

    /// Number of particles of walls.
    pub fn wall_particles(&self) -> usize {
        self.placed.walls.len()
    }

    /// Directed pairs of one pass over the fluid.
    pub fn pairs(&self) -> usize {
        self.columns.list.starts()[self.fluid]
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
    pub fn records(&self) -> FluidRecords {
        self.records
    }
}

/// The largest length of vectors; no number where one of them is none.
fn largest<'a, const D: usize>(vectors: impl Iterator<Item = &'a SVector<f64, D>>) -> f64 {
    let longer = |largest: f64, square: f64| if square <= largest { largest } else { square };
    vectors.map(SVector::norm_squared).fold(0.0, longer).sqrt()
}
