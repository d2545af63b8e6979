//! Bodies with known surfaces, and what the band measures of them.

use crate::patch::Patch;
use nalgebra::{SVector, Vector2, Vector3};
use sph_fluid::{FluidControls, SurfaceTension, Tait};
use sph_kernel::KernelKind;
use std::f64::consts::PI;

/// Rings of particles about the origin, `across` spacings over the radius 1: positions and areas.
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

/// Wendland C2 with h = 1.5 spacings, density and tension of one.
pub fn tense<const D: usize>(spacing: f64, sound_speed: f64) -> FluidControls<D> {
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    FluidControls {
        density_diffusion: 0.1,
        corrected_gradients: true,
        surface_tension: Some(SurfaceTension::new(1.0, 0.0, 0.0).unwrap()),
        ..FluidControls::new(kernel, Tait::new(1.0, sound_speed, 7.0).unwrap())
    }
}

/// Shells about the origin, `across` spacings over the radius 1, each a Fibonacci lattice: positions and volumes.
fn shells(across: usize) -> (Vec<Vector3<f64>>, Vec<f64>) {
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

/// Mean and root mean square of kappa/(D - 1) - 1 over the band of a round body of radius 1, weighted with V |grad C|, and the
/// area of the surface over the exact one.
fn round_body<const D: usize>(positions: Vec<SVector<f64, D>>, volumes: Vec<f64>, across: usize) -> [f64; 3] {
    let spacing = 1.0 / across as f64;
    let controls = tense(spacing, 15.0);
    let mut patch = Patch::new(positions, volumes.clone(), Vec::new(), spacing, f64::INFINITY, controls);
    patch.evaluate(0.0);
    let surface = patch.sweep.surface().unwrap();
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
    let mut patch = Patch::new(positions, areas.clone(), Vec::new(), spacing, period, tense(spacing, 15.0));
    patch.evaluate(0.0);
    let surface = patch.sweep.surface().unwrap();
    let length: f64 = (0..areas.len()).map(|i| 2.0 * surface.gradients()[i].norm() * areas[i]).sum();
    // Two faces.
    assert!((length / (2.0 * period) - 1.0).abs() < 0.01, "{length}");
    assert!(surface.curvatures().iter().all(|kappa| kappa.abs() < 1e-9));
    assert!(patch.accelerations.iter().all(|a: &Vector2<f64>| a.norm() < 1e-9));
}
