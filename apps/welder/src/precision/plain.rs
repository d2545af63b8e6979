//! The ladder of a scene of fluid or of elastic bodies: the case at twice its spacing, at its own and at half of it, and what the
//! numbers of its summary say about their errors by themselves.

use super::convergence::{Convergence, index_of_two};
use super::{MeasureError, PrecisionError, table};
use crate::case::scene::Budget;
use crate::case::{self, CaseError, Loaded, Problem};
use crate::cli::{ExitStatus, PrecisionArguments, say};
use crate::fluid::{FluidFlow, FluidModel};
use crate::observe::scatter_picture::{Series, draw_scatter};
use crate::observe::{Machine, ObserveError, process_cpu_s, summary};
use crate::run::Scenario;
use crate::solid::{SolidBody, SolidModel};
use crate::version;
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// Spacings of the runs over that of the case, coarse to fine.
const RATIOS: [f64; 3] = [2.0, 1.0, 0.5];

/// Numbers that differ by this share at most, as the mass, do not change with the spacing.
const ROUND_OFF: f64 = 1e-12;

/// Lines of the picture; more of them cannot be told apart.
const LINES: usize = 8;

/// What a run found, and what it cost.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Run {
    spacing_m: f64,
    particles: usize,
    steps: u64,
    pair_visits: u64,
    cpu_s: f64,
    /// The numbers of the summary that the scene has of its own.
    values: BTreeMap<String, f64>,
}

/// What the runs say about one number.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Judged {
    quantity: String,
    /// At twice the spacing, at the case's own, at half of it.
    values: [f64; 3],
    #[serde(flatten)]
    convergence: Convergence,
    /// Difference of the case's own value to the extrapolated one, or, where there is none, to the finest; relative to that.
    own_error: f64,
    /// Grid convergence index of the finest; without an order that of the two finest with order one.
    finest_index: f64,
}

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    commit: &'static str,
    machine: Machine,
    case: &'a str,
    runs: &'a [Run],
    quantities: &'a [Judged],
}

/// Runs the ladder of a case named `name` whose own spacing \[m\] is given.
pub(super) fn ladder(
    arguments: &PrecisionArguments,
    name: &str,
    spacing: f64,
    folder: &Path,
) -> Result<ExitStatus, PrecisionError> {
    for (option, is_there) in
        [("--vary", arguments.vary.is_some()), ("--wanted-error", arguments.wanted_error.is_some())]
    {
        if is_there {
            let reason = "this option is for welds".to_string();
            let remedy = "accepted: without it, a ladder of spacings; --set changes the case".to_string();
            return Err(CaseError::from(Problem::without_text(option, reason, remedy)).into());
        }
    }
    // All are read before the first is run: a spacing that the scene refuses is told at once.
    let cases = RATIOS.map(|ratio| at_spacing(arguments, ratio * spacing));
    std::fs::create_dir_all(folder).map_err(ObserveError::file("create", folder))?;
    let mut runs = Vec::new();
    say(&head());
    for case in cases.into_iter().collect::<Result<Vec<_>, _>>()? {
        let run = run(&case)?;
        say(&row(&run));
        runs.push(run);
    }
    let judged = judge(&runs);
    say(&told(&judged));
    write(arguments, name, folder, &runs, &judged)?;
    say(&format!("results in {}", folder.display()));
    Ok(ExitStatus::Done)
}

fn at_spacing(arguments: &PrecisionArguments, spacing: f64) -> Result<Loaded, CaseError> {
    let mut overrides = arguments.overrides.clone();
    overrides.push(format!("spacing_m={spacing:?}"));
    case::load_any(&arguments.case, &overrides)
}

fn run(case: &Loaded) -> Result<Run, PrecisionError> {
    let clock = || process_cpu_s().unwrap_or(f64::NAN);
    let started = clock();
    let mut run = match case {
        Loaded::Fluid(case) if case.scene.dimension() == 2 => {
            finish(FluidFlow::<2>::new(FluidModel::from_case(case)?)?, &case.scene.budget)
        }
        Loaded::Fluid(case) => finish(FluidFlow::<3>::new(FluidModel::from_case(case)?)?, &case.scene.budget),
        Loaded::Solid(case) if case.scene.dimension() == 2 => {
            finish(SolidBody::<2>::new(SolidModel::from_case(case)?)?, &case.scene.budget)
        }
        Loaded::Solid(case) => finish(SolidBody::<3>::new(SolidModel::from_case(case)?)?, &case.scene.budget),
        Loaded::Weld(_) => unreachable!("a change of the spacing makes no weld of another scene"),
    }?;
    run.cpu_s = clock() - started;
    Ok(run)
}

