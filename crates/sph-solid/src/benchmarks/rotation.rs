//! Blocks of aluminium that turn: stress must turn with them, and a free spin keep its angular momentum and its energy.

use super::aluminium::{DENSITY, aluminium};
use super::largest;
use super::shapes::centred;
use crate::{
    Controls, Error, FindNeighbors, SolidPatch, SolidStart, SymmetricTensor, UpdatedControls, UpdatedPatch,
    strain_of_stress,
};
use nalgebra::{Matrix2, Rotation2, SVector, Vector2};
use sph_kernel::KernelKind;
use std::f64::consts::TAU;

const SPACING: f64 = 1e-3;

/// Stress that a turned block starts with \[Pa\], a deviator.
const STRESS: SymmetricTensor<2> =
    SymmetricTensor { in_plane: Matrix2::new(50e6, 20e6, 20e6, -60e6), out_of_plane: 10e6 };

/// Steps of a turn in the updated-Lagrangian form.
const STEPS: usize = 1000;

/// What changed in two turns of a free block.
#[derive(Debug)]
pub struct Spin<Patch> {
    /// Relative change of angular momentum.
    pub momentum: f64,
    /// Relative change of total energy.
    pub energy: f64,
    /// The block.
    pub patch: Patch,
}

/// Coefficients of the updated-Lagrangian form for the block's spacing: a Gaussian kernel with h/dx 1.2, the corrected form or
/// the paper's.
#[must_use]
pub fn updated_controls(paper: bool) -> UpdatedControls<2> {
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * SPACING);
    if paper { UpdatedControls::paper(kernel, SPACING) } else { UpdatedControls::corrected(kernel, SPACING) }
}

/// Largest error of the stress of a block of `cells` along its edges, turned `turns` times, over the stress it starts with,
/// Q S Q^T being exact; total Lagrangian, with the block.
///
/// # Errors
/// [`Error`] of the body.
pub fn turned(cells: usize, turns: f64, find: FindNeighbors<2>) -> Result<(f64, SolidPatch<2>), Error> {
    let material = aluminium(0.0)?;
    let strain = strain_of_stress(&STRESS, material.solver_moduli());
    let start = SolidStart::new(centred([cells; 2], SPACING), SPACING, material);
    let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: 1.2, ..start }, find)?;
    patch.strains.fill(strain * -1.0);
    let turn = *Rotation2::new(TAU * turns).matrix();
    patch.set_displacements(|position| turn * position - position);
    Ok((worst_stress(&patch.stresses(), &turned_by(&turn)), patch))
}

/// The same in the updated-Lagrangian form, in straight drifts, 1000 to a turn; with the largest relative error of density,
/// and with the block.
///
/// # Errors
/// [`Error`] of the body.
pub fn turned_updated(
    cells: usize,
    turns: usize,
    controls: UpdatedControls<2>,
    find: FindNeighbors<2>,
) -> Result<(f64, f64, UpdatedPatch<2>), Error> {
    let start = centred([cells; 2], SPACING);
    let mut patch = UpdatedPatch::new(start.clone(), aluminium(0.0)?, controls, find)?;
    patch.deviators.fill(STRESS);
    for step in 1..=turns * STEPS {
        let turn = *Rotation2::new(TAU * step as f64 / STEPS as f64).matrix();
        patch.move_to(|i| turn * start[i], 1e-6);
    }
    let stress = worst_stress(&patch.deviators, &STRESS);
    let density = largest(patch.densities.iter().map(|density| (density / DENSITY - 1.0).abs()));
    Ok((stress, density, patch))
}

/// Largest error of the deviator of a block that is sheared by `angle` in 1000 straight drifts in the updated-Lagrangian form,
/// over the shear modulus G, with the block. Jaumann's rate has S_xy = G sin(angle), S_xx = G (1 - cos(angle)) (Dienes 1979).
/// Sheared by 0.5 all particles follow it, by 1 all but those in the acute corners, whose correction fades.
///
/// # Errors
/// [`Error`] of the body.
pub fn sheared_updated(
    cells: usize,
    angle: f64,
    controls: UpdatedControls<2>,
    find: FindNeighbors<2>,
) -> Result<(f64, UpdatedPatch<2>), Error> {
    let (start, material) = (centred([cells; 2], SPACING), aluminium(0.0)?);
    let shear = material.solver_moduli().shear_pa();
    let mut patch = UpdatedPatch::new(start.clone(), material, controls, find)?;
    for step in 1..=STEPS {
        let angle = angle * step as f64 / STEPS as f64;
        patch.move_to(|i| Vector2::new(start[i].x + angle * start[i].y, start[i].y), 1e-6);
    }
    let (along, across) = (1.0 - angle.cos(), angle.sin());
    let exact = Matrix2::new(along, across, across, -along) * shear;
    let errors = patch.deviators.iter().map(|deviator| (deviator.in_plane - exact).norm() / shear);
    Ok((largest(errors), patch))
}

