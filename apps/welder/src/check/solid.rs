//! `welder check` of a scene of elastic bodies.

use crate::case::SolidCase;
use crate::model::ModelError;
use crate::observe::Machine;
use crate::run::solid_numbers;
use crate::solid::{SolidBody, SolidModel};

/// Particle-steps of the updated-Lagrangian form that one core makes in a second, a careful figure for a forecast.
const PARTICLE_STEPS_PER_SECOND: f64 = 3e5;

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
    let (step, controls) = (body.longest_step(), &model.controls);
    let steps = case.scene.time.end_s / step;
    let held = model.held.iter().filter(|held| **held).count();
    let numbers: Vec<String> =
        solid_numbers(&body).iter().map(|(name, value)| format!("{name} {value:.3}")).collect();
    Ok(vec![
        format!(
            "  particles      {particles} ({:.4e} {unit}), {held} of them held, in {} pieces, in {D} dimensions",
            body.mass(),
            body.pieces()
        ),
        format!(
            "  scheme         {:?}, artificial stress {}, viscosity on zero-energy modes {}",
            controls.form, controls.artificial_stress, controls.hourglass_viscosity
        ),
        format!(
            "  steps          sound rules: {step:.2e} s at {:.1} m/s of waves of pressure",
            model.wave_speed
        ),
        format!(
            "  forecast       about {steps:.0} steps, {:.1} s on one core of {}",
            steps * particles as f64 / PARTICLE_STEPS_PER_SECOND,
            Machine::here()
        ),
        format!("  numbers        {}", numbers.join(", ")),
    ])
}
