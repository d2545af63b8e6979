//! Motion: bending, spin, and what must not change with them.

use crate::material::{DENSITY, aluminium};
use crate::plate;
use crate::scene::{Scene, lattice};
use nalgebra::{Matrix2, SMatrix, SVector, Vector2};
use sph_solid::{Controls, SymmetricTensor, gough_joule_rate, second_stress, strain_of_stress};
use std::f64::consts::TAU;

#[test]
fn plate_swings_with_the_period_of_timoshenkos_beam() {
    // Timoshenko's period is 1.0096 of the thin plate's.
    for (cells, mark) in [(5, 0.06), (10, 0.02)] {
        let (period, energy) = plate::total(cells, 0.8);
        println!("plate, {cells} across: period {period:.4} of the thin plate's, energy {energy:.1e}");
        assert!((period / 1.0096 - 1.0).abs() < mark, "{period} at {cells}");
        assert!(energy.abs() < 1e-4, "{energy} at {cells}");
    }
}

/// Angular momentum and energy after two turns of a free block at 0.035 c at its edges, relative to their start.
fn spinning_block<const D: usize>(cells: usize, hourglass: f64) -> (f64, f64) {
    let (spacing, half) = (1e-3, 0.5e-3 * cells as f64);
    let controls = Controls { hourglass, viscosity: 0.0 };
    let positions = lattice([-half; D], [cells; D], spacing);
    let mut scene = Scene::new(positions, spacing, 1.0, aluminium(0.0), controls);
    let spin = 0.035 * (aluminium(0.0).solver_moduli().bulk_pa() / DENSITY).sqrt() / half;
    for (position, velocity) in scene.positions.iter().zip(&mut scene.velocities) {
        (velocity[0], velocity[1]) = (-position[1] * spin, position[0] * spin);
    }
    let angular = |scene: &Scene<D>| -> f64 {
        let part = |i: usize| {
            let (x, v) = (scene.positions[i] + scene.displacements[i], scene.velocities[i]);
            (x[0] * v[1] - x[1] * v[0]) * scene.body.masses()[i]
        };
        (0..scene.positions.len()).map(part).sum()
    };
    let (momentum, energy): (f64, f64) = (angular(&scene), scene.energies().iter().sum());
    let dt = scene.body.stable_step(0.6);
    scene.run((2.0 * TAU / spin / dt) as usize, dt, 0.0);
    let turned = scene.body.deformations()[cells / 2];
    assert!((turned - SMatrix::identity()).norm() < 0.2, "it has turned twice: {turned}");
    (angular(&scene) / momentum - 1.0, scene.energies().iter().sum::<f64>() / energy - 1.0)
}

#[test]
fn plate_between_strips_swings_as_finite_elements_say() {
    // Converged plane-strain finite elements: 0.2616 s; published SPH at 10 across 0.283 s.
    let (period, energy) = plate::between_strips(10, 0.8);
    println!("plate between strips, 10 across: period {period:.4} s, energy {energy:.1e}");
    assert!((period / 0.2616 - 1.0).abs() < 0.03, "{period}");
    assert!(energy.abs() < 1e-4, "{energy}");
}

#[test]
fn a_free_spin_keeps_angular_momentum_and_energy() {
    for hourglass in [0.0, 0.3] {
        for (dimension, (momentum, energy)) in
            [(2, spinning_block::<2>(10, hourglass)), (3, spinning_block::<3>(6, hourglass))]
        {
            println!(
                "spin {dimension}-D, hourglass {hourglass}: angular momentum {momentum:.1e}, energy {energy:.1e}"
            );
            assert!(momentum.abs() < 1e-8 && energy.abs() < 1e-4, "{momentum} {energy}");
        }
    }
}

