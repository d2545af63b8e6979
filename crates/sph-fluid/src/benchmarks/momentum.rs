//! Momentum of a free body on which nothing acts from outside: forces between pairs keep it to round-off, the force of tension, which is
//! none of pairs, does not.

use super::drop;
use super::shapes::{rings, tense};
use crate::{Error, FindNeighbors, FluidControls, FluidPatch, Friction, PatchStart};
use nalgebra::Vector2;

const STEPS: usize = 200;

/// Momentum gained in 200 steps by pressure, friction and artificial viscosity with density diffusion, over sum m |v|: the largest of
/// plain and corrected gradients with both frictions. With a body.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn pair_residual(across: usize, find: FindNeighbors<2>) -> Result<(f64, FluidPatch<2>), Error> {
    let mut found = Vec::new();
    for friction in [Friction::Shear, Friction::Strain] {
        for corrected_gradients in [false, true] {
            let controls =
                FluidControls { friction, corrected_gradients, surface_tension: None, ..controls(across)? };
            let mut patch = body(across, controls, find)?;
            let before = momentum(&patch);
            let dt = drop::SCHEME.acoustic_step(0.25, patch.spacing());
            (0..STEPS).for_each(|_| patch.step(dt));
            found.push(((momentum(&patch) - before).norm() / size(&patch), patch));
        }
    }
    let worst = super::largest(found.iter().map(|(residual, _)| *residual));
    Ok((worst, found.swap_remove(0).1))
}

/// Largest speed of the centre of mass, of a body with tension that started with none, over sqrt(tau/(rho R)), in two capillary times.
/// With the body.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn tension_residual(across: usize, find: FindNeighbors<2>) -> Result<(f64, FluidPatch<2>), Error> {
    let mut patch = body(across, controls(across)?, find)?;
    let mass: f64 = patch.masses().iter().sum();
    let centre = momentum(&patch) / mass;
    patch.velocities_mut().iter_mut().for_each(|velocity| *velocity -= centre);
    let dt = drop::SCHEME.acoustic_step(0.25, patch.spacing());
    let mut fastest = 0.0;
    while patch.time() < 2.0 {
        patch.step(dt);
        fastest = super::largest([fastest, momentum(&patch).norm() / mass].into_iter());
    }
    Ok((fastest, patch))
}

fn controls(across: usize) -> Result<FluidControls<2>, Error> {
    let controls = tense(drop::SCHEME, 1.0 / across as f64)?;
    Ok(FluidControls { dynamic_viscosity: 0.01, artificial_viscosity: 0.1, ..controls })
}

/// A round body of rings with the pressure of its tension that is sheared, squeezed and turned without symmetry.
fn body(across: usize, controls: FluidControls<2>, find: FindNeighbors<2>) -> Result<FluidPatch<2>, Error> {
    let (positions, areas) = rings(across);
    let speeds: Vec<_> =
        positions.iter().map(|x| Vector2::new((2.0 * x.y + 0.3).sin(), 0.5 * x.x * x.y) * 0.2).collect();
    let start = PatchStart { pressure: |_| 1.0, ..PatchStart::free(positions, areas, 1.0 / across as f64) };
    let mut patch = FluidPatch::new(start, controls, find)?;
    patch.velocities_mut().copy_from_slice(&speeds);
    Ok(patch)
}

fn momentum(patch: &FluidPatch<2>) -> Vector2<f64> {
    patch.velocities().iter().zip(patch.masses()).map(|(velocity, mass)| velocity * *mass).sum()
}

fn size(patch: &FluidPatch<2>) -> f64 {
    patch.velocities().iter().zip(patch.masses()).map(|(velocity, mass)| velocity.norm() * mass).sum()
}
