//! A block of aluminium that cools when it is stretched and warms when it is pressed.

use super::aluminium::{ALPHA, DENSITY, HEAT_CAPACITY, aluminium};
use super::shapes::centred;
use crate::{Error, FindNeighbors, START_TEMPERATURE, SolidPatch, SolidStart};
use nalgebra::Vector2;

const SPACING: f64 = 1e-3;

/// Steps in which the block is stretched.
const STEPS: i32 = 10;

/// Change of temperature \[K\] of aluminium that starts at 293 K and whose volume becomes 1 + `growth` times what it was.
///
/// A unit of mass takes the heat -3 K alpha T dJ/rho_0 from the change dJ of its volume ratio: dT/T = -3 K alpha dJ/(rho_0 c), so
/// that T = T_0 exp(-3 K alpha (J - 1)/(rho_0 c)) (Kelvin 1855). To first order -0.5754 K at 1e-3.
///
/// # Errors
/// [`Error`] of the material.
pub fn exact_change(growth: f64) -> Result<f64, Error> {
    let bulk = aluminium(ALPHA)?.sound.real().bulk_pa();
    Ok(START_TEMPERATURE * (-3.0 * bulk * ALPHA * growth / (DENSITY * HEAT_CAPACITY)).exp_m1())
}

/// Change of temperature \[K\] of every particle of a block of `cells` along its edges that starts at 293 K and is stretched by
/// `strain` along x in ten steps, plane strain, by the heats that the body gives; with the block.
///
/// # Errors
/// [`Error`] of the body.
pub fn stretched(
    cells: usize,
    strain: f64,
    find: FindNeighbors<2>,
) -> Result<(Vec<f64>, SolidPatch<2>), Error> {
    let start = SolidStart::new(centred([cells; 2], SPACING), SPACING, aluminium(ALPHA)?);
    let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: 1.2, ..start }, find)?;
    let (mut heats, dt) = (vec![0.0; patch.positions().len()], 1.0 / f64::from(STEPS));
    // In one second; each step at its middle.
    patch.set_velocities(|position| Vector2::new(strain * position.x, 0.0));
    for step in 0..STEPS {
        let middle = strain * dt * (f64::from(step) + 0.5);
        patch.set_displacements(|position| Vector2::new(middle * position.x, 0.0));
        patch.gough_joule_heats(&mut heats);
        for (i, heat) in heats.iter().enumerate() {
            patch.temperatures[i] += heat * dt / (patch.body().masses()[i] * HEAT_CAPACITY);
        }
    }
    let changes = patch.temperatures.iter().map(|temperature| temperature - START_TEMPERATURE).collect();
    Ok((changes, patch))
}
