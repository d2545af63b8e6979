//! Heat in particles at rest: stored pair weights, stabilised super steps, an error estimate that chooses them.

mod deposit;
mod faces;
mod moving;
mod renewal;
mod step_size;
mod super_step;

use super::{Cost, Exchange, Failure, Physics};
use crate::build::{
    Members, Neighborhood, PairReport, Workpiece, conduction_rows, default_ratio, mirrors, pair_table,
};
use crate::case::scene::{ConductivityMean, Face, FlowSchedule, KernelShape, Weights};
use crate::model::{Model, ModelError};
use crate::particles::Particles;
use deposit::Deposit;
use faces::FaceExchange;
use moving::MovingRows;
use renewal::{RenewedRows, RowRule};
use serde::{Deserialize, Serialize};
use sph_integrate::{Rkl2Coefficients, StepLimit, largest_eigenvalue};
use sph_kernel::KernelKind;
use sph_thermal::conduction::{ConductionMatrix, ConductionRows, JointPair, LANES};
use step_size::{StepSize, Verdict};
use super_step::{Columns, Operator, StageWeights, block_sum};

/// Rows this long pay for a power iteration; for shorter ones Gershgorin's bound is within 5 to 15 %.
const POWER_ITERATION_PAIRS: usize = 12;

/// Heat conduction of particles at rest with phase change, laser and faces.
pub struct Heat {
    operator: Operator,
    joints: Vec<JointPair>,
    faces: FaceExchange,
    deposit: Option<Deposit>,
    columns: Columns,
    /// Laser power of each particle, mean over the step in hand \[W\].
    laser: Vec<f64>,
    /// Laser power of each particle at the end of the step in hand less that at its start \[W\].
    swing: Vec<f64>,
    /// Enthalpy of the stage in hand where joints and faces look for it \[J/kg\].
    met: Vec<f64>,
    /// Particles that joints and faces touch.
    touched: Vec<usize>,
    /// Bound on the spectrum of the rows that were made first.
    bound: f64,
    /// Rows that follow the melt, where it flows.
    renewed: Option<RenewedRows>,
    step_size: StepSize,
    /// Power that leaves through faces at the start of the next step \[W\].
    leaving: f64,
    exchange: Exchange,
    cost: Cost,
    /// What the set-up of the pairs found.
    pub report: PairReport,
}

/// What a checkpoint holds besides the shared columns.
#[derive(Serialize, Deserialize)]
struct State {
    step_size: step_size::State,
    exchange: Exchange,
    cost: Cost,
    conducted: Vec<f64>,
    laser: Vec<f64>,
    leaving: f64,
    /// Which rows follow the melt; empty where it does not flow.
    renewed: Vec<bool>,
}

impl Heat {
    /// Pairs, weights and step control of `model` on `workpiece`.
    ///
    /// # Errors
    /// [`ModelError`] when the weights cannot be fitted or a setting is refused.
    pub fn new(model: &Model, workpiece: &Workpiece) -> Result<Self, ModelError> {
        let (settings, particles) = (&model.heat, &workpiece.particles);
        let kernel = kernel_kind(settings.kernel);
        let weights = settings.weights;
        // Rows that melt moves into are normalised ones, and reach as far.
        let reaching = if model.flow.is_some() { Weights::Normalized } else { weights };
        let ratio = settings.smoothing_ratio.unwrap_or_else(|| default_ratio(reaching, workpiece.disorder));
        let all = Members::all(particles.len());
        let planes = mirrors(workpiece, &model.faces, weights);
        let neighborhood = Neighborhood::new(workpiece, &planes, &all, kernel, ratio)?;
        let pairs = pair_table(workpiece, &all, &neighborhood, &particles.volume, kernel)?;
        let (rows, report) = conduction_rows(&pairs, ratio, weights)?;
        let renewed = model
            .flow
            .is_some()
            .then(|| RenewedRows::new(RowRule { planes, kernel, ratio }, rows.clone(), &pairs, workpiece));
        let moving = if weights == Weights::Moving {
            refuse_moving(model)?;
            Some(MovingRows::new(workpiece, neighborhood, kernel))
        } else {
            None
        };
        let faces = FaceExchange::new(model, workpiece, &rows)?;
        let deposit = match &model.laser {
            Some(laser) => Some(Deposit::new(laser, workpiece, &rows, model.mirrored())?),
            None => None,
        };
        let bound = spectral_bound(&rows, particles);
        let euler = longest_euler_step(model, workpiece, &faces, bound);
        let harmonic = settings.conductivity_mean == ConductivityMean::Harmonic;
        let (rows, joints) =
            if harmonic { (rows, Vec::new()) } else { rows.split_joints(&particles.material) };
        let operator = operator(model, workpiece, &rows, harmonic, moving);
        let columns = Columns::new(&operator);
        let touched = touched(&faces, &joints);
        let mut heat = Self {
            laser: vec![0.0; columns.power.len()],
            swing: vec![0.0; columns.power.len()],
            met: vec![0.0; if touched.is_empty() { 0 } else { columns.power.len() }],
            step_size: StepSize::new(settings.stepping, deposit.as_ref().map(Deposit::source), euler)?,
            bound,
            renewed,
            leaving: 0.0,
            exchange: Exchange::default(),
            cost: Cost::default(),
            operator,
            joints,
            faces,
            deposit,
            columns,
            touched,
            report,
        };
        heat.start_anew(&particles.enthalpy);
        Ok(heat)
    }

