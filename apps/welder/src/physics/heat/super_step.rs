//! The hot loop: one pass per stage, row product, stage update and new potential fused.
//!
//! Stages work on increments u = h - h_start, so that a particle at rest in temperature keeps its bits and the ledger
//! closes to round-off. Blocks of rows run in parallel; what they add up is added block by block, so that results are
//! the same bits for any number of threads.

use super::moving::MovingRows;
use rayon::prelude::*;
use sph_integrate::Rkl2Coefficients;
use sph_thermal::conduction::{ConductionMatrix, LANES, joint_conductance};
use sph_thermal::phase::EnthalpyCurve;

/// Rows to a block.
const BLOCK: usize = 512 * LANES;

/// Particles below which a pass stays on one thread: handing it out would cost more than it brings.
const PARALLEL_PARTICLES: usize = 16 * BLOCK;

/// How a pair conducts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Exchange {
    /// By the Kirchhoff potential of one material.
    Kirchhoff,
    /// By temperature with the harmonic mean of both conductivities (Cleary and Monaghan 1999).
    Harmonic,
    /// By the Kirchhoff potential in rows that are computed anew at every stage.
    Moving,
}

/// What stays the same over a run.
pub(super) struct Operator {
    /// Rows to compute anew, where the exchange is `Moving`.
    pub(super) moving: Option<MovingRows>,
    pub(super) matrix: ConductionMatrix,
    /// 1/(mass) \[1/kg\], padded.
    pub(super) inverse_mass: Vec<f64>,
    pub(super) material: Vec<u8>,
    pub(super) curves: Vec<EnthalpyCurve>,
    pub(super) exchange: Exchange,
}

/// Columns of a super step, padded to whole chunks.
pub(super) struct Columns {
    /// Enthalpy at the start of the step \[J/kg\].
    pub(super) start: Vec<f64>,
    /// Rate at the start by conduction and faces \[W/kg\].
    pub(super) conducted: Vec<f64>,
    /// The same at the end: that of the next step's start, once the step is accepted.
    pub(super) conducted_end: Vec<f64>,
    /// The same with the laser \[W/kg\].
    pub(super) rate: Vec<f64>,
    /// Increments of the last stage and of the one before \[J/kg\].
    pub(super) increment: Vec<f64>,
    pub(super) before: Vec<f64>,
    /// Potential of the last stage, and of the one that is being computed \[W/m\].
    pub(super) potential: Vec<f64>,
    next_potential: Vec<f64>,
    /// Heat besides conduction \[W\].
    pub(super) power: Vec<f64>,
    /// Temperature and conductivity, for the harmonic mean only.
    temperature: Vec<f64>,
    conductivity: Vec<f64>,
    /// Potential of particles and copies, and conducted heat \[W\], for moving rows only.
    seen: Vec<f64>,
    heat: Vec<f64>,
}

impl Columns {
    pub(super) fn new(operator: &Operator) -> Self {
        let padded = operator.matrix.padded_len();
        let column = || vec![0.0; padded];
        let harmonic =
            || if operator.exchange == Exchange::Harmonic { vec![0.0; padded] } else { Vec::new() };
        Self {
            start: column(),
            conducted: column(),
            conducted_end: column(),
            rate: column(),
            increment: column(),
            before: column(),
            potential: column(),
            next_potential: column(),
            power: column(),
            temperature: harmonic(),
            conductivity: harmonic(),
            seen: vec![0.0; operator.moving.as_ref().map_or(0, MovingRows::column_len)],
            heat: vec![0.0; if operator.moving.is_some() { padded } else { 0 }],
        }
    }
}

/// Weights of one stage, times the step where they meet rates.
#[derive(Clone, Copy)]
pub(super) struct StageWeights {
    /// Of the last stage's increment.
    pub(super) last: f64,
    /// Of the increment before.
    pub(super) before: f64,
    /// Of the rate now \[s\].
    pub(super) now: f64,
    /// Of the rate at the start \[s\].
    pub(super) start: f64,
}

