//! Physics, time, output and budget.

use super::super::nearest::suggestion;
use super::super::scene::{
    Budget, FLOW_FIELDS, Heat, OUTPUT_FIELDS, Output, Physics, STRESS_FIELDS, Scene, Stepping,
};
use super::findings::Findings;
use super::plausible::{DURATION, SMOOTHING_RATIO, STEP_FACTOR, TOLERANCE, number};

/// Most frames, rows or checkpoints of one run; more is a slip in an interval, not a wish.
const MOST_OUTPUTS: f64 = 1e6;

/// Checks the list of physics, the end of the run, what it writes and what it may cost.
pub fn check(findings: &mut Findings, scene: &Scene) {
    check_physics(findings, scene);
    let end_is_fine = findings.within("time.end_s", scene.time.end_s, &DURATION);
    check_intervals(findings, &scene.output, scene.time.end_s, end_is_fine);
    check_fields(findings, scene);
    check_budget(findings, &scene.budget);
}

fn check_physics(findings: &mut Findings, scene: &Scene) {
    let listed = !scene.physics.is_empty();
    findings.require(listed, "physics", "nothing to compute", "list at least one physics: physics: [Heat()]");
    for (index, physics) in scene.physics.iter().enumerate() {
        let first = scene.physics.iter().position(|other| other.name() == physics.name());
        let reason = format!("{} is listed before, at physics.{}", physics.name(), first.unwrap_or(0));
        findings.require(
            first == Some(index),
            &format!("physics.{index}"),
            &reason,
            "list each physics once",
        );
        match physics {
            Physics::Heat(heat) => check_heat(findings, &format!("physics.{index}"), heat),
            Physics::Flow(flow) => super::flow::check(findings, scene, &format!("physics.{index}"), flow),
            Physics::Stress(stress) => {
                super::stress::check(findings, scene, &format!("physics.{index}"), stress)
            }
        }
    }
}

fn check_heat(findings: &mut Findings, field: &str, heat: &Heat) {
    if let Some(ratio) = heat.smoothing_ratio {
        findings.within(&format!("{field}.smoothing_ratio"), ratio, &SMOOTHING_RATIO);
    }
    let stepping = format!("{field}.stepping");
    match heat.stepping {
        Stepping::SuperSteps { tolerance, max_stages } => {
            if let Some(tolerance) = tolerance {
                findings.within(&format!("{stepping}.tolerance"), tolerance, &TOLERANCE);
            }
            let fine = (3..=1000).contains(&max_stages);
            findings.require(
                fine,
                &format!("{stepping}.max_stages"),
                "not a usable number of stages",
                "accepted: 3 to 1000",
            );
        }
        Stepping::Euler { factor } => {
            findings.within(&format!("{stepping}.factor"), factor, &STEP_FACTOR);
        }
    }
}

/// Checks the intervals of `output` against the end of the run.
pub fn check_intervals(findings: &mut Findings, output: &Output, end_s: f64, end_is_fine: bool) {
    let intervals = [
        ("frame_interval_s", output.frame_interval_s),
        ("history_interval_s", output.history_interval_s),
        ("checkpoint_interval_s", output.checkpoint_interval_s),
    ];
    for (name, interval_s) in intervals {
        let field = format!("output.{name}");
        let Some(interval_s) = interval_s else { continue };
        if !findings.within(&field, interval_s, &DURATION) || !end_is_fine {
            continue;
        }
        let count = end_s / interval_s;
        let reason = format!("{} outputs in {} s", number(count.floor()), number(end_s));
        let remedy = format!("accepted: at least {} s", number(end_s / MOST_OUTPUTS));
        findings.require(count <= MOST_OUTPUTS, &field, &reason, remedy);
    }
}

fn check_fields(findings: &mut Findings, scene: &Scene) {
    let all: Vec<&str> = OUTPUT_FIELDS.iter().copied().chain(scene.own_fields()).collect();
    check_listed(findings, &scene.output, &all, |name| {
        if STRESS_FIELDS.contains(&name) {
            "a field of Stress, which the scene does not list under physics"
        } else if FLOW_FIELDS.contains(&name) {
            "a field of Flow, which the scene does not list under physics"
        } else {
            "there is no such output field"
        }
    });
}

/// Checks that each field that `output` lists is one of `all`, and listed once; `reason` says why another is none.
pub fn check_listed(
    findings: &mut Findings,
    output: &Output,
    all: &[&str],
    reason: impl Fn(&str) -> &'static str,
) {
    let Some(fields) = &output.fields else { return };
    for (index, name) in fields.iter().enumerate() {
        let place = format!("output.fields.{index}");
        let known = all.contains(&name.as_str());
        let twice = fields[..index].contains(name);
        findings.require(known, &place, reason(name), suggestion(name, all));
        findings.require(!twice, &place, "listed twice", "list each field once");
    }
}

/// Checks that a budget allows anything.
pub fn check_budget(findings: &mut Findings, budget: &Budget) {
    let limits = [
        ("max_particles", Some(budget.max_particles)),
        ("max_steps", Some(budget.max_steps)),
        ("max_memory_bytes", budget.max_memory_bytes),
    ];
    for (name, limit) in limits {
        let field = format!("budget.{name}");
        findings.require(limit != Some(0), &field, "a budget of zero allows nothing", "accepted: 1 or more");
    }
}
