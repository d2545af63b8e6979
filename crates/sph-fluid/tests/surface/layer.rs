//! Flat layers driven by a surface temperature that rises along x.

use crate::patch::find;
use nalgebra::Vector3;
use sph_fluid::benchmarks::Scheme;
use sph_fluid::benchmarks::layer::{CLOSED_SCHEME, ClosedLayer, SCHEME, SLOPE, film, return_flow};
use sph_fluid::{FluidControls, FluidPatch, PatchStart, Renewal, SurfaceTension, Tait};
use sph_kernel::KernelKind;

#[test]
fn the_film_runs_with_the_shear_of_the_surface() {
    for renewal in [None, Some(Renewal::default())] {
        let (ratio, _) = film(8, Scheme { renewal, ..SCHEME }, find).unwrap();
        println!("film, 8 rows, renewal {}: u_s/exact {ratio:.4}", renewal.is_some());
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
    }
}

#[test]
fn the_return_flow_has_the_speed_of_birikh() {
    for (rows, mark) in [(8, 0.04), (16, 0.03)] {
        for renewal in [None, Some(Renewal::default())] {
            let (speed, force, _) = return_flow(rows, Scheme { renewal, ..SCHEME }, find).unwrap();
            let renewed = renewal.is_some();
            println!(
                "return flow, {rows} rows, renewal {renewed}: u_s/exact {speed:.4}, force/exact {force:.4}"
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
    let volumes = vec![spacing.powi(3); positions.len()];
    let start = PatchStart {
        periods: [Some(columns as f64 * spacing), None, None],
        temperature: |position: &Vector3<f64>| position.x + 3.0 * position.z,
        ..PatchStart::free(positions, volumes, spacing)
    };
    let patch = FluidPatch::new(start, controls, find).unwrap();
    let middle =
        |i: &usize| patch.positions()[*i].y > 0.0 && patch.positions()[*i].y < columns as f64 * spacing;
    let upper = |i: &usize| patch.positions()[*i].z > 0.5;
    let chosen: Vec<usize> = (0..patch.positions().len()).filter(middle).filter(upper).collect();
    let force: f64 = chosen.iter().map(|&i| patch.masses()[i] * patch.accelerations()[i].x).sum();
    let area = (columns as f64 * spacing).powi(2);
    assert!((force / (SLOPE * area) - 1.0).abs() < 0.01, "{}", force / (SLOPE * area));
    assert!(chosen.iter().all(|&i| patch.accelerations()[i].z.abs() < 1e-9));
}

#[test]
fn a_closed_layer_does_not_stall() {
    // Measured 1.001 with an L2 error of 0.072.
    let mut layer = ClosedLayer::new(8, CLOSED_SCHEME, find).unwrap();
    layer.run_to(28.0);
    let (speed, error) = layer.middle();
    println!("closed layer, 8 rows, t = 28: u_s/exact {speed:.4}, L2 {error:.3}");
    assert!((speed - 1.0).abs() < 0.05, "{speed}");
    assert!(error < 0.12, "{error}");
    // The upper rows neither pile up nor dry out: half a spacing at most over 28 time units.
    let top = layer.patch.positions().iter().map(|position| position.y).fold(0.0, f64::max);
    assert!((top - 0.9375).abs() < 0.5 * layer.patch.spacing(), "{top}");
}

#[test]
fn the_plain_scheme_stalls_in_a_closed_layer() {
    let mut layer =
        ClosedLayer::new(8, Scheme { renewal: None, corrected_gradients: false, ..CLOSED_SCHEME }, find)
            .unwrap();
    layer.run_to(28.0);
    let (speed, _) = layer.middle();
    println!("closed layer, plain scheme, 8 rows, t = 28: u_s/exact {speed:.4}");
    assert!(speed < 0.85, "the test of the cure no longer bites: {speed}");
}
