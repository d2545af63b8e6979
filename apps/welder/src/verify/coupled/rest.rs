//! A pool at rest in its own solid: gravity and surface tension on, nothing else.
//!
//! The metal conducts next to nothing, so that the pool keeps its size. It starts at the density of no pressure, sinks into
//! its weight, and swings; ten periods later it must be at rest, and stay so for twenty.

use super::super::benchmark::larger;
use super::super::scene::{block, constant, reference_aluminium, run_until};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Flow, Weights};
use crate::model::{FlowModel, Model, ModelError, TensionLaw};
use crate::run::Simulation;
use nalgebra::Vector3;
use sph_fluid::SurfaceTension;
use sph_thermal::phase::ThermalMaterial;
use std::sync::Arc;

/// Depth of the pool \[m\]; it is twice as long and wide.
const DEPTH: f64 = 4e-3;

/// Layers of solid around it, more than the melt's kernel reaches.
const LAYERS: usize = 4;

/// Temperatures of the solid and of the pool \[K\].
const COLD: f64 = 800.0;
const HOT: f64 = 950.0;

/// Conductivity \[W/(m K)\]: in the run, heat goes less than a thousandth of a spacing.
const INSULATING: f64 = 1e-6;

/// Surface tension \[N/m\], the same at all temperatures; gravity \[m/s²\].
const TENSION: f64 = 0.9;
const GRAVITY: f64 = 9.81;

/// Kinematic viscosity over DEPTH sqrt(g DEPTH), as in `melt/tank`.
const DAMPING: f64 = 0.02;

/// Periods of damping and of rest, and looks in each.
const DAMPED: usize = 10;
const HELD: usize = 20;
const LOOKS: usize = 4;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "coupled/melt-at-rest",
    tested_crate: "welder",
    reference: "melt at rest: 20 periods of the lowest wave of the pool (gravity and tension) after 10 of damping",
    quantities: &[
        Quantity {
            suffix: "speed",
            text: "largest speed of any particle, over sqrt(g H), H = 4 mm; nu = 0.02 H sqrt(g H); resolution: rows of the pool",
            marks: &[Mark { resolution: 4.0, error: 1e-3 }, Mark { resolution: 8.0, error: 1e-3 }],
        },
        Quantity {
            suffix: "leak",
            text: "share of the melt that is ever outside the pool's walls, or a spacing above its face",
            marks: &[Mark { resolution: 4.0, error: 0.0 }, Mark { resolution: 8.0, error: 0.0 }],
        },
        Quantity {
            suffix: "gap",
            text: "largest distance from a particle of the pool's walls to the nearest melt, in spacings, less one",
            marks: &[Mark { resolution: 4.0, error: 0.25 }, Mark { resolution: 8.0, error: 0.25 }],
        },
    ],
    resolutions: [4.0, 6.0, 8.0],
    quick: 1,
    run: |resolution| {
        let mut simulation = Simulation::new(model(resolution as usize)?)?;
        let errors = held(&mut simulation)?;
        Ok(Outcome::of(&simulation, errors))
    },
};

/// Period of the lowest wave of the pool \[s\]: omega^2 = (g k + tau k^3/rho) tanh(k H), k = pi over its length.
fn period() -> f64 {
    let wave_number = std::f64::consts::PI / (2.0 * DEPTH);
    let pulled = TENSION * wave_number.powi(3) / reference_aluminium().density;
    let square = (GRAVITY * wave_number + pulled) * (wave_number * DEPTH).tanh();
    std::f64::consts::TAU / square.sqrt()
}

