//! A plate clamped at its rim whose upper face is heated beyond melting in a spot and cools: residual stress in three
//! dimensions, with yield, against finite elements.

use super::aluminium::{ALPHA, aluminium};
use super::shapes::lattice;
use crate::{Error, FindNeighbors, SolidPatch, SolidStart, SymmetricTensor, YieldStress};
use nalgebra::{Matrix3, Vector3};

const SPACING: f64 = 1e-3;
/// Layers of held particles beyond the rim: more than the reach of a kernel.
const RIM: usize = 3;
/// Steps from cold to hot, and as many back.
const LEVELS: u32 = 100;
const RISE: f64 = 700.0;

/// Residual stress \[MPa\] of `data/clamped_plate_reference.py 64 200`, every 0.025 R from 0.0125 R: 36 radii, 20 depths each. Against
/// it, 24 and 40 cells over the radius are off by 4.7 and 1.4 % in the norm of [`ClampedPlate::error`], 100 levels by 0.03 %.
const REFERENCE: &str = include_str!("../../data/clamped_plate.csv");
const STEP: f64 = 0.025;
const DEPTHS: usize = 20;

/// What was found of the plate.
#[derive(Debug)]
pub struct ClampedPlate {
    /// Relative L2 error of stress, r from 0.1 to 0.85 R, depth from 0.1 to 0.4 R (a fifth of the thickness off either face).
    pub error: f64,
    /// Largest von Mises stress over the yield stress of cold material.
    pub strength: f64,
    /// The plate.
    pub patch: SolidPatch<3>,
}

/// A plate of radius R, `cells` spacings, and thickness R/2, with T = 293 K + 700 K f exp(-(r^2 + d^2)/(0.4 R)^2), d the
/// depth below the upper face, f from 0 to 1 and back; yield stress 90 MPa at 293 K, zero from 853 K on.
///
/// # Errors
/// [`Error`] of the body.
pub fn clamped_plate(cells: usize, find: FindNeighbors<3>) -> Result<ClampedPlate, Error> {
    let cold_yield = 90e6;
    let radius = cells as f64 * SPACING;
    let mut material = aluminium(ALPHA)?;
    material.yield_stress = Some(YieldStress::falling_to_zero(cold_yield, 293.0, 853.0)?);
    let mut patch = SolidPatch::new(SolidStart::new(positions(cells), SPACING, material), find)?;
    patch.hold(|position| position.xy().norm() > radius);
    let spot = |x: &Vector3<f64>| RISE * (-x.norm_squared() / (0.4 * radius).powi(2)).exp();
    for level in (1..=LEVELS).chain((0..LEVELS).rev()) {
        let share = f64::from(level) / f64::from(LEVELS);
        patch.set_temperatures(|x| 293.0 + share * spot(x));
        patch.settle(radius, 1.6);
    }
    patch.relax(radius);
    let stresses = patch.stresses();
    let strength = super::largest(stresses.iter().map(SymmetricTensor::von_mises)) / cold_yield;
    Ok(ClampedPlate { error: error(&patch, &stresses, radius), strength, patch })
}

/// Cells of the plate and its held rim; the upper face is z = 0.
fn positions(cells: usize) -> Vec<Vector3<f64>> {
    let half = cells + RIM;
    let low = -(half as f64) * SPACING;
    let depth = cells / 2;
    let all = lattice([low, low, -(depth as f64) * SPACING], [2 * half, 2 * half, depth], SPACING);
    all.into_iter().filter(|x| x.xy().norm() < half as f64 * SPACING).collect()
}

fn error(patch: &SolidPatch<3>, stresses: &[SymmetricTensor<3>], radius: f64) -> f64 {
    let reference = reference();
    let (mut wrong, mut right) = (0.0, 0.0);
    for (position, stress) in patch.positions().iter().zip(stresses) {
        let (r, depth) = (position.xy().norm() / radius, -position.z / radius);
        if (0.1..0.85).contains(&r) && (0.1..0.4).contains(&depth) {
            let exact = SymmetricTensor { in_plane: at(&reference, position, r, depth), out_of_plane: 0.0 };
            wrong += (*stress - exact).norm_squared();
            right += exact.norm_squared();
        }
    }
    f64::sqrt(wrong / right)
}

/// Radial, hoop, axial and shear stress \[Pa\] of all radii and depths; a line that cannot be read is no number.
fn reference() -> Vec<[f64; 4]> {
    let number = |text: Option<&str>| text.and_then(|text| text.parse::<f64>().ok()).unwrap_or(f64::NAN);
    let line = |line: &str| {
        let mut columns = line.split(',').skip(2);
        std::array::from_fn(|_| 1e6 * number(columns.next()))
    };
    REFERENCE.lines().skip(1).map(line).collect()
}

/// The reference at a place, linear between its nodes, in Cartesian axes \[Pa\].
fn at(reference: &[[f64; 4]], position: &Vector3<f64>, r: f64, depth: f64) -> Matrix3<f64> {
    let (across, down) = (r / STEP - 0.5, depth / STEP - 0.5);
    let (i, j) = (across as usize, down as usize);
    let (right, below) = (across.fract(), down.fract());
    let node = |i: usize, j: usize, k: usize| reference[i * DEPTHS + j][k];
    let [radial, hoop, axial, shear]: [f64; 4] = std::array::from_fn(|k| {
        let near = node(i, j, k) * (1.0 - below) + node(i, j + 1, k) * below;
        let far = node(i + 1, j, k) * (1.0 - below) + node(i + 1, j + 1, k) * below;
        near * (1.0 - right) + far * right
    });
    let outward = Vector3::new(position.x, position.y, 0.0).normalize();
    let around = Vector3::z().cross(&outward);
    let up = Vector3::z();
    outward * outward.transpose() * radial
        + around * around.transpose() * hoop
        + up * up.transpose() * axial
        + (outward * up.transpose() + up * outward.transpose()) * shear
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_is_whole_and_free_at_its_faces() {
        let reference = reference();
        assert_eq!(reference.len(), 36 * DEPTHS);
        assert!(reference.iter().flatten().all(|stress| stress.is_finite()));
        // Next to the faces what acts on them is small against the stress along them.
        for i in 0..30 {
            let [radial, hoop, axial, shear] = reference[i * DEPTHS];
            assert!(axial.abs().max(shear.abs()) < 0.1 * radial.hypot(hoop), "{i}");
        }
    }
}
