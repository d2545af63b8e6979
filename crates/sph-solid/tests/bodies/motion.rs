//! Limits of motion: the longest step, the yield stress, and sums that do not depend on threads.

use crate::find::find;
use nalgebra::{Matrix2, SVector, Vector2};
use sph_solid::benchmarks::aluminium::aluminium;
use sph_solid::benchmarks::rotation::updated_controls;
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::{
    FindNeighbors, SolidPatch, SolidStart, SymmetricTensor, UpdatedPatch, YieldStress, second_stress,
};

const SPACING: f64 = 1e-3;

/// Kinetic energy after `steps` steps of `factor` h/c_P over that of the noise at the start.
fn grown<const D: usize>(cells: usize, ratio: f64, factor: f64, steps: usize, find: FindNeighbors<D>) -> f64 {
    let start = SolidStart::new(lattice([0.0; D], [cells; D], SPACING), SPACING, aluminium(0.0).unwrap());
    let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: ratio, ..start }, find).unwrap();
    for (k, velocity) in patch.velocities.iter_mut().enumerate() {
        *velocity = SVector::from_fn(|axis, _| (12.9 * k as f64 + 7.7 * axis as f64).sin() * 1e-4);
    }
    let start: f64 = patch.energies().iter().sum();
    let dt = patch.body().stable_step(factor);
    patch.run(steps, dt);
    patch.energies()[0] / start
}

#[test]
fn steps_up_to_h_over_the_wave_speed_are_stable() {
    for factor in [0.6, 1.0] {
        assert!(grown::<2>(10, 1.2, factor, 600, find) < 2.0);
        assert!(grown::<3>(6, 0.8, factor, 300, find) < 2.0);
    }
    let (flat, solid) = (grown::<2>(10, 1.2, 1.6, 600, find), grown::<3>(6, 0.8, 1.6, 300, find));
    assert!(!(flat < 1e3 || solid < 1e3), "the limit is where it should be: {flat} {solid}");
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