/// Takes a scene to its end.
fn finish<const D: usize>(mut scene: impl Scenario<D>, budget: &Budget) -> Result<Run, MeasureError> {
    while !scene.finished() {
        if scene.steps() >= budget.max_steps {
            return Err(MeasureError::Steps(budget.max_steps));
        }
        scene.step(scene.end())?;
    }
    if let Some(fault) = scene.fault() {
        tracing::warn!("at a spacing of {:.3e} m: {fault}", scene.spacing());
    }
    let mut values = BTreeMap::new();
    let outcome = serde_json::to_value(scene.outcome()).expect("a summary can be written as JSON");
    flatten("", &outcome, &mut values);
    Ok(Run {
        spacing_m: scene.spacing(),
        particles: scene.positions().len(),
        steps: scene.steps(),
        pair_visits: scene.cost().pair_visits,
        cpu_s: 0.0,
        values,
    })
}

/// The numbers of a value under their paths, as `energy.kinetic_j` and `high_m.0`.
fn flatten(path: &str, value: &Value, into: &mut BTreeMap<String, f64>) {
    let below = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    match value {
        Value::Object(fields) => fields.iter().for_each(|(key, value)| flatten(&below(key), value, into)),
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(k, value)| flatten(&below(&k.to_string()), value, into));
        }
        _ => into.extend(value.as_f64().map(|number| (path.to_string(), number))),
    }
}

/// Judges all numbers that change with the spacing.
fn judge(runs: &[Run]) -> Vec<Judged> {
    let [coarse, own, fine] = runs else { return Vec::new() };
    let judge_one = |quantity: &String| {
        let values = [coarse, own, fine].map(|run| run.values.get(quantity).copied().unwrap_or(f64::NAN));
        let rungs = [coarse, own, fine].map(|run| run.spacing_m).into_iter().zip(values);
        let convergence = Convergence::of(&rungs.collect::<Vec<_>>())?;
        let best = convergence.extrapolated.unwrap_or(values[2]);
        let of_two = || index_of_two(values[2], values[1], own.spacing_m / fine.spacing_m);
        let changes = values.iter().any(|value| (value - values[2]).abs() > ROUND_OFF * values[2].abs());
        changes.then(|| Judged {
            quantity: quantity.clone(),
            values,
            convergence,
            own_error: (values[1] / best - 1.0).abs(),
            finest_index: convergence.index.unwrap_or_else(of_two),
        })
    };
    fine.values.keys().filter_map(judge_one).collect()
}

fn head() -> String {
    format!("{:>10} {:>9} {:>8} {:>11} {:>8}", "um", "particles", "steps", "pair visits", "cpu s")
}

fn row(run: &Run) -> String {
    format!(
        "{:>10.3} {:>9} {:>8} {:>11.3e} {:>8.2}",
        1e6 * run.spacing_m,
        run.particles,
        run.steps,
        run.pair_visits as f64,
        run.cpu_s
    )
}

fn told(judged: &[Judged]) -> String {
    let mut lines = vec![format!(
        "{:<26} {:>12} {:>12} {:>12} {:>6} {:>12} {:>8} {:>8}",
        "at the end", "twice", "own", "half", "order", "extrapolated", "own %", "index %"
    )];
    lines.extend(judged.iter().map(|one| {
        let cell = |value: Option<String>| value.unwrap_or_else(|| "-".into());
        format!(
            "{:<26} {:>12.4e} {:>12.4e} {:>12.4e} {:>6} {:>12} {:>8.2} {:>8.2}{}",
            one.quantity,
            one.values[0],
            one.values[1],
            one.values[2],
            cell(one.convergence.order.map(|order| format!("{order:.2}"))),
            cell(one.convergence.extrapolated.map(|value| format!("{value:.4e}"))),
            100.0 * one.own_error,
            100.0 * one.finest_index,
            if one.convergence.asymptotic { String::new() } else { format!("  {}", table::NOT_ASYMPTOTIC) }
        )
    }));
    lines.join("\n")
}

