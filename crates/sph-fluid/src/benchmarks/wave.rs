//! A small standing wave on water of depth 1 with wavelength 2, g = 9.81, periodic along x over a floor, at
//! Re = H sqrt(g H)/nu = 500. Density is one.

use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{Error, FindNeighbors, FluidControls, FluidPatch, Friction, PatchStart, Tait};
use nalgebra::Vector2;
use sph_kernel::KernelKind;
use std::f64::consts::PI;

/// Gravity \[m/s^2\].
const GRAVITY: f64 = 9.81;
/// sqrt(g H)/500 \[m^2/s\].
const VISCOSITY: f64 = 6.264_183e-3;
/// Period 2 pi/sqrt(g k tanh(k H)) with k = pi \[s\] (Airy).
pub const PERIOD: f64 = 1.133_917;
/// Rate 2 nu k^2 \[1/s\] at which the amplitude decays below a free surface, to first order in nu (Lamb 1932, art. 348).
pub const DECAY_RATE: f64 = 0.123_65;
/// What [`DECAY_RATE`] lacks, as a factor: at Re 500 the root of the linear problem (Lamb 1932, art. 349) is 0.925 of it, and the
/// floor, where the water sticks, adds k sqrt(nu omega/2)/sinh(2 k H), which is 0.0125 of it.
pub const EXACT_DECAY: f64 = 0.9374;
/// Amplitude of the surface at the start \[m\].
const AMPLITUDE: f64 = 0.05;
/// Half periods between the first crossing of zero and the last.
const HALF_PERIODS: usize = 6;

/// What was measured of a standing wave.
#[derive(Debug)]
pub struct StandingWave {
    /// Mean period over [`PERIOD`]; NaN where it does not swing.
    pub period: f64,
    /// Rate of decay over [`DECAY_RATE`].
    pub decay_rate: f64,
    /// The water.
    pub patch: FluidPatch<2>,
}

/// Velocity of the wave at a place, of that of the surface's crest.
fn mode(position: &Vector2<f64>) -> Vector2<f64> {
    let (x, y) = (PI * position.x, PI * position.y);
    Vector2::new(-x.sin() * y.cosh(), x.cos() * y.sinh()) / PI.sinh()
}

fn still_water(
    rows: usize,
    friction: Friction,
    find: FindNeighbors<2>,
) -> Result<(FluidPatch<2>, f64), Error> {
    let (spacing, n) = (1.0 / rows as f64, rows as i32);
    // With 1.5 spacings the friction along the lines of a lattice is 7 % low (trial of this project).
    let (length, sound_speed) = (2.0 * spacing, 10.0 * GRAVITY.sqrt());
    // A kernel of two spacings sees four rows, and the skin half of one more.
    let beside = WALL_ROWS + 1;
    let start = lattice(spacing, -beside..2 * n + beside, -beside..n, |column, row| match row {
        0.. if (0..2 * n).contains(&column) => Site::Fluid,
        0.. => Site::Empty,
        _ => Site::Wall,
    });
    let start = PatchStart {
        pressure: |position: &Vector2<f64>| GRAVITY * (1.0 - position.y),
        periods: [Some(2.0), None],
        ..start
    };
    let kernel = KernelKind::WendlandC2.with_smoothing_length(length);
    let controls = FluidControls {
        dynamic_viscosity: VISCOSITY,
        friction,
        density_diffusion: 0.1,
        body_acceleration: Vector2::new(0.0, -GRAVITY),
        ..FluidControls::new(kernel, Tait::new(1.0, sound_speed, 7.0)?)
    };
    Ok((FluidPatch::new(start, controls, find)?, 0.5 * length / sound_speed))
}

/// The wave, `rows` rows deep, from a level surface with the velocities of its mode: period between crossings of zero of the
/// velocity's projection on the mode, decay between the peaks after the first crossing and before the last.
/// [`Friction::Strain`] is right; [`Friction::Shear`] takes half of the energy in potential flow.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn standing_wave(rows: usize, friction: Friction, find: FindNeighbors<2>) -> Result<StandingWave, Error> {
    let (mut patch, dt) = still_water(rows, friction, find)?;
    let crest = AMPLITUDE * 2.0 * PI / PERIOD;
    let speeds: Vec<_> = patch.positions().iter().map(|position| mode(position) * crest).collect();
    patch.velocities_mut().copy_from_slice(&speeds);
    let (mut crossings, mut peaks) = (Vec::new(), Vec::new());
    let (mut before, mut peak) = (0.0, (0.0, 0.0));
    while crossings.len() <= HALF_PERIODS && patch.time() < HALF_PERIODS as f64 * PERIOD {
        patch.step(dt);
        let pairs = patch.positions().iter().zip(patch.velocities());
        let now: f64 = pairs.map(|(position, velocity)| mode(position).dot(velocity)).sum();
        if before * now < 0.0 {
            crossings.push(patch.time() - dt * now / (now - before));
            peaks.push(peak);
            peak = (0.0, 0.0);
        }
        if now.abs() > peak.1 {
            peak = (patch.time(), now.abs());
        }
        before = now;
    }
    let (mut period, mut decay_rate) = (f64::NAN, f64::NAN);
    // The peak before the first crossing is the start, where the wave leaves the lattice.
    if let (Some(last), Some(first), Some(end)) =
        (crossings.get(HALF_PERIODS), peaks.get(1), peaks.get(HALF_PERIODS))
    {
        period = (last - crossings[0]) / (0.5 * HALF_PERIODS as f64) / PERIOD;
        decay_rate = (first.1 / end.1).ln() / (end.0 - first.0) / DECAY_RATE;
    }
    Ok(StandingWave { period, decay_rate, patch })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Complex;

    #[test]
    fn the_decay_is_the_root_of_the_linear_problem_and_the_layer_at_the_floor() {
        // (s + 2 a)^2 + omega^2 = 4 a^2 sqrt(1 + s/a) with a = nu k^2, for exp(s t) on deep water.
        let (rate, square) = (VISCOSITY * PI * PI, GRAVITY * PI * PI.tanh());
        assert!((2.0 * rate / DECAY_RATE - 1.0).abs() < 1e-4);
        assert!((2.0 * PI / square.sqrt() / PERIOD - 1.0).abs() < 1e-5);
        let mut root = Complex::new(-2.0 * rate, square.sqrt());
        for _ in 0..50 {
            let layer = (root / rate + 1.0).sqrt();
            let wrong = (root + 2.0 * rate) * (root + 2.0 * rate) + square - layer * (4.0 * rate * rate);
            let slope = (root + 2.0 * rate) * 2.0 - (layer * 2.0).inv() * (4.0 * rate);
            root -= wrong / slope;
        }
        let floor = PI * (0.5 * VISCOSITY * square.sqrt()).sqrt() / (2.0 * PI).sinh();
        let exact = (floor - root.re) / DECAY_RATE;
        assert!((exact - EXACT_DECAY).abs() < 1e-4, "{exact}");
        // Viscosity lengthens the period by less than its mark.
        assert!((square.sqrt() / root.im - 1.001_66).abs() < 1e-5);
    }
}
