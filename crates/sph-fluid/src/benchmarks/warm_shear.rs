//! Flow between a plate at rest and one that moves, both held at one temperature, which its own friction warms (Brinkman 1951).
//! Density, viscosity, height, speed of the plate, conductivity and heat capacity are one.

use super::largest;
use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{Conduction, Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Tait};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

/// Artificial speed of sound.
const SOUND_SPEED: f64 = 10.0;
/// When the temperature stands still to exp(-pi^2).
const END: f64 = 1.0;
const COLUMNS: i32 = 12;

/// T = eta U^2 (z/H)(1 - z/H)/(2 k) \[K\] above the plates at a height, once steady.
#[must_use]
pub fn exact_warmth(height: f64) -> f64 {
    0.5 * height * (1.0 - height)
}

/// Largest error of a particle's temperature at t = 1, over the largest temperature; with the fluid.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn warm_shear(rows: usize, find: FindNeighbors<2>) -> Result<(f64, FluidPatch<2>), Error> {
    let height = rows as i32;
    let columns = -WALL_ROWS..COLUMNS + WALL_ROWS;
    let mut start =
        lattice(1.0 / rows as f64, columns, -WALL_ROWS..height + WALL_ROWS, |column, row| {
            match ((0..COLUMNS).contains(&column), (0..height).contains(&row)) {
                (true, true) => Site::Fluid,
                (false, true) => Site::Empty,
                (_, false) => Site::Wall,
            }
        });
    for (position, velocity) in start.walls.iter().zip(&mut start.wall_velocities) {
        velocity.x = if position.y > 1.0 { 1.0 } else { 0.0 };
    }
    let (spacing, length) = (start.spacing, 1.5 * start.spacing);
    let controls = FluidControls {
        dynamic_viscosity: 1.0,
        density_diffusion: 0.1,
        viscous_heating: true,
        ..FluidControls::new(
            KernelKind::WendlandC2.with_smoothing_length(length),
            Tait::new(1.0, SOUND_SPEED, 7.0)?,
        )
    };
    let start = PatchStart {
        periods: [Some(f64::from(COLUMNS) * spacing), None],
        conduction: Some(Conduction { diffusivity: 1.0, heat_capacity: 1.0, held: |_| Some(0.0) }),
        ..start
    };
    let mut patch = FluidPatch::new(start, controls, find)?;
    let speeds: Vec<_> = patch.positions().iter().map(|position| Vector2::new(position.y, 0.0)).collect();
    patch.velocities_mut().copy_from_slice(&speeds);
    patch.run_to(END, (0.125 * length * length).min(0.5 * length / SOUND_SPEED));
    let warmth = patch.positions().iter().zip(patch.temperatures());
    let error = largest(warmth.map(|(position, warmth)| (warmth - exact_warmth(position.y)).abs()));
    Ok((error / exact_warmth(0.5), patch))
}
