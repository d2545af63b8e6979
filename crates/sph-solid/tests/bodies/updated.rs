//! The updated-Lagrangian forms: what they keep, what they lose, and the rubber rings.

use crate::material::aluminium;
use crate::plate;
use crate::rings::{Rings, collide};
use crate::scene::lattice;
use crate::updated_scene::UpdatedScene;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use sph_kernel::KernelKind;
use sph_solid::{SymmetricTensor, UpdatedControls};
use std::f64::consts::TAU;

const SPACING: f64 = 1e-3;

fn controls(spacing: f64, paper: bool) -> UpdatedControls<2> {
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
    if paper { UpdatedControls::paper(kernel, spacing) } else { UpdatedControls::corrected(kernel, spacing) }
}

/// Largest error of stress over the pre-stress, and of density, of a block turned `turns` times in straight drifts.
fn imposed_rotation(paper: bool, turns: usize) -> (f64, f64) {
    let stress = Matrix2::new(50e6, 20e6, 20e6, -50e6);
    let positions = lattice([-4.0 * SPACING; 2], [8, 8], SPACING);
    let mut scene = UpdatedScene::new(positions.clone(), aluminium(0.0), controls(SPACING, paper));
    scene.deviators.fill(SymmetricTensor { in_plane: stress, out_of_plane: 0.0 });
    let (steps, dt) = (1000, 1e-6);
    for step in 1..=turns * steps {
        let next = *nalgebra::Rotation2::new(TAU * step as f64 / steps as f64).matrix();
        for i in 0..positions.len() {
            let position = next * positions[i];
            scene.velocities[i] = (position - scene.positions[i]) / dt;
            scene.positions[i] = position;
        }
        scene.evaluate(dt);
    }
    let worst = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let stresses = worst(&mut scene.deviators.iter().map(|s| (s.in_plane - stress).norm() / stress.norm()));
    (stresses, worst(&mut scene.densities.iter().map(|density| (density / 2700.0 - 1.0).abs())))
}

#[test]
fn stress_turns_with_the_body_for_ten_turns_if_gradients_are_corrected() {
    let (stress, density) = imposed_rotation(false, 10);
    println!("corrected, 10 turns: stress {stress:.1e}, density {density:.1e}");
    assert!(stress < 1e-7 && density < 1e-10, "{stress} {density}");
    let (stress, _) = imposed_rotation(true, 1);
    println!("paper, 1 turn: stress {stress:.1e}");
    assert!(stress > 10.0, "the test bites: {stress}");
}

#[test]
fn in_three_dimensions_stress_turns_about_any_axis() {
    let positions = lattice([-2.5 * SPACING; 3], [5; 3], SPACING);
    let kernel = KernelKind::Gaussian.with_smoothing_length(0.8 * SPACING);
    let mut scene =
        UpdatedScene::new(positions.clone(), aluminium(0.0), UpdatedControls::corrected(kernel, SPACING));
    let stress = Matrix3::new(50e6, 20e6, -7e6, 20e6, -20e6, 11e6, -7e6, 11e6, -30e6);
    scene.deviators.fill(SymmetricTensor { in_plane: stress, out_of_plane: 0.0 });
    let axis = nalgebra::Unit::new_normalize(Vector3::new(1.0, 2.0, -0.5));
    for step in 1..=200 {
        let next = nalgebra::Rotation3::from_axis_angle(&axis, TAU * f64::from(step) / 200.0);
        for i in 0..positions.len() {
            let position = next * positions[i];
            scene.velocities[i] = (position - scene.positions[i]) / 1e-6;
            scene.positions[i] = position;
        }
        scene.evaluate(1e-6);
    }
    for (found, density) in scene.deviators.iter().zip(&scene.densities) {
        assert!((found.in_plane - stress).norm() < 1e-7 * stress.norm());
        assert!((density / 2700.0 - 1.0).abs() < 1e-10);
    }
}

