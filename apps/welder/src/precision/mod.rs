//! `welder precision`: error against cost of a case, over spacings and settings.
//!
//! The reference is the case itself at half of its spacing with the tolerance of its steps cut to a fifth; what is listed
//! is the difference to it in width, depth and peak rise, beside processor time, particles and pair visits. Each
//! setting changes one thing against the defaults, so that a line tells what that thing is worth.

mod settings;
mod table;

use crate::case::{self, Case};
use crate::cli::{ExitStatus, PrecisionArguments, refuse, say};
use crate::model::{Model, ModelError};
use crate::observe::scatter_picture::{Series, draw_scatter};
use crate::observe::{Machine, ObserveError, process_cpu_s, summary};
use crate::physics::Failure;
use crate::run::{Simulation, level_plan};
use serde::Serialize;
use settings::Setting;
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

/// Sizes that a run found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Sizes {
    width_m: f64,
    depth_m: f64,
    peak_temperature_k: f64,
    solidified_at_s: Option<f64>,
}

/// One run of the ladder.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
    width_error: f64,
    depth_error: f64,
    peak_error: f64,
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
    points: &'a [Point],
}

/// Runs the ladder of the case of `arguments`.
pub fn command(arguments: &PrecisionArguments) -> ExitStatus {
    let case = match case::load(&arguments.case, &[]) {
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
        Ok(()) => ExitStatus::Done,
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

fn ladder(case: &Case, arguments: &PrecisionArguments) -> Result<(), PrecisionError> {
    let folder = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(&case.name));
    std::fs::create_dir_all(&folder).map_err(ObserveError::file("create", &folder))?;
    let base = Model::from_case(case)?;
    let spacings = settings::spacings(&base);
    if spacings.len() < 2 {
        return Err(PrecisionError::NoLadder);
    }
    let fine = settings::reference(&base);
    let (finest, reference) = run(&fine, "reference")?;
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
    let start = (base.start)(base.bounds().0).1;
    let mut points = Vec::new();
    say(&table::head());
    for setting in settings::all() {
        for &spacing in &spacings {
            let Some(model) = setting.apply(&base, spacing) else { continue };
            let (mut point, sizes) = run(&model, &setting.name)?;
            let relative = |found: f64, exact: f64| if exact == 0.0 { f64::NAN } else { found / exact - 1.0 };
            point.width_error = relative(sizes.width_m, reference.width_m);
            point.depth_error = relative(sizes.depth_m, reference.depth_m);
            point.peak_error =
                relative(sizes.peak_temperature_k - start, reference.peak_temperature_k - start);
            say(&table::row(&point));
            points.push(point);
        }
    }
    table::write_csv(&folder.join("precision.csv"), &points)?;
    draw(&folder, &case.name, &points)?;
    if let Some(path) = &arguments.json {
        let report = Report {
            version: env!("CARGO_PKG_VERSION"),
            machine: Machine::here(),
            case: &case.name,
            reference,
            reference_spacing_m: fine.spacing(),
            reference_particles: finest.particles,
            points: &points,
        };
        summary::write_json(path, &report)?;
    }
    say(&format!("results in {}", folder.display()));
    Ok(())
}

/// Runs a model and counts what it costs; errors are left at zero.
fn run(model: &Model, setting: &str) -> Result<(Point, Sizes), PrecisionError> {
    let clock = || process_cpu_s().unwrap_or(f64::NAN);
    let started = clock();
    let plan = level_plan(model, 0.0)?;
    let mut simulation = Simulation::with_plan(model.clone(), &plan)?;
    let built = clock();
    simulation.run_quietly()?;
    let ended = clock();
    let (records, cost) = (simulation.records(), simulation.cost());
    let sizes = Sizes {
        width_m: records.liquidus.width,
        depth_m: records.liquidus.depth,
        peak_temperature_k: records.peak_temperature,
        solidified_at_s: records.solidified_at,
    };
    let particles = simulation.particles().len();
    let point = Point {
        setting: setting.to_string(),
        spacing_m: model.spacing(),
        particles,
        pairs_per_particle: cost.pair_visits as f64 / cost.sweeps as f64 / particles as f64,
        steps: simulation.steps(),
        sweeps: cost.sweeps,
        pair_visits: cost.pair_visits,
        cpu_s: ended - started,
        setup_cpu_s: built - started,
        width_error: 0.0,
        depth_error: 0.0,
        peak_error: 0.0,
        sizes,
    };
    Ok((point, sizes))
}

fn draw(folder: &Path, name: &str, points: &[Point]) -> Result<(), ObserveError> {
    type Of = fn(&Point) -> f64;
    let errors: [(&str, Of); 3] =
        [("width", |p| p.width_error), ("depth", |p| p.depth_error), ("peak", |p| p.peak_error)];
    let costs: [(&str, &str, Of); 2] =
        [("cpu", "processor time, s", |p| p.cpu_s), ("particles", "particles", |p| p.particles as f64)];
    for (what, error) in errors {
        for (stem, label, cost) in costs {
            let series: Vec<Series> =
                settings::all().iter().map(|setting| line(setting, points, cost, error)).collect();
            let title = format!("{name}: error in {what}");
            let path = folder.join(format!("precision_{what}_{stem}.png"));
            draw_scatter(&path, &title, (label, "error, %"), &series)?;
        }
    }
    Ok(())
}

fn line(setting: &Setting, points: &[Point], cost: fn(&Point) -> f64, error: fn(&Point) -> f64) -> Series {
    let own = points.iter().filter(|point| point.setting == setting.name);
    Series { name: setting.name.clone(), points: own.map(|p| (cost(p), 100.0 * error(p).abs())).collect() }
}
