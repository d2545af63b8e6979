//! The swinging plate of rubber of Gray, Monaghan and Swift (2001), in the first mode of a cantilever.

use super::shapes::lattice;
use super::time_of_return;
use super::waves::half_period;
use crate::{
    Error, FindNeighbors, IsotropicModuli, Material, SolidPatch, SolidStart, UpdatedControls, UpdatedPatch,
};
use nalgebra::Vector2;

/// Period of Timoshenko's beam, clamped \[s\]: 1.0096 times that of a thin plate.
pub const TIMOSHENKO: f64 = 1.0096 * 0.254_13;

/// Period of converged plane-strain finite elements of the plate between strips \[s\]; published SPH has 0.283 s with 10
/// across.
pub const BETWEEN_STRIPS: f64 = 0.2616;

/// Length and height \[m\].
const PLATE: [f64; 2] = [0.2, 0.02];

/// Speed of the tip at the start \[m/s\]: a thousandth of sqrt(K/rho).
const AMPLITUDE: f64 = 0.057_009;

/// Steps over h/c_P.
const STEP: f64 = 0.6;

/// When to give up waiting for half a period \[s\].
const LONGEST: f64 = 0.25;

/// What was measured of half a period.
#[derive(Debug)]
pub struct Swing<Patch> {
    /// Period \[s\].
    pub period: f64,
    /// Relative change of total energy over half a period; what viscosity takes counts as change.
    pub energy: f64,
    /// Steps of it.
    pub steps: u64,
    /// The plate.
    pub patch: Patch,
}

fn rubber() -> Result<Material, Error> {
    Material::elastic(IsotropicModuli::from_bulk_and_shear(3.25e6, 7.15e5)?, 1000.0)
}

/// The plate with four layers behind its root.
fn clamped_plate(spacing: f64) -> Vec<Vector2<f64>> {
    let cells = (PLATE[1] / spacing).round() as usize;
    lattice([-4.0 * spacing, -0.5 * PLATE[1]], [10 * cells + 4, cells], spacing)
}

/// Total Lagrangian, `cells` over the height, clamped by the layers behind its root.
///
/// # Errors
/// [`Error`] of the body.
pub fn clamped(cells: usize, find: FindNeighbors<2>) -> Result<Swing<SolidPatch<2>>, Error> {
    let spacing = PLATE[1] / cells as f64;
    swing(SolidStart::new(clamped_plate(spacing), spacing, rubber()?), |position| position.x < 0.0, find)
}

/// Amplitude of the clamped plate in a later period (the tenth, say) over that in the first; with the plate.
///
/// # Errors
/// [`Error`] of the body.
pub fn amplitude_after(
    periods: usize,
    cells: usize,
    find: FindNeighbors<2>,
) -> Result<(f64, SolidPatch<2>), Error> {
    let spacing = PLATE[1] / cells as f64;
    let mut patch = SolidPatch::new(SolidStart::new(clamped_plate(spacing), spacing, rubber()?), find)?;
    patch.hold(|position| position.x < 0.0);
    patch.set_velocities(|x| Vector2::new(0.0, AMPLITUDE * first_mode(x.x / PLATE[0])));
    let shape = patch.velocities.clone();
    let dt = patch.body().stable_step(STEP);
    patch.evaluate();
    let mut largest_in = |steps: usize| {
        let elongation = |_| {
            patch.step(dt);
            patch.displacements.iter().zip(&shape).map(|(u, shape)| u.dot(shape)).sum::<f64>()
        };
        (0..steps).map(elongation).fold(0.0, f64::max)
    };
    let period = (TIMOSHENKO / dt).ceil() as usize;
    let first = largest_in(period);
    largest_in((periods - 2) * period);
    Ok((largest_in(period) / first, patch))
}

