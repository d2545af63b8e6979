//! Scenes of pure fluid.

use super::super::axes::Axes;
use super::super::fluid::{Body, FluidScene, Side, Temperature};
use super::super::problem::Problem;
use super::super::source::Source;
use super::findings::Findings;
use super::lattice::is_whole;
use super::plausible::{
    ARTIFICIAL_VISCOSITY, DENSITY_DIFFUSION, DENSITY_PULL, DURATION, FLUID_LENGTH, FLUID_PLACE,
    FLUID_SMOOTHING, FLUID_SPACING, FLUID_TEMPERATURE, GRAVITY, LIQUID_DENSITY, LIQUID_EXPANSION,
    LIQUID_SOUND, LIQUID_TENSION, LIQUID_TENSION_SLOPE, LIQUID_VISCOSITY, Range, SHIFTING, SPIN,
    TEMPERATURE_SLOPE, VELOCITY, number,
};
use super::{run, size};
use crate::fluid::{expected, least_period, wall_rows};

/// Rows of particles that a layer needs at least.
const LEAST_ROWS: f64 = 4.0;

/// Sound must be this many times as fast as what it is measured against.
const LEAST_SOUND: f64 = 5.0;

/// Warmth may change densities by this share at most over a scene.
const LARGEST_EXPANSION: f64 = 0.5;

/// Most bodies: frames number them in bytes.
const MOST_BODIES: usize = 256;

/// All findings, in the order of the sections.
pub fn validate_fluid(source: &Source, scene: &FluidScene) -> Vec<Problem> {
    let mut findings = Findings::new(source, "");
    let shaped = check_tuples(&mut findings, scene.dimension(), "domain.size_m", tuples(scene));
    check_values(&mut findings, scene);
    check_run(&mut findings, scene);
    // What follows compares numbers that must be right by themselves.
    if shaped && findings.is_empty() {
        check_domain(&mut findings, scene);
        scene
            .bodies
            .iter()
            .enumerate()
            .for_each(|(index, body)| check_body(&mut findings, scene, index, body));
        check_temperature(&mut findings, scene);
    }
    if findings.is_empty() {
        check_overlap(&mut findings, scene);
        check_sound(&mut findings, scene);
        check_size(&mut findings, scene);
    }
    findings.into_problems()
}

/// Every tuple of the scene with its place and range.
fn tuples(scene: &FluidScene) -> Vec<(String, &Axes, Range)> {
    let mut all = vec![("domain.size_m".to_string(), &scene.domain.size_m, FLUID_LENGTH)];
    let optional = [
        ("domain.low_m", scene.domain.low_m.as_ref(), FLUID_PLACE),
        ("gravity_m_s2", scene.gravity_m_s2.as_ref(), GRAVITY),
    ];
    all.extend(
        optional.into_iter().filter_map(|(field, axes, range)| Some((field.to_string(), axes?, range))),
    );
    for (name, side) in scene.domain.sides.named().into_iter().flatten() {
        if let Side::Wall { velocity_m_s: Some(velocity) } = side {
            all.push((format!("domain.sides.{name}.velocity_m_s"), velocity, VELOCITY));
        }
    }
    for (index, body) in scene.bodies.iter().enumerate() {
        match body {
            Body::Block { low_m, high_m, .. } => {
                all.push((format!("bodies.{index}.low_m"), low_m, FLUID_PLACE));
                all.push((format!("bodies.{index}.high_m"), high_m, FLUID_PLACE));
            }
            Body::Ball { centre_m, .. } => {
                all.push((format!("bodies.{index}.centre_m"), centre_m, FLUID_PLACE))
            }
        }
        all.extend(
            body.velocity_m_s().map(|velocity| (format!("bodies.{index}.velocity_m_s"), velocity, VELOCITY)),
        );
    }
    if let Some(Temperature::Linear { slope_k_m, .. }) = &scene.temperature {
        all.push(("temperature.slope_k_m".to_string(), slope_k_m, TEMPERATURE_SLOPE));
    }
    all
}

