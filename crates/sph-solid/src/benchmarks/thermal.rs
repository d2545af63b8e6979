//! Blocks of aluminium that are warmed as a whole, free or held, against linear thermoelasticity (Timoshenko and Goodier 1970,
//! chapter 13).

use super::aluminium::{ALPHA, POISSON, YOUNG, aluminium};
use super::largest;
use super::shapes::centred;
use crate::{Error, FindNeighbors, SolidPatch, SolidStart, SymmetricTensor, YieldStress};
use nalgebra::SVector;

const SPACING: f64 = 1e-3;

/// Layers at an end that are held.
const CLAMP: f64 = 4.0 * SPACING;

/// What is left of a free block's expansion.
#[derive(Debug)]
pub struct FreeExpansion<const D: usize> {
    /// Largest stress of all particles over E alpha dT.
    pub stress: f64,
    /// Largest relative error of displacement.
    pub displacement: f64,
    /// The block.
    pub patch: SolidPatch<D>,
}

/// A free square or cube of `cells` along its edges, warmed until alpha dT is `strain`; h/dx is `ratio`.
///
/// # Errors
/// [`Error`] of the body.
pub fn free_expansion<const D: usize>(
    cells: usize,
    ratio: f64,
    strain: f64,
    find: FindNeighbors<D>,
) -> Result<FreeExpansion<D>, Error> {
    let start = SolidStart::new(centred([cells; D], SPACING), SPACING, aluminium(ALPHA)?);
    let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: ratio, ..start }, find)?;
    patch.set_temperatures(|_| 293.0 + strain / ALPHA);
    let half = 0.5 * SPACING * cells as f64;
    patch.relax(half);
    patch.relax(half);
    let stress = largest(patch.stresses().iter().map(|stress| stress.in_plane.norm()));
    // In plane strain the held third axis adds Poisson's share.
    let free = if D == 3 { strain.exp() - 1.0 } else { (1.0 + POISSON) * strain };
    let errors = patch.positions().iter().zip(&patch.displacements).map(|(position, displacement)| {
        let expected = position * free;
        (displacement - expected).norm() / expected.norm()
    });
    let displacement = largest(errors);
    Ok(FreeExpansion { stress: stress / (YOUNG * strain), displacement, patch })
}

/// Stress \[Pa\] in the middle of a body of `counts` cells, 4 layers of which are held at both ends of the first `held` axes,
/// after a rise by `warming` \[K\]; with the body. Exact is -E alpha dT of a bar held along, 1/(1 - nu) times it of a plate,
/// 1/(1 - 2 nu) of a block held on all sides.
///
/// # Errors
/// [`Error`] of the body.
pub fn held<const D: usize>(
    counts: [usize; D],
    held: usize,
    warming: f64,
    find: FindNeighbors<D>,
) -> Result<(SymmetricTensor<D>, SolidPatch<D>), Error> {
    let start = SolidStart::new(centred(counts, SPACING), SPACING, aluminium(ALPHA)?);
    let mut patch = SolidPatch::new(start, find)?;
    hold_ends(&mut patch, &counts, held);
    patch.set_temperatures(|_| 293.0 + warming);
    patch.relax(0.5 * SPACING * counts.iter().copied().fold(0, usize::max) as f64);
    Ok((middle_stress(&patch), patch))
}

/// Stress \[Pa\] along a bar that is held at its ends, warmed by 100 K, hot, and cold again: its yield stress falls from 100 MPa
/// at 293 K to zero at 853 K, so that it is squeezed at 393 K and pulled at 293 K.
///
/// # Errors
/// [`Error`] of the body.
pub fn yielding_bar(find: FindNeighbors<3>) -> Result<[f64; 2], Error> {
    let (counts, mut material) = ([8, 4, 4], aluminium(ALPHA)?);
    material.yield_stress = Some(YieldStress::falling_to_zero(100e6, 293.0, 853.0)?);
    let mut patch = SolidPatch::new(SolidStart::new(centred(counts, SPACING), SPACING, material), find)?;
    hold_ends(&mut patch, &counts, 1);
    // Slowly: when steps of 10 K go round the bar as waves, they make its sides flow first, and the result is 2 % off.
    let mut bring_to = |rise: i32| {
        patch.set_temperatures(|_| 293.0 + f64::from(rise));
        patch.relax(SPACING);
        middle_stress(&patch).in_plane[(0, 0)]
    };
    let hot = (1..=100).map(&mut bring_to).fold(0.0, |_, now| now);
    let cold = (0..100).rev().map(&mut bring_to).fold(0.0, |_, now| now);
    Ok([hot, cold])
}

/// Holds 4 layers at both ends of the first `held` axes, each along its axis.
fn hold_ends<const D: usize>(patch: &mut SolidPatch<D>, counts: &[usize; D], held: usize) {
    for i in 0..patch.free.len() {
        for axis in 0..held {
            if patch.positions()[i][axis].abs() > 0.5 * SPACING * counts[axis] as f64 - CLAMP {
                patch.free[i][axis] = 0.0;
            }
        }
    }
}

/// Mean stress \[Pa\] within two spacings of the origin.
fn middle_stress<const D: usize>(patch: &SolidPatch<D>) -> SymmetricTensor<D> {
    let stresses = patch.stresses();
    let inside = |position: &SVector<f64, D>| position.norm() < 2.0 * SPACING;
    let middle = || patch.positions().iter().zip(&stresses).filter(|(position, _)| inside(position));
    let sum = middle().fold(SymmetricTensor::zero(), |sum, (_, stress)| sum + *stress);
    sum * (1.0 / middle().count() as f64)
}
