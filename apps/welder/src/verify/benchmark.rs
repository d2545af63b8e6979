//! What a benchmark is, and running it.

use super::{Entry, observed_order};
use crate::cli::Level;
use crate::model::ModelError;
use crate::observe::process_cpu_s;
use crate::physics::Failure;
use crate::run::Simulation;
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// The largest error that is accepted at a resolution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// The resolution, one of the benchmark's.
    pub resolution: f64,
    /// The largest error.
    pub error: f64,
}

/// One number that a benchmark looks at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// What follows the benchmark's name and a slash in the entry's name; empty where there is one quantity.
    pub suffix: &'static str,
    /// What is compared, how errors are counted, and what the resolution counts.
    pub text: &'static str,
    /// What must hold; rising resolutions.
    pub marks: &'static [Mark],
}

/// A scene whose answer is known.
#[derive(Debug, Clone, Copy)]
pub struct Benchmark {
    /// Stable name.
    pub name: &'static str,
    /// Crate whose law is tested.
    pub tested_crate: &'static str,
    /// What the answer is compared with.
    pub reference: &'static str,
    /// The numbers that it looks at, in the order of the errors that `run` returns.
    pub quantities: &'static [Quantity],
    /// Resolutions, rising.
    pub resolutions: [f64; 3],
    /// How many of them a quick run takes.
    pub quick: usize,
    /// Runs it at one resolution.
    pub run: fn(f64) -> Result<Outcome, BenchmarkError>,
}

/// What a run at one resolution found.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Error of each quantity.
    pub errors: Vec<f64>,
    /// Particles.
    pub particles: usize,
    /// Directed pairs visited.
    pub pair_visits: u64,
}

/// Error and cost at one resolution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LevelResult {
    /// The resolution.
    pub resolution: f64,
    /// Particles.
    pub particles: usize,
    /// Error, relative where the reference is not zero.
    pub error: f64,
    /// Directed pairs visited.
    pub pair_visits: u64,
    /// Processor time over all threads, where the system tells \[s\].
    pub cpu_s: Option<f64>,
    /// Time on the clock \[s\].
    pub wall_s: f64,
}

