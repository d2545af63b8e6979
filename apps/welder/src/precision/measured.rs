//! One run for the sake of its sizes and its cost.

use super::limits::Limits;
use super::quantity::{Errors, Sizes};
use crate::build::LevelPlan;
use crate::cli::ExitStatus;
use crate::model::{Model, ModelError};
use crate::observe::process_cpu_s;
use crate::physics::Failure;
use crate::run::{Simulation, level_plan};
use serde::Serialize;

/// Why there is nothing to measure.
#[derive(Debug, thiserror::Error)]
pub(crate) enum MeasureError {
    #[error("{0}")]
    Model(#[from] ModelError),
    #[error("{0}")]
    Failure(#[from] Failure),
    /// A run that the limits do not allow.
    #[error("the run at {:.2} um {what}", 1e6 * spacing_m)]
    TooLarge { spacing_m: f64, what: String },
    #[error("the step budget of {0} steps is used up: raise budget.max_steps, or shorten time.end_s")]
    Steps(u64),
}

impl MeasureError {
    /// How the program ends by it.
    pub(crate) fn status(&self) -> ExitStatus {
        match self {
            MeasureError::TooLarge { .. } | MeasureError::Model(_) => ExitStatus::WrongInput,
            MeasureError::Failure(_) | MeasureError::Steps(_) => ExitStatus::RunFailed,
        }
    }
}

/// What a run found, and what it cost.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Point {
    pub(crate) setting: String,
    pub(crate) spacing_m: f64,
    pub(crate) particles: usize,
    pub(crate) pairs_per_particle: f64,
    pub(crate) steps: u64,
    pub(crate) sweeps: u64,
    pub(crate) pair_visits: u64,
    pub(crate) cpu_s: f64,
    pub(crate) setup_cpu_s: f64,
    #[serde(flatten)]
    pub(crate) errors: Errors,
    #[serde(flatten)]
    pub(crate) sizes: Sizes,
}

impl Point {
    /// Runs a model to its end, on its own levels of spacing; errors are left at zero.
    ///
    /// # Errors
    /// [`MeasureError`] where the model is too large, cannot be built, or its run fails.
    pub(crate) fn measure(model: &Model, limits: &Limits) -> Result<Self, MeasureError> {
        Self::measure_on(model, || level_plan(model, 0.0), "", limits)
    }

    /// The same on the levels that `plan` makes, under the name of a setting.
    ///
    /// # Errors
    /// Those of [`Point::measure`].
    pub(crate) fn measure_on(
        model: &Model,
        plan: impl FnOnce() -> Result<LevelPlan<3>, ModelError>,
        setting: &str,
        limits: &Limits,
    ) -> Result<Self, MeasureError> {
        let clock = || process_cpu_s().unwrap_or(f64::NAN);
        let started = clock();
        let plan = plan()?;
        if let Some(what) = limits.refuse(&plan) {
            return Err(MeasureError::TooLarge { spacing_m: model.spacing(), what });
        }
        let mut simulation = Simulation::with_plan(model.clone(), &plan)?;
        let built = clock();
        while !simulation.finished() {
            if simulation.steps() >= limits.steps {
                return Err(MeasureError::Steps(limits.steps));
            }
            simulation.step(model.end)?;
        }
        let ended = clock();
        let (records, cost) = (simulation.records(), simulation.cost());
        let start = (model.start)(model.bounds().0).1;
        let sizes = Sizes {
            width_m: records.liquidus.width,
            depth_m: records.liquidus.depth,
            length_m: records.liquidus.length,
            peak_temperature_k: records.peak_temperature,
            peak_rise_k: records.peak_temperature - start,
            weld_volume_m3: simulation.gauge().weld_volume(model, simulation.particles()),
            solidified_at_s: records.solidified_at,
        };
        let particles = simulation.particles().len();
        Ok(Point {
            setting: setting.to_string(),
            spacing_m: model.spacing(),
            particles,
            pairs_per_particle: cost.pair_visits as f64 / cost.sweeps as f64 / particles as f64,
            steps: simulation.steps(),
            sweeps: cost.sweeps,
            pair_visits: cost.pair_visits,
            cpu_s: ended - started,
            setup_cpu_s: built - started,
            errors: Errors::default(),
            sizes,
        })
    }
}
