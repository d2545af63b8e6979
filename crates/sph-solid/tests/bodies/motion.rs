//! Limits of motion: the longest step, the yield stress, and sums that do not depend on threads.

use crate::find::find;
use nalgebra::{Matrix2, Vector2};
use sph_solid::benchmarks::aluminium::aluminium;
use sph_solid::benchmarks::rotation::updated_controls;
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::benchmarks::stability::longest_step;
use sph_solid::{SolidPatch, SolidStart, SymmetricTensor, UpdatedPatch, YieldStress, second_stress};

const SPACING: f64 = 1e-3;

#[test]
fn steps_up_to_h_over_the_wave_speed_are_stable() {
    let (flat, solid) = (longest_step::<2>(10, find).unwrap().0, longest_step::<3>(6, find).unwrap().0);
    println!("longest stable step: {flat:.3} h/c_P in the plane, {solid:.3} in space");
    for factor in [flat, solid] {
        assert!((1.0..1.6).contains(&factor), "{factor}");
    }
}

#[test]
fn a_bar_pulled_beyond_its_strength_flows_and_keeps_the_yield_stress() {
    let mut material = aluminium(0.0).unwrap();
    material.yield_stress = Some(YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap());
    let strain_to = |temperature: f64, strain: f64| {
        let start = SolidStart::new(lattice([0.0; 2], [6, 6], SPACING), SPACING, material.clone());
        let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: 1.0, ..start }, find).unwrap();
        patch.temperatures.fill(temperature);
        patch.set_displacements(|position| Vector2::new(strain * position.x, -strain * position.y));
        (patch.stresses()[14].von_mises(), patch.equivalents[14])
    };
    let (shear, elastic) = strain_to(293.0, 1e-4);
    let expected = second_stress(
        &SymmetricTensor { in_plane: Matrix2::new(1e-4, 0.0, 0.0, -1e-4), out_of_plane: 0.0 },
        material.solver_moduli(),
    );
    assert!((shear / expected.von_mises() - 1.0).abs() < 1e-3 && elastic == 0.0);
    let (flowing, plastic) = strain_to(573.0, 5e-3);
    assert!((flowing / 45e6 - 1.0).abs() < 1e-2 && plastic > 4e-3, "{flowing} {plastic}");
    let (molten, _) = strain_to(900.0, 5e-3);
    assert!(molten < 1e-6 * 45e6, "{molten}");
}

#[test]
fn same_bits_on_one_and_two_threads() {
    let on = |threads| {
        let positions = lattice([0.0; 2], [40, 10], SPACING);
        let mut patch =
            UpdatedPatch::new(positions, aluminium(0.0).unwrap(), updated_controls(true), find).unwrap();
        for (position, velocity) in patch.positions.iter().zip(&mut patch.velocities) {
            *velocity = Vector2::new((900.0 * position.y).sin(), (700.0 * position.x).cos());
        }
        let dt = patch.stable_step(0.6);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| patch.run(20, dt));
        (patch.velocities, patch.densities)
    };
    assert_eq!(on(1), on(2));
}
