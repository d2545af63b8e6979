//! `welder check`: what a case is before it is run.

mod advice;
mod disk;
mod estimates;
mod fluid;
mod melt;
mod prove;
mod solid;

use crate::build::{LevelPlan, Workpiece};
use crate::case::scene::{FLOW_FIELDS, Scene};
use crate::case::{self, Case, Loaded};
use crate::cli::{CheckArguments, ExitStatus, refuse, say};
use crate::model::{Model, ModelError};
use crate::observe::Machine;
use crate::physics::Physics;
use crate::physics::heat::Heat;
use crate::physics::stress::Stress;
use crate::run::{Simulation, WeldRun, level_plan, numbers};
use sph_integrate::stages_for;

/// Memory that the program takes before the first particle \[bytes\].
const BYTES_WITHOUT_PARTICLES: f64 = 14e6;

/// Memory that a particle takes over a run \[bytes\]: peak_memory_bytes over particles of the aluminium spot at 25 um, and what
/// stress and flow add to it in their spots at 100 um and 50 um.
const BYTES_OF_HEAT: f64 = 1850.0;
const BYTES_OF_STRESS: f64 = 2000.0;
const BYTES_OF_FLOW: f64 = 14_000.0;

/// Directed pairs that one core visits in a second, a careful figure for a forecast.
const PAIRS_PER_SECOND: f64 = 5e8;

/// Directed pairs of stress that one core visits in a second, a careful figure for a forecast.
const STRESS_PAIRS_PER_SECOND: f64 = 1e8;

/// Steps by the error estimate for each step by the laser's rule, a figure for a forecast.
const STEPS_PER_RULE_STEP: f64 = 3.0;

/// A part is advised to change its size by this share at most.
const LARGEST_SIZE_CHANGE: f64 = 0.05;

/// Checks the case of `arguments` and tells what it will be.
pub fn command(arguments: &CheckArguments) -> ExitStatus {
    let case = match case::load_any(&arguments.case, &arguments.overrides) {
        Ok(case) => case,
        Err(error) => return refuse(&error),
    };
    let (name, told) = match &case {
        Loaded::Weld(case) => (&case.name, Model::from_case(case).and_then(|model| describe(case, &model))),
        Loaded::Fluid(case) => (&case.name, fluid::describe(case)),
        Loaded::Solid(case) => (&case.name, solid::describe(case)),
    };
    match told {
        Ok(lines) => {
            say(&format!("{name}: the case is well formed\n{}", lines.join("\n")));
            match (&case, arguments.prove) {
                (_, false) => ExitStatus::Done,
                (Loaded::Weld(case), true) => prove::prove(case, arguments.json.as_deref()),
                (_, true) => {
                    tracing::error!("--prove compares the physics of a weld; this case is none");
                    ExitStatus::WrongInput
                }
            }
        }
        Err(error) => {
            tracing::error!("the case cannot be built: {error}");
            ExitStatus::WrongInput
        }
    }
}

fn describe(case: &Case, model: &Model) -> Result<Vec<String>, ModelError> {
    let largest = case.scene.budget.max_particles;
    let plan = level_plan(model, 0.0)?;
    let particles = plan.count();
    let mut lines = vec![format!(
        "  particles      {particles} in {} levels, spacing {:.1} um to {:.1} um; {}",
        plan.levels(),
        1e6 * model.spacing(),
        1e6 * model.spacing() * f64::from(1u32 << (plan.levels() - 1)),
        memory(particles as f64, bytes_per_particle(&case.scene)),
    )];
    lines.extend(slab_advice(model, &plan));
    if particles > largest {
        lines.push(format!(
            "  budget         too many: budget.max_particles is {largest}; the run will be refused"
        ));
        return Ok(lines);
    }
    let workpiece = Workpiece::new(model, &plan);
    let heat = Heat::new(model, &workpiece)?;
    lines.push(pair_line(&heat));
    lines.push(step_lines(model, &heat));
    lines.extend(model.flow.as_ref().map(|flow| melt::forecast(model, flow)).transpose()?);
    lines.extend(stress_line(model, &workpiece)?);
    let at_start = WeldRun::at_start(Simulation::around(model.clone(), workpiece, heat)?);
    let mut output = case.scene.output();
    // Columns of the flow are zero but in the melt, and pack to next to nothing.
    output.fields.retain(|field| !FLOW_FIELDS.contains(&field.as_str()));
    lines.push(disk::line(&at_start, &output));
    lines.extend(power_lines(model));
    lines.extend(warnings(model));
    let named: Vec<String> =
        numbers(model).iter().map(|(name, value)| format!("{name} {value:.3}")).collect();
    lines.push(format!("  numbers        {}", named.join(", ")));
    lines.extend(advice::lines(case, model));
    Ok(lines)
}

/// Memory that a particle of a weld takes over a run \[bytes\].
pub(crate) fn bytes_per_particle(scene: &Scene) -> f64 {
    let stress = scene.stress().map_or(0.0, |_| BYTES_OF_STRESS);
    let flow = scene.flow().map_or(0.0, |_| BYTES_OF_FLOW);
    BYTES_OF_HEAT + stress + flow
}

