//! Drops of R = rho = tau = 1 under their own tension: pressure of rest (Laplace), and the period of a small oscillation
//! (Rayleigh 1879).

use super::shapes::{cut_ball, rings, tense};
use crate::{Error, FindNeighbors, FluidControls, FluidPatch, PatchStart};
use nalgebra::{SVector, Vector2};
use std::f64::consts::PI;

/// Artificial speed of sound \[sqrt(tau/(rho R))\].
const SOUND_SPEED: f64 = 15.0;
/// Viscosity of drops at rest \[sqrt(rho tau R)\].
pub const RESTING_VISCOSITY: f64 = 0.05;
/// Period of the second mode in 2-D, 2 pi/sqrt(6).
pub const PERIOD: f64 = 2.565_100;
/// Largest speed of an oscillation over the radius times its angular frequency.
const AMPLITUDE: f64 = 0.08;

/// What was measured of a drop at rest, over the second half of its run.
#[derive(Debug)]
pub struct AtRest<const D: usize> {
    /// Mean pressure over (D - 1) tau/R.
    pub pressure: f64,
    /// Largest speed \[sqrt(tau/(rho R))\].
    pub largest_speed: f64,
    /// The drop.
    pub patch: FluidPatch<D>,
}

fn controls<const D: usize>(spacing: f64, viscosity: f64) -> Result<FluidControls<D>, Error> {
    let dynamic_viscosity = viscosity;
    Ok(FluidControls { dynamic_viscosity, artificial_viscosity: 0.1, ..tense(spacing, SOUND_SPEED)? })
}

/// A drop in rings, `across` spacings to the radius, with the pressure of its curvature.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn round_drop(across: usize, viscosity: f64, find: FindNeighbors<2>) -> Result<FluidPatch<2>, Error> {
    FluidPatch::new(ring_start(across), controls(1.0 / across as f64, viscosity)?, find)
}

fn ring_start(across: usize) -> PatchStart<2> {
    let (positions, areas) = rings(across);
    PatchStart { pressure: |_| 1.0, ..PatchStart::free(positions, areas, 1.0 / across as f64) }
}

/// A drop of rings at rest until `end`.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn drop_at_rest(across: usize, end: f64, find: FindNeighbors<2>) -> Result<AtRest<2>, Error> {
    let patch = round_drop(across, RESTING_VISCOSITY, find)?;
    Ok(watch(patch, end, 0.25))
}

/// A ball cut out of a lattice, which first becomes round, until `end`.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn ball_at_rest(across: usize, end: f64, find: FindNeighbors<3>) -> Result<AtRest<3>, Error> {
    let (positions, spacing) = (cut_ball(across), 1.0 / across as f64);
    let volumes = vec![spacing.powi(3); positions.len()];
    let start = PatchStart { pressure: |_| 2.0, ..PatchStart::free(positions, volumes, spacing) };
    Ok(watch(FluidPatch::new(start, controls(spacing, RESTING_VISCOSITY)?, find)?, end, 0.5))
}

fn watch<const D: usize>(mut patch: FluidPatch<D>, end: f64, acoustic: f64) -> AtRest<D> {
    let dt = step(&patch, acoustic);
    let (mut pressure, mut largest_speed, mut count) = (0.0, 0.0_f64, 0.0);
    while patch.time() < end {
        patch.step(dt);
        if patch.time() > 0.5 * end {
            pressure += inner_pressure(&patch) * radius(&patch) / (D - 1) as f64;
            largest_speed = largest_speed.max(patch.largest_speed());
            count += 1.0;
        }
    }
    AtRest { pressure: pressure / count, largest_speed, patch }
}

fn step<const D: usize>(patch: &FluidPatch<D>, acoustic: f64) -> f64 {
    acoustic * 1.5 * patch.spacing() / SOUND_SPEED
}

/// Radius of a round body of the fluid's volume.
fn radius<const D: usize>(patch: &FluidPatch<D>) -> f64 {
    if D == 2 { (patch.volume() / PI).sqrt() } else { (0.75 * patch.volume() / PI).cbrt() }
}

/// Mean pressure within half of the radius.
fn inner_pressure<const D: usize>(patch: &FluidPatch<D>) -> f64 {
    let inner = |position: &SVector<f64, D>| position.norm() < 0.5;
    let (mut sum, mut count) = (0.0, 0.0);
    for (position, pressure) in patch.positions().iter().zip(patch.sweep().pressures()) {
        if inner(position) {
            sum += pressure;
            count += 1.0;
        }
    }
    sum / count
}

/// Mean period of the second mode over [`PERIOD`], between zero crossings of sum m (x^2 - y^2) over three periods; the
/// first half period, in which the particles leave their rings, does not count. NaN where it does not swing. With the drop.
/// `corrected_gradients` is the default of the other drops; without, the period is what plain sums give.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn swinging_drop(
    across: usize,
    corrected_gradients: bool,
    find: FindNeighbors<2>,
) -> Result<(f64, FluidPatch<2>), Error> {
    let controls = FluidControls { corrected_gradients, ..controls(1.0 / across as f64, 0.01)? };
    let mut patch = FluidPatch::new(ring_start(across), controls, find)?;
    let speeds: Vec<_> = patch.positions().iter().map(|x| Vector2::new(x.x, -x.y)).collect();
    let largest = AMPLITUDE * 2.0 * PI / PERIOD;
    patch.velocities_mut().iter_mut().zip(speeds).for_each(|(velocity, shape)| *velocity = shape * largest);
    let (dt, mut before, mut crossings) = (step(&patch, 0.25), 0.0, Vec::new());
    while crossings.len() < 7 && patch.time() < 4.5 * PERIOD {
        patch.step(dt);
        let now = elongation(&patch);
        if before * now < 0.0 {
            crossings.push(patch.time() - dt * now / (now - before));
        }
        before = now;
    }
    let ratio = crossings.get(6).map_or(f64::NAN, |last| (last - crossings[0]) / 3.0 / PERIOD);
    Ok((ratio, patch))
}

fn elongation(patch: &FluidPatch<2>) -> f64 {
    patch.positions().iter().zip(patch.masses()).map(|(x, mass)| mass * (x.x * x.x - x.y * x.y)).sum()
}