    /// Takes `enthalpy` as the state, and evaluates it; no cost of a step.
    fn start_anew(&mut self, enthalpy: &[f64]) {
        let cost = self.cost;
        self.begin(enthalpy);
        self.leaving = self.conduct();
        std::mem::swap(&mut self.columns.conducted, &mut self.columns.conducted_end);
        self.cost = cost;
    }

    /// Longest stable explicit Euler step \[s\].
    pub fn euler_step(&self) -> f64 {
        self.step_size.euler()
    }

    /// Longest step that the laser's rule allows \[s\], where there is a laser.
    pub fn laser_step(&self) -> Option<f64> {
        self.step_size.laser_step()
    }

    /// Directed pairs that one evaluation of the right-hand side visits.
    pub fn pairs(&self) -> usize {
        let stored = self.operator.matrix.pairs() + 2 * self.joints.len();
        self.operator.moving.as_ref().map_or(stored, MovingRows::pairs)
    }

    /// Share of rows stored as a pattern.
    pub fn pattern_share(&self) -> f64 {
        self.operator.matrix.pattern_share()
    }

    /// Takes `enthalpy` as the start of a step.
    fn begin(&mut self, enthalpy: &[f64]) {
        self.columns.start[..enthalpy.len()].copy_from_slice(enthalpy);
        self.columns.increment.fill(0.0);
        self.operator.evaluate(&mut self.columns);
    }

    /// Rate by conduction and faces at the last stage, into `conducted_end`; returns the power that leaves \[W\].
    fn conduct(&mut self) -> f64 {
        self.columns.power.fill(0.0);
        let leaving = self.add_exchange();
        self.operator.rate(&mut self.columns);
        self.count_sweep();
        leaving
    }

    /// Keeps the light of the particles that can still be lit, and of no others.
    fn keep_light(&mut self) {
        let before = std::mem::replace(&mut self.laser, vec![0.0; self.swing.len()]);
        self.swing.fill(0.0);
        for &i in self.deposit.iter().flat_map(Deposit::particles) {
            self.laser[i] = before[i];
        }
    }

    fn count_sweep(&mut self) {
        self.cost.sweeps += 1;
        self.cost.pair_visits += self.pairs() as u64;
    }

    /// Adds joints and faces at the last stage to `power`; returns the power that leaves the part \[W\].
    fn add_exchange(&mut self) -> f64 {
        if self.touched.is_empty() {
            return 0.0;
        }
        let Columns { start, increment, power, .. } = &mut self.columns;
        for &i in &self.touched {
            self.met[i] = start[i] + increment[i];
        }
        let (met, curves, material) = (&self.met, &self.operator.curves, &self.operator.material);
        let side = |i: usize| {
            let curve = &curves[material[i] as usize];
            (curve.temperature(met[i]), curve.conductivity(met[i]))
        };
        for pair in &self.joints {
            let (first, second) = (pair.first as usize, pair.second as usize);
            let heat = pair.heat(side(first), side(second));
            power[first] += heat;
            power[second] -= heat;
        }
        self.faces.add(met, curves, &self.laser, power)
    }

    /// Takes the light from `time` to `time + step` \[s\]: its mean and, from the means of both halves, its change, so that
    /// the stages see a source that moves or ramps. Returns the energy absorbed \[J\].
    fn light(&mut self, time: f64, step: f64) -> f64 {
        let Some(deposit) = &mut self.deposit else { return 0.0 };
        let middle = time + 0.5 * step;
        let first = deposit.fill(time, middle, &mut self.laser);
        let second = deposit.fill(middle, time + step, &mut self.swing);
        for &i in deposit.particles() {
            let (first, second) = (self.laser[i], self.swing[i]);
            self.laser[i] = 0.5 * (first + second);
            self.swing[i] = 2.0 * (second - first);
        }
        0.5 * step * (first + second)
    }