/// The same plate held as by Gray, Monaghan and Swift: its root, two heights deep, is free between fixed strips above and
/// below.
///
/// The first row of a strip rests in the face itself, as a boundary of finite elements does, with the half cell that lies
/// outside; two whole rows follow. A row that rests half a spacing outside holds the plate too softly (1.68 % slow with 20
/// across). Strips that move against the root, which would hold the faces too, gain energy at the strips' ends and blow up.
///
/// # Errors
/// [`Error`] of the body.
pub fn between_strips(cells: usize, find: FindNeighbors<2>) -> Result<Swing<SolidPatch<2>>, Error> {
    let spacing = PLATE[1] / cells as f64;
    let (root, half_height) = (2.0 * PLATE[1], 0.5 * PLATE[1]);
    let mut positions = lattice([-root, -half_height], [12 * cells, cells], spacing);
    let mut shares = vec![1.0; positions.len()];
    for (row, share) in [0.5, 1.0, 1.0].into_iter().enumerate() {
        let height = half_height + row as f64 * spacing;
        for x in lattice([-root, 0.0], [2 * cells, 1], spacing) {
            positions.extend([Vector2::new(x.x, height), Vector2::new(x.x, -height)]);
            shares.extend([share; 2]);
        }
    }
    let start = SolidStart { shares, ..SolidStart::new(positions, spacing, rubber()?) };
    swing(start, |x| x.y.abs() > half_height - 0.25 * spacing, find)
}

fn swing(
    start: SolidStart<2>,
    fixed: impl Fn(&Vector2<f64>) -> bool,
    find: FindNeighbors<2>,
) -> Result<Swing<SolidPatch<2>>, Error> {
    let mut patch = SolidPatch::new(start, find)?;
    patch.hold(fixed);
    let mode = |x: &Vector2<f64>| Vector2::new(0.0, first_mode(x.x / PLATE[0]));
    let half = half_period(&mut patch, mode, AMPLITUDE, STEP, LONGEST);
    let start = |i: usize| {
        let speed = AMPLITUDE * first_mode(patch.positions()[i].x / PLATE[0]) * patch.free[i].y;
        0.5 * patch.body().masses()[i] * speed * speed
    };
    let start: f64 = (0..patch.positions().len()).map(start).sum();
    let energy = patch.energies().iter().sum::<f64>() / start - 1.0;
    let steps = (patch.time / patch.body().stable_step(STEP)).round() as u64;
    Ok(Swing { period: 2.0 * half, energy, steps, patch })
}

/// The clamped plate with the updated-Lagrangian form, a whole number of the controls' spacings high.
///
/// # Errors
/// [`Error`] of the body.
pub fn updated(
    controls: UpdatedControls<2>,
    find: FindNeighbors<2>,
) -> Result<Swing<UpdatedPatch<2>>, Error> {
    let start = clamped_plate(controls.spacing);
    let mut patch = UpdatedPatch::new(start.clone(), rubber()?, controls, find)?;
    for (i, position) in start.iter().enumerate() {
        if position.x < 0.0 {
            patch.free[i] = Vector2::zeros();
        } else {
            patch.velocities[i].y = AMPLITUDE * first_mode(position.x / PLATE[0]);
        }
    }
    let shape = patch.velocities.clone();
    let (energy, dt) = (patch.kinetic_energy(), patch.stable_step(STEP));
    patch.evaluate(0.0);
    let half = time_of_return(dt, LONGEST, || {
        patch.step(dt);
        (0..start.len()).map(|i| (patch.positions[i] - start[i]).dot(&shape[i])).sum()
    });
    let energy = (patch.kinetic_energy() + patch.elastic_energy()) / energy - 1.0;
    Ok(Swing { period: 2.0 * half, energy, steps: (patch.time / dt).round() as u64, patch })
}

/// First mode of a cantilever beam, 1 at the tip (x = 1), zero behind the root.
fn first_mode(x: f64) -> f64 {
    let k: f64 = 1.875_104_068_711_961;
    let ratio = (k.cos() + k.cosh()) / (k.sin() + k.sinh());
    let shape = |x: f64| (k * x).cosh() - (k * x).cos() - ratio * ((k * x).sinh() - (k * x).sin());
    shape(x.max(0.0)) / shape(1.0)
}
