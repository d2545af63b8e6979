//! Scenes of benchmarks, built without a case file.

use super::BenchmarkError;
use crate::case::scene::{Faces, Flow, Heat, Levels, Resolution, Stepping};
use crate::model::{FlowModel, Model, ModelError, Start, TensionLaw};
use crate::run::Simulation;
use laser_source::{Absorption, Beam, LaserSource, Path, Pulse};
use sph_fluid::SurfaceTension;
use sph_thermal::phase::{EnthalpyCurve, Table, ThermalMaterial};
use std::sync::Arc;

/// Temperature at which materials of benchmarks without melting start \[K\]: any will do, rises are compared.
pub(super) const START: f64 = 300.0;

/// A material of constant properties that stays solid below 1e6 K.
///
/// # Panics
/// Unless all numbers are positive.
pub fn never_melting(density: f64, heat_capacity: f64, conductivity: f64) -> ThermalMaterial {
    ThermalMaterial {
        density,
        solidus: 1e6,
        liquidus: 2e6,
        latent_heat: 0.0,
        heat_capacity_solid: constant(heat_capacity),
        heat_capacity_liquid: constant(heat_capacity),
        conductivity_solid: constant(conductivity),
        conductivity_liquid: constant(conductivity),
    }
}

/// The aluminium of the reference solutions for spots: constant properties on either side of 847 to 905 K.
pub fn reference_aluminium() -> ThermalMaterial {
    ThermalMaterial {
        density: 2500.0,
        solidus: 847.0,
        liquidus: 905.0,
        latent_heat: 3.97e5,
        heat_capacity_solid: constant(1050.0),
        heat_capacity_liquid: constant(1180.0),
        conductivity_solid: constant(200.0),
        conductivity_liquid: constant(95.0),
    }
}

/// The flow of that aluminium: twenty times its viscosity, and the change of its tension with temperature times `slope`.
///
/// # Errors
/// [`ModelError`] when the tension is refused.
pub(super) fn reference_flow(slope: f64) -> Result<FlowModel, ModelError> {
    let liquidus = reference_aluminium().liquidus;
    let tension = TensionLaw::Linear(SurfaceTension::new(0.9, -3.5e-4 * slope, liquidus)?);
    Ok(FlowModel {
        settings: Flow::default(),
        viscosity: constant(2.6e-2),
        tension,
        expansion: None,
        liquidus,
    })
}

pub(super) fn constant(value: f64) -> Table {
    Table::constant(value).expect("benchmarks have positive properties")
}

/// A block of `counts` particles that starts at 300 K, with adiabatic faces, no laser and the program's defaults.
///
/// # Errors
/// [`ModelError`] when a material has no enthalpy curve.
pub fn block(counts: [usize; 3], spacing: f64, materials: Vec<ThermalMaterial>) -> Result<Model, ModelError> {
    let curves = materials.iter().map(EnthalpyCurve::continuous).collect::<Result<_, _>>()?;
    Ok(Model {
        name: "benchmark".into(),
        low_corner: [0.0; 2],
        size: counts.map(|count| count as f64 * spacing),
        faces: Faces::default(),
        resolution: Resolution { spacing_m: spacing, levels: Levels::Uniform, disorder: 0.0, seed: 1 },
        evaporation: vec![None; materials.len()],
        tension: None,
        materials,
        curves,
        start: uniform_start(START),
        laser: None,
        heat: Heat::default(),
        flow: None,
        stress: None,
        end: 0.0,
        stop_when_solid: false,
    })
}

/// Error of a step where benchmarks look at the error of space alone.
const FINE_TOLERANCE: f64 = 1e-5;

/// Steps so short that the error of time lies below that of space.
///
/// The program's default is made for welds, whose steps the laser limits; where there is no laser, it leaves 0.5 to 2 %.
pub(super) fn fine_steps() -> Stepping {
    Stepping::SuperSteps { tolerance: Some(FINE_TOLERANCE), max_stages: 60 }
}

/// The first material at one temperature \[K\] everywhere.
pub(super) fn uniform_start(temperature: f64) -> Start {
    Arc::new(move |_| (0, temperature))
}

/// Light of constant power \[W\], all absorbed at the top face at the origin, from time zero for `duration` \[s\].
///
/// # Errors
/// [`ModelError`] when a number is refused.
pub fn spot(beam: Beam, power: f64, duration: f64) -> Result<LaserSource, ModelError> {
    let pulse = Pulse::Constant { start_s: 0.0, duration_s: duration, power_w: power };
    let path = Path::Spot { position_m: [0.0; 2], pulse };
    Ok(LaserSource::new(beam, path, Absorption::Surface { absorptivity: 1.0 })?)
}

/// Builds a model and runs it to its end.
pub(super) fn run(model: Model) -> Result<Simulation, BenchmarkError> {
    let mut simulation = Simulation::new(model)?;
    simulation.run_quietly()?;
    Ok(simulation)
}

/// Steps a simulation until `time` \[s\].
pub(super) fn run_until(simulation: &mut Simulation, time: f64) -> Result<(), BenchmarkError> {
    while simulation.time() < time {
        simulation.step(time)?;
    }
    Ok(())
}

/// (x \[m\], temperature \[K\]) of a row of particles along x.
pub(super) fn profile(simulation: &Simulation) -> Vec<(f64, f64)> {
    let (particles, curves) = (simulation.particles(), &simulation.model().curves);
    let node = |i: usize| {
        let curve = &curves[particles.material[i] as usize];
        (particles.position[i].x, curve.temperature(particles.enthalpy[i]))
    };
    let mut nodes: Vec<_> = (0..particles.len()).map(node).collect();
    nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_at_rest_stays_as_it_is() {
        let mut model = block([4, 1, 1], 0.25, vec![never_melting(1.0, 1.0, 1.0)]).unwrap();
        model.end = 0.1;
        let simulation = run(model).unwrap();
        assert_eq!(simulation.time(), 0.1);
        let profile = profile(&simulation);
        assert_eq!(profile.iter().map(|node| node.0).collect::<Vec<_>>(), [0.125, 0.375, 0.625, 0.875]);
        assert!(profile.iter().all(|node| (node.1 - START).abs() < 1e-12 * START));
    }
}