    /// Sets `power` of what is lit or touched to the laser's at `at` of the step, from 0 to 1.
    fn shine(&mut self, at: f64) {
        let power = &mut self.columns.power;
        for &i in &self.touched {
            power[i] = self.laser[i];
        }
        for &i in self.deposit.iter().flat_map(Deposit::particles) {
            power[i] = self.laser[i] + (at - 0.5) * self.swing[i];
        }
    }

    /// One super step of `step` \[s\] from the state in hand; returns the energy that left through faces \[J\].
    fn super_step(&mut self, step: f64) -> f64 {
        let coefficients = self.step_size.coefficients(step);
        // An Euler step takes the mean, super steps what the laser does at each stage.
        let behind = if coefficients.is_some() { 0.5 } else { 0.0 };
        let inverse_mass = &self.operator.inverse_mass;
        let Columns { rate, conducted, .. } = &mut self.columns;
        for i in 0..rate.len() {
            rate[i] = conducted[i] + (self.laser[i] - behind * self.swing[i]) * inverse_mass[i];
        }
        let Some(coefficients) = coefficients else {
            return self.euler_stage(step, step * self.leaving);
        };
        let first = coefficients.first_mu_tilde() * step;
        let mut left = self.euler_stage(first, first * self.leaving);
        let mut left_before = 0.0;
        // Time of the last stage and of the one before.
        let (mut reached, mut reached_before) = (first, 0.0);
        self.columns.power.fill(0.0);
        for weights in StageWeights::of(&coefficients, step) {
            self.shine(reached / step);
            let next = weights.last * reached + weights.before * reached_before + weights.now + weights.start;
            reached_before = std::mem::replace(&mut reached, next);
            let leaving = self.add_exchange();
            self.operator.stage(weights, &mut self.columns);
            self.count_sweep();
            let next = weights.last * left
                + weights.before * left_before
                + weights.now * leaving
                + weights.start * self.leaving;
            left_before = std::mem::replace(&mut left, next);
        }
        left
    }

    /// Sets the increment to `step` times the rate at the start, the one before to zero; passes `left` on.
    fn euler_stage(&mut self, step: f64, left: f64) -> f64 {
        let Columns { rate, increment, before, .. } = &mut self.columns;
        increment.iter_mut().zip(rate.iter()).for_each(|(u, rate)| *u = step * rate);
        before.fill(0.0);
        self.operator.evaluate(&mut self.columns);
        left
    }

    /// Estimated error of the step over the heat taken up so far, both as root mean squares over mass.
    fn error(&self, particles: &Particles<3>, step: f64) -> f64 {
        let Columns { start, increment, rate, conducted_end, .. } = &self.columns;
        let [error, heated] = block_sum(particles.len(), |i| {
            let end_light = self.laser[i] + 0.5 * self.swing[i];
            let end_rate = conducted_end[i] + end_light * self.operator.inverse_mass[i];
            let error = sph_integrate::local_error(0.0, increment[i], rate[i], end_rate, step);
            let heated = start[i] + increment[i] - particles.start_enthalpy[i];
            let mass = particles.mass[i];
            [mass * error * error, mass * heated * heated]
        });
        if heated > 0.0 { (error / heated).sqrt() } else { error }
    }

    /// Makes the end of the step the state; returns the lowest enthalpy \[J/kg\].
    fn accept(&mut self, particles: &mut Particles<3>, leaving: f64) -> f64 {
        let mut lowest = f64::INFINITY;
        let Columns { start, increment, .. } = &mut self.columns;
        for i in 0..particles.len() {
            let enthalpy = start[i] + increment[i];
            start[i] = enthalpy;
            particles.enthalpy[i] = enthalpy;
            particles.peak_enthalpy[i] = particles.peak_enthalpy[i].max(enthalpy);
            lowest = lowest.min(enthalpy);
        }
        self.columns.increment.fill(0.0);
        self.leaving = leaving;
        std::mem::swap(&mut self.columns.conducted, &mut self.columns.conducted_end);
        lowest
    }