/// Why a benchmark has no answer.
#[derive(Debug, thiserror::Error)]
pub enum BenchmarkError {
    /// Its scene could not be built.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Its fluid was refused.
    #[error(transparent)]
    Fluid(#[from] sph_fluid::Error),
    /// Its solid was refused.
    #[error(transparent)]
    Solid(#[from] sph_solid::Error),
    /// Its run went wrong.
    #[error(transparent)]
    Run(#[from] Failure),
    /// Its checkpoint could not be written or read.
    #[error(transparent)]
    Checkpoint(#[from] crate::observe::CheckpointError),
    /// The machine refused threads.
    #[error("threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

impl Outcome {
    /// The errors of one simulation, with its cost.
    pub fn of(simulation: &Simulation, errors: Vec<f64>) -> Self {
        let pair_visits = simulation.cost().pair_visits;
        Self { errors, particles: simulation.particles().len(), pair_visits }
    }

    /// The same quantities of two runs: the larger errors, the cost of both.
    pub fn worst(mut self, other: &Self) -> Self {
        self.errors.iter_mut().zip(&other.errors).for_each(|(own, other)| *own = larger(*own, *other));
        self.particles = self.particles.max(other.particles);
        self.pair_visits += other.pair_visits;
        self
    }
}

/// The larger of two errors; no number is the largest of all.
pub(super) fn larger(first: f64, second: f64) -> f64 {
    if first.is_nan() || first > second { first } else { second }
}

/// |found / exact - 1|.
pub(super) fn relative(found: f64, exact: f64) -> f64 {
    (found / exact - 1.0).abs()
}

impl Benchmark {
    /// The resolutions that a level of effort takes.
    pub fn resolutions_at(&self, level: Level) -> &[f64] {
        match level {
            Level::Quick => &self.resolutions[..self.quick],
            Level::Full => &self.resolutions,
        }
    }

    /// Names of its entries.
    pub fn entry_names(&self) -> impl Iterator<Item = String> + '_ {
        self.quantities.iter().map(|quantity| self.entry_name(quantity))
    }

    fn entry_name(&self, quantity: &Quantity) -> String {
        if quantity.suffix.is_empty() {
            self.name.to_string()
        } else {
            format!("{}/{}", self.name, quantity.suffix)
        }
    }

    /// Runs it at all resolutions of a level and judges each quantity.
    ///
    /// # Errors
    /// [`BenchmarkError`] of the first run that has no answer.
    pub fn entries(&self, level: Level) -> Result<Vec<Entry>, BenchmarkError> {
        let mut levels = vec![Vec::new(); self.quantities.len()];
        for &resolution in self.resolutions_at(level) {
            let results = self.measure(resolution)?;
            levels.iter_mut().zip(results).for_each(|(levels, result)| levels.push(result));
        }
        Ok(self
            .quantities
            .iter()
            .zip(levels)
            .map(|(quantity, levels)| self.entry(quantity, levels))
            .collect())
    }

    /// Error and cost of each quantity at one resolution.
    ///
    /// # Errors
    /// [`BenchmarkError`] when the run has no answer.
    pub fn measure(&self, resolution: f64) -> Result<Vec<LevelResult>, BenchmarkError> {
        let (clock, before) = (Instant::now(), process_cpu_s());
        let Outcome { errors, particles, pair_visits } = (self.run)(resolution)?;
        let cpu_s = process_cpu_s().zip(before).map(|(after, before)| after - before);
        let wall_s = clock.elapsed().as_secs_f64();
        let result = |error| LevelResult { resolution, particles, error, pair_visits, cpu_s, wall_s };
        Ok(errors.into_iter().map(result).collect())
    }

    fn entry(&self, quantity: &Quantity, levels: Vec<LevelResult>) -> Entry {
        let error_at = |mark: &Mark| {
            let found = levels.iter().find(|level| level.resolution == mark.resolution);
            found.map(|level| level.error)
        };
        // The mark that is hardest to meet speaks for all in the report.
        let judged = quantity.marks.iter().filter_map(|mark| Some((mark, error_at(mark)?)));
        let strain =
            |&(mark, error): &(&Mark, f64)| if mark.error > 0.0 { error / mark.error } else { error };
        let hardest = judged.clone().max_by(|a, b| strain(a).total_cmp(&strain(b)));
        let mark = hardest.map_or(&quantity.marks[0], |(mark, _)| mark);
        Entry {
            name: self.entry_name(quantity),
            tested_crate: self.tested_crate.into(),
            reference: self.reference.into(),
            quantity: quantity.text.into(),
            observed_order: observed_order(&levels),
            pass_mark: mark.error,
            at_resolution: mark.resolution,
            passed: hardest.is_some() && judged.clone().all(|(mark, error)| error <= mark.error),
            levels,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MARKS: &[Mark] = &[Mark { resolution: 1.0, error: 0.5 }, Mark { resolution: 2.0, error: 0.1 }];

    fn benchmark(run: fn(f64) -> Result<Outcome, BenchmarkError>) -> Benchmark {
        Benchmark {
            name: "test/one",
            tested_crate: "none",
            reference: "arithmetic",
            quantities: &[Quantity { suffix: "sum", text: "a sum", marks: MARKS }],
            resolutions: [1.0, 2.0, 4.0],
            quick: 2,
            run,
        }
    }

    fn outcome(error: f64) -> Result<Outcome, BenchmarkError> {
        Ok(Outcome { errors: vec![error], particles: 7, pair_visits: 3 })
    }

    #[test]
    fn every_mark_must_hold_and_the_hardest_is_shown() {
        let good = benchmark(|n| outcome(0.36 / (n * n))).entries(Level::Full).unwrap().remove(0);
        assert_eq!((good.name.as_str(), good.levels.len(), good.passed), ("test/one/sum", 3, true));
        assert_eq!((good.at_resolution, good.pass_mark), (2.0, 0.1));
        assert!((good.observed_order.unwrap() - 2.0).abs() < 1e-9);
        let bad = benchmark(|n| outcome(0.6 / (n * n * n))).entries(Level::Quick).unwrap().remove(0);
        assert_eq!((bad.levels.len(), bad.passed, bad.at_resolution), (2, false, 1.0));
        let lost = benchmark(|_| outcome(f64::NAN)).entries(Level::Quick).unwrap().remove(0);
        assert!(!lost.passed);
    }

    #[test]
    fn the_worst_of_two_runs_keeps_what_is_no_number() {
        let worst = outcome(0.1).unwrap().worst(&outcome(0.2).unwrap());
        assert_eq!((worst.errors[0], worst.pair_visits), (0.2, 6));
        assert!(outcome(0.1).unwrap().worst(&outcome(f64::NAN).unwrap()).errors[0].is_nan());
        assert!(outcome(f64::NAN).unwrap().worst(&outcome(0.1).unwrap()).errors[0].is_nan());
    }
}