#[test]
fn stress_turns_with_the_body_for_ten_turns() {
    let spacing = 1e-3;
    let moduli = *aluminium(0.0).solver_moduli();
    let stress = SymmetricTensor { in_plane: Matrix2::new(50e6, 20e6, 20e6, -30e6), out_of_plane: 10e6 };
    let mut scene =
        Scene::new(lattice([0.0; 2], [8, 8], spacing), spacing, 1.2, aluminium(0.0), Controls::default());
    scene.strains.fill(strain_of_stress(&stress, &moduli) * -1.0);
    for turns in [0.0, 0.3, 5.2, 10.0] {
        let rotation = *nalgebra::Rotation2::new(TAU * turns).matrix();
        for (position, displacement) in scene.positions.iter().zip(&mut scene.displacements) {
            *displacement = rotation * position - position;
        }
        scene.refresh();
        let expected = rotation * stress.in_plane * rotation.transpose();
        for found in scene.stresses() {
            assert!((found.in_plane - expected).norm() < 1e-7 * 50e6, "{turns} turns");
            assert!((found.out_of_plane - 10e6).abs() < 1e-7 * 50e6, "{turns} turns");
        }
    }
}

#[test]
fn a_compressed_block_warms_as_gough_and_joule_say() {
    // Uniaxial, -1e-3, in ten steps; the same with the opposite sign cools by 0.5754 K.
    let spacing = 1e-3;
    let mut scene =
        Scene::new(lattice([0.0; 2], [8, 8], spacing), spacing, 1.2, aluminium(0.0), Controls::default());
    let bulk = aluminium(0.0).sound.real().bulk_pa();
    for (sign, exact) in [(1.0, -0.5754), (-1.0, 0.5754)] {
        let mut temperatures = vec![293.0; 64];
        let mut volumes = vec![1.0; 64];
        for step in 1..=10 {
            let strain = sign * 1e-4 * f64::from(step);
            for (position, displacement) in scene.positions.iter().zip(&mut scene.displacements) {
                *displacement = Vector2::new(strain * position.x, 0.0);
            }
            scene.refresh();
            for i in 0..64 {
                let volume = scene.body.deformations()[i].determinant();
                temperatures[i] += gough_joule_rate(
                    bulk,
                    23.1e-6,
                    temperatures[i],
                    (volume / volumes[i]).ln(),
                    DENSITY,
                    897.0,
                );
                volumes[i] = volume;
            }
        }
        for temperature in temperatures {
            assert!(((temperature - 293.0) / exact - 1.0).abs() < 2e-3, "{temperature}");
        }
    }
}

/// Kinetic energy after `steps` steps of `factor` h/c_P over that of the noise at the start.
fn grown<const D: usize>(cells: usize, ratio: f64, factor: f64, steps: usize) -> f64 {
    let spacing = 1e-3;
    let positions = lattice([0.0; D], [cells; D], spacing);
    let mut scene = Scene::new(positions, spacing, ratio, aluminium(0.0), Controls::default());
    for (k, velocity) in scene.velocities.iter_mut().enumerate() {
        *velocity = SVector::from_fn(|axis, _| (12.9 * k as f64 + 7.7 * axis as f64).sin() * 1e-4);
    }
    let start: f64 = scene.energies().iter().sum();
    let dt = scene.body.stable_step(factor);
    scene.run(steps, dt, 0.0);
    scene.energies()[0] / start
}

#[test]
fn steps_up_to_h_over_the_wave_speed_are_stable() {
    for factor in [0.6, 1.0] {
        assert!(grown::<2>(10, 1.2, factor, 600) < 2.0);
        assert!(grown::<3>(6, 0.8, factor, 300) < 2.0);
    }
    let (flat, solid) = (grown::<2>(10, 1.2, 1.6, 600), grown::<3>(6, 0.8, 1.6, 300));
    assert!(!(flat < 1e3 || solid < 1e3), "the limit is where it should be: {flat} {solid}");
}

#[test]
fn a_bar_pulled_beyond_its_strength_flows_and_keeps_the_yield_stress() {
    let mut material = aluminium(0.0);
    material.yield_stress = Some(sph_solid::YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap());
    let spacing = 1e-3;
    let strain_to = |temperature: f64, strain: f64| {
        let positions = lattice([0.0; 2], [6, 6], spacing);
        let mut scene = Scene::new(positions, spacing, 1.0, material.clone(), Controls::default());
        scene.temperatures.fill(temperature);
        for (position, displacement) in scene.positions.iter().zip(&mut scene.displacements) {
            *displacement = Vector2::new(strain * position.x, -strain * position.y);
        }
        scene.refresh();
        (scene.stresses()[14].von_mises(), scene.equivalents[14])
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