/// The memory that a run takes, in words.
fn memory(particles: f64, bytes_per_particle: f64) -> String {
    format!("about {:.0} MB of memory", 1e-6 * (BYTES_WITHOUT_PARTICLES + particles * bytes_per_particle))
}

/// Sizes that coarse blocks do not divide keep slabs of fine particles on the far faces: says what near sizes would save.
fn slab_advice(model: &Model, plan: &LevelPlan<3>) -> Option<String> {
    let counts = model.counts();
    let rounded = |block: i64| counts.map(|count| ((count + block / 2) / block).max(1) * block);
    let near = |sizes: &[i64; 3]| {
        (0..3).all(|axis| {
            (sizes[axis] - counts[axis]).abs() as f64 <= LARGEST_SIZE_CHANGE * counts[axis] as f64
        })
    };
    let blocks = (1..plan.levels()).rev().map(|level| 1i64 << level);
    let (block, sizes) = blocks.map(|block| (block, rounded(block))).find(|(_, sizes)| near(sizes))?;
    let saved = LevelPlan::around(sizes, plan.finest_box()).count();
    if plan.count() < saved + saved / 4 {
        return None;
    }
    let sizes = sizes.map(|count| format!("{:.4e}", count as f64 * model.spacing())).join(", ");
    Some(format!(
        "  advice         a part of multiples of {block} spacings needs fewer particles: part.size_m: ({sizes}) takes {saved}"
    ))
}

/// What the set-up of the pairs found.
fn pair_line(heat: &Heat) -> String {
    let fit = heat.report.fit.map_or_else(String::new, |fit| {
        format!(
            ", fitted to {:.1e} in {} iterations, {:.1} % of weights negative",
            fit.residual,
            fit.iterations,
            100.0 * fit.negative_share
        )
    });
    let patterns = 100.0 * heat.pattern_share();
    format!(
        "  pairs          h/dx {:.2}{fit}; {patterns:.0} % of rows in patterns",
        heat.report.smoothing_ratio
    )
}

fn step_lines(model: &Model, heat: &Heat) -> String {
    let euler = heat.euler_step();
    let rule = heat.laser_step().unwrap_or(model.end / 50.0).min(model.end);
    let stages = stages_for(rule / STEPS_PER_RULE_STEP, euler) as f64;
    let steps = STEPS_PER_RULE_STEP * model.end / rule;
    let seconds = steps * stages * heat.pairs() as f64 / PAIRS_PER_SECOND;
    format!(
        "  steps          explicit Euler {euler:.2e} s ({}); laser rule {rule:.2e} s; {} directed pairs a sweep\n\
         \x20 forecast       about {steps:.0} super steps of {stages:.0} stages, {seconds:.2} s on one core of {}",
        heat.step_limit(0.0).name,
        heat.pairs(),
        Machine::here(),
    )
}

/// What stress adds to the particles and to the work.
fn stress_line(model: &Model, workpiece: &Workpiece) -> Result<Option<String>, ModelError> {
    let Some(settings) = &model.stress else { return Ok(None) };
    let stress = Stress::new(model, settings, workpiece)?;
    let seconds = 100.0 * (stress.steps() * stress.pairs()) as f64 / STRESS_PAIRS_PER_SECOND;
    Ok(Some(format!(
        "  stress         {} particles with copies beyond mirror planes and clamps; {} steps of settling in a step of heat, about {seconds:.0} s for 100 of them on one core",
        stress.particles(),
        stress.steps(),
    )))
}

/// Commanded, emitted, absorbed, reflected and missed energy of the whole beam.
fn power_lines(model: &Model) -> Option<String> {
    let laser = model.laser.as_ref()?;
    let (low, high) = model.bounds();
    let mirrored = model.mirrored();
    let grow = |axis: usize, side: usize| if mirrored[axis][side] { high[axis] - low[axis] } else { 0.0 };
    let face = laser_source::Rectangle {
        x_min_m: low[0] - grow(0, 0),
        x_max_m: high[0] + grow(0, 1),
        y_min_m: low[1] - grow(1, 0),
        y_max_m: high[1] + grow(1, 1),
    };
    let audit = laser.audit(0.0, model.end, &face);
    // Light that a thin part lets through has missed it.
    let held = laser.absorption().share_between(0.0, model.size[2]);
    Some(format!(
        "  laser          {:.4} J commanded, {:.4} J emitted: {:.4} J absorbed, {:.4} J reflected, {:.4} J missed",
        audit.commanded_j,
        audit.emitted_j,
        held * audit.absorbed_j,
        audit.reflected_j,
        audit.missed_j + (1.0 - held) * audit.absorbed_j
    ))
}

fn warnings(model: &Model) -> Vec<String> {
    let jump = |curve: &sph_thermal::phase::EnthalpyCurve| curve.temperature_jump();
    let tell = |jump: sph_thermal::phase::TemperatureJump| {
        format!(
            "  warning        the enthalpy curve of Hu and Eberhard (2015) jumps by {:.1} K at the solidus; \
             melting takes {:+.0} % more than the latent heat",
            jump.at_solidus_k,
            100.0 * jump.excess_latent_heat
        )
    };
    model.curves.iter().filter_map(jump).map(tell).collect()
}
