//! Scenes of elastic bodies.

use super::super::axes::Axes;
use super::super::fluid::Body;
use super::super::over_rise::OverRise;
use super::super::problem::Problem;
use super::super::solid::{Form, SOLID_FIELDS, Solid, SolidScene};
use super::super::source::Source;
use super::findings::Findings;
use super::fluid::{check_tuples, check_whole, overlap};
use super::plausible::{
    ARTIFICIAL_STRESS, BODY_EXPANSION, BODY_YIELD, DAMPING, DISORDER, DURATION, FLUID_LENGTH, FLUID_PLACE,
    FLUID_SPACING, GRAVITY, LIQUID_DENSITY, POISSON, RADIUS, RISE, Range, SMOOTHING_RATIO, SOLID_YOUNG,
    VELOCITY, number,
};
use super::{run, size};

/// Rows of particles that a body needs at least, from side to side.
const LEAST_ROWS: f64 = 4.0;

/// Most bodies: frames number them in bytes.
const MOST_BODIES: usize = 256;

/// A body that starts faster than this share of sqrt(E/rho) meets others as in an explosion.
const LARGEST_SPEED: f64 = 0.5;

/// All findings, in the order of the sections.
pub fn validate_solid(source: &Source, scene: &SolidScene) -> Vec<Problem> {
    let mut findings = Findings::new(source, "");
    let count = scene.bodies.len();
    let reason = format!("{count} bodies");
    findings.require((1..=MOST_BODIES).contains(&count), "bodies", &reason, "accepted: 1 to 256 bodies");
    check_tuples(&mut findings, scene.dimension(), "the first of bodies", tuples(scene));
    check_values(&mut findings, scene);
    let end_is_fine = findings.within("time.end_s", scene.time.end_s, &DURATION);
    run::check_intervals(&mut findings, &scene.output, scene.time.end_s, end_is_fine);
    run::check_listed(&mut findings, &scene.output, SOLID_FIELDS, |_| "a scene of solids has no such field");
    run::check_budget(&mut findings, &scene.budget);
    // What follows compares numbers that must be right by themselves.
    if findings.is_empty() {
        scene
            .bodies
            .iter()
            .enumerate()
            .for_each(|(index, body)| check_body(&mut findings, scene, index, body));
        check_held(&mut findings, scene);
    }
    if findings.is_empty() {
        check_meeting(&mut findings, scene);
        check_size(&mut findings, scene);
    }
    findings.into_problems()
}

/// Every tuple of the scene with its place and range.
fn tuples(scene: &SolidScene) -> Vec<(String, &Axes, Range)> {
    let mut all: Vec<(String, &Axes, Range)> = Vec::new();
    all.extend(scene.gravity_m_s2.as_ref().map(|gravity| ("gravity_m_s2".to_string(), gravity, GRAVITY)));
    for (index, body) in scene.bodies.iter().enumerate() {
        let field = |name: &str| format!("bodies.{index}.{name}");
        match body {
            Solid::Block { low_m, high_m, .. } => {
                all.push((field("low_m"), low_m, FLUID_PLACE));
                all.push((field("high_m"), high_m, FLUID_PLACE));
            }
            Solid::Ring { centre_m, .. } => all.push((field("centre_m"), centre_m, FLUID_PLACE)),
        }
        all.extend(body.velocity_m_s().map(|velocity| (field("velocity_m_s"), velocity, VELOCITY)));
    }
    for (index, hold) in scene.held.iter().enumerate() {
        all.push((format!("held.{index}.low_m"), &hold.low_m, FLUID_PLACE));
        all.push((format!("held.{index}.high_m"), &hold.high_m, FLUID_PLACE));
        let velocity = hold.velocity_m_s.as_ref();
        all.extend(velocity.map(|velocity| (format!("held.{index}.velocity_m_s"), velocity, VELOCITY)));
    }
    let spot = scene.heating.as_ref().and_then(|heating| heating.spot.as_ref());
    all.extend(spot.map(|spot| ("heating.spot.centre_m".to_string(), &spot.centre_m, FLUID_PLACE)));
    all
}

