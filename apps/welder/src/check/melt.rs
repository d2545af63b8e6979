//! What a melt that flows adds to the work of a run: a coarse run of conduction tells how much melts for how long.

use crate::model::{FlowModel, Model, ModelError};
use crate::observe::Machine;
use crate::physics::flow::{LARGEST_MOVE, SMOOTHING_RATIO};
use crate::run::{Simulation, coarse_conduction};
use sph_fluid::{SOUND_SPEED_RATIO, acoustic_step};
use std::f64::consts::PI;

/// Seconds that one core takes for a particle of melt or wall in a step of the melt, and for finding the neighbours of heat anew in
/// one step of heat: careful figures for a forecast, of the flow cases of this project.
const SECONDS_PER_PARTICLE: f64 = 6e-6;
const SECONDS_PER_RENEWAL: f64 = 0.05;

/// Spacings that walls reach into the solid around a pool.
const WALL: f64 = 4.0;

/// Steps and work of the melt, as far as conduction lets expect.
pub(super) fn forecast(model: &Model, flow: &FlowModel) -> Result<String, ModelError> {
    let molten = Molten::of(model)?;
    let spacing = model.spacing();
    let speed = flow.expected_speed(model);
    let sound = match flow.settings.sound_speed_m_s {
        Some(sound) => sound,
        None => flow.first_sound_speed(model).max(SOUND_SPEED_RATIO * speed),
    };
    // Kick-drift-kick takes twice the acoustic limit.
    let steps = molten.time / (2.0 * acoustic_step(SMOOTHING_RATIO * spacing, sound, speed));
    let melt = molten.volume_time / molten.time.max(f64::MIN_POSITIVE) / spacing.powi(3);
    let renewals = molten.time * speed / (LARGEST_MOVE * spacing);
    let seconds = steps * (melt + walls_of(melt)) * SECONDS_PER_PARTICLE + renewals * SECONDS_PER_RENEWAL;
    Ok(format!(
        "  melt           {speed:.2} m/s expected, sound {sound:.1} m/s; molten for {:.2e} s, {melt:.0} particles on average: about \
         {steps:.0} steps of the melt and {renewals:.0} of heat, {seconds:.0} s on one core of {}",
        molten.time,
        Machine::here()
    ))
}

/// Particles of the solid in the reach of a half-sphere of so many of melt.
fn walls_of(melt: f64) -> f64 {
    let half_sphere = |radius: f64| 2.0 / 3.0 * PI * radius.powi(3);
    let radius = (1.5 * melt / PI).cbrt();
    half_sphere(radius + WALL) - half_sphere(radius)
}

/// How long anything is molten \[s\], and the integral of its volume over time \[m³ s\], of the modelled part.
#[derive(Debug, Default)]
struct Molten {
    time: f64,
    volume_time: f64,
}

impl Molten {
    fn of(model: &Model) -> Result<Self, ModelError> {
        let mut simulation = Simulation::new(coarse_conduction(model))?;
        let mut molten = Self::default();
        while !simulation.finished() {
            // A run that fails tells what melted until then.
            let Ok(report) = simulation.step(model.end) else { break };
            let volume = simulation.records().now.melt_volume / simulation.gauge().copies();
            if volume > 0.0 {
                molten.time += report.step;
                molten.volume_time += volume * report.step;
            }
        }
        Ok(molten)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pool_of_one_radius_has_walls_of_a_shell() {
        let melt = 2.0 / 3.0 * PI * 1000.0;
        assert!((walls_of(melt) - 2.0 / 3.0 * PI * (14.0f64.powi(3) - 1000.0)).abs() < 1e-6);
    }
}