    fn failure(&self, particles: &Particles<3>, time: f64, what: &str) -> Failure {
        let wrong = |i: &usize| {
            let enthalpy = self.columns.start[*i] + self.columns.increment[*i];
            !enthalpy.is_finite() || enthalpy < 0.0
        };
        let at = (0..particles.len()).find(wrong).map(|i| particles.position[i].into());
        let advice =
            "try Normalized weights, a smoothing_ratio of 1.0, less disorder, or a smaller tolerance";
        Failure { physics: "heat", what: what.into(), time, at, advice: advice.into() }
    }
}

impl Physics<3> for Heat {
    fn name(&self) -> &'static str {
        "heat"
    }

    fn step_limit(&self, time: f64) -> StepLimit {
        self.step_size.limit(time)
    }

    fn next_event(&self, time: f64) -> Option<f64> {
        self.step_size.next_event(time)
    }

    fn advance(&mut self, particles: &mut Particles<3>, time: f64, step: f64) -> Result<f64, Failure> {
        let mut step = step;
        self.step_size.begin(time);
        loop {
            let absorbed = self.light(time, step);
            let left = self.super_step(step);
            let leaving = self.conduct();
            let error = self.error(particles, step);
            if !error.is_finite() && step <= self.step_size.smallest() {
                return Err(self.failure(particles, time, "the enthalpy is no number any more"));
            }
            match self.step_size.judge(time, step, error) {
                Verdict::Accept => {
                    if let Some(deposit) = &self.deposit {
                        self.exchange.add(&deposit.audit(time, time + step, absorbed));
                    }
                    self.exchange.lost += left;
                    if self.accept(particles, leaving) < 0.0 {
                        return Err(self.failure(particles, time + step, "a particle is colder than 0 K"));
                    }
                    return Ok(step);
                }
                Verdict::Retry(shorter) => {
                    step = shorter;
                    self.cost.rejected_steps += 1;
                    self.columns.increment.fill(0.0);
                    self.operator.evaluate(&mut self.columns);
                }
            }
        }
    }

    fn take_heat(&mut self, particles: &Particles<3>) {
        self.start_anew(&particles.enthalpy);
    }

    fn rearrange(&mut self, model: &Model, workpiece: &Workpiece) -> Result<(), ModelError> {
        let Some(renewed) = &mut self.renewed else { return Ok(()) };
        if model.flow.as_ref().is_some_and(|flow| flow.settings.schedule == FlowSchedule::Together) {
            renewed.restore(vec![true; workpiece.particles.len()]);
        }
        let mut chunks = renewed.renew(workpiece)?;
        chunks.iter_mut().for_each(|row| *row /= LANES as u32);
        chunks.dedup();
        for chunk in chunks {
            self.operator.matrix.replace_chunk(renewed.rows(), chunk as usize);
        }
        self.faces = FaceExchange::new(model, workpiece, renewed.rows())?;
        if let Some(laser) = &model.laser {
            self.deposit = Some(Deposit::new(laser, workpiece, renewed.rows(), model.mirrored())?);
        }
        let bound = self.bound.max(renewed.bound(&workpiece.particles.mass));
        self.step_size.set_euler(longest_euler_step(model, workpiece, &self.faces, bound));
        self.touched = touched(&self.faces, &self.joints);
        self.keep_light();
        self.start_anew(&workpiece.particles.enthalpy);
        Ok(())
    }

    fn energy(&self) -> Exchange {
        self.exchange
    }

    fn cost(&self) -> Cost {
        self.cost
    }

    fn save(&self) -> Vec<u8> {
        let state = State {
            step_size: self.step_size.state(),
            exchange: self.exchange,
            cost: self.cost,
            conducted: self.columns.conducted.clone(),
            laser: self.laser.clone(),
            leaving: self.leaving,
            renewed: self.renewed.as_ref().map_or_else(Vec::new, |rows| rows.renewed().to_vec()),
        };
        postcard::to_stdvec(&state).expect("numbers and columns always serialise")
    }

    fn restore(&mut self, particles: &Particles<3>, state: &[u8]) -> Result<(), String> {
        let state: State =
            postcard::from_bytes(state).map_err(|error| format!("the state of heat: {error}"))?;
        if state.conducted.len() != self.columns.conducted.len() || state.laser.len() != self.laser.len() {
            return Err("the state of heat is of another number of particles".into());
        }
        if let Some(rows) = &mut self.renewed {
            if state.renewed.len() != particles.len() {
                return Err("the state of heat is of a scene without flow".into());
            }
            rows.restore(state.renewed);
        }
        self.step_size.restore(state.step_size);
        (self.exchange, self.cost, self.leaving) = (state.exchange, state.cost, state.leaving);
        (self.columns.conducted, self.laser) = (state.conducted, state.laser);
        self.begin(&particles.enthalpy);
        Ok(())
    }
}