/// Largest speed, leak and gap while the pool must be at rest.
fn held(simulation: &mut Simulation) -> Result<Vec<f64>, BenchmarkError> {
    run_until(simulation, DAMPED as f64 * period())?;
    let mut worst = [0.0f64; 3];
    for look in 1..=HELD * LOOKS {
        run_until(simulation, (DAMPED as f64 + look as f64 / LOOKS as f64) * period())?;
        let speed = simulation.mechanics().map_or(f64::NAN, |now| now.largest_speed);
        let found = [speed / (GRAVITY * DEPTH).sqrt(), leak(simulation), gap(simulation)];
        worst = std::array::from_fn(|k| larger(found[k], worst[k]));
    }
    Ok(worst.to_vec())
}

/// Whether a place is inside the pool's walls and not far above its face.
fn in_pool(place: &Vector3<f64>, above: f64) -> bool {
    place.x.abs() < DEPTH && place.y.abs() < DEPTH && place.z > -DEPTH && place.z < above
}

/// The particles that are melt: all that started in the pool, for nothing melts or freezes.
fn melt(simulation: &Simulation) -> (Vec<Vector3<f64>>, Vec<Vector3<f64>>) {
    let particles = simulation.particles();
    let liquidus = simulation.model().curves[0].enthalpy_liquidus();
    let (melt, solid): (Vec<usize>, Vec<usize>) =
        (0..particles.len()).partition(|&i| particles.enthalpy[i] >= liquidus);
    let places = |chosen: Vec<usize>| chosen.into_iter().map(|i| particles.position[i]).collect();
    (places(melt), places(solid))
}

fn leak(simulation: &Simulation) -> f64 {
    let (melt, _) = melt(simulation);
    let spacing = simulation.model().spacing();
    let lost = melt.iter().filter(|place| !in_pool(place, spacing)).count();
    lost as f64 / melt.len() as f64
}

fn gap(simulation: &Simulation) -> f64 {
    let (melt, solid) = melt(simulation);
    let spacing = simulation.model().spacing();
    let faces: [Vector3<f64>; 6] = std::array::from_fn(|k| {
        let side = if k % 2 == 0 { spacing } else { -spacing };
        Vector3::from_fn(|axis, _| if axis == k / 2 { side } else { 0.0 })
    });
    let beside = |place: &&Vector3<f64>| faces.iter().any(|step| in_pool(&(*place + step), 0.0));
    let nearest = |place: &Vector3<f64>| {
        melt.iter().map(|other| (place - other).norm_squared()).fold(f64::INFINITY, f64::min).sqrt()
    };
    solid.iter().filter(beside).map(nearest).fold(0.0, f64::max) / spacing - 1.0
}

/// A block with the pool in the middle of its top face.
fn model(rows: usize) -> Result<Model, ModelError> {
    let spacing = DEPTH / rows as f64;
    let metal = ThermalMaterial {
        conductivity_solid: constant(INSULATING),
        conductivity_liquid: constant(INSULATING),
        ..reference_aluminium()
    };
    let across = 2 * (rows + LAYERS);
    let mut model = block([across, across, rows + LAYERS], spacing, vec![metal])?;
    model.low_corner = [-0.5 * across as f64 * spacing; 2];
    model.start = Arc::new(|place| (0, if in_pool(&place.into(), 0.0) { HOT } else { COLD }));
    let density = model.materials[0].density;
    model.flow = Some(FlowModel {
        settings: Flow { sound_speed_m_s: Some(sound_speed()), ..Flow::default() },
        viscosity: constant(DAMPING * density * DEPTH * (GRAVITY * DEPTH).sqrt()),
        tension: TensionLaw::Linear(SurfaceTension::new(TENSION, 0.0, HOT)?),
        expansion: None,
        liquidus: model.materials[0].liquidus,
    });
    model.heat.weights = Weights::Normalized;
    model.end = (DAMPED + HELD) as f64 * period();
    Ok(model)
}

/// Ten times the larger of sqrt(2 g H) and the capillary speed sqrt(tau/(rho H)) \[m/s\].
fn sound_speed() -> f64 {
    10.0 * (2.0 * GRAVITY * DEPTH).max(TENSION / (reference_aluminium().density * DEPTH)).sqrt()
}
