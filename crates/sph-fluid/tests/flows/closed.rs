//! A closed channel under a force across it.

use crate::patch::find;
use nalgebra::Vector2;
use sph_fluid::benchmarks::channel::{Channel, DENSITY, HEIGHT};
use sph_fluid::{FluidControls, FluidPatch, PatchStart, Renewal, Tait, ThermalExpansion};
use sph_kernel::KernelKind;

#[test]
fn a_closed_channel_carries_the_weight_and_comes_to_rest() {
    let (across, force) = (12, 1e-4);
    let speed = (2.0 * force * HEIGHT).sqrt();
    let mut channel = Channel::new(across, Vector2::new(0.0, -force), 0.0, speed, find).unwrap();
    channel.run_to(1.0);
    // The force is switched on at once; what is left of the waves after 1 s was measured as 9e-5.
    assert!(channel.largest_error(|_, _| 0.0) < 2e-4 * speed);
    // From the lowest to the highest row of fluid, of rho g; measured 1.0012.
    let (positions, pressures) = (channel.patch.positions(), channel.patch.sweep().pressures());
    let last = positions.len() - 1;
    let height = positions[last].y - positions[0].y;
    let slope = (pressures[0] - pressures[last]) / height / (DENSITY * force);
    assert!((slope - 1.0).abs() < 2.5e-3, "{slope}");
}

/// Two columns of melt under their weight, warm on one side and cold on the other. With walls of fixed volume their mean density
/// rose by 40 % in this time.
#[test]
fn a_shifted_melt_between_near_walls_keeps_its_density() {
    let (columns, rows, spacing) = (2, 20, 1.0 / 28.0);
    let (mut positions, mut walls) = (Vec::new(), Vec::new());
    for column in -4..columns + 4 {
        for row in -4..rows + 4 {
            let inside = (0..columns).contains(&column) && (0..rows).contains(&row);
            let place = Vector2::new(f64::from(column) + 0.5, f64::from(row) + 0.5) * spacing;
            if inside { positions.push(place) } else { walls.push(place) }
        }
    }
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    let controls = FluidControls {
        dynamic_viscosity: 0.005,
        artificial_viscosity: 0.02,
        density_diffusion: 0.1,
        body_acceleration: Vector2::new(0.0, -50.0),
        thermal_expansion: Some(ThermalExpansion::new(0.005, 0.0).unwrap()),
        renewal: Some(Renewal::default()),
        ..FluidControls::new(kernel, Tait::new(1.0, 12.0, 7.0).unwrap())
    };
    let volumes = vec![spacing * spacing; positions.len()];
    let start = PatchStart {
        wall_velocities: vec![Vector2::zeros(); walls.len()],
        walls,
        pressure: |place: &Vector2<f64>| 50.0 * (20.0 / 28.0 - place.y),
        temperature: |place: &Vector2<f64>| 8.0 - 16.0 * 14.0 * place.x,
        ..PatchStart::free(positions, volumes, spacing)
    };
    let mut patch = FluidPatch::new(start, controls, find).unwrap();
    let mean = |patch: &FluidPatch<2>| patch.densities().iter().sum::<f64>() / patch.densities().len() as f64;
    let before = mean(&patch);
    patch.run_to(1.0, 0.5 * 1.5 * spacing / 12.0);
    println!("mean density of two columns: {before:.4}, then {:.4}", mean(&patch));
    assert!((mean(&patch) / before - 1.0).abs() < 0.02, "{before} {}", mean(&patch));
}
