//! Bodies with known surfaces, and what the band measures of them.

use crate::patch::find;
use nalgebra::{SVector, Vector2};
use sph_fluid::benchmarks::drop::SCHEME;
use sph_fluid::benchmarks::shapes::{rings, shells, tense};
use sph_fluid::{FluidControls, FluidPatch, PatchStart, SurfaceModel};
use std::f64::consts::PI;

/// Mean and root mean square of kappa/(D - 1) - 1 over the band of a round body of radius 1, weighted with V |grad C|, and the
/// area of the surface over the exact one.
fn round_body<const D: usize>(positions: Vec<SVector<f64, D>>, volumes: Vec<f64>, across: usize) -> [f64; 3] {
    let spacing = 1.0 / across as f64;
    let start = PatchStart::free(positions, volumes.clone(), spacing);
    let patch = FluidPatch::new(start, tense(SCHEME, spacing).unwrap(), find).unwrap();
    let surface = patch.sweep().surface().unwrap();
    let weight = |i: usize| surface.gradients()[i].norm() * volumes[i];
    let band: Vec<usize> = (0..volumes.len()).filter(|&i| surface.flags()[i]).collect();
    let total: f64 = band.iter().map(|&i| weight(i)).sum();
    let error = |i: usize| surface.curvatures()[i] / (D - 1) as f64 - 1.0;
    let mean = band.iter().map(|&i| weight(i) * error(i)).sum::<f64>() / total;
    let square = band.iter().map(|&i| weight(i) * error(i).powi(2)).sum::<f64>() / total;
    let exact = if D == 2 { 2.0 * PI } else { 4.0 * PI };
    let area: f64 = (0..volumes.len()).map(|i| 2.0 * weight(i)).sum();
    [mean, square.sqrt(), area / exact]
}

#[test]
fn curvature_of_rings_and_shells() {
    for across in [10, 20, 40] {
        let (positions, areas) = rings(across);
        let [mean, root, length] = round_body(positions, areas, across);
        println!("rings R/dx {across}: curvature {mean:+.4} mean, {root:.4} rms; length {length:.4}");
        assert!(mean.abs() < 0.01 && root < 0.02, "{across}: {mean} {root}");
    }
    let (positions, volumes) = shells(10);
    let [mean, root, area] = round_body(positions, volumes, 10);
    println!("shells R/dx 10: curvature {mean:+.4} mean, {root:.4} rms; area {area:.4}");
    assert!(mean.abs() < 0.01 && root < 0.02, "{mean} {root}");
}

#[test]
fn a_plane_has_its_area_and_no_curvature() {
    let (rows, columns) = (12, 16);
    let spacing = 1.0 / rows as f64;
    let site = |k: usize| Vector2::new((k % columns) as f64 + 0.5, (k / columns) as f64 + 0.5) * spacing;
    let positions: Vec<_> = (0..rows * columns).map(site).collect();
    let areas = vec![spacing * spacing; positions.len()];
    let period = columns as f64 * spacing;
    let start =
        PatchStart { periods: [Some(period), None], ..PatchStart::free(positions, areas.clone(), spacing) };
    let patch = FluidPatch::new(start, tense(SCHEME, spacing).unwrap(), find).unwrap();
    let surface = patch.sweep().surface().unwrap();
    let length: f64 = (0..areas.len()).map(|i| 2.0 * surface.gradients()[i].norm() * areas[i]).sum();
    // Two faces.
    assert!((length / (2.0 * period) - 1.0).abs() < 0.01, "{length}");
    assert!(surface.curvatures().iter().all(|kappa| kappa.abs() < 1e-9));
    assert!(patch.accelerations().iter().all(|a: &Vector2<f64>| a.norm() < 1e-9));
}

#[test]
fn a_crowd_below_the_rows_of_a_surface_is_no_surface() {
    // A particle more, half a spacing below the third row: the gradient at the particle above it is 0.24/h, towards the body as at a
    // surface, and its colour 1.2.
    let (rows, columns) = (12, 16);
    let spacing = 1.0 / rows as f64;
    let site = |k: usize| Vector2::new((k % columns) as f64 + 0.5, (k / columns) as f64 + 0.5) * spacing;
    let mut positions: Vec<_> = (0..rows * columns).map(site).collect();
    let (crowded, deeper) = (9 * columns + 8, 7 * columns + 8);
    positions.push(positions[crowded] - Vector2::new(0.0, 0.5 * spacing));
    let areas = vec![spacing * spacing; positions.len()];
    let period = columns as f64 * spacing;
    let start = PatchStart { periods: [Some(period), None], ..PatchStart::free(positions, areas, spacing) };
    let patch = FluidPatch::new(start, tense(SCHEME, spacing).unwrap(), find).unwrap();
    let surface = patch.sweep().surface().unwrap();
    let steepness = surface.gradients()[crowded].norm() * 1.5 * spacing;
    assert!(steepness > 0.2, "{steepness}");
    assert!(!surface.flags()[crowded] && surface.flags()[11 * columns + 8]);
    // Out of reach of the two rows of the surface: no plane, no curvature, no force of tension.
    assert_eq!((surface.planes()[deeper].1, surface.curvatures()[deeper]), (f64::INFINITY, 0.0));
}

/// sum m a.x of a round body of radius 1 without pressure, over -(D - 1) tau A, what tension along its area A does: the pressure that a
/// stress of the surface makes over Laplace's.
fn virial<const D: usize>(
    (positions, volumes): (Vec<SVector<f64, D>>, Vec<f64>),
    across: usize,
    corrected_gradients: bool,
) -> f64 {
    let spacing = 1.0 / across as f64;
    let surface_model = SurfaceModel::Stress;
    let controls = FluidControls { surface_model, corrected_gradients, ..tense(SCHEME, spacing).unwrap() };
    let patch = FluidPatch::new(PatchStart::free(positions, volumes, spacing), controls, find).unwrap();
    let forces = patch.masses().iter().zip(patch.accelerations());
    let sum: f64 =
        forces.zip(patch.positions()).map(|((mass, acceleration), x)| mass * acceleration.dot(x)).sum();
    let exact = if D == 2 { -2.0 * PI } else { -8.0 * PI };
    sum / exact
}

#[test]
fn a_stress_of_the_surface_has_its_tension_in_the_plane_and_in_space() {
    for corrected in [false, true] {
        let circle = virial(rings(20), 20, corrected);
        let sphere = virial(shells(10), 10, corrected);
        println!(
            "stress, corrected gradients {corrected}: circle R/dx 20 {circle:.4}, sphere R/dx 10 {sphere:.4}"
        );
        assert!((circle - 1.0).abs() < 0.02, "{circle}");
        assert!((sphere - 1.0).abs() < 0.04, "{sphere}");
    }
}
