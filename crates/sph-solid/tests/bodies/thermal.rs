//! Thermal stress against closed solutions of linear thermoelasticity (Timoshenko and Goodier 1970, chapter 13).

use crate::material::{ALPHA, DENSITY, POISSON, YOUNG, aluminium};
use crate::round::{disc_error, sphere};
use crate::scene::{Scene, ball, lattice};
use nalgebra::SVector;
use sph_solid::{Controls, ReducedSound, SymmetricTensor, YieldStress, pressure_wave_speed};

const SPACING: f64 = 1e-3;

fn wave_speed() -> f64 {
    pressure_wave_speed(aluminium(ALPHA).solver_moduli(), DENSITY)
}

fn scene<const D: usize>(positions: Vec<SVector<f64, D>>, ratio: f64) -> Scene<D> {
    Scene::new(positions, SPACING, ratio, aluminium(ALPHA), Controls::default())
}

/// Largest stress over E alpha dT and largest error of the edges' strain of a freely expanding block.
fn free_expansion<const D: usize>(ratio: f64, strain: f64) -> (f64, f64) {
    let mut scene = scene(lattice([-4.0 * SPACING; D], [8; D], SPACING), ratio);
    let warming = strain / ALPHA;
    scene.temperatures.fill(293.0 + warming);
    scene.relax(4.0 * SPACING, wave_speed());
    scene.relax(4.0 * SPACING, wave_speed());
    let stress = scene.stresses().iter().map(|s| s.in_plane.norm()).fold(0.0, f64::max) / (YOUNG * strain);
    // In plane strain the held third axis adds Poisson's share.
    let free = if D == 3 { strain.exp() - 1.0 } else { (1.0 + POISSON) * strain };
    let edges = (0..scene.positions.len()).map(|i| {
        let expected = scene.positions[i] * free;
        (scene.displacements[i] - expected).norm() / expected.norm()
    });
    (stress, edges.fold(0.0, f64::max))
}

#[test]
fn a_free_block_expands_without_stress_corners_included() {
    for ratio in [0.8, 1.2] {
        let (stress, strain) = free_expansion::<2>(ratio, 1e-3);
        println!("2-D h/dx {ratio}: stress {stress:.1e} E alpha dT, strain {strain:.1e}");
        assert!(stress < 1e-4 && strain < 3e-3);
        let (stress, strain) = free_expansion::<3>(ratio, 1e-3);
        println!("3-D h/dx {ratio}: stress {stress:.1e} E alpha dT, strain {strain:.1e}");
        assert!(stress < 1e-4 && strain < 1e-4);
    }
}

#[test]
fn expansion_up_to_melting_is_as_the_density_says() {
    let (stress, strain) = free_expansion::<3>(0.8, 0.0129);
    assert!(stress < 1e-4 && strain < 1e-4, "{stress} {strain}");
}

/// Stress \[MPa\] in the middle of a body of `counts` cells, 4 layers of which are held at both ends of the first `held`
/// axes, after a rise by `warming` \[K\].
fn held<const D: usize>(counts: [usize; D], held: usize, warming: f64) -> SymmetricTensor<D> {
    let half: [f64; D] = counts.map(|count| -0.5 * SPACING * count as f64);
    let mut scene = scene(lattice(half, counts, SPACING), 0.8);
    hold(&mut scene, &half, held);
    scene.temperatures.fill(293.0 + warming);
    let longest = -half.iter().copied().fold(0.0, f64::min);
    scene.relax(longest, wave_speed());
    middle_stress(&scene)
}

/// Holds 4 layers at both ends of the first `held` axes.
fn hold<const D: usize>(scene: &mut Scene<D>, half: &[f64; D], held: usize) {
    for (position, free) in scene.positions.iter().zip(&mut scene.free) {
        for axis in 0..held {
            if position[axis].abs() > -half[axis] - 4.0 * SPACING {
                free[axis] = 0.0;
            }
        }
    }
}

/// Mean stress \[MPa\] within two spacings of the origin.
fn middle_stress<const D: usize>(scene: &Scene<D>) -> SymmetricTensor<D> {
    let stresses = scene.stresses();
    let middle: Vec<usize> =
        (0..stresses.len()).filter(|&i| scene.positions[i].norm() < 2.0 * SPACING).collect();
    let sum = middle.iter().fold(SymmetricTensor::zero(), |sum, &i| sum + stresses[i]);
    sum * (1e-6 / middle.len() as f64)
}