fn check_values(findings: &mut Findings, scene: &SolidScene) {
    let (material, scheme) = (&scene.material, &scene.scheme);
    findings.within("spacing_m", scene.spacing_m, &FLUID_SPACING);
    findings.within("material.density_kg_m3", material.density_kg_m3, &LIQUID_DENSITY);
    findings.within("material.young_pa", material.young_pa, &SOLID_YOUNG);
    findings.within("material.poisson", material.poisson, &POISSON);
    findings.within("disorder", scene.disorder, &DISORDER);
    check_over_rise(findings, "material.expansion_1_k", &material.expansion_1_k, &BODY_EXPANSION);
    if let Some(yield_pa) = &material.yield_pa {
        check_over_rise(findings, "material.yield_pa", yield_pa, &BODY_YIELD);
    }
    findings.within("damping_1_s", scene.damping_1_s, &DAMPING);
    if let Some(ratio) = scheme.smoothing_ratio {
        findings.within("scheme.smoothing_ratio", ratio, &SMOOTHING_RATIO);
    }
    if let Some(stress) = scheme.artificial_stress {
        findings.within("scheme.artificial_stress", stress, &ARTIFICIAL_STRESS);
        let reason = "the total-Lagrangian form needs none";
        let remedy = "leave it out, or accepted with scheme.form: Paper, Corrected";
        findings.require(scheme.form != Form::Total, "scheme.artificial_stress", reason, remedy);
    }
    check_heating(findings, scene);
}

/// A number, or a table whose rises ascend.
fn check_over_rise(findings: &mut Findings, field: &str, value: &OverRise, range: &Range) {
    let points = match value {
        OverRise::Constant(value) => {
            findings.within(field, *value, range);
            return;
        }
        OverRise::Table(points) => points,
    };
    let remedy = "accepted: [(rise_k, value), ...] with at least two points, or a number";
    findings.require(points.len() >= 2, field, "fewer than two points", remedy);
    for (index, &(rise_k, value)) in points.iter().enumerate() {
        findings.within(&format!("{field}.{index}.1"), value, range);
        if findings.within(&format!("{field}.{index}.0"), rise_k, &RISE) && index > 0 {
            let reason = format!("not above the rise before it, {} K", number(points[index - 1].0));
            let remedy = "accepted: rises that ascend from point to point";
            let ascends = points[index - 1].0 < rise_k;
            findings.require(ascends, &format!("{field}.{index}.0"), &reason, remedy);
        }
    }
}

fn check_heating(findings: &mut Findings, scene: &SolidScene) {
    let Some(heating) = &scene.heating else { return };
    let reason = "a material that does not expand, so that it does nothing";
    let remedy = "give material.expansion_1_k, or leave heating out";
    let expands = scene.material.expansion_1_k.points().iter().any(|&(_, expansion)| expansion > 0.0);
    findings.require(expands, "heating", reason, remedy);
    findings.require(!heating.nodes.is_empty(), "heating.nodes", "no nodes", "accepted: at least one");
    let mut before_s = 0.0;
    for (index, node) in heating.nodes.iter().enumerate() {
        let field = |name: &str| format!("heating.nodes.{index}.{name}");
        findings.within(&field("rise_k"), node.rise_k, &RISE);
        if findings.within(&field("time_s"), node.time_s, &DURATION) {
            let reason = format!("{} s, which is not after {} s", number(node.time_s), number(before_s));
            let remedy = "accepted: times that rise, the first above zero";
            findings.require(node.time_s > before_s, &field("time_s"), &reason, remedy);
        }
        before_s = node.time_s;
    }
    if let Some(spot) = &heating.spot {
        findings.within("heating.spot.radius_m", spot.radius_m, &FLUID_LENGTH);
    }
}

fn check_body(findings: &mut Findings, scene: &SolidScene, index: usize, body: &Solid) {
    match body {
        Solid::Block { low_m, high_m, .. } => {
            for (axis, (low, high)) in low_m.values().iter().zip(high_m.values()).enumerate() {
                let field = format!("bodies.{index}.high_m.{axis}");
                if findings.require(high > low, &field, "not above low_m", "accepted: high_m above low_m") {
                    check_whole(findings, &field, *high, *low, scene.spacing_m);
                    check_rows(findings, scene, &field, high - low);
                }
            }
        }
        Solid::Ring { inner_radius_m, outer_radius_m, .. } => {
            let field = |name: &str| format!("bodies.{index}.{name}");
            let inner = findings.within(&field("inner_radius_m"), *inner_radius_m, &RADIUS);
            let outer = findings.within(&field("outer_radius_m"), *outer_radius_m, &FLUID_LENGTH);
            let wall = outer_radius_m - inner_radius_m;
            let remedy = "accepted: an outer radius above the inner one";
            if inner
                && outer
                && findings.require(wall > 0.0, &field("outer_radius_m"), "leaves no wall", remedy)
            {
                check_rows(findings, scene, &field("outer_radius_m"), wall);
            }
        }
    }
    check_speed(findings, scene, &format!("bodies.{index}.velocity_m_s"), body.velocity_m_s());
}

