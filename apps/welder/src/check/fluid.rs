//! `welder check` of a scene of fluid.

use super::{disk, memory};
use crate::case::FluidCase;
use crate::fluid::{FluidFlow, FluidModel};
use crate::model::ModelError;
use crate::observe::Machine;
use crate::run::fluid_numbers;
use sph_integrate::smallest;

/// Memory that a particle of fluid or wall takes over a run in the plane and in space \[bytes\]: peak_memory_bytes over particles of
/// the dam break and of a ball with surface tension, large ones.
const BYTES_PER_PARTICLE: [f64; 2] = [2300.0, 3400.0];

/// Directed pairs of the plain sweep that one core visits in a second, a careful figure for a forecast.
const PAIRS_PER_SECOND: f64 = 2e7;

/// What the first evaluation after each list adds to the work.
const SHARE_OF_LISTS: f64 = 0.2;

/// What the scene will be.
pub(super) fn describe(case: &FluidCase) -> Result<Vec<String>, ModelError> {
    match case.scene.dimension() {
        2 => describe_in::<2>(case),
        _ => describe_in::<3>(case),
    }
}

fn describe_in<const D: usize>(case: &FluidCase) -> Result<Vec<String>, ModelError> {
    let flow = FluidFlow::<D>::new(FluidModel::from_case(case)?)?;
    let (model, expected) = (flow.model(), flow.model().expected);
    let (fluid, walls) = (flow.positions().len(), flow.wall_particles());
    let unit = if D == 2 { "kg/m" } else { "kg" };
    let speed = expected.speed.max(flow.largest_speed());
    let (limits, end) = (flow.step_limits(speed), case.scene.time.end_s);
    let steps = end / smallest(limits).dt_s;
    let named: Vec<String> =
        limits.iter().map(|limit| format!("{} {:.2e} s", limit.name, limit.dt_s)).collect();
    let numbers: Vec<String> =
        fluid_numbers(model, speed).iter().map(|(name, value)| format!("{name} {value:.3}")).collect();
    let passes = 2.0 * (1.0 + SHARE_OF_LISTS) * steps * flow.pairs() as f64;
    let ratio = model.sound_speed() / expected.sound_needs;
    Ok(vec![
        format!(
            "  particles      {fluid} of fluid ({:.4e} {unit}), {walls} of walls, in {D} dimensions; {}",
            flow.mass(),
            memory((fluid + walls) as f64, BYTES_PER_PARTICLE[D - 2])
        ),
        format!(
            "  speed          {:.3e} m/s expected; sound {:.3e} m/s, {ratio:.1} times what it must be fast against",
            expected.speed,
            model.sound_speed()
        ),
        format!("  scheme         {}", scheme(model)),
        format!("  steps          {} rules; {}", smallest(limits).name, named.join(", ")),
        format!(
            "  forecast       about {steps:.0} steps, {} directed pairs a pass, {:.1} s on one core of {}",
            flow.pairs(),
            passes / PAIRS_PER_SECOND,
            Machine::here()
        ),
        disk::line(&flow, &case.scene.output()),
        format!("  numbers        {}", numbers.join(", ")),
    ])
}

/// What the defaults have come to.
fn scheme<const D: usize>(model: &FluidModel<D>) -> String {
    let controls = &model.controls;
    let gradients = if controls.corrected_gradients { "corrected" } else { "plain" };
    let renewal = controls.renewal.map_or_else(String::new, |renewal| {
        format!(", shifting {}, pull of densities {}", renewal.shifting, renewal.density_pull)
    });
    format!(
        "{gradients} gradients, artificial viscosity {}, density diffusion {}{renewal}",
        controls.artificial_viscosity, controls.density_diffusion
    )
}
