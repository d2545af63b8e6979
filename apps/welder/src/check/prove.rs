//! `welder check --prove`: the advice held against runs. A coarse copy of the case is run as it is, and once more with each
//! effect taken out, or put in where the case leaves it out; the changes stand beside what was estimated.
//!
//! A change between two runs on the same particles is known better than either size, for most of the error of the spacing is
//! in both.

mod coarse;
mod twins;

use super::advice::{Advice, Bound, NEGLIGIBLE, advice};
use crate::case::Case;
use crate::cli::{ExitStatus, say};
use crate::model::Model;
use crate::observe::{Machine, summary};
use crate::precision::{Errors, Limits, MeasureError, Point};
use crate::version;
use serde::Serialize;
use std::path::Path;
use twins::Twins;

/// What the two runs of one effect found.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Finding {
    effect: &'static str,
    /// What the two runs differ in.
    change: String,
    /// What `check` says.
    verdict: &'static str,
    /// What `check` estimates.
    bound: Option<Bound>,
    /// What the runs say.
    #[serde(flatten)]
    outcome: Outcome,
    /// Whether the advice holds; none where nothing was estimated or run.
    holds: Option<bool>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
enum Outcome {
    /// Changes that leaving the effect out makes, relative to the run that has it, and processor time with and without.
    Compared { changes: Errors, cpu_with_s: f64, cpu_without_s: f64 },
    /// Why there were no two runs.
    NotRun(String),
    /// A run ended before its time.
    Failed(String),
}

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    commit: &'static str,
    machine: Machine,
    case: &'a str,
    base: &'a Point,
    findings: &'a [Finding],
}

/// Runs the pairs of the case and says which advice holds.
pub(super) fn prove(case: &Case, json: Option<&Path>) -> ExitStatus {
    // One thread: processor time is then the cost, whatever else the machine does.
    let pool = match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
        Ok(pool) => pool,
        Err(error) => {
            tracing::error!("the thread cannot be started: {error}");
            return ExitStatus::RunFailed;
        }
    };
    match pool.install(|| compare(case)) {
        Ok((base, findings)) => conclude(case, &base, &findings, json),
        Err(error) => {
            tracing::error!("the coarse copy of the case: {error}");
            error.status()
        }
    }
}

fn compare(case: &Case) -> Result<(Point, Vec<Finding>), MeasureError> {
    let coarse = coarse::coarse(case);
    let base = measure(&twins::base(&coarse))?;
    say(&head(case, &base));
    let model = Model::from_case(&coarse)?;
    let told = advice(case, &model);
    let mut findings = Vec::new();
    for twins in twins::all(&coarse, &model) {
        let advised = told.iter().find(|advice| advice.effect.name() == twins.effect);
        let finding = judge(&twins, advised, outcome(&twins, &base));
        say(&row(&finding));
        findings.push(finding);
    }
    Ok((base, findings))
}

fn measure(case: &Case) -> Result<Point, MeasureError> {
    Point::measure(&Model::from_case(case)?, &Limits::of(&case.scene))
}

fn outcome(twins: &Twins, base: &Point) -> Outcome {
    let pair = match &twins.pair {
        Ok(pair) => pair,
        Err(reason) => return Outcome::NotRun(reason.clone()),
    };
    let run = |case: &Option<Case>| case.as_ref().map_or_else(|| Ok(base.clone()), measure);
    match (run(&pair.with), run(&pair.without)) {
        (Ok(with), Ok(without)) => Outcome::Compared {
            changes: Errors::against(&without.sizes, &with.sizes),
            cpu_with_s: with.cpu_s,
            cpu_without_s: without.cpu_s,
        },
        (Err(error), _) => Outcome::Failed(format!("with: {error}")),
        (_, Err(error)) => Outcome::Failed(format!("without: {error}")),
    }
}

/// Holds the advice against the runs: no change may be larger than estimated, and what can be left out may change the peak
/// rise by [`NEGLIGIBLE`] at most.
fn judge(twins: &Twins, advised: Option<&Advice>, outcome: Outcome) -> Finding {
    let (bound, matters) = advised.map_or((None, None), |advice| (advice.bound, advice.matters));
    let holds = match &outcome {
        Outcome::Compared { changes, .. } => {
            let within = bound.map(|bound| bound.holds(changes));
            let negligible = (matters == Some(false)).then(|| changes.peak_error.abs() <= NEGLIGIBLE);
            match (within, negligible) {
                (None, None) => None,
                _ => Some(within != Some(false) && negligible != Some(false)),
            }
        }
        _ => None,
    };
    Finding {
        effect: twins.effect,
        change: twins.change.clone(),
        verdict: advised.map_or("-", Advice::verdict),
        bound,
        outcome,
        holds,
    }
}

/// Changes are known to this share: two runs whose boxes of levels or whose steps differ come that close.
const RESOLVED: f64 = 1e-3;

