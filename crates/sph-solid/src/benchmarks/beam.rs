//! The beam CSM3 of Turek and Hron (2006): clamped to a cylinder, set free at rest under its weight, it swings by a third of
//! its length without damping.

use super::shapes::lattice;
use crate::{Error, FindNeighbors, IsotropicModuli, Material, SolidPatch, SolidStart};
use nalgebra::Vector2;

/// Mean of the tip's highest and lowest displacement across \[m\].
pub const MEAN: f64 = -64.09e-3;

/// Half their difference \[m\].
pub const AMPLITUDE: f64 = 65.64e-3;

/// Frequency \[Hz\].
pub const FREQUENCY: f64 = 1.094;

/// Length from the cylinder's rear, and height \[m\].
const BEAM: [f64; 2] = [0.35, 0.02];

/// Radius of the cylinder \[m\], whose rear is the origin.
const CYLINDER: f64 = 0.05;

/// What the tip does.
#[derive(Debug)]
pub struct TipMotion {
    /// Mean of the highest and the lowest displacement across \[m\].
    pub mean: f64,
    /// Half their difference \[m\].
    pub amplitude: f64,
    /// One over the time between two downward passages of the mean \[Hz\]; NaN where there are not two.
    pub frequency: f64,
    /// The beam.
    pub patch: SolidPatch<2>,
}

/// A period and a third with `cells`, an even number, over the height: so the length is a whole number of cells.
///
/// # Errors
/// [`Error`] of the body.
pub fn swinging_beam(cells: usize, find: FindNeighbors<2>) -> Result<TipMotion, Error> {
    let spacing = BEAM[1] / cells as f64;
    let columns = (BEAM[0] / spacing).round() as usize;
    let positions = lattice([-4.0 * spacing, -0.5 * BEAM[1]], [columns + 4, cells], spacing);
    let material = Material::elastic(IsotropicModuli::from_young_and_poisson(1.4e6, 0.4)?, 1000.0)?;
    let mut patch = SolidPatch::new(SolidStart::new(positions, spacing, material), find)?;
    patch.hold(|x| (x + Vector2::new(CYLINDER, 0.0)).norm() < CYLINDER);
    patch.body_acceleration = Vector2::new(0.0, -2.0);
    patch.evaluate();
    let dt = patch.body().stable_step(0.6);
    let mut tip = vec![0.0];
    while (tip.len() as f64) * dt < 1.33 / FREQUENCY {
        patch.step(dt);
        tip.push(end_of_middle_line(&patch, spacing));
    }
    let lowest = tip.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = tip.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mean = 0.5 * (lowest + highest);
    let downward = |k: &usize| tip[*k] > mean && tip[k + 1] <= mean;
    let passage = |k: usize| dt * (k as f64 + (tip[k] - mean) / (tip[k] - tip[k + 1]));
    let mut passages = (0..tip.len() - 1).filter(downward).map(passage);
    let period = passages.next().zip(passages.next()).map_or(f64::NAN, |(first, second)| second - first);
    Ok(TipMotion { mean, amplitude: 0.5 * (highest - lowest), frequency: 1.0 / period, patch })
}

/// Displacement across \[m\] of the middle of the end face, which is half a spacing beyond the last particles.
fn end_of_middle_line(patch: &SolidPatch<2>, spacing: f64) -> f64 {
    let across = |from_end: f64| {
        let beside = |x: &Vector2<f64>| {
            x.y.abs() < spacing && (x.x - BEAM[0] + from_end * spacing).abs() < 0.1 * spacing
        };
        patch.mean(beside, |i| patch.displacements[i].y)
    };
    1.5 * across(0.5) - 0.5 * across(1.5)
}
