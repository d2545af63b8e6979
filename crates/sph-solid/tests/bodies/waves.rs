//! Speeds of elastic waves, from half periods of standing waves between free ends.

use crate::material::{DENSITY, POISSON, YOUNG, aluminium};
use crate::scene::{Scene, lattice};
use nalgebra::{SVector, Vector2, Vector3};
use sph_solid::{Controls, bar_speed, pressure_wave_speed, shear_wave_speed};
use std::f64::consts::PI;

const CELLS: usize = 40;
const SPACING: f64 = 1e-3;
const LENGTH: f64 = CELLS as f64 * SPACING;

/// Speed from the lowest mode cos(pi x/L) along `direction`: half a period is L/c.
fn speed<const D: usize>(counts: [usize; D], direction: SVector<f64, D>, free: SVector<f64, D>) -> f64 {
    let controls = Controls::default();
    let positions = lattice([0.0; D], counts, SPACING);
    let mut scene = Scene::new(positions, SPACING, 0.8, aluminium(0.0), controls);
    scene.free.fill(free);
    let dt = scene.body.stable_step(0.3);
    let mode = |x: &SVector<f64, D>| direction * (PI * x[0] / LENGTH).cos();
    LENGTH / scene.half_period(mode, 1e-3, dt, 2.0 * LENGTH / 3000.0)
}

#[test]
fn pressure_wave() {
    let measured = speed([CELLS, 8], Vector2::x(), Vector2::x());
    let exact = pressure_wave_speed(aluminium(0.0).solver_moduli(), DENSITY);
    println!("pressure wave {measured:.1} m/s, exact {exact:.1}");
    assert!((measured / exact - 1.0).abs() < 0.01);
}

#[test]
fn shear_wave() {
    let measured = speed([CELLS, 8], Vector2::y(), Vector2::y());
    let exact = shear_wave_speed(aluminium(0.0).solver_moduli(), DENSITY);
    println!("shear wave {measured:.1} m/s, exact {exact:.1}");
    assert!((measured / exact - 1.0).abs() < 0.01);
}

#[test]
fn bar_wave() {
    let measured = speed([CELLS, 4, 4], Vector3::x(), Vector3::repeat(1.0));
    let exact = bar_speed(aluminium(0.0).solver_moduli(), DENSITY);
    println!("bar wave {measured:.1} m/s, exact {exact:.1}");
    assert!((measured / exact - 1.0).abs() < 0.01);
}

#[test]
fn thin_plate_wave_in_plane_strain() {
    let measured = speed([CELLS, 4], Vector2::x(), Vector2::repeat(1.0));
    let exact = (YOUNG / (DENSITY * (1.0 - POISSON * POISSON))).sqrt();
    println!("plate wave {measured:.1} m/s, exact {exact:.1}");
    assert!((measured / exact - 1.0).abs() < 0.01);
}