/// Checks that tuples, given with place and range, have as many numbers as `named` has, and that these are plausible.
pub fn check_tuples(
    findings: &mut Findings,
    dimension: usize,
    named: &str,
    tuples: Vec<(String, &Axes, Range)>,
) -> bool {
    let mut fine = true;
    for (field, axes, range) in tuples {
        let count = axes.values().len();
        let reason = format!("has {count} numbers in a scene of {dimension} dimensions, as {named} has it");
        let remedy = format!("accepted: {dimension} numbers here, or as many in {named}");
        fine &= findings.require(count == dimension, &field, &reason, remedy);
        fine &= findings.all_within(&field, axes.values(), &range);
    }
    fine
}

fn check_values(findings: &mut Findings, scene: &FluidScene) {
    let (fluid, scheme) = (&scene.fluid, &scene.scheme);
    findings.within("spacing_m", scene.spacing_m, &FLUID_SPACING);
    findings.within("fluid.density_kg_m3", fluid.density_kg_m3, &LIQUID_DENSITY);
    findings.within("fluid.viscosity_pa_s", fluid.viscosity_pa_s, &LIQUID_VISCOSITY);
    findings.within("fluid.surface_tension_n_m", fluid.surface_tension_n_m, &LIQUID_TENSION);
    let slope = fluid.surface_tension_slope_n_m_k;
    findings.within("fluid.surface_tension_slope_n_m_k", slope, &LIQUID_TENSION_SLOPE);
    findings.within("fluid.volume_expansion_1_k", fluid.volume_expansion_1_k, &LIQUID_EXPANSION);
    findings.within("fluid.reference_k", fluid.reference_k, &FLUID_TEMPERATURE);
    if let Some(sound) = fluid.sound_speed_m_s {
        findings.within("fluid.sound_speed_m_s", sound, &LIQUID_SOUND);
    }
    findings.within("scheme.smoothing_ratio", scheme.smoothing_ratio, &FLUID_SMOOTHING);
    findings.within("scheme.artificial_viscosity", scheme.artificial_viscosity, &ARTIFICIAL_VISCOSITY);
    findings.within("scheme.density_diffusion", scheme.density_diffusion, &DENSITY_DIFFUSION);
    findings.within("scheme.shifting", scheme.shifting, &SHIFTING);
    if let Some(pull) = scheme.density_pull {
        findings.within("scheme.density_pull", pull, &DENSITY_PULL);
    }
    for (index, body) in scene.bodies.iter().enumerate() {
        let (field, spin) = (format!("bodies.{index}.spin_rad_s"), body.spin_rad_s());
        findings.within(&field, spin, &SPIN);
        let reason = format!("{spin} rad/s in a scene in space");
        findings.require(
            spin == 0.0 || scene.dimension() == 2,
            &field,
            &reason,
            "accepted: 0, or a scene in the plane",
        );
    }
    let count = scene.bodies.len();
    let reason = format!("{count} bodies");
    findings.require((1..=MOST_BODIES).contains(&count), "bodies", &reason, "accepted: 1 to 256 bodies");
}

fn check_run(findings: &mut Findings, scene: &FluidScene) {
    let end_is_fine = findings.within("time.end_s", scene.time.end_s, &DURATION);
    run::check_intervals(findings, &scene.output, scene.time.end_s, end_is_fine);
    run::check_listed(findings, &scene.output, &scene.fields(), |name| match name {
        "temperature_k" => "the scene has no temperature",
        _ => "a scene of fluid has no such field",
    });
    run::check_budget(findings, &scene.budget);
}

