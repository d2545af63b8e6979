//! Disc and sphere with a hot centre (Timoshenko and Goodier 1970, chapter 13).

use crate::material::{ALPHA, DENSITY, POISSON, YOUNG, aluminium};
use crate::scene::{Scene, ball};
use nalgebra::{SMatrix, SVector};
use sph_solid::{Controls, pressure_wave_speed};

const SPACING: f64 = 1e-3;

fn scene<const D: usize>(positions: Vec<SVector<f64, D>>, ratio: f64) -> Scene<D> {
    Scene::new(positions, SPACING, ratio, aluminium(ALPHA), Controls::default())
}

fn wave_speed() -> f64 {
    pressure_wave_speed(aluminium(ALPHA).solver_moduli(), DENSITY)
}

/// Relative L2 error of the in-plane stress over r < 0.85 R.
fn error<const D: usize>(
    scene: &Scene<D>,
    radius: f64,
    exact: impl Fn(&SVector<f64, D>) -> SMatrix<f64, D, D>,
) -> f64 {
    let (mut wrong, mut right) = (0.0, 0.0);
    for (position, stress) in scene.positions.iter().zip(scene.stresses()) {
        if position.norm() < 0.85 * radius {
            wrong += (stress.in_plane - exact(position)).norm_squared();
            right += exact(position).norm_squared();
        }
    }
    f64::sqrt(wrong / right)
}

/// Radial and hoop stress as a tensor.
fn radial<const D: usize>(position: &SVector<f64, D>, radial: f64, hoop: f64) -> SMatrix<f64, D, D> {
    let outward = position.normalize();
    SMatrix::identity() * hoop + outward * outward.transpose() * (radial - hoop)
}

/// Relative L2 error of the in-plane stress within 0.85 R, disc in plane strain, T = T1 exp(-r^2/w^2), w = 0.4 R, alpha T1 = 1e-3.
pub fn disc_error(cells: usize, ratio: f64) -> f64 {
    let (radius, rise) = (cells as f64 * SPACING, 1e-3 / ALPHA);
    let width = 0.4 * radius;
    let mut scene = scene(ball::<2>(cells, SPACING), ratio);
    let profile = |r: f64| rise * (-(r / width).powi(2)).exp();
    for (position, temperature) in scene.positions.iter().zip(&mut scene.temperatures) {
        *temperature += profile(position.norm());
    }
    scene.relax(radius, wave_speed());
    let mean = |r: f64| 0.5 * rise * (width / r).powi(2) * (1.0 - (-(r / width).powi(2)).exp());
    let scale = ALPHA * YOUNG / (1.0 - POISSON);
    error(&scene, radius, |x| {
        let r = x.norm();
        radial(x, scale * (mean(radius) - mean(r)), scale * (mean(radius) + mean(r) - profile(r)))
    })
}

/// The same for a sphere with T = T1 (1 - r^2/R^2), alpha T1 = 1e-3, and the stress at its centre over the exact one.
///
/// sigma_r = -0.4 S (1 - r^2/R^2), hoop S (-0.4 + 0.8 r^2/R^2), S = E alpha T1/(1 - nu).
pub fn sphere(cells: usize) -> (f64, f64) {
    let (radius, rise) = (cells as f64 * SPACING, 1e-3 / ALPHA);
    let mut scene = scene(ball::<3>(cells, SPACING), 0.8);
    let square = |x: &SVector<f64, 3>| x.norm_squared() / (radius * radius);
    for (position, temperature) in scene.positions.iter().zip(&mut scene.temperatures) {
        *temperature += rise * (1.0 - square(position));
    }
    scene.relax(radius, wave_speed());
    let scale = YOUNG * 1e-3 / (1.0 - POISSON);
    let exact =
        |x: &SVector<f64, 3>| radial(x, -0.4 * scale * (1.0 - square(x)), scale * (-0.4 + 0.8 * square(x)));
    let error = error(&scene, radius, exact);
    let stresses = scene.stresses();
    let centre = scene.mean(|x| x.norm() < SPACING, |i| stresses[i].trace() / 3.0) / (-0.4 * scale);
    (error, centre)
}