impl StageWeights {
    /// The stages after the first of a super step of `step` \[s\].
    pub(super) fn of(coefficients: &Rkl2Coefficients, step: f64) -> impl Iterator<Item = Self> + '_ {
        coefficients.stages().iter().map(move |stage| Self {
            last: stage.mu,
            before: stage.nu,
            now: stage.mu_tilde * step,
            start: stage.gamma_tilde * step,
        })
    }
}

impl Operator {
    fn potential(&self, particle: usize, enthalpy: f64) -> f64 {
        match self.curves.as_slice() {
            [curve] => curve.potential(enthalpy),
            curves => curves[self.material[particle] as usize].potential(enthalpy),
        }
    }

    /// Heat \[W\] that the rows of a chunk receive by conduction.
    #[inline]
    fn chunk_heat(&self, chunk: usize, columns: &Sources<'_>) -> [f64; LANES] {
        match self.exchange {
            Exchange::Kirchhoff => self.matrix.chunk_heat(chunk, columns.potential),
            Exchange::Harmonic => self.matrix.chunk_heat_by(chunk, |weight, own, other| {
                let conductance = joint_conductance(columns.conductivity[own], columns.conductivity[other]);
                weight * conductance * (columns.temperature[other] - columns.temperature[own])
            }),
            Exchange::Moving => {
                let start = chunk * LANES;
                columns.heat[start..start + LANES].try_into().expect("a slice of LANES entries")
            }
        }
    }

    /// Fills `potential` (and, for the harmonic mean, temperature and conductivity) from `start` + `increment`.
    pub(super) fn evaluate(&self, columns: &mut Columns) {
        let (start, increment) = (&columns.start, &columns.increment);
        for_blocks(&mut columns.potential, |first, potential| {
            for (lane, potential) in potential.iter_mut().enumerate() {
                let i = first + lane;
                if i < self.material.len() {
                    *potential = self.potential(i, start[i] + increment[i]);
                }
            }
        });
        self.prepare_exchange(columns);
    }

    /// What exchanges other than by stored Kirchhoff rows need of the state, before rows are met.
    fn prepare_exchange(&self, columns: &mut Columns) {
        if let Some(moving) = &self.moving {
            moving.heat(&columns.potential, &mut columns.seen, &mut columns.heat);
        }
        if self.exchange != Exchange::Harmonic {
            return;
        }
        for i in 0..self.material.len() {
            let curve = &self.curves[self.material[i] as usize];
            let enthalpy = columns.start[i] + columns.increment[i];
            columns.temperature[i] = curve.temperature(enthalpy);
            columns.conductivity[i] = curve.conductivity(enthalpy);
        }
    }

    /// Writes the rate by conduction and `power` at the potential of the last stage into `conducted_end`.
    pub(super) fn rate(&self, columns: &mut Columns) {
        let mut rate = std::mem::take(&mut columns.conducted_end);
        let sources = Sources::of(columns);
        let power = &columns.power;
        for_blocks(&mut rate, |first, rate| {
            for (at, rate) in rate.chunks_exact_mut(LANES).enumerate() {
                let (chunk, base) = (first / LANES + at, first + at * LANES);
                let heat = self.chunk_heat(chunk, &sources);
                for lane in 0..LANES {
                    rate[lane] = (heat[lane] + power[base + lane]) * self.inverse_mass[base + lane];
                }
            }
        });
        columns.conducted_end = rate;
    }

