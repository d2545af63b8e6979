//! A viscous fluid at rest in an open tank between walls; density, depth and gravity are one.

use super::largest;
use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Tait, artificial_sound_speed};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

/// Viscosity \[H sqrt(g H)\].
const VISCOSITY: f64 = 0.02;

/// What was measured of a tank after its waves have died.
#[derive(Debug)]
pub struct Tank {
    /// Largest difference of a particle's pressure from rho g (H - z) \[rho g H\].
    pub pressure_error: f64,
    /// Largest speed \[sqrt(g H)\].
    pub largest_speed: f64,
    /// The fluid.
    pub patch: FluidPatch<2>,
}

/// A square tank of `rows` rows of fluid, watched for `duration` \[sqrt(H/g)\] after half of that. It starts on the lattice with the
/// pressure of its depth; the rows at the surface and in the corners settle. Later the whole lattice gives way to a closer
/// packing, here and there, and does so slowly only in a viscous fluid: with artificial viscosity alone, 30 rows reach 0.003 (trial of
/// this project).
///
/// # Errors
/// [`Error`] of the sweep.
pub fn tank(rows: usize, duration: f64, find: FindNeighbors<2>) -> Result<Tank, Error> {
    let (spacing, n) = (1.0 / rows as f64, rows as i32);
    let length = 1.5 * spacing;
    let sound_speed = artificial_sound_speed(0.0, 1.0, 0.0, 0.0, 1.0);
    let start = lattice(spacing, -WALL_ROWS..n + WALL_ROWS, -WALL_ROWS..n + WALL_ROWS, |column, row| {
        if row < 0 || !(0..n).contains(&column) {
            Site::Wall
        } else if row < n {
            Site::Fluid
        } else {
            Site::Empty
        }
    });
    let start = PatchStart { pressure: |position: &Vector2<f64>| 1.0 - position.y, ..start };
    let kernel = KernelKind::WendlandC2.with_smoothing_length(length);
    let controls = FluidControls {
        dynamic_viscosity: VISCOSITY,
        artificial_viscosity: 0.1,
        density_diffusion: 0.1,
        body_acceleration: Vector2::new(0.0, -1.0),
        ..FluidControls::new(kernel, Tait::new(1.0, sound_speed, 7.0)?)
    };
    let mut patch = FluidPatch::new(start, controls, find)?;
    let dt = 0.5 * length / sound_speed;
    patch.run_to(0.5 * duration, dt);
    let (mut pressure_errors, mut speeds) = (Vec::new(), Vec::new());
    while patch.time() < 1.5 * duration {
        patch.step(dt);
        let pairs = patch.positions().iter().zip(patch.sweep().pressures());
        pressure_errors.push(largest(pairs.map(|(position, pressure)| (pressure + position.y - 1.0).abs())));
        speeds.push(patch.largest_speed());
    }
    let (pressure_error, largest_speed) = (largest(pressure_errors.into_iter()), largest(speeds.into_iter()));
    Ok(Tank { pressure_error, largest_speed, patch })
}
