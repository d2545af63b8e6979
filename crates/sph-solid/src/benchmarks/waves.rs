//! Speeds of elastic waves in aluminium, from half periods of standing waves between free ends (Landau and Lifshitz, Theory of
//! Elasticity (1986), sections 22 and 25). Each is measured over exact, with the body.

use super::aluminium::{DENSITY, POISSON, YOUNG, aluminium};
use super::shapes::lattice;
use super::time_of_return;
use crate::{Error, FindNeighbors, SolidPatch, SolidStart, bar_speed, pressure_wave_speed, shear_wave_speed};
use nalgebra::{SVector, Vector2, Vector3};
use std::f64::consts::PI;

/// Length of the bodies \[m\].
const LENGTH: f64 = 0.04;

/// Pressure wave in plane strain, sides held, against c_P; `cells` over the length.
///
/// # Errors
/// [`Error`] of the body.
pub fn pressure_wave(cells: usize, find: FindNeighbors<2>) -> Result<(f64, SolidPatch<2>), Error> {
    let exact = pressure_wave_speed(aluminium(0.0)?.solver_moduli(), DENSITY);
    speed([cells, cells / 5], Vector2::x(), Vector2::x(), exact, find)
}

/// Shear wave in plane strain against c_S; `cells` over the length.
///
/// # Errors
/// [`Error`] of the body.
pub fn shear_wave(cells: usize, find: FindNeighbors<2>) -> Result<(f64, SolidPatch<2>), Error> {
    let exact = shear_wave_speed(aluminium(0.0)?.solver_moduli(), DENSITY);
    speed([cells, cells / 5], Vector2::y(), Vector2::y(), exact, find)
}

/// Wave in a bar with free sides, a tenth as thick as long, against sqrt(E/rho); `cells` over the length.
///
/// # Errors
/// [`Error`] of the body.
pub fn bar_wave(cells: usize, find: FindNeighbors<3>) -> Result<(f64, SolidPatch<3>), Error> {
    let exact = bar_speed(aluminium(0.0)?.solver_moduli(), DENSITY);
    speed([cells, cells / 10, cells / 10], Vector3::x(), Vector3::repeat(1.0), exact, find)
}

/// Wave in a thin plate, free faces, plane strain, against sqrt(E/((1 - nu^2) rho)); `cells` over the length.
///
/// # Errors
/// [`Error`] of the body.
pub fn plate_wave(cells: usize, find: FindNeighbors<2>) -> Result<(f64, SolidPatch<2>), Error> {
    let exact = (YOUNG / (DENSITY * (1.0 - POISSON * POISSON))).sqrt();
    speed([cells, cells / 10], Vector2::x(), Vector2::repeat(1.0), exact, find)
}

/// Speed over `exact` \[m/s\] from the lowest mode cos(pi x/L) along `direction`: half a period is L/c.
fn speed<const D: usize>(
    counts: [usize; D],
    direction: SVector<f64, D>,
    free: SVector<f64, D>,
    exact: f64,
    find: FindNeighbors<D>,
) -> Result<(f64, SolidPatch<D>), Error> {
    let spacing = LENGTH / counts[0] as f64;
    let start = SolidStart::new(lattice([0.0; D], counts, spacing), spacing, aluminium(0.0)?);
    let mut patch = SolidPatch::new(start, find)?;
    patch.free.fill(free);
    let mode = |x: &SVector<f64, D>| direction * (PI * x[0] / LENGTH).cos();
    let half = half_period(&mut patch, mode, 1e-3, 0.3, 2.0 * LENGTH / exact);
    Ok((LENGTH / half / exact, patch))
}

/// Gives a body the velocities `amplitude` \[m/s\] times `mode`, and returns the time \[s\] after which its displacement along
/// the mode is back at zero: half a period. Steps are `factor` h/c_P; NaN if it takes more than `longest` \[s\].
pub(super) fn half_period<const D: usize>(
    patch: &mut SolidPatch<D>,
    mode: impl Fn(&SVector<f64, D>) -> SVector<f64, D>,
    amplitude: f64,
    factor: f64,
    longest: f64,
) -> f64 {
    let shape = |(x, free): (&SVector<f64, D>, &SVector<f64, D>)| mode(x).component_mul(free);
    let shapes: Vec<_> = patch.positions().iter().zip(&patch.free).map(shape).collect();
    patch.velocities = shapes.iter().map(|shape| shape * amplitude).collect();
    patch.evaluate();
    let dt = patch.body().stable_step(factor);
    time_of_return(dt, longest, || {
        patch.step(dt);
        patch.displacements.iter().zip(&shapes).map(|(displacement, shape)| displacement.dot(shape)).sum()
    })
}
