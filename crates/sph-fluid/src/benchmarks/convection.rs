//! Convection that warmth drives: a closed square between a hot and a cold side (de Vahl Davis 1983). Height, density, temperature difference and U = sqrt(g beta dT H) are one.

use super::fit::velocity_at;
use super::largest;
use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{
    Conduction, Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Renewal, Tait, ThermalExpansion,
};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

/// beta \[1/K\]: small enough for the reference, which lets density change in the weight only.
const EXPANSION: f64 = 0.1;
/// g = 1/beta.
const GRAVITY: f64 = 10.0;
/// Artificial speed of sound.
const SOUND_SPEED: f64 = 20.0;
const PRANDTL: f64 = 0.71;
/// Ra = g beta dT H^3/(nu a).
const RAYLEIGH: f64 = 1e4;
/// Of Ra 1e4 and Pr 0.71 (de Vahl Davis 1983): Nusselt number, and the largest horizontal speed on the upright middle line \[a/H\].
pub const NUSSELT: f64 = 2.243;
/// See [`NUSSELT`].
pub const SPEED: f64 = 16.178;
/// Time over which a measurement goes, and how often it looks.
const WINDOW: f64 = 5.0;
const LOOKS: usize = 10;

/// a = U H/sqrt(Ra Pr).
fn diffusivity() -> f64 {
    1.0 / (RAYLEIGH * PRANDTL).sqrt()
}

fn controls(spacing: f64) -> Result<FluidControls<2>, Error> {
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    Ok(FluidControls {
        dynamic_viscosity: PRANDTL * diffusivity(),
        density_diffusion: 0.1,
        body_acceleration: Vector2::new(0.0, -GRAVITY),
        thermal_expansion: Some(ThermalExpansion::new(EXPANSION, 0.5)?),
        renewal: Some(Renewal::default()),
        corrected_gradients: true,
        ..FluidControls::new(kernel, Tait::new(1.0, SOUND_SPEED, 7.0)?)
    })
}

/// Heat from the hot side and to the cold one over that without flow, and the largest horizontal speed on the upright middle line
/// \[a/H\], means over the last five of `time` units, with the fluid.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn convection(
    rows: usize,
    time: f64,
    find: FindNeighbors<2>,
) -> Result<([f64; 2], f64, FluidPatch<2>), Error> {
    let n = rows as i32;
    let inside = 0..n;
    let all = -WALL_ROWS..n + WALL_ROWS;
    let start = lattice(1.0 / rows as f64, all.clone(), all, |column, row| {
        if inside.contains(&column) && inside.contains(&row) { Site::Fluid } else { Site::Wall }
    });
    let held = |place: &Vector2<f64>| {
        let beside = (0.0..1.0).contains(&place.y) && !(0.0..1.0).contains(&place.x);
        beside.then_some(if place.x < 0.5 { 1.0 } else { 0.0 })
    };
    let start = PatchStart {
        pressure: |place: &Vector2<f64>| GRAVITY * (1.0 - place.y),
        temperature: |place: &Vector2<f64>| 1.0 - place.x,
        conduction: Some(Conduction { diffusivity: diffusivity(), heat_capacity: 1.0, held }),
        ..start
    };
    let spacing = start.spacing;
    let mut patch = FluidPatch::new(start, controls(spacing)?, find)?;
    let (mut nusselt, mut speed) = ([0.0; 2], 0.0);
    for look in 1..=LOOKS {
        let now = time - WINDOW + WINDOW * look as f64 / LOOKS as f64;
        patch.run_to(now, 0.5 * 1.5 * spacing / SOUND_SPEED);
        let sides =
            [patch.heat_taken_from(|place| place.x < 0.0), -patch.heat_taken_from(|place| place.x > 1.0)];
        nusselt = [0, 1].map(|side| nusselt[side] + sides[side] / diffusivity() / LOOKS as f64);
        let along =
            (0..rows).map(|row| velocity_at(&patch, Vector2::new(0.5, (row as f64 + 0.5) * spacing)).x);
        speed += largest(along.map(f64::abs)) / diffusivity() / LOOKS as f64;
    }
    Ok((nusselt, speed, patch))
}
