//! The area that the surface's particles make up: sum V delta, with the weights delta of both surface forces.

use super::drop::{self, ball_at_rest, drop_at_rest};
use super::shapes::tense;
use crate::{Error, FindNeighbors, FluidPatch, PatchStart};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Area over the true one.
#[derive(Clone, Copy, Debug)]
pub struct Areas {
    /// With delta = 2 |grad C|, the weight of tension; plain sums.
    pub tension: f64,
    /// With delta = 2 w1(s), the weight of Marangoni's force.
    pub marangoni: f64,
}

/// The areas of a patch over `exact` \[m^(D-1)\].
fn areas<const D: usize>(patch: &FluidPatch<D>, exact: f64) -> Areas {
    let (mut tension, mut marangoni) = (0.0, 0.0);
    if let Some(surface) = patch.sweep().surface() {
        let (support, profile) = (surface.profile().support(), surface.profile());
        for (i, (mass, density)) in patch.masses().iter().zip(patch.densities()).enumerate() {
            let (volume, depth) = (mass / density, surface.planes()[i].1);
            tension += 2.0 * volume * surface.gradients()[i].norm();
            if depth < support {
                marangoni += 2.0 * volume * profile.weight(depth.max(0.0));
            }
        }
    }
    Areas { tension: tension / exact, marangoni: marangoni / exact }
}

/// A layer with two flat faces, on its lattice, `rows` rows thick.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn plane(rows: usize, find: FindNeighbors<2>) -> Result<(Areas, FluidPatch<2>), Error> {
    let (spacing, columns) = (1.0 / rows as f64, 16);
    let site = |k: usize| Vector2::new((k % columns) as f64 + 0.5, (k / columns) as f64 + 0.5) * spacing;
    let positions: Vec<_> = (0..rows * columns).map(site).collect();
    let volumes = vec![spacing * spacing; positions.len()];
    let period = columns as f64 * spacing;
    let start = PatchStart { periods: [Some(period), None], ..PatchStart::free(positions, volumes, spacing) };
    let patch = FluidPatch::new(start, tense(drop::SCHEME, spacing)?, find)?;
    Ok((areas(&patch, 2.0 * period), patch))
}

/// A drop that has rested for two capillary times.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn circle(across: usize, find: FindNeighbors<2>) -> Result<(Areas, FluidPatch<2>), Error> {
    Ok(round(drop_at_rest(across, 2.0, drop::SCHEME, find)?.patch))
}

/// A ball cut out of a lattice, after two capillary times.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn sphere(across: usize, find: FindNeighbors<3>) -> Result<(Areas, FluidPatch<3>), Error> {
    Ok(round(ball_at_rest(across, 2.0, drop::SCHEME, find)?.patch))
}

/// Against the circle or sphere of the same volume.
fn round<const D: usize>(patch: FluidPatch<D>) -> (Areas, FluidPatch<D>) {
    let volume = patch.volume();
    let exact = if D == 2 { 2.0 * (PI * volume).sqrt() } else { (36.0 * PI * volume * volume).cbrt() };
    (areas(&patch, exact), patch)
}