impl Bound {
    /// Whether changes stay within the estimate, as far as they are known.
    fn holds(self, changes: &Errors) -> bool {
        let (change, most) = match self {
            Bound::Rise(share) => (changes.peak_error, share),
            Bound::Melt(share) => (changes.weld_error, share),
        };
        change.abs() <= most + RESOLVED
    }
}

fn head(case: &Case, base: &Point) -> String {
    format!(
        "{}: with and without, at {:.2} um, {} particles: width {:.2} um, depth {:.2} um, length {:.2} um, peak {:.1} K ({:.2} s)\n\
         {:<14} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9}  {:<10} {:<15} {:<6} change",
        case.name,
        1e6 * base.spacing_m,
        base.particles,
        1e6 * base.sizes.width_m,
        1e6 * base.sizes.depth_m,
        1e6 * base.sizes.length_m,
        base.sizes.peak_temperature_k,
        base.cpu_s,
        "effect",
        "width %",
        "depth %",
        "length %",
        "peak %",
        "weld %",
        "with s",
        "without s",
        "check",
        "estimate",
        "holds"
    )
}

fn row(finding: &Finding) -> String {
    let (changes, cost) = match &finding.outcome {
        Outcome::Compared { changes, cpu_with_s, cpu_without_s } => {
            (Some(changes), [*cpu_with_s, *cpu_without_s].map(|cpu_s| format!("{cpu_s:.2}")))
        }
        _ => (None, ["-", "-"].map(String::from)),
    };
    let cell = |of: fn(&Errors) -> f64| {
        let share = changes.map(of).filter(|share| share.is_finite());
        share.map_or_else(|| "-".into(), |share| format!("{:+.2}", 100.0 * share))
    };
    let estimate = match finding.bound {
        Some(Bound::Rise(share)) => format!("peak <= {:.2} %", 100.0 * share),
        Some(Bound::Melt(share)) => format!("weld <= {:.0} %", 100.0 * share),
        None => "-".into(),
    };
    let reason = match &finding.outcome {
        Outcome::Compared { .. } => String::new(),
        Outcome::NotRun(reason) => format!("; not run: {reason}"),
        Outcome::Failed(reason) => format!("; failed: {reason}"),
    };
    format!(
        "{:<14} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9}  {:<10} {:<15} {:<6} {}{reason}",
        finding.effect,
        cell(|e| e.width_error),
        cell(|e| e.depth_error),
        cell(|e| e.length_error),
        cell(|e| e.peak_error),
        cell(|e| e.weld_error),
        cost[0],
        cost[1],
        finding.verdict,
        estimate,
        finding.holds.map_or("-", |holds| if holds { "yes" } else { "NO" }),
        finding.change,
    )
}

/// Writes the findings, and says how it ends: a run that failed outweighs an advice that does not hold.
fn conclude(case: &Case, base: &Point, findings: &[Finding], json: Option<&Path>) -> ExitStatus {
    if let Some(path) = json {
        let (version, commit, machine) = (version::NUMBER, version::COMMIT, Machine::here());
        let report = Report { version, commit, machine, case: &case.name, base, findings };
        if let Err(error) = summary::write_json(path, &report) {
            tracing::error!("{error}");
            return ExitStatus::RunFailed;
        }
    }
    if findings.iter().any(|finding| matches!(finding.outcome, Outcome::Failed(_))) {
        return ExitStatus::RunFailed;
    }
    let wrong: Vec<_> = findings
        .iter()
        .filter(|finding| finding.holds == Some(false))
        .map(|finding| finding.effect)
        .collect();
    if wrong.is_empty() {
        ExitStatus::Done
    } else {
        tracing::error!("the runs contradict the advice on: {}", wrong.join(", "));
        ExitStatus::AuditFailed
    }
}

#[cfg(test)]
mod tests {
    use super::super::advice::Effect;
    use super::*;

    fn found(matters: Option<bool>, bound: Option<Bound>, peak_error: f64) -> Option<bool> {
        let advice = Advice { effect: Effect::Losses, matters, text: String::new(), bound };
        let twins = Twins { effect: "losses", change: String::new(), pair: Err(String::new()) };
        let changes = Errors { peak_error, weld_error: f64::NAN, ..Errors::default() };
        let outcome = Outcome::Compared { changes, cpu_with_s: 1.0, cpu_without_s: 1.0 };
        judge(&twins, Some(&advice), outcome).holds
    }

    #[test]
    fn an_advice_is_held_against_its_own_estimate() {
        let bound = Some(Bound::Rise(0.02));
        assert_eq!(found(Some(true), bound, -0.019), Some(true));
        assert_eq!(found(Some(true), bound, -0.022), Some(false));
        assert_eq!(found(Some(false), Some(Bound::Rise(0.05)), 0.011), Some(false), "not negligible");
        assert_eq!(found(Some(false), None, 0.009), Some(true));
        assert_eq!(found(Some(true), None, 0.5), None, "nothing was estimated");
        assert_eq!(found(Some(true), Some(Bound::Melt(0.5)), 0.0), Some(false), "no number is no proof");
    }
}