fn write(
    arguments: &PrecisionArguments,
    name: &str,
    folder: &Path,
    runs: &[Run],
    judged: &[Judged],
) -> Result<(), PrecisionError> {
    write_runs(&folder.join("precision.csv"), runs)?;
    write_judged(&folder.join("precision_convergence.csv"), judged)?;
    let title = format!("{name}: distance to the extrapolated value");
    let lines: Vec<Series> = judged.iter().filter_map(|one| line(one, runs)).take(LINES).collect();
    draw_scatter(&folder.join("precision_convergence.png"), &title, ("spacing, um", "distance, %"), &lines)?;
    if let Some(path) = &arguments.json {
        let (version, commit, machine) = (version::NUMBER, version::COMMIT, Machine::here());
        summary::write_json(
            path,
            &Report { version, commit, machine, case: name, runs, quantities: judged },
        )?;
    }
    Ok(())
}

/// The distances of a number that has an extrapolated value.
fn line(one: &Judged, runs: &[Run]) -> Option<Series> {
    let (limit, order) = (one.convergence.extrapolated?, one.convergence.order?);
    let distance = |value: &f64| 100.0 * (value / limit - 1.0).abs();
    let spacings = runs.iter().map(|run| 1e6 * run.spacing_m);
    let points = spacings.zip(one.values.iter().map(distance)).collect();
    Some(Series { name: format!("{}, order {order:.2}", one.quantity), points })
}

fn write_runs(path: &Path, runs: &[Run]) -> Result<(), PrecisionError> {
    let mut table = csv::Writer::from_writer(Vec::new());
    let costs = ["spacing_m", "particles", "steps", "pair_visits", "cpu_s"];
    let names = runs.first().into_iter().flat_map(|run| run.values.keys().map(String::as_str));
    table.write_record(costs.into_iter().chain(names))?;
    for run in runs {
        let costs = [
            run.spacing_m.to_string(),
            run.particles.to_string(),
            run.steps.to_string(),
            run.pair_visits.to_string(),
            run.cpu_s.to_string(),
        ];
        table.write_record(costs.into_iter().chain(run.values.values().map(f64::to_string)))?;
    }
    table::place(path, table)
}

fn write_judged(path: &Path, judged: &[Judged]) -> Result<(), PrecisionError> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record([
        "quantity",
        "value_at_twice",
        "value",
        "value_at_half",
        "observed_order",
        "extrapolated",
        "relative_error",
        "grid_convergence_index_at_half",
        "verdict",
    ])?;
    for one in judged {
        let optional = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
        let found = &one.convergence;
        table.write_record([
            one.quantity.clone(),
            one.values[0].to_string(),
            one.values[1].to_string(),
            one.values[2].to_string(),
            optional(found.order),
            optional(found.extrapolated),
            one.own_error.to_string(),
            one.finest_index.to_string(),
            if found.asymptotic { "asymptotic" } else { table::NOT_ASYMPTOTIC }.to_string(),
        ])?;
    }
    table::place(path, table)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runs(value: impl Fn(f64) -> f64) -> Vec<Run> {
        let run = |spacing_m: f64| Run {
            spacing_m,
            particles: 1,
            steps: 1,
            pair_visits: 1,
            cpu_s: 1.0,
            values: BTreeMap::from([("tip.1".into(), value(spacing_m)), ("mass_kg".into(), 2.0)]),
        };
        RATIOS.map(|ratio| run(0.1 * ratio)).to_vec()
    }

    #[test]
    fn what_changes_with_the_spacing_is_judged() {
        let judged = judge(&runs(|h| 3.0 + 0.6 * h * h));
        assert_eq!(judged.len(), 1, "the mass does not change: {judged:?}");
        assert!((judged[0].convergence.order.unwrap() - 2.0).abs() < 1e-6);
        assert!((judged[0].own_error / (0.006 / 3.0) - 1.0).abs() < 1e-6, "{judged:?}");
        assert!(told(&judged).contains("tip.1"), "{}", told(&judged));
    }

    #[test]
    fn values_that_swing_are_compared_with_the_finest() {
        let judged = judge(&runs(|h| if h == 0.1 { 1.1 } else { 1.0 }));
        assert_eq!(judged[0].convergence.order, None);
        assert!((judged[0].own_error - 0.1).abs() < 1e-12 && (judged[0].finest_index - 0.3).abs() < 1e-12);
    }

    #[test]
    fn numbers_are_named_by_their_paths() {
        let value =
            serde_json::json!({"a": 1.5, "low_m": [1, 2.0], "energy": {"kinetic_j": 3.0, "none": null}});
        let mut found = BTreeMap::new();
        flatten("", &value, &mut found);
        let expected = [("a", 1.5), ("energy.kinetic_j", 3.0), ("low_m.0", 1.0), ("low_m.1", 2.0)];
        assert_eq!(found, expected.map(|(name, number)| (name.to_string(), number)).into());
    }
}
