//! `welder precision`: error against cost of a case, over spacings and settings.
//!
//! The reference is the case itself at half of its spacing with the tolerance of its steps cut to a fifth; what is listed
//! is the difference to it in the pool's width, depth and length, peak rise and weld volume, beside processor time, particles and pair visits. Each
//! setting changes one thing against the defaults, so that a line tells what that thing is worth. Over its spacings each
//! setting is also judged without the reference, by Richardson extrapolation and the grid convergence index.

mod convergence;
mod estimate;
mod picture;
mod quantity;
mod settings;
mod table;

use crate::case::{self, Case};
use crate::cli::{ExitStatus, PrecisionArguments, refuse, say};
use crate::model::{Model, ModelError};
use crate::observe::{Machine, ObserveError, process_cpu_s, summary};
use crate::physics::Failure;
use crate::run::{Simulation, level_plan};
use estimate::Estimate;
use quantity::{Errors, Sizes};
use serde::Serialize;
use std::path::Path;

/// What can stop the ladder.
#[derive(Debug, thiserror::Error)]
enum PrecisionError {
    #[error("{0}")]
    Model(#[from] ModelError),
    #[error("{0}")]
    Failure(#[from] Failure),
    #[error("{0}")]
    Observe(#[from] ObserveError),
    #[error("{0}")]
    Table(#[from] csv::Error),
    #[error("no coarser spacing divides the part; choose a size that is a multiple of 2 or 4 spacings")]
    NoLadder,
}

/// One run of the ladder.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
struct Point {
    setting: String,
    spacing_m: f64,
    particles: usize,
    pairs_per_particle: f64,
    steps: u64,
    sweeps: u64,
    pair_visits: u64,
    cpu_s: f64,
    setup_cpu_s: f64,
    #[serde(flatten)]
    errors: Errors,
    #[serde(flatten)]
    sizes: Sizes,
}

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    machine: Machine,
    case: &'a str,
    reference: Sizes,
    reference_spacing_m: f64,
    reference_particles: usize,
    /// Grid convergence index of the reference in each quantity, in the order of the estimates.
    reference_indices: Vec<f64>,
    points: &'a [Point],
    estimates: &'a [Estimate],
}

/// Runs the ladder of the case of `arguments`.
pub fn command(arguments: &PrecisionArguments) -> ExitStatus {
    let case = match case::load(&arguments.case, &arguments.overrides) {
        Ok(case) => case,
        Err(error) => return refuse(&error),
    };
    // One thread: processor time is then the cost, whatever else the machine does.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let told = match pool {
        Ok(pool) => pool.install(|| ladder(&case, arguments)),
        Err(error) => {
            tracing::error!("the thread cannot be started: {error}");
            return ExitStatus::RunFailed;
        }
    };
    match told {
        Ok(status) => status,
        Err(PrecisionError::NoLadder) => {
            tracing::error!("{}: {}", case.path.display(), PrecisionError::NoLadder);
            ExitStatus::WrongInput
        }
        Err(error) => {
            tracing::error!("{error}");
            ExitStatus::RunFailed
        }
    }
}

fn ladder(case: &Case, arguments: &PrecisionArguments) -> Result<ExitStatus, PrecisionError> {
    let folder = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(&case.name));
    std::fs::create_dir_all(&folder).map_err(ObserveError::file("create", &folder))?;
    let base = Model::from_case(case)?;
    let spacings = settings::spacings(&base);
    if spacings.len() < 2 {
        return Err(PrecisionError::NoLadder);
    }
    let fine = settings::reference(&base);
    let finest = run(&fine, "reference")?;
    let reference = finest.sizes;
    say(&format!(
        "{}: reference at {:.2} um, {} particles: width {:.2} um, depth {:.2} um, peak {:.1} K ({:.1} s)",
        case.name,
        1e6 * fine.spacing(),
        finest.particles,
        1e6 * reference.width_m,
        1e6 * reference.depth_m,
        reference.peak_temperature_k,
        finest.cpu_s
    ));
    let mut points = Vec::new();
    say(&table::head());
    for setting in settings::all() {
        for &spacing in &spacings {
            let Some(model) = setting.apply(&base, spacing) else { continue };
            let mut point = run(&model, &setting.name)?;
            point.errors = Errors::against(&point.sizes, &reference);
            say(&table::row(&point));
            points.push(point);
        }
    }
    let estimates = estimate::estimates(&points);
    let indices = estimate::reference_indices((fine.spacing(), &reference), &points, &estimates);
    say(&table::convergence(&estimates, &indices));
    table::write_csv(&folder.join("precision.csv"), &points)?;
    table::write_convergence(&folder.join("precision_convergence.csv"), &estimates)?;
    picture::draw(&folder, &case.name, &points)?;
    picture::draw_convergence(&folder, &case.name, &points, &estimates)?;
    if let Some(path) = &arguments.json {
        let report = Report {
            version: env!("CARGO_PKG_VERSION"),
            machine: Machine::here(),
            case: &case.name,
            reference,
            reference_spacing_m: fine.spacing(),
            reference_particles: finest.particles,
            reference_indices: indices.clone(),
            points: &points,
            estimates: &estimates,
        };
        summary::write_json(path, &report)?;
    }
    say(&format!("results in {}", folder.display()));
    Ok(arguments.wanted_error.map_or(ExitStatus::Done, |wanted| choose(&points, &indices, wanted)))
}

/// Says which run is the cheapest that is as exact as wanted; without one the audit has failed.
fn choose(points: &[Point], indices: &[f64], wanted: f64) -> ExitStatus {
    let told = |point: &Point| {
        let (bound, quantity) = estimate::bound(point, indices);
        format!(
            "`{}` at spacing_m {:.3e}: {:.2} %, of {quantity}, in {:.3} s of processor time",
            point.setting,
            point.spacing_m,
            100.0 * bound,
            point.cpu_s
        )
    };
    match (estimate::cheapest(points, indices, wanted), estimate::most_exact(points, indices)) {
        (Some(point), _) => {
            say(&format!("cheapest within the wanted error of {wanted}: {}", told(point)));
            ExitStatus::Done
        }
        (None, best) => {
            let best = best.map_or_else(|| "nothing ran".into(), told);
            say(&format!("no run is within the wanted error of {wanted}; the most exact: {best}"));
            ExitStatus::AuditFailed
        }
    }
}

/// Runs a model and counts what it costs; errors are left at zero.
fn run(model: &Model, setting: &str) -> Result<Point, PrecisionError> {
    let clock = || process_cpu_s().unwrap_or(f64::NAN);
    let started = clock();
    let plan = level_plan(model, 0.0)?;
    let mut simulation = Simulation::with_plan(model.clone(), &plan)?;
    let built = clock();
    simulation.run_quietly()?;
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
