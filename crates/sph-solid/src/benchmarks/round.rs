//! Disc and sphere of aluminium with a hot centre against exact stresses (Timoshenko and Goodier 1970, chapter 13).

use super::aluminium::{ALPHA, POISSON, YOUNG, aluminium};
use super::shapes::ball;
use crate::{Error, FindNeighbors, SolidPatch, SolidStart};
use nalgebra::{SMatrix, SVector};

const SPACING: f64 = 1e-3;

/// Rise of temperature at the centre \[K\]: free expansion by a thousandth.
const RISE: f64 = 1e-3 / ALPHA;

/// What was measured of a sphere.
#[derive(Debug)]
pub struct HotSphere {
    /// Relative L2 error of stress within 0.85 of the radius.
    pub error: f64,
    /// Mean stress at the centre over the exact one.
    pub centre: f64,
    /// Mean outward displacement from 0.85 of the radius on over the exact one.
    pub growth: f64,
    /// Hoop stress at the surface over the exact one: the straight line in r^2 that is nearest to the hoop stresses between
    /// half the radius and two spacings below the surface, continued to it. The outermost two rows of a lattice that is cut
    /// into a ball carry stress of their stairs.
    pub hoop: f64,
    /// The sphere.
    pub patch: SolidPatch<3>,
}

/// Relative L2 error of the in-plane stress within 0.85 R of a disc in plane strain with dT = T1 exp(-r^2/w^2), w = 0.4 R,
/// alpha T1 = 1e-3; with the disc. `cells` over the radius.
///
/// # Errors
/// [`Error`] of the body.
pub fn hot_disc(cells: usize, find: FindNeighbors<2>) -> Result<(f64, SolidPatch<2>), Error> {
    hot_disc_of(ball(cells, SPACING), cells, find)
}

/// The same of particles that need not stand on a lattice \[m\], about the origin, 1 mm apart.
///
/// # Errors
/// [`Error`] of the body.
pub fn hot_disc_of(
    positions: Vec<SVector<f64, 2>>,
    cells: usize,
    find: FindNeighbors<2>,
) -> Result<(f64, SolidPatch<2>), Error> {
    let radius = cells as f64 * SPACING;
    let width = 0.4 * radius;
    let profile = |r: f64| RISE * (-(r / width).powi(2)).exp();
    let patch = settled(positions, cells, profile, find)?;
    let mean = |r: f64| 0.5 * RISE * (width / r).powi(2) * (1.0 - (-(r / width).powi(2)).exp());
    let scale = ALPHA * YOUNG / (1.0 - POISSON);
    let error = error(&patch, radius, |x| {
        let r = x.norm();
        radial(x, scale * (mean(radius) - mean(r)), scale * (mean(radius) + mean(r) - profile(r)))
    });
    Ok((error, patch))
}

/// A sphere with dT = T1 (1 - r^2/R^2), alpha T1 = 1e-3; `cells` over the radius.
///
/// sigma_r = -0.4 S (1 - r^2/R^2), hoop S (-0.4 + 0.8 r^2/R^2), S = E alpha T1/(1 - nu); outward displacement
/// alpha T1 r ((1 + nu)(1/3 - r^2/(5 R^2)) + 4 (1 - 2 nu)/15)/(1 - nu), 0.4 alpha T1 R at the surface.
///
/// # Errors
/// [`Error`] of the body.
pub fn hot_sphere(cells: usize, find: FindNeighbors<3>) -> Result<HotSphere, Error> {
    let radius = cells as f64 * SPACING;
    let square = |r: f64| (r / radius).powi(2);
    let patch = settled(ball(cells, SPACING), cells, |r| RISE * (1.0 - square(r)), find)?;
    let scale = YOUNG * ALPHA * RISE / (1.0 - POISSON);
    let error = error(&patch, radius, |x| {
        let square = square(x.norm());
        radial(x, -0.4 * scale * (1.0 - square), scale * (-0.4 + 0.8 * square))
    });
    let stresses = patch.stresses();
    let centre = patch.mean(|x| x.norm() < SPACING, |i| stresses[i].trace() / 3.0) / (-0.4 * scale);
    let exact = |r: f64| {
        let share = (1.0 + POISSON) * (1.0 / 3.0 - 0.2 * square(r)) + 4.0 / 15.0 * (1.0 - 2.0 * POISSON);
        ALPHA * RISE * r * share / (1.0 - POISSON)
    };
    let outward = |i: usize| {
        let (position, r) = (patch.positions()[i], patch.positions()[i].norm());
        patch.displacements[i].dot(&position) / r / exact(r)
    };
    let growth = patch.mean(|x| x.norm() > 0.85 * radius, outward);
    let inner = patch.positions().iter().zip(&stresses).filter_map(|(x, stress)| {
        let hoop = 0.5 * (stress.trace() - x.normalize().dot(&(stress.in_plane * x.normalize())));
        (0.5 * radius..radius - 2.0 * SPACING).contains(&x.norm()).then(|| (square(x.norm()), hoop))
    });
    let hoop = line_at_one(inner) / (0.4 * scale);
    Ok(HotSphere { error, centre, growth, hoop, patch })
}

/// Value at 1 of the straight line nearest to points (least squares).
fn line_at_one(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut count, mut sums, mut products) = (0.0, [0.0; 2], [0.0; 2]);
    for (x, y) in points {
        count += 1.0;
        sums = [sums[0] + x, sums[1] + y];
        products = [products[0] + x * x, products[1] + x * y];
    }
    let mean = sums.map(|sum| sum / count);
    let slope = (products[1] - mean[0] * sums[1]) / (products[0] - mean[0] * sums[0]);
    mean[1] + slope * (1.0 - mean[0])
}

/// A disc or ball at rest, warmed by `rise` \[K\] of the distance from its centre \[m\].
fn settled<const D: usize>(
    positions: Vec<SVector<f64, D>>,
    cells: usize,
    rise: impl Fn(f64) -> f64,
    find: FindNeighbors<D>,
) -> Result<SolidPatch<D>, Error> {
    let mut patch = SolidPatch::new(SolidStart::new(positions, SPACING, aluminium(ALPHA)?), find)?;
    patch.set_temperatures(|position| 293.0 + rise(position.norm()));
    patch.relax(cells as f64 * SPACING);
    Ok(patch)
}

/// Relative L2 error of the in-plane stress over r < 0.85 R.
fn error<const D: usize>(
    patch: &SolidPatch<D>,
    radius: f64,
    exact: impl Fn(&SVector<f64, D>) -> SMatrix<f64, D, D>,
) -> f64 {
    let (mut wrong, mut right) = (0.0, 0.0);
    for (position, stress) in patch.positions().iter().zip(patch.stresses()) {
        if position.norm() < 0.85 * radius {
            let exact = exact(position);
            wrong += (stress.in_plane - exact).norm_squared();
            right += exact.norm_squared();
        }
    }
    f64::sqrt(wrong / right)
}

/// Radial and hoop stress as a tensor.
fn radial<const D: usize>(position: &SVector<f64, D>, radial: f64, hoop: f64) -> SMatrix<f64, D, D> {
    let outward = position.normalize();
    SMatrix::identity() * hoop + outward * outward.transpose() * (radial - hoop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_continued() {
        assert!((line_at_one([0.2, 0.5, 0.6].map(|x| (x, 3.0 - 2.0 * x)).into_iter()) - 1.0).abs() < 1e-14);
        assert!((line_at_one([(0.0, 1.0), (0.5, 0.0), (0.0, 3.0)].into_iter()) + 2.0).abs() < 1e-14);
    }
}
