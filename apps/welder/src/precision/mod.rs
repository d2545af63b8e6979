//! `welder precision`: error against cost of a case, over spacings and settings; of a scene that is no weld over spacings alone
//! (`plain.rs`).
//!
//! The reference is the case itself at half of its spacing with short steps; what is listed is the difference to it in the
//! pool's width, depth and length, peak rise and weld volume, beside processor time, particles and pair visits. Each
//! setting changes one thing against the defaults, so that a line tells what that thing is worth. All but one run on the same
//! boxes of levels, each cell halved from one spacing to the next: so the runs with the reference's steps and the reference
//! differ in the spacing alone, and Richardson extrapolation and the grid convergence index judge them without a reference.

mod convergence;
mod estimate;
mod limits;
mod measured;
mod picture;
mod plain;
mod quantity;
mod rungs;
mod settings;
mod table;
mod vary;

use crate::case::source::Source;
use crate::case::{self, Case, CaseError, Loaded};
use crate::cli::{ExitStatus, PrecisionArguments, refuse, say};
use crate::model::{Model, ModelError};
use crate::observe::{Machine, ObserveError, summary};
use crate::run::level_plan;
use crate::version;
use estimate::Estimate;
use rungs::Rungs;
use settings::{Boxes, Setting, TIGHT};

use serde::Serialize;
use std::path::Path;

pub(crate) use limits::Limits;
pub(crate) use measured::{MeasureError, Point};
pub(crate) use quantity::Errors;