fn check_domain(findings: &mut Findings, scene: &FluidScene) {
    let (sides, spacing_m) = (scene.domain.sides.named(), scene.spacing_m);
    for (axis, [(low_name, low), (high_name, high)]) in sides.into_iter().enumerate() {
        let place = |name: &str| format!("domain.sides.{name}");
        let pair = (*low == Side::Periodic) == (*high == Side::Periodic);
        let reason = format!("a scene that repeats does so at both of {low_name} and {high_name}");
        findings.require(pair, &place(low_name), &reason, "accepted: Periodic at both, or at neither");
        for (name, side) in [(low_name, low), (high_name, high)] {
            let plane = axis >= scene.dimension();
            let reason = "a scene in the plane has no side along z";
            findings.require(!plane || *side == Side::Open, &place(name), reason, "leave it out");
            let across = match side {
                Side::Wall { velocity_m_s: Some(velocity) } if !plane => velocity.values()[axis],
                _ => 0.0,
            };
            let field = format!("domain.sides.{name}.velocity_m_s.{axis}");
            let reason = "a wall moves along itself only";
            findings.require(across == 0.0, &field, reason, "accepted: 0 across the wall");
        }
        if axis < scene.dimension() {
            let (field, size_m) = (format!("domain.size_m.{axis}"), scene.domain.size_m.values()[axis]);
            check_whole(findings, &field, size_m, 0.0, spacing_m);
            let least_m = least_period(scene.scheme.smoothing_ratio) * spacing_m;
            let reason =
                format!("a scene that repeats after {} spacings meets itself", number(size_m / spacing_m));
            let remedy = format!("accepted: at least {} m, or a finer spacing_m", number(least_m));
            let repeats = *low == Side::Periodic;
            findings.require(!repeats || size_m >= least_m, &field, &reason, remedy);
        }
    }
}

/// Checks that a place lies a whole number of spacings from the origin of the lattice.
pub fn check_whole(
    findings: &mut Findings,
    field: &str,
    value_m: f64,
    origin_m: f64,
    spacing_m: f64,
) -> bool {
    let count = (value_m - origin_m) / spacing_m;
    let near = |count: f64| number(origin_m + count * spacing_m);
    let reason = format!("{} spacings of {} m, not a whole number", number(count), number(spacing_m));
    let remedy = format!("nearest accepted: {} or {} m", near(count.floor()), near(count.ceil()));
    findings.require(is_whole(count), field, &reason, remedy)
}

/// Low and high corner of the domain, filled up with zeros.
fn domain(scene: &FluidScene) -> [Vec<f64>; 2] {
    let low = scene.domain.low_m.clone().unwrap_or(Axes::repeat(0.0, scene.dimension()));
    let high = low.values().iter().zip(scene.domain.size_m.values()).map(|(low, size)| low + size).collect();
    [low.values().to_vec(), high]
}

fn check_body(findings: &mut Findings, scene: &FluidScene, index: usize, body: &Body) {
    let ([low, high], spacing_m) = (domain(scene), scene.spacing_m);
    // Corners are sums of given numbers; a billionth of the domain is round-off.
    let slack = |axis: usize| 1e-9 * scene.domain.size_m.values()[axis];
    for axis in 0..scene.dimension() {
        let accepted = format!("accepted: {} to {} m on this axis", number(low[axis]), number(high[axis]));
        let inside = |value: f64| value >= low[axis] - slack(axis) && value <= high[axis] + slack(axis);
        match body {
            Body::Block { low_m, high_m, .. } => {
                let ends = [("low_m", low_m.values()[axis]), ("high_m", high_m.values()[axis])];
                for (name, value) in ends {
                    let field = format!("bodies.{index}.{name}.{axis}");
                    findings.require(inside(value), &field, "outside the domain", accepted.as_str());
                    check_whole(findings, &field, value, low[axis], spacing_m);
                }
                check_rows(findings, scene, index, axis, ends[1].1 - ends[0].1);
            }
            Body::Ball { centre_m, radius_m, .. } => {
                let centre = centre_m.values()[axis];
                let field = format!("bodies.{index}.centre_m.{axis}");
                let reason = "the ball reaches outside the domain";
                findings.require(
                    inside(centre - radius_m) && inside(centre + radius_m),
                    &field,
                    reason,
                    accepted,
                );
            }
        }
    }
    if let Body::Ball { radius_m, .. } = body {
        let field = format!("bodies.{index}.radius_m");
        let reason = format!("{} spacings: too coarse for a round surface", number(radius_m / spacing_m));
        let least = number(LEAST_ROWS * spacing_m);
        let remedy =
            format!("accepted: at least {least} m, or spacing_m at most {}", number(radius_m / LEAST_ROWS));
        findings.require(*radius_m >= LEAST_ROWS * spacing_m * (1.0 - 1e-9), &field, &reason, remedy);
    }
}

