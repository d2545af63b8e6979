//! `welder check` of a scene of elastic bodies.

use super::{disk, memory};
use crate::case::SolidCase;
use crate::model::ModelError;
use crate::observe::Machine;
use crate::run::solid_numbers;
use crate::solid::{Numerics, SolidBody, SolidModel};

/// Particle-steps of the total- and of the updated-Lagrangian form that one core makes in a second, careful figures for a forecast.
const PARTICLE_STEPS_PER_SECOND: [f64; 2] = [1e6, 3e5];

/// Memory that a particle takes over a run in the plane and in space \[bytes\]: peak_memory_bytes over particles of rings and of a
/// ball, large ones.
const BYTES_PER_PARTICLE: [f64; 2] = [1300.0, 2900.0];

/// What the scene will be.
pub(super) fn describe(case: &SolidCase) -> Result<Vec<String>, ModelError> {
    match case.scene.dimension() {
        2 => describe_in::<2>(case),
        _ => describe_in::<3>(case),
    }
}

fn describe_in<const D: usize>(case: &SolidCase) -> Result<Vec<String>, ModelError> {
    let body = SolidBody::<D>::new(SolidModel::from_case(case)?)?;
    let (model, particles) = (body.model(), body.positions().len());
    let unit = if D == 2 { "kg/m" } else { "kg" };
    let step = body.longest_step();
    let [total, updated] = PARTICLE_STEPS_PER_SECOND;
    let (scheme, rate) = match &model.numerics {
        Numerics::Total => ("Total, contact where bodies meet".to_string(), total),
        Numerics::Updated(controls) => {
            let (stress, viscosity) = (controls.artificial_stress, controls.hourglass_viscosity);
            let form = controls.form;
            (
                format!("{form:?}, artificial stress {stress}, viscosity on zero-energy modes {viscosity}"),
                updated,
            )
        }
    };
    let steps = case.scene.time.end_s / step;
    let held = model.held.iter().filter(|held| **held).count();
    let numbers: Vec<String> =
        solid_numbers(&body).iter().map(|(name, value)| format!("{name} {value:.3}")).collect();
    Ok(vec![
        format!(
            "  particles      {particles} ({:.4e} {unit}), {held} of them held, in {} pieces, in {D} dimensions; {}",
            body.mass(),
            body.pieces(),
            memory(particles as f64, BYTES_PER_PARTICLE[D - 2])
        ),
        format!("  scheme         {scheme}"),
        format!(
            "  steps          sound rules: {step:.2e} s at {:.1} m/s of waves of pressure",
            model.wave_speed
        ),
        format!(
            "  forecast       about {steps:.0} steps, {:.1} s on one core of {}",
            steps * particles as f64 / rate,
            Machine::here()
        ),
        disk::line(&body, &case.scene.output()),
        format!("  numbers        {}", numbers.join(", ")),
    ])
}