/// Longest stable explicit Euler step \[s\] with rows whose spectrum is bounded by `bound`.
fn longest_euler_step(model: &Model, workpiece: &Workpiece, faces: &FaceExchange, bound: f64) -> f64 {
    let slopes = model.curves.iter().map(|curve| curve.largest_potential_slope());
    let fastest = slopes.fold(0.0, f64::max) * bound;
    2.0 / (fastest + faces.fastest_loss(&model.curves, &workpiece.particles.mass))
}

/// Particles that faces or joints touch, rising, each once.
fn touched(faces: &FaceExchange, joints: &[JointPair]) -> Vec<usize> {
    let joined = joints.iter().flat_map(|pair| [pair.first as usize, pair.second as usize]);
    let mut touched: Vec<usize> = faces.particles().iter().copied().chain(joined).collect();
    touched.sort_unstable();
    touched.dedup();
    touched
}

/// Rows computed anew know mirrors and one material only.
fn refuse_moving(model: &Model) -> Result<(), ModelError> {
    let held =
        model.faces.named().into_iter().find(|(_, face)| matches!(face, Face::FixedTemperature { .. }));
    let reason = match held {
        Some((name, _)) => format!("the face {name} of fixed temperature"),
        None if model.curves.len() > 1 => "a joint of two materials".to_string(),
        None if model.heat.conductivity_mean == ConductivityMean::Harmonic => "the harmonic mean".to_string(),
        None => return Ok(()),
    };
    Err(ModelError::Unsupported(format!(
        "weights: Moving does not go with {reason}; use Fitted or Normalized"
    )))
}

fn operator(
    model: &Model,
    workpiece: &Workpiece,
    rows: &ConductionRows,
    harmonic: bool,
    moving: Option<MovingRows>,
) -> Operator {
    let matrix = ConductionMatrix::new(rows);
    let mut inverse_mass: Vec<f64> = workpiece.particles.mass.iter().map(|mass| 1.0 / mass).collect();
    inverse_mass.resize(matrix.padded_len(), 0.0);
    Operator {
        matrix,
        inverse_mass,
        material: workpiece.particles.material.clone(),
        curves: model.curves.clone(),
        exchange: match (harmonic, &moving) {
            (true, _) => super_step::Exchange::Harmonic,
            (false, Some(_)) => super_step::Exchange::Moving,
            (false, None) => super_step::Exchange::Kirchhoff,
        },
        moving,
    }
}

/// The kernel of a scene.
pub fn kernel_kind(shape: KernelShape) -> KernelKind {
    match shape {
        KernelShape::WendlandC2 => KernelKind::WendlandC2,
        KernelShape::Gaussian => KernelKind::Gaussian,
        KernelShape::CubicSpline => KernelKind::CubicSpline,
        KernelShape::QuinticSpline => KernelKind::QuinticSpline,
    }
}

/// Bound on the spectrum of `dh/dt = (1/mass) sum g (h_j - h_i)`: Gershgorin's, or the power iteration's where rows are
/// long enough for it to pay (it finds 0.55 to 0.85 of Gershgorin's bound there).
fn spectral_bound(rows: &ConductionRows, particles: &Particles<3>) -> f64 {
    let (mass, material) = (&particles.mass, &particles.material);
    // The harmonic mean of a joint is up to twice the conductivity of the poorer side.
    let scale = |i: usize, j: usize| if material[i] == material[j] { 1.0 } else { 2.0 };
    let gershgorin = rows.gershgorin_bound(mass, scale);
    let joined = material.iter().any(|other| *other != material[0]);
    if joined || rows.pairs() < POWER_ITERATION_PAIRS * rows.particles() {
        return gershgorin;
    }
    // The symmetric form: 1/sqrt(mass) on either side.
    let scale: Vec<f64> = mass.iter().map(|mass| 1.0 / mass.sqrt()).collect();
    let mut wall = vec![0.0; mass.len()];
    for coupling in rows.walls() {
        wall[coupling.particle as usize] += coupling.coefficient;
    }
    let found = largest_eigenvalue(mass.len(), |x, y| {
        for i in 0..x.len() {
            let own = x[i] * scale[i];
            let (neighbors, weights) = rows.row(i);
            let exchange = |(&j, g): (&u32, &f64)| g * (own - x[j as usize] * scale[j as usize]);
            let sum: f64 = neighbors.iter().zip(weights).map(exchange).sum();
            y[i] = scale[i] * (sum + wall[i] * own);
        }
    });
    found.min(gershgorin)
}