    /// One stage: reads potential, increments and rate; writes the new increment over `before` and swaps.
    pub(super) fn stage(&self, weights: StageWeights, columns: &mut Columns) {
        let mut next = std::mem::take(&mut columns.before);
        let mut next_potential = std::mem::take(&mut columns.next_potential);
        let sources = Sources::of(columns);
        let Columns { start, rate, increment, power, .. } = &*columns;
        let block = |(index, (next, potential)): (usize, (&mut [f64], &mut [f64]))| {
            let first = index * BLOCK;
            for at in (0..next.len()).step_by(LANES) {
                let base = first + at;
                let heat = self.chunk_heat(base / LANES, &sources);
                let lanes = base..base + LANES;
                let (power, mass) = (&power[lanes.clone()], &self.inverse_mass[lanes.clone()]);
                let (start, rate, last) = (&start[lanes.clone()], &rate[lanes.clone()], &increment[lanes]);
                let next = &mut next[at..at + LANES];
                for lane in 0..LANES {
                    let now = (heat[lane] + power[lane]) * mass[lane];
                    next[lane] = weights.last * last[lane]
                        + weights.before * next[lane]
                        + weights.now * now
                        + weights.start * rate[lane];
                }
                let potential = &mut potential[at..at + LANES];
                self.chunk_potential(base, start, next, potential);
            }
        };
        if self.material.len() < PARALLEL_PARTICLES {
            next.chunks_mut(BLOCK).zip(next_potential.chunks_mut(BLOCK)).enumerate().for_each(block);
        } else {
            next.par_chunks_mut(BLOCK).zip(next_potential.par_chunks_mut(BLOCK)).enumerate().for_each(block);
        }
        columns.before = std::mem::replace(&mut columns.increment, next);
        columns.next_potential = std::mem::replace(&mut columns.potential, next_potential);
        self.prepare_exchange(columns);
    }

    #[inline]
    fn chunk_potential(&self, base: usize, start: &[f64], increment: &[f64], potential: &mut [f64]) {
        match self.curves.as_slice() {
            [curve] => {
                let mut enthalpy = [0.0; LANES];
                for lane in 0..LANES {
                    enthalpy[lane] = start[lane] + increment[lane];
                }
                potential.copy_from_slice(&curve.potentials(&enthalpy));
            }
            curves => {
                for lane in 0..LANES.min(self.material.len().saturating_sub(base)) {
                    let curve = &curves[self.material[base + lane] as usize];
                    potential[lane] = curve.potential(start[lane] + increment[lane]);
                }
            }
        }
    }
}

/// What a row product reads.
struct Sources<'a> {
    potential: &'a [f64],
    temperature: &'a [f64],
    conductivity: &'a [f64],
    heat: &'a [f64],
}

impl<'a> Sources<'a> {
    fn of(columns: &'a Columns) -> Self {
        Self {
            potential: &columns.potential,
            temperature: &columns.temperature,
            conductivity: &columns.conductivity,
            heat: &columns.heat,
        }
    }
}

/// Runs `work(first, block)` over blocks of a column, in parallel where that pays.
fn for_blocks(column: &mut [f64], work: impl Fn(usize, &mut [f64]) + Sync) {
    if column.len() < PARALLEL_PARTICLES {
        column.chunks_mut(BLOCK).enumerate().for_each(|(index, block)| work(index * BLOCK, block));
    } else {
        column.par_chunks_mut(BLOCK).enumerate().for_each(|(index, block)| work(index * BLOCK, block));
    }
}

/// Sum of `term(i)` over `0..count`, block by block, so that it does not depend on the number of threads.
pub(super) fn block_sum<const N: usize>(count: usize, term: impl Fn(usize) -> [f64; N] + Sync) -> [f64; N] {
    let block = |index: usize| {
        let mut sum = [0.0; N];
        for i in index * BLOCK..((index + 1) * BLOCK).min(count) {
            let terms = term(i);
            for k in 0..N {
                sum[k] += terms[k];
            }
        }
        sum
    };
    let blocks = count.div_ceil(BLOCK);
    let add = |mut total: [f64; N], sum: [f64; N]| {
        (0..N).for_each(|k| total[k] += sum[k]);
        total
    };
    if count < PARALLEL_PARTICLES {
        return (0..blocks).map(block).fold([0.0; N], add);
    }
    let sums: Vec<[f64; N]> = (0..blocks).into_par_iter().map(block).collect();
    sums.into_iter().fold([0.0; N], add)
}
