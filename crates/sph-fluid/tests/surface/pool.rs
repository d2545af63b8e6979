//! A half-sphere of melt held by a solid, under its tension: at rest, and driven by a hot spot in its middle.

use crate::patch::find;
use nalgebra::{SVector, Vector3};
use sph_fluid::{FluidControls, FluidPatch, PatchStart, Renewal, SurfaceTension, Tait};
use sph_kernel::KernelKind;

/// Radius of the pool \[m\].
const RADIUS: f64 = 0.5e-3;
/// Density and tension of liquid aluminium \[kg/m^3, N/m\].
const DENSITY: f64 = 2385.0;
const TENSION: f64 = 0.9;
/// Sixty times the viscosity of liquid aluminium \[Pa s\].
const VISCOSITY: f64 = 60.0 * 1.1e-3;
/// Artificial speed of sound \[m/s\].
const SOUND_SPEED: f64 = 10.0;
/// Temperature of the spot over the rim \[K\].
const SPOT: f64 = 50.0;

/// A pool of `across` spacings to its radius in a solid as thick as the kernel; tau_T = `slope` \[N/(m K)\].
fn pool(across: usize, slope: f64) -> FluidPatch<3> {
    let spacing = RADIUS / across as f64;
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    let controls = FluidControls {
        dynamic_viscosity: VISCOSITY,
        density_diffusion: 0.1,
        body_acceleration: Vector3::new(0.0, 0.0, -9.81),
        surface_tension: Some(SurfaceTension::new(TENSION, slope, 0.0).unwrap()),
        renewal: Some(Renewal::default()),
        ..FluidControls::new(kernel, Tait::new(DENSITY, SOUND_SPEED, 7.0).unwrap())
    };
    let n = 2 * (across as i32 + 4);
    let (mut melt, mut solid) = (Vec::new(), Vec::new());
    for k in 0..n * n * (n / 2) {
        let cell = [k % n - n / 2, k / n % n - n / 2, -(k / n / n) - 1];
        let position = SVector::<f64, 3>::from_fn(|axis, _| (f64::from(cell[axis]) + 0.5) * spacing);
        if position.norm() < RADIUS {
            melt.push(position);
        } else if position.norm() < RADIUS + 4.0 * spacing {
            solid.push(position);
        }
    }
    let volumes = vec![spacing.powi(3); melt.len()];
    let start = PatchStart {
        wall_velocities: vec![Vector3::zeros(); solid.len()],
        walls: solid,
        pressure: |position: &Vector3<f64>| -DENSITY * 9.81 * position.z,
        temperature: |position: &Vector3<f64>| {
            SPOT * (-position.xy().norm_squared() / (0.7 * RADIUS).powi(2)).exp()
        },
        ..PatchStart::free(melt, volumes, spacing)
    };
    FluidPatch::new(start, controls, find).unwrap()
}

/// Largest speed \[m/s\] of a run to `end` \[s\], and how far the farthest particle lies outside the pool \[spacings\].
fn run(patch: &mut FluidPatch<3>, end: f64) -> (f64, f64) {
    let (dt, mut largest) = (0.5 * 1.5 * patch.spacing() / SOUND_SPEED, 0.0_f64);
    while patch.time() < end {
        patch.step(dt);
        largest = largest.max(patch.largest_speed());
    }
    let outside = |position: &SVector<f64, 3>| (position.norm() - RADIUS).max(position.z) / patch.spacing();
    (largest, patch.positions().iter().map(outside).fold(f64::NEG_INFINITY, f64::max))
}

#[test]
fn a_pool_at_rest_stays_at_rest() {
    let mut patch = pool(8, 0.0);
    let (largest, outside) = run(&mut patch, 2e-3);
    let unit = (TENSION / (DENSITY * RADIUS)).sqrt();
    println!("pool at rest, R/dx 8, 2 ms: largest speed {:.2e} of the capillary speed", largest / unit);
    assert!(largest < 0.01 * unit, "{}", largest / unit);
    assert!(outside < 0.1, "{outside}");
}

#[test]
fn a_driven_pool_runs_outwards_without_noise() {
    let mut patch = pool(8, -3.5e-4);
    let (largest, outside) = run(&mut patch, 2e-3);
    // The exact Stokes flow is fastest on the surface: 0.14 of tau_T dT/eta. Particles lie below it.
    let exact = 0.14 * 3.5e-4 * SPOT / VISCOSITY;
    println!("driven pool, R/dx 8, 2 ms: largest speed {:.3} of the exact largest", largest / exact);
    assert!(largest > 0.5 * exact && largest < exact, "{}", largest / exact);
    assert!(outside < 0.5, "{outside}");
    let outward = |i: &usize| {
        let (position, velocity) = (patch.positions()[*i].xy(), patch.velocities()[*i].xy());
        position.dot(&velocity) / position.norm()
    };
    let top = |i: &usize| {
        let share = patch.positions()[*i].xy().norm() / RADIUS;
        patch.positions()[*i].z > -0.75 * patch.spacing() && share > 0.3 && share < 0.7
    };
    let upper: Vec<f64> = (0..patch.positions().len()).filter(top).map(|i| outward(&i)).collect();
    assert!(upper.len() > 50 && upper.iter().all(|&speed| speed > 0.0), "{upper:?}");
}