fn check_speed(findings: &mut Findings, scene: &SolidScene, field: &str, velocity: Option<&Axes>) {
    let speed = velocity.map_or(0.0, |velocity| velocity.values().iter().map(|v| v * v).sum::<f64>().sqrt());
    let most = LARGEST_SPEED * (scene.material.young_pa / scene.material.density_kg_m3).sqrt();
    let reason =
        format!("{} m/s, beyond half of sqrt(E/rho): an impact that no elastic body survives", number(speed));
    let remedy = format!("accepted: at most {} m/s", number(most));
    findings.require(speed <= most, field, &reason, remedy);
}

fn check_rows(findings: &mut Findings, scene: &SolidScene, field: &str, thickness_m: f64) {
    let rows = thickness_m / scene.spacing_m;
    let reason = format!("the body is {} spacings thick: spacing_m does not resolve it", number(rows));
    let least = number(LEAST_ROWS * scene.spacing_m);
    let remedy =
        format!("accepted: at least {least} m, or spacing_m at most {}", number(thickness_m / LEAST_ROWS));
    findings.require(rows >= LEAST_ROWS * (1.0 - 1e-9), field, &reason, remedy);
}

/// A body as if it were full, for what asks where it is.
fn filled(body: &Solid) -> Body {
    match body {
        Solid::Block { low_m, high_m, .. } => {
            Body::Block { low_m: low_m.clone(), high_m: high_m.clone(), velocity_m_s: None, spin_rad_s: 0.0 }
        }
        Solid::Ring { centre_m, outer_radius_m, .. } => {
            Body::Ball { centre_m: centre_m.clone(), radius_m: *outer_radius_m, velocity_m_s: None }
        }
    }
}

fn check_held(findings: &mut Findings, scene: &SolidScene) {
    for (index, hold) in scene.held.iter().enumerate() {
        let ends = hold.low_m.values().iter().zip(hold.high_m.values());
        let field = format!("held.{index}");
        let ordered = ends.into_iter().all(|(low, high)| low < high);
        let remedy = "accepted: high_m above low_m on every axis";
        if !findings.require(ordered, &format!("{field}.high_m"), "not above low_m", remedy) {
            continue;
        }
        check_speed(findings, scene, &format!("{field}.velocity_m_s"), hold.velocity_m_s.as_ref());
        let all = Body::Block {
            low_m: hold.low_m.clone(),
            high_m: hold.high_m.clone(),
            velocity_m_s: None,
            spin_rad_s: 0.0,
        };
        let holds = scene.bodies.iter().any(|body| overlap(&filled(body), &all, 0.0));
        findings.require(
            holds,
            &field,
            "meets no body, so that it holds nothing",
            "move it, or leave it out",
        );
    }
}

fn check_meeting(findings: &mut Findings, scene: &SolidScene) {
    for (index, body) in scene.bodies.iter().enumerate() {
        let slack_m = 1e-6 * scene.spacing_m;
        let hit =
            scene.bodies[..index].iter().position(|other| overlap(&filled(body), &filled(other), slack_m));
        let reason = format!(
            "overlaps with bodies.{}; what lies in the hole of a ring counts as well",
            hit.unwrap_or(0)
        );
        findings.require(hit.is_none(), &format!("bodies.{index}"), &reason, "move one of them");
    }
}

fn check_size(findings: &mut Findings, scene: &SolidScene) {
    let (spacing_m, dimension) = (scene.spacing_m, scene.dimension() as i32);
    let ball = |radius: f64| {
        let factor = if dimension == 2 { 1.0 } else { 4.0 / 3.0 };
        factor * std::f64::consts::PI * radius.powi(dimension)
    };
    let room = |body: &Solid| match body {
        Solid::Block { low_m, high_m, .. } => {
            low_m.values().iter().zip(high_m.values()).map(|(low, high)| high - low).product::<f64>()
        }
        Solid::Ring { inner_radius_m, outer_radius_m, .. } => ball(*outer_radius_m) - ball(*inner_radius_m),
    };
    let particles = scene.bodies.iter().map(room).sum::<f64>() / spacing_m.powi(dimension);
    let coarser = |factor: f64| number(spacing_m * factor.powf(1.0 / f64::from(dimension)));
    size::check_count(findings, "spacing_m", particles, &scene.budget, coarser, "smaller bodies");
}