/// What can stop the ladder.
#[derive(Debug, thiserror::Error)]
enum PrecisionError {
    #[error("{0}")]
    Model(#[from] ModelError),
    #[error("{0}")]
    Measure(#[from] MeasureError),
    #[error("{0}")]
    Observe(#[from] ObserveError),
    #[error("{0}")]
    Table(#[from] csv::Error),
    #[error("{0}")]
    Case(#[from] CaseError),
}

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    commit: &'static str,
    machine: Machine,
    case: &'a str,
    /// Grid convergence index of the reference in each quantity, in the order of the estimates.
    reference_indices: &'a [f64],
    /// All runs; the reference is the last one of the setting with its steps.
    points: &'a [Point],
    estimates: &'a [Estimate],
}

/// Runs the ladder of the case of `arguments`.
pub fn command(arguments: &PrecisionArguments) -> ExitStatus {
    let case = match case::load_any(&arguments.case, &arguments.overrides) {
        Ok(case) => case,
        Err(error) => return refuse(&error),
    };
    // One thread: processor time is then the cost, whatever else the machine does.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let told = match pool {
        Ok(pool) => pool.install(|| of_kind(&case, arguments)),
        Err(error) => {
            tracing::error!("the thread cannot be started: {error}");
            return ExitStatus::RunFailed;
        }
    };
    match told {
        Ok(status) => status,
        Err(PrecisionError::Case(error)) => refuse(&error),
        Err(PrecisionError::Measure(error)) => {
            tracing::error!("{error}");
            error.status()
        }
        Err(error) => {
            tracing::error!("{error}");
            ExitStatus::RunFailed
        }
    }
}

fn of_kind(case: &Loaded, arguments: &PrecisionArguments) -> Result<ExitStatus, PrecisionError> {
    let folder = |name: &str| arguments.out.clone().unwrap_or_else(|| Path::new("out").join(name));
    match case {
        Loaded::Weld(case) => ladder(case, arguments, &folder(&case.name)).map_err(|error| match error {
            PrecisionError::Measure(error @ MeasureError::TooLarge { .. }) => {
                let remedy = "use a larger spacing_m, or raise the budget: precision also runs the case at half of its spacing";
                at_spacing(case, &error.to_string(), remedy).into()
            }
            error => error,
        }),
        Loaded::Fluid(case) => plain::ladder(arguments, &case.name, case.scene.spacing_m, &folder(&case.name)),
        Loaded::Solid(case) => plain::ladder(arguments, &case.name, case.scene.spacing_m, &folder(&case.name)),
    }
}

/// A finding about the spacing of the case.
fn at_spacing(case: &Case, reason: &str, remedy: &str) -> CaseError {
    let source = Source::of_text(&case.path, case.source_text.clone());
    source.map_or_else(|problem| problem, |s| s.problem("resolution.spacing_m", reason, remedy)).into()
}

/// What a ladder found.
struct Ladder {
    points: Vec<Point>,
    estimates: Vec<Estimate>,
    /// Grid convergence index of the reference in each quantity.
    reference_indices: Vec<f64>,
}

fn ladder(case: &Case, arguments: &PrecisionArguments, folder: &Path) -> Result<ExitStatus, PrecisionError> {
    let base = Model::from_case(case)?;
    let settings = match &arguments.vary {
        None => settings::all(&base),
        Some(argument) => {
            settings::plain(&base).into_iter().chain(vary::settings(arguments, argument)?).collect()
        }
    };
    let Some(rungs) = Rungs::new(&base)? else {
        let reason =
            "twice this spacing does not divide the part, or leaves less than two to the beam's radius (1/e)";
        return Err(at_spacing(
            case,
            reason,
            "accepted: a spacing of which each side holds a multiple of 2, six or more, and the radius four",
        )
        .into());
    };
    std::fs::create_dir_all(folder).map_err(ObserveError::file("create", folder))?;
    let points = climb(&rungs, &settings, &Limits::of(&case.scene))?;
    let estimates = estimate::estimates(&points);
    let reference_indices = estimate::reference_indices(&points, &estimates);
    let found = Ladder { points, estimates, reference_indices };
    say(&table::convergence(&found.estimates, &found.reference_indices));
    write(case, arguments, folder, &found)?;
    say(&format!("results in {}", folder.display()));
    let wanted = arguments.wanted_error;
    Ok(wanted.map_or(ExitStatus::Done, |wanted| choose(&found.points, &found.reference_indices, wanted)))
}

/// Runs all settings on all rungs. The reference, which is the largest, comes first in time, and among the points after those
/// of its own setting.
fn climb(rungs: &Rungs, settings: &[Setting], limits: &Limits) -> Result<Vec<Point>, MeasureError> {
    let measure = |setting: &Setting, cut: i64| {
        let Some(model) = setting.at(rungs.spacing(cut)) else { return Ok(None) };
        let plan = || match setting.boxes {
            Boxes::Ladder => Ok(rungs.plan(cut)),
            Boxes::Own => level_plan(&model, 0.0),
        };
        Point::measure_on(&model, plan, &setting.name, limits).map(Some)
    };
    let tight = settings.iter().find(|setting| setting.name == TIGHT);
    let reference = tight.map(|setting| measure(setting, Rungs::REFERENCE)).transpose()?.flatten();
    let mut points = Vec::new();
    let Some(reference) = reference else { return Ok(points) };
    say(&table::head());
    let mut tell = |mut point: Point| {
        point.errors = Errors::against(&point.sizes, &reference.sizes);
        say(&table::row(&point));
        points.push(point);
    };
    for setting in settings {
        for cut in Rungs::CUTS {
            measure(setting, cut)?.into_iter().for_each(&mut tell);
        }
        if setting.name == TIGHT {
            tell(reference.clone());
        }
    }
    Ok(points)
}

fn write(
    case: &Case,
    arguments: &PrecisionArguments,
    folder: &Path,
    found: &Ladder,
) -> Result<(), PrecisionError> {
    let Ladder { points, estimates, reference_indices } = found;
    table::write_csv(&folder.join("precision.csv"), points)?;
    table::write_convergence(&folder.join("precision_convergence.csv"), estimates)?;
    picture::draw(folder, &case.name, points)?;
    picture::draw_convergence(folder, &case.name, points, estimates)?;
    if let Some(path) = &arguments.json {
        let (version, commit, machine) = (version::NUMBER, version::COMMIT, Machine::here());
        summary::write_json(
            path,
            &Report { version, commit, machine, case: &case.name, reference_indices, points, estimates },
        )?;
    }
    Ok(())
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