/// Layers need rows: a spacing near the depth of a film, or above it, resolves nothing.
fn check_rows(findings: &mut Findings, scene: &FluidScene, index: usize, axis: usize, depth_m: f64) {
    let field = format!("bodies.{index}.high_m.{axis}");
    let remedy = "accepted: high_m above low_m on every axis";
    if !findings.require(depth_m > 0.0, &field, "not above low_m", remedy) {
        return;
    }
    let rows = depth_m / scene.spacing_m;
    let reason = format!("the layer is {} spacings deep: spacing_m does not resolve it", number(rows));
    let remedy = format!(
        "accepted: at least {} m, or spacing_m at most {}",
        number(LEAST_ROWS * scene.spacing_m),
        number(depth_m / LEAST_ROWS)
    );
    findings.require(rows >= LEAST_ROWS * (1.0 - 1e-9), &field, &reason, remedy);
}

fn check_temperature(findings: &mut Findings, scene: &FluidScene) {
    let fluid = &scene.fluid;
    let needs = [
        ("surface_tension_slope_n_m_k", fluid.surface_tension_slope_n_m_k != 0.0, "tension changes"),
        ("volume_expansion_1_k", fluid.volume_expansion_1_k != 0.0, "density changes"),
    ];
    for (name, needed, what) in needs {
        let reason = format!("{what} with temperature, and the scene has none");
        let remedy = "add temperature: Uniform(...) or Linear(...), or leave this field out";
        let given = scene.temperature.is_some();
        findings.require(given || !needed, &format!("fluid.{name}"), &reason, remedy);
    }
    match &scene.temperature {
        None => {}
        Some(Temperature::Uniform { temperature_k }) => {
            findings.within("temperature.temperature_k", *temperature_k, &FLUID_TEMPERATURE);
            check_expansion(findings, scene, *temperature_k, *temperature_k);
        }
        Some(Temperature::Linear { origin_k, slope_k_m }) => {
            let [low, high] = domain(scene);
            let ends = |axis: usize| [low[axis], high[axis]].map(|x| slope_k_m.values()[axis] * x);
            let corner = |of: fn(f64, f64) -> f64| {
                origin_k + (0..low.len()).map(|axis| of(ends(axis)[0], ends(axis)[1])).sum::<f64>()
            };
            let coldest = corner(f64::min);
            let reason = format!("the coldest corner of the domain is at {} K", number(coldest));
            let remedy = "accepted: above 0 K everywhere";
            findings.require(coldest > 0.0, "temperature.origin_k", &reason, remedy);
            check_expansion(findings, scene, coldest, corner(f64::max));
            let periodic = |axis: &usize| *scene.domain.sides.named()[*axis][0].1 == Side::Periodic;
            let sloped = |axis: &usize| slope_k_m.values()[*axis] != 0.0;
            let jumps = fluid.volume_expansion_1_k != 0.0;
            for axis in (0..low.len()).filter(periodic).filter(sloped) {
                let reason =
                    "fluid that expands would jump from one density to another where the scene repeats";
                let remedy = "accepted: 0 along an axis that is Periodic, or walls at its ends, or no volume_expansion_1_k";
                findings.require(!jumps, &format!("temperature.slope_k_m.{axis}"), reason, remedy);
            }
        }
    }
}

/// A reference far from the temperatures of the scene is a slip, or asks for more than a liquid expands.
fn check_expansion(findings: &mut Findings, scene: &FluidScene, coldest_k: f64, hottest_k: f64) {
    let fluid = &scene.fluid;
    let strain = |k: f64| fluid.volume_expansion_1_k * (k - fluid.reference_k);
    for temperature_k in [coldest_k, hottest_k] {
        let reason = format!(
            "at {} K in the domain it makes the density {} times that at reference_k, {} K",
            number(temperature_k),
            number((-strain(temperature_k)).exp()),
            number(fluid.reference_k)
        );
        let remedy = format!(
            "accepted: expansion times the distance from reference_k at most {LARGEST_EXPANSION}; is reference_k that of the scene?"
        );
        let fine = strain(temperature_k).abs() <= LARGEST_EXPANSION;
        if !findings.require(fine, "fluid.volume_expansion_1_k", &reason, remedy) {
            return;
        }
    }
}