#[test]
fn a_bar_held_at_its_ends() {
    // Most of the difference at 100 K is finite strain, which linear theory leaves out.
    for (warming, exact, mark) in [(100.0, -161.7, 0.01), (10.0, -16.17, 0.001)] {
        let stress = held::<3>([20, 6, 6], 1, warming).in_plane[(0, 0)];
        println!("bar {stress:.3} MPa, exact {exact}");
        assert!((stress / exact - 1.0).abs() < mark, "{stress}");
    }
}

#[test]
fn a_bar_that_yields_when_hot_is_pulled_when_cold() {
    // Uniaxial: E alpha dT = 161.7 MPa against sigma_y(393 K) = 82.1 MPa; back at 293 K the rest of it is tension.
    let mut material = aluminium(ALPHA);
    material.yield_stress = Some(YieldStress::falling_to_zero(100e6, 293.0, 853.0).unwrap());
    let half = [-4.0 * SPACING, -2.0 * SPACING, -2.0 * SPACING];
    let positions = lattice(half, [8, 4, 4], SPACING);
    let mut scene = Scene::new(positions, SPACING, 0.8, material, Controls::default());
    hold(&mut scene, &half, 1);
    // Slowly: when steps of 10 K go round the bar as waves, they make its sides flow first, and the result is 2 % off.
    for step in 1..=100 {
        scene.temperatures.fill(293.0 + f64::from(step));
        scene.relax(SPACING, wave_speed());
    }
    let hot = middle_stress(&scene).in_plane[(0, 0)];
    for step in 1..=100 {
        scene.temperatures.fill(393.0 - f64::from(step));
        scene.relax(SPACING, wave_speed());
    }
    let cold = middle_stress(&scene).in_plane[(0, 0)];
    println!("bar with yield: hot {hot:.2} MPa, exact -82.14; cold {cold:.2} MPa, exact 79.56");
    assert!((hot / -82.14 - 1.0).abs() < 0.01 && (cold / 79.56 - 1.0).abs() < 0.02, "{hot} {cold}");
}

#[test]
fn a_plate_held_in_its_plane() {
    // Plane strain holds the second axis.
    let stress = held::<2>([20, 8], 1, 100.0);
    let (along, across) = (stress.in_plane[(0, 0)], stress.out_of_plane);
    println!("plate {along:.2} and {across:.2} MPa, exact -241.3");
    assert!((along / -241.34 - 1.0).abs() < 0.01 && (across / -241.34 - 1.0).abs() < 0.01);
}

#[test]
fn a_block_held_on_all_sides() {
    let stress = held::<3>([6, 6, 6], 3, 100.0);
    println!("block {:.2} MPa, exact -475.6", stress.trace() / 3.0);
    assert!((stress.trace() / 3.0 / -475.6 - 1.0).abs() < 0.01);
}

#[test]
fn reduced_sound_expands_alike_and_reports_true_stress() {
    let run = |reduced: bool| {
        let mut material = aluminium(ALPHA);
        if reduced {
            material.sound = ReducedSound::to_speed(*material.sound.real(), DENSITY, 50.0).unwrap();
        }
        let wave = pressure_wave_speed(material.solver_moduli(), DENSITY);
        let positions = ball::<2>(5, SPACING);
        let mut scene = Scene::new(positions, SPACING, 1.0, material, Controls::default());
        for (position, temperature) in scene.positions.iter().zip(&mut scene.temperatures) {
            *temperature += 50.0 * position.x / SPACING;
        }
        scene.relax(5.0 * SPACING, wave);
        (scene.displacements[3], scene.stresses()[40])
    };
    let ((moved, stress), (moved_slowly, reported)) = (run(false), run(true));
    assert!((moved - moved_slowly).norm() < 1e-9 * moved.norm());
    assert!((stress.in_plane - reported.in_plane).norm() < 1e-9 * stress.out_of_plane.abs());
    assert!((stress.out_of_plane / reported.out_of_plane - 1.0).abs() < 1e-9);
}

#[test]
fn disc_with_a_hot_centre() {
    for (cells, mark) in [(10, 0.04), (20, 0.016)] {
        let error = disc_error(cells, 0.8);
        println!("disc, {cells} over the radius: {:.2} %", 100.0 * error);
        assert!(error < mark, "{error} at {cells}");
    }
}

#[test]
fn sphere_with_a_hot_centre() {
    let (error, centre) = sphere(8);
    println!("sphere, 8 over the radius: {:.2} %, centre {centre:.3} of exact", 100.0 * error);
    assert!(error < 0.10, "{error}");
    assert!((centre - 1.0).abs() < 0.03, "{centre}");
}
