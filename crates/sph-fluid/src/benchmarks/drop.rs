//! Drops of R = rho = tau = 1 under their own tension: pressure of rest (Laplace), and the period of a small oscillation
//! (Rayleigh 1879).

use super::Scheme;
use super::shapes::{cut_ball, rings, tense};
use crate::{Error, FindNeighbors, FluidControls, FluidPatch, PatchStart};
use nalgebra::{SVector, Vector2};
use std::f64::consts::PI;

/// Sound 15 times as fast as capillary waves; gradients exact at the surface.
pub const SCHEME: Scheme = Scheme { corrected_gradients: true, ..Scheme::new(15.0) };
/// Viscosity of drops at rest \[sqrt(rho tau R)\].
pub const RESTING_VISCOSITY: f64 = 0.05;
/// Period of the second mode in 2-D, 2 pi/sqrt(6).
pub const PERIOD: f64 = 2.565_100;
/// Viscosity of drops that swing.
const SWINGING_VISCOSITY: f64 = 0.01;
/// Amplitude \[R\] of a small oscillation.
pub const SMALL: f64 = 0.08;

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

fn controls<const D: usize>(scheme: Scheme, spacing: f64, viscosity: f64) -> Result<FluidControls<D>, Error> {
    let dynamic_viscosity = viscosity;
    Ok(FluidControls { dynamic_viscosity, artificial_viscosity: 0.1, ..tense(scheme, spacing)? })
}

/// A drop in rings, `across` spacings to the radius, with the pressure of its curvature.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn round_drop(
    across: usize,
    viscosity: f64,
    scheme: Scheme,
    find: FindNeighbors<2>,
) -> Result<FluidPatch<2>, Error> {
    FluidPatch::new(ring_start(across), controls(scheme, 1.0 / across as f64, viscosity)?, find)
}

fn ring_start(across: usize) -> PatchStart<2> {
    let (positions, areas) = rings(across);
    PatchStart { pressure: |_| 1.0, ..PatchStart::free(positions, areas, 1.0 / across as f64) }
}

/// A drop of rings at rest until `end`.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn drop_at_rest(
    across: usize,
    end: f64,
    scheme: Scheme,
    find: FindNeighbors<2>,
) -> Result<AtRest<2>, Error> {
    let patch = round_drop(across, RESTING_VISCOSITY, scheme, find)?;
    let dt = scheme.acoustic_step(0.25, patch.spacing());
    Ok(watch(patch, end, dt))
}

/// A ball cut out of a lattice, which first becomes round, until `end`.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn ball_at_rest(
    across: usize,
    end: f64,
    scheme: Scheme,
    find: FindNeighbors<3>,
) -> Result<AtRest<3>, Error> {
    let (positions, spacing) = (cut_ball(across), 1.0 / across as f64);
    let volumes = vec![spacing.powi(3); positions.len()];
    let start = PatchStart { pressure: |_| 2.0, ..PatchStart::free(positions, volumes, spacing) };
    let patch = FluidPatch::new(start, controls(scheme, spacing, RESTING_VISCOSITY)?, find)?;
    Ok(watch(patch, end, scheme.acoustic_step(0.5, spacing)))
}

fn watch<const D: usize>(mut patch: FluidPatch<D>, end: f64, dt: f64) -> AtRest<D> {
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

/// What was measured of a drop that swings.
#[derive(Debug)]
pub struct Swing {
    /// Three periods of the second mode over [`PERIOD`], one after the other, between zero crossings of sum m (x^2 - y^2); the first
    /// half period, in which the particles leave their rings, does not count. NaN where it does not swing.
    pub periods: [f64; 3],
    /// How far the drop reached over its radius at the first turn, less one.
    pub amplitude: f64,
    /// The drop.
    pub patch: FluidPatch<2>,
}

/// A round drop that starts with the velocities of its second mode, whose `amplitude` \[R\] it would reach without friction if it were
/// small; [`SMALL`] is.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn swinging_drop(
    across: usize,
    amplitude: f64,
    scheme: Scheme,
    find: FindNeighbors<2>,
) -> Result<Swing, Error> {
    let mut patch = round_drop(across, SWINGING_VISCOSITY, scheme, find)?;
    let speeds: Vec<_> = patch.positions().iter().map(|x| Vector2::new(x.x, -x.y)).collect();
    let largest = amplitude * 2.0 * PI / PERIOD;
    patch.velocities_mut().iter_mut().zip(speeds).for_each(|(velocity, shape)| *velocity = shape * largest);
    let (dt, mut before) = (scheme.acoustic_step(0.25, patch.spacing()), 0.0);
    let (mut crossings, mut reached) = (Vec::new(), 0.0_f64);
    while crossings.len() < 7 && patch.time() < 5.5 * PERIOD {
        patch.step(dt);
        let now = elongation(&patch);
        if before * now < 0.0 {
            crossings.push(patch.time() - dt * now / (now - before));
        }
        before = now;
        if crossings.is_empty() {
            reached = reached.max(reach(&patch) - 1.0);
        }
    }
    crossings.resize(7, f64::NAN);
    let periods = [0, 2, 4].map(|k| (crossings[k + 2] - crossings[k]) / PERIOD);
    Ok(Swing { periods, amplitude: reached, patch })
}

impl Swing {
    /// Mean of the three periods.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.periods.iter().sum::<f64>() / 3.0
    }
}

/// How far the drop reaches from its centre, to the edge of its outermost cell.
#[must_use]
pub fn reach(patch: &FluidPatch<2>) -> f64 {
    super::largest(patch.positions().iter().map(|position| position.norm())) + 0.5 * patch.spacing()
}

fn elongation(patch: &FluidPatch<2>) -> f64 {
    patch.positions().iter().zip(patch.masses()).map(|(x, mass)| mass * (x.x * x.x - x.y * x.y)).sum()
}