fn turned_by(turn: &Matrix2<f64>) -> SymmetricTensor<2> {
    SymmetricTensor { in_plane: turn * STRESS.in_plane * turn.transpose(), ..STRESS }
}

/// Largest difference over the stress at the start.
fn worst_stress(found: &[SymmetricTensor<2>], expected: &SymmetricTensor<2>) -> f64 {
    let errors = found.iter().map(|found| (*found - *expected).norm_squared() / STRESS.norm_squared());
    largest(errors).sqrt()
}

/// Two turns of a free square or cube of `cells` along its edges that turns about its z axis, its edges at 0.035 sqrt(K/rho);
/// h/dx is 1. Total Lagrangian.
///
/// # Errors
/// [`Error`] of the body.
pub fn spin<const D: usize>(
    cells: usize,
    controls: Controls,
    find: FindNeighbors<D>,
) -> Result<Spin<SolidPatch<D>>, Error> {
    let start = SolidStart::new(centred([cells; D], SPACING), SPACING, aluminium(0.0)?);
    let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: 1.0, controls, ..start }, find)?;
    let rate = spin_rate(cells)?;
    patch.set_velocities(|position| turning(position, rate));
    let angular = |patch: &SolidPatch<D>| -> f64 {
        let part = |i: usize| {
            let place = patch.positions()[i] + patch.displacements[i];
            patch.body().masses()[i] * perpendicular(&place, &patch.velocities[i])
        };
        (0..patch.positions().len()).map(part).sum()
    };
    let (momentum, energy): (f64, f64) = (angular(&patch), patch.energies().iter().sum());
    let dt = patch.body().stable_step(0.6);
    patch.run((2.0 * TAU / rate / dt) as usize, dt);
    let momentum = angular(&patch) / momentum - 1.0;
    let energy = patch.energies().iter().sum::<f64>() / energy - 1.0;
    Ok(Spin { momentum, energy, patch })
}

/// The same in 2-D in the updated-Lagrangian form.
///
/// # Errors
/// [`Error`] of the body.
pub fn spin_updated(
    cells: usize,
    controls: UpdatedControls<2>,
    find: FindNeighbors<2>,
) -> Result<Spin<UpdatedPatch<2>>, Error> {
    let mut patch = UpdatedPatch::new(centred([cells; 2], SPACING), aluminium(0.0)?, controls, find)?;
    let rate = spin_rate(cells)?;
    patch.velocities = patch.positions.iter().map(|position| turning(position, rate)).collect();
    let angular = |patch: &UpdatedPatch<2>| -> f64 {
        let part = |i: usize| patch.masses()[i] * perpendicular(&patch.positions[i], &patch.velocities[i]);
        (0..patch.positions.len()).map(part).sum()
    };
    let (momentum, energy) = (angular(&patch), patch.kinetic_energy());
    let dt = patch.stable_step(0.6);
    patch.run((2.0 * TAU / rate / dt) as usize, dt);
    let momentum = angular(&patch) / momentum - 1.0;
    let energy = (patch.kinetic_energy() + patch.elastic_energy()) / energy - 1.0;
    Ok(Spin { momentum, energy, patch })
}

/// Angular speed \[1/s\] that gives the edges of a block 0.035 sqrt(K/rho).
fn spin_rate(cells: usize) -> Result<f64, Error> {
    let sound = (aluminium(0.0)?.solver_moduli().bulk_pa() / DENSITY).sqrt();
    Ok(0.035 * sound / (0.5 * SPACING * cells as f64))
}

/// Velocity \[m/s\] of a turn about the z axis.
fn turning<const D: usize>(position: &SVector<f64, D>, rate: f64) -> SVector<f64, D> {
    SVector::from_fn(|axis, _| match axis {
        0 => -position[1] * rate,
        1 => position[0] * rate,
        _ => 0.0,
    })
}

/// z component of x cross v.
fn perpendicular<const D: usize>(place: &SVector<f64, D>, velocity: &SVector<f64, D>) -> f64 {
    place[0] * velocity[1] - place[1] * velocity[0]
}
