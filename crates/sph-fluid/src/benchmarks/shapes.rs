//! Round bodies of particles in rings and shells.

use super::Scheme;
use crate::{FluidControls, SurfaceTension, error::Error};
use nalgebra::{SVector, Vector2, Vector3};
use std::f64::consts::PI;

/// Rings about the origin, `across` spacings over the radius 1: positions and areas.
#[must_use]
pub fn rings(across: usize) -> (Vec<Vector2<f64>>, Vec<f64>) {
    let (spacing, mut positions, mut areas) = (1.0 / across as f64, Vec::new(), Vec::new());
    for ring in 0..across {
        let radius = (ring as f64 + 0.5) * spacing;
        let count = (2.0 * PI * (ring as f64 + 0.5)).round();
        for k in 0..count as usize {
            // Golden turns keep neighbouring rings from lining up.
            let angle = 2.0 * PI * (k as f64 / count + 0.381_966 * ring as f64);
            positions.push(Vector2::new(angle.cos(), angle.sin()) * radius);
            areas.push(2.0 * PI * radius * spacing / count);
        }
    }
    (positions, areas)
}

/// Shells about the origin, `across` spacings over the radius 1, each a Fibonacci lattice: positions and volumes.
#[must_use]
pub fn shells(across: usize) -> (Vec<Vector3<f64>>, Vec<f64>) {
    let (spacing, mut positions, mut volumes) = (1.0 / across as f64, Vec::new(), Vec::new());
    for shell in 0..across {
        let content = 4.0 * PI / 3.0 * (3 * shell * shell + 3 * shell + 1) as f64;
        let count = content.round();
        for k in 0..count as usize {
            let height = 1.0 - (2 * k + 1) as f64 / count;
            let angle = PI * (3.0 - 5.0_f64.sqrt()) * k as f64 + 2.4 * shell as f64;
            let around = (1.0 - height * height).sqrt();
            let direction = Vector3::new(around * angle.cos(), around * angle.sin(), height);
            positions.push(direction * ((shell as f64 + 0.5) * spacing));
            volumes.push(content * spacing.powi(3) / count);
        }
    }
    (positions, volumes)
}

/// Positions inside the ball of radius 1, cut out of a lattice with `across` spacings to the radius.
#[must_use]
pub fn cut_ball<const D: usize>(across: usize) -> Vec<SVector<f64, D>> {
    let (n, spacing) = (2 * across, 1.0 / across as f64);
    let along = |k: usize, axis: usize| (k / n.pow(axis as u32) % n) as f64 + 0.5;
    let site = |k: usize| SVector::<f64, D>::from_fn(|axis, _| along(k, axis) * spacing - 1.0);
    (0..n.pow(D as u32)).map(site).filter(|position| position.norm() < 1.0).collect()
}

/// A body with a density and a tension of one.
///
/// # Errors
/// [`Error::OutOfRange`] for a speed of sound that is not positive.
pub fn tense<const D: usize>(scheme: Scheme, spacing: f64) -> Result<FluidControls<D>, Error> {
    let surface_tension = Some(SurfaceTension::new(1.0, 0.0, 0.0)?);
    Ok(FluidControls { surface_tension, ..scheme.controls(spacing)? })
}