#[test]
fn same_bits_on_one_and_two_threads() {
    let on = |threads| {
        let positions = lattice([0.0; 2], [40, 10], SPACING);
        let mut scene = UpdatedScene::new(positions, aluminium(0.0), controls(SPACING, true));
        for (position, velocity) in scene.positions.iter().zip(&mut scene.velocities) {
            *velocity = Vector2::new((900.0 * position.y).sin(), (700.0 * position.x).cos());
        }
        let dt = scene.stable_step(0.6);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| scene.run(20, dt));
        (scene.velocities, scene.densities)
    };
    assert_eq!(on(1), on(2));
}

/// Angular momentum and energy after two turns of a free block at 0.035 c at its edges, relative to their start.
fn free_spin(paper: bool) -> (f64, f64) {
    let positions = lattice([-5.0 * SPACING; 2], [10, 10], SPACING);
    let mut scene = UpdatedScene::new(positions, aluminium(0.0), controls(SPACING, paper));
    let sound = (scene.material.solver_moduli().bulk_pa() / 2700.0).sqrt();
    let spin = 0.035 * sound / (5.0 * SPACING);
    for (position, velocity) in scene.positions.iter().zip(&mut scene.velocities) {
        *velocity = Vector2::new(-position.y, position.x) * spin;
    }
    let angular = |scene: &UpdatedScene<2>| -> f64 {
        (0..100).map(|i| scene.positions[i].perp(&scene.velocities[i]) * scene.masses[i]).sum()
    };
    let (momentum, energy) = (angular(&scene), scene.kinetic_energy());
    let dt = scene.stable_step(0.6);
    scene.run((2.0 * TAU / spin / dt) as usize, dt);
    (angular(&scene) / momentum - 1.0, (scene.kinetic_energy() + scene.elastic_energy()) / energy - 1.0)
}

#[test]
fn a_free_spin_is_kept_by_the_corrected_form_and_lost_by_the_papers() {
    let (momentum, energy) = free_spin(false);
    println!("corrected spin: angular momentum {momentum:.1e}, energy {energy:.1e}");
    assert!(momentum.abs() < 1e-6 && energy.abs() < 1e-3, "{momentum} {energy}");
    let (momentum, _) = free_spin(true);
    println!("paper spin: angular momentum {momentum:.1e}");
    assert!(momentum < -0.3, "{momentum}");
}

#[test]
fn the_corrected_plate_is_nearer_to_timoshenkos_than_the_papers() {
    let spacing = 0.02 / 5.0;
    let (corrected, lost) = plate::updated(5, controls(spacing, false));
    let (paper, _) = plate::updated(5, controls(spacing, true));
    println!(
        "plate, 5 across: corrected {corrected:.3} (energy {lost:.1e}), paper {paper:.3} of the thin plate's"
    );
    // The trial's 1.287 and 1.441; exact is 1.0096.
    assert!((corrected - 1.287).abs() < 0.02, "{corrected}");
    assert!((paper - 1.441).abs() < 0.02, "{paper}");
    assert!(lost.abs() < 0.05, "{lost}");
}

#[test]
fn rubber_rings_bounce_whole_with_artificial_stress_and_break_without() {
    let whole = collide(&Rings { poisson: 0.4, speed: 0.059, artificial_stress: 0.3 });
    println!("rings: {} pieces, momentum {:.1e}, rebound {:.2}", whole.pieces, whole.momentum, whole.rebound);
    assert!(whole.pieces == 2 && whole.momentum < 1e-12, "{}", whole.pieces);
    assert!((0.65..0.8).contains(&whole.rebound), "{}", whole.rebound);
    let broken = collide(&Rings { poisson: 0.4, speed: 0.059, artificial_stress: 0.0 });
    println!("rings without artificial stress: {} pieces, rebound {:.2}", broken.pieces, broken.rebound);
    assert!(broken.pieces > 2 && broken.momentum < 1e-12, "the test bites: {}", broken.pieces);
}