fn check_overlap(findings: &mut Findings, scene: &FluidScene) {
    for (index, body) in scene.bodies.iter().enumerate() {
        let hit = scene.bodies[..index].iter().position(|other| overlap(body, other, 1e-6 * scene.spacing_m));
        let reason = format!("overlaps with bodies.{}", hit.unwrap_or(0));
        let remedy = "move one of them, or make one of both";
        findings.require(hit.is_none(), &format!("bodies.{index}"), &reason, remedy);
    }
}

/// Whether two bodies share more than `slack_m` of room.
pub fn overlap(one: &Body, other: &Body, slack_m: f64) -> bool {
    match (one, other) {
        (Body::Block { low_m: a, high_m: b, .. }, Body::Block { low_m: c, high_m: d, .. }) => {
            let ends = a.values().iter().zip(b.values()).zip(c.values().iter().zip(d.values()));
            ends.into_iter().all(|((a, b), (c, d))| a.max(*c) + slack_m < b.min(*d))
        }
        (Body::Ball { centre_m: a, radius_m: r, .. }, Body::Ball { centre_m: b, radius_m: s, .. }) => {
            distance(a.values().iter().zip(b.values()).map(|(a, b)| a - b)) + slack_m < r + s
        }
        (Body::Ball { centre_m, radius_m, .. }, Body::Block { low_m, high_m, .. })
        | (Body::Block { low_m, high_m, .. }, Body::Ball { centre_m, radius_m, .. }) => {
            let ends = centre_m.values().iter().zip(low_m.values()).zip(high_m.values());
            distance(ends.map(|((x, low), high)| x - x.clamp(*low, *high))) + slack_m < *radius_m
        }
    }
}

fn distance(differences: impl Iterator<Item = f64>) -> f64 {
    differences.map(|difference| difference * difference).sum::<f64>().sqrt()
}

fn check_sound(findings: &mut Findings, scene: &FluidScene) {
    let (field, expected) = ("fluid.sound_speed_m_s", expected(scene));
    let least = LEAST_SOUND * expected.sound_needs;
    match scene.fluid.sound_speed_m_s {
        None => {
            let reason = "nothing in the scene says how fast the fluid will be";
            let remedy = "give the artificial speed of sound, ten times the largest speed";
            findings.require(least > 0.0 && least.is_finite(), field, reason, remedy);
        }
        Some(sound) => {
            let reason = format!(
                "{:.1} times the {} m/s that the scene lets expect: density would change by {:.0} %",
                sound / expected.sound_needs,
                number(expected.sound_needs),
                100.0 * (expected.sound_needs / sound).powi(2)
            );
            let remedy = format!("accepted: at least {} m/s; ten times the speed is right", number(least));
            findings.require(sound >= least, field, &reason, remedy);
        }
    }
}

fn check_size(findings: &mut Findings, scene: &FluidScene) {
    let (spacing_m, dimension) = (scene.spacing_m, scene.dimension() as i32);
    let fluid: f64 =
        scene.bodies.iter().map(|body| body_room(body, dimension)).sum::<f64>() / spacing_m.powi(dimension);
    let rows = wall_rows(scene.scheme.smoothing_ratio) as f64;
    let sides = scene.domain.sides.named();
    let cells = |axis: usize| scene.domain.size_m.values()[axis] / spacing_m;
    let face =
        |axis: usize| (0..scene.dimension()).filter(|&other| other != axis).map(cells).product::<f64>();
    let walls = |axis: usize| {
        let count = sides[axis].iter().filter(|(_, side)| matches!(side, Side::Wall { .. })).count();
        count as f64 * rows * face(axis)
    };
    let particles = fluid + (0..scene.dimension()).map(walls).sum::<f64>();
    let coarser = |factor: f64| number(spacing_m * factor.powf(1.0 / f64::from(dimension)));
    size::check_count(
        findings,
        "spacing_m",
        particles,
        &scene.budget,
        coarser,
        "smaller bodies, a smaller domain",
    );
}

fn body_room(body: &Body, dimension: i32) -> f64 {
    match body {
        Body::Block { low_m, high_m, .. } => {
            low_m.values().iter().zip(high_m.values()).map(|(low, high)| high - low).product()
        }
        Body::Ball { radius_m, .. } if dimension == 2 => std::f64::consts::PI * radius_m.powi(2),
        Body::Ball { radius_m, .. } => 4.0 / 3.0 * std::f64::consts::PI * radius_m.powi(3),
    }
}
