//! A block of aluminium that cools when it is stretched and warms when it is pressed.

use super::aluminium::{ALPHA, DENSITY, HEAT_CAPACITY, aluminium};
use super::shapes::centred;
use crate::{Error, FindNeighbors, SolidPatch, SolidStart, gough_joule_rate};
use nalgebra::Vector2;

const SPACING: f64 = 1e-3;

/// Steps in which the block is stretched.
const STEPS: i32 = 10;

/// Change of temperature \[K\] of every particle of a block of `cells` along its edges that starts at 293 K and is stretched by
/// `strain` along x in ten steps, plane strain; with the block.
///
/// # Errors
/// [`Error`] of the body.
pub fn stretched(
    cells: usize,
    strain: f64,
    find: FindNeighbors<2>,
) -> Result<(Vec<f64>, SolidPatch<2>), Error> {
    let material = aluminium(0.0)?;
    let bulk = material.sound.real().bulk_pa();
    let start = SolidStart::new(centred([cells; 2], SPACING), SPACING, material);
    let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: 1.2, ..start }, find)?;
    let particles = patch.positions().len();
    let (mut changes, mut volumes) = (vec![0.0; particles], vec![1.0; particles]);
    for step in 1..=STEPS {
        let strain = strain * f64::from(step) / f64::from(STEPS);
        patch.set_displacements(|position| Vector2::new(strain * position.x, 0.0));
        for i in 0..particles {
            let volume = patch.body().deformations()[i].determinant();
            let growth = (volume / volumes[i]).ln();
            changes[i] += gough_joule_rate(bulk, ALPHA, 293.0 + changes[i], growth, DENSITY, HEAT_CAPACITY);
            volumes[i] = volume;
        }
    }
    Ok((changes, patch))
}
