//! Flat layers driven by a surface temperature that rises along x: the open film and the shallow return flow.

use crate::patch::Patch;
use nalgebra::{Vector2, Vector3};
use sph_fluid::{FluidControls, Renewal, SurfaceTension, Tait};
use sph_kernel::KernelKind;

/// tau_T of the layers; density, viscosity, height and gradient of temperature are one.
const SLOPE: f64 = -0.1;
/// Particles along x.
const COLUMNS: usize = 12;

/// A layer at rest over a wall, its surface open.
fn layer(rows: usize, renewal: Option<Renewal>) -> Patch<2> {
    let spacing = 1.0 / rows as f64;
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    let controls = FluidControls {
        dynamic_viscosity: 1.0,
        density_diffusion: 0.1,
        surface_tension: Some(SurfaceTension::new(0.0, SLOPE, 0.0).unwrap()),
        renewal,
        ..FluidControls::new(kernel, Tait::new(1.0, 5.0, 7.0).unwrap())
    };
    let site = |column: f64, row: f64| Vector2::new(column + 0.5, row + 0.5) * spacing;
    let positions: Vec<_> =
        (0..rows * COLUMNS).map(|k| site((k % COLUMNS) as f64, (k / COLUMNS) as f64)).collect();
    let walls = (0..5 * (COLUMNS + 12))
        .map(|k| site((k % (COLUMNS + 12)) as f64 - 6.0, -1.0 - (k / (COLUMNS + 12)) as f64))
        .collect();
    let masses = vec![spacing * spacing; positions.len()];
    let mut patch = Patch::new(positions, masses, walls, spacing, COLUMNS as f64 * spacing, controls);
    patch.temperature = |position| position.x;
    patch.evaluate(0.0);
    patch
}

fn step_of(patch: &Patch<2>) -> f64 {
    let length = 1.5 * patch.spacing;
    (0.125 * length * length).min(0.25 * length / 5.1)
}

/// Surface value of the fit u = a z + b z^2 through all particles.
fn surface_speed(patch: &Patch<2>) -> f64 {
    let (mut matrix, mut right) = (nalgebra::Matrix2::zeros(), Vector2::zeros());
    for i in 0..patch.fluid {
        let basis = Vector2::new(patch.positions[i].y, patch.positions[i].y.powi(2));
        matrix += basis * basis.transpose();
        right += basis * patch.velocities[i].x;
    }
    (matrix.try_inverse().unwrap() * right).sum()
}

/// Surface speed of the open film over the exact tau_T G H/eta at t = 2.
fn film(rows: usize, renewal: Option<Renewal>) -> f64 {
    let mut patch = layer(rows, renewal);
    let dt = step_of(&patch);
    while patch.time < 2.0 {
        patch.step(dt);
    }
    // What is left of the start-up: (8/pi^2) exp(-pi^2 t/4).
    surface_speed(&patch) / (SLOPE * (1.0 - 8.0 / 9.869_604 * (-9.869_604_f64 / 4.0 * patch.time).exp()))
}

/// Surface speed of the layer without net flux over the exact tau_T G H/(4 eta), and the force that holds the flux over
/// the exact 3/2 tau_T G/H.
fn return_flow(rows: usize, renewal: Option<Renewal>) -> (f64, f64) {
    let mut patch = layer(rows, renewal);
    let (dt, mut force) = (step_of(&patch), 0.0);
    while patch.time < 2.0 {
        patch.step(dt);
        let mean: f64 = patch.velocities[..patch.fluid].iter().map(|v| v.x).sum::<f64>() / patch.fluid as f64;
        patch.velocities[..patch.fluid].iter_mut().for_each(|v| v.x -= mean);
        force = -mean / dt;
    }
    (surface_speed(&patch) / (SLOPE / 4.0), force / (-1.5 * SLOPE))
}

#[test]
fn the_film_runs_with_the_shear_of_the_surface() {
    for renewal in [None, Some(Renewal::default())] {
        let ratio = film(8, renewal);
        println!("film, 8 rows, renewal {}: u_s/exact {ratio:.4}", renewal.is_some());
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
    }
}

#[test]
fn the_return_flow_has_the_speed_of_birikh() {
    for (rows, mark) in [(8, 0.04), (16, 0.03)] {
        for renewal in [None, Some(Renewal::default())] {
            let (speed, force) = return_flow(rows, renewal);
            println!(
                "return flow, {rows} rows, renewal {}: u_s/exact {speed:.4}, force/exact {force:.4}",
                renewal.is_some()
            );
            assert!((speed - 1.0).abs() < mark, "{rows}: {speed}");
        }
    }
}

/// A tilted plane of temperature: the force of Marangoni runs along the surface, and its sum is tau_T G over the area.
#[test]
fn the_driving_force_is_exact_in_three_dimensions() {
    let (rows, columns) = (8, 10);
    let spacing = 1.0 / rows as f64;
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    let controls = FluidControls {
        surface_tension: Some(SurfaceTension::new(0.0, SLOPE, 0.0).unwrap()),
        ..FluidControls::new(kernel, Tait::new(1.0, 5.0, 7.0).unwrap())
    };
    let side = columns + 12;
    let site = |k: usize| {
        Vector3::new(
            (k % columns) as f64 + 0.5,
            (k / columns % side) as f64 - 5.5,
            (k / columns / side) as f64 + 0.5,
        ) * spacing
    };
    let positions: Vec<_> = (0..columns * side * rows).map(site).collect();
    let masses = vec![spacing.powi(3); positions.len()];
    let mut patch = Patch::new(positions, masses, Vec::new(), spacing, columns as f64 * spacing, controls);
    patch.temperature = |position| position.x + 3.0 * position.z;
    patch.evaluate(0.0);
    let middle = |i: &usize| patch.positions[*i].y > 0.0 && patch.positions[*i].y < columns as f64 * spacing;
    let upper = |i: &usize| patch.positions[*i].z > 0.5;
    let chosen: Vec<usize> = (0..patch.fluid).filter(middle).filter(upper).collect();
    let force: f64 = chosen.iter().map(|&i| patch.masses[i] * patch.accelerations[i].x).sum();
    let area = (columns as f64 * spacing).powi(2);
    assert!((force / (SLOPE * area) - 1.0).abs() < 0.01, "{}", force / (SLOPE * area));
    assert!(chosen.iter().all(|&i| patch.accelerations[i].z.abs() < 1e-9));
}
