//! Blocks of aluminium that carry noise: the longest step that does not make it grow.

use super::aluminium::aluminium;
use super::shapes::centred;
use crate::{Error, FindNeighbors, SolidPatch, SolidStart};
use nalgebra::SVector;

const SPACING: f64 = 1e-3;

/// Steps in which an unstable motion is found out.
const STEPS: usize = 600;

/// How often the range of the step is halved.
const HALVINGS: usize = 9;

/// The longest stable step over h/c_P of a free square or cube of `cells` along its edges with the default scheme (h/dx 0.8,
/// hourglass 0.4), between 0.5 and 2 to half a per cent; with the block.
///
/// # Errors
/// [`Error`] of the body.
pub fn longest_step<const D: usize>(
    cells: usize,
    find: FindNeighbors<D>,
) -> Result<(f64, SolidPatch<D>), Error> {
    let start = SolidStart::new(centred([cells; D], SPACING), SPACING, aluminium(0.0)?);
    let mut patch = SolidPatch::new(start, find)?;
    let (mut stable, mut unstable) = (0.5, 2.0);
    for _ in 0..HALVINGS {
        let factor = 0.5 * (stable + unstable);
        if is_stable(&mut patch, factor) { stable = factor } else { unstable = factor }
    }
    Ok((stable, patch))
}

/// Whether noise of the velocities keeps its energy over steps of `factor` h/c_P.
fn is_stable<const D: usize>(patch: &mut SolidPatch<D>, factor: f64) -> bool {
    patch.set_displacements(|_| SVector::zeros());
    for (k, velocity) in patch.velocities.iter_mut().enumerate() {
        *velocity = SVector::from_fn(|axis, _| (12.9 * k as f64 + 7.7 * axis as f64).sin() * 1e-4);
    }
    let [start, ..] = patch.energies();
    let dt = patch.body().stable_step(factor);
    (0..STEPS).for_each(|_| patch.step(dt));
    // Of energy that stays some is elastic. What grows may have no number any more.
    patch.energies()[0] < 2.0 * start
}
