//! Bodies that turn.

use crate::find::find;
use nalgebra::{Matrix3, SMatrix, Vector3};
use sph_kernel::KernelKind;
use sph_solid::benchmarks::aluminium::aluminium;
use sph_solid::benchmarks::rotation::{
    Spin, sheared_updated, spin, spin_updated, turned, turned_updated, updated_controls,
};
use sph_solid::benchmarks::shapes::centred;
use sph_solid::{Controls, SolidPatch, SymmetricTensor, UpdatedControls, UpdatedPatch};
use std::f64::consts::TAU;

#[test]
fn stress_turns_with_the_body_for_ten_turns() {
    for turns in [0.0, 0.3, 5.2, 10.0] {
        let (error, _) = turned(8, turns, find).unwrap();
        assert!(error < 1e-7, "{error} after {turns} turns");
    }
}

#[test]
fn stress_turns_with_the_body_for_ten_turns_if_gradients_are_corrected() {
    let (stress, density, _) = turned_updated(8, 10, updated_controls(false), find).unwrap();
    println!("corrected, 10 turns: stress {stress:.1e}, density {density:.1e}");
    assert!(stress < 1e-7 && density < 1e-10, "{stress} {density}");
    let (stress, _, _) = turned_updated(8, 1, updated_controls(true), find).unwrap();
    println!("paper, 1 turn: stress {stress:.1e}");
    assert!(stress > 10.0, "the test bites: {stress}");
}

#[test]
fn simple_shear_gives_the_sine() {
    let (error, _) = sheared_updated(8, 0.5, updated_controls(false), find).unwrap();
    println!("simple shear by 0.5: {error:.1e} G");
    assert!(error < 1e-6, "{error}");
}

#[test]
fn in_three_dimensions_stress_turns_about_any_axis() {
    let spacing = 1e-3;
    let start = centred([5; 3], spacing);
    let kernel = KernelKind::Gaussian.with_smoothing_length(0.8 * spacing);
    let controls = UpdatedControls::corrected(kernel, spacing);
    let mut patch = UpdatedPatch::new(start.clone(), aluminium(0.0).unwrap(), controls, find).unwrap();
    let stress = Matrix3::new(50e6, 20e6, -7e6, 20e6, -20e6, 11e6, -7e6, 11e6, -30e6);
    patch.deviators.fill(SymmetricTensor { in_plane: stress, out_of_plane: 0.0 });
    let axis = nalgebra::Unit::new_normalize(Vector3::new(1.0, 2.0, -0.5));
    for step in 1..=200 {
        let turn = nalgebra::Rotation3::from_axis_angle(&axis, TAU * f64::from(step) / 200.0);
        patch.move_to(|i| turn * start[i], 1e-6);
    }
    for (found, density) in patch.deviators.iter().zip(&patch.densities) {
        assert!((found.in_plane - stress).norm() < 1e-7 * stress.norm());
        assert!((density / 2700.0 - 1.0).abs() < 1e-10);
    }
}

/// Judges a spin in the total-Lagrangian form.
fn keeps_both<const D: usize>(hourglass: f64, spin: &Spin<SolidPatch<D>>) {
    let Spin { momentum, energy, patch } = spin;
    println!("spin {D}-D, hourglass {hourglass}: angular momentum {momentum:.1e}, energy {energy:.1e}");
    assert!(momentum.abs() < 1e-8 && energy.abs() < 1e-4, "{momentum} {energy}");
    let turned = patch.body().deformations()[5];
    assert!((turned - SMatrix::identity()).norm() < 0.2, "it has turned twice: {turned}");
}

#[test]
fn a_free_spin_keeps_angular_momentum_and_energy() {
    for hourglass in [0.0, 0.3] {
        let controls = Controls { hourglass, viscosity: 0.0 };
        keeps_both(hourglass, &spin::<2>(10, controls, find).unwrap());
        keeps_both(hourglass, &spin::<3>(6, controls, find).unwrap());
    }
}

#[test]
fn a_free_spin_is_kept_by_the_corrected_form_and_lost_by_the_papers() {
    let Spin { momentum, energy, .. } = spin_updated(10, updated_controls(false), find).unwrap();
    println!("corrected spin: angular momentum {momentum:.1e}, energy {energy:.1e}");
    assert!(momentum.abs() < 1e-6 && energy.abs() < 1e-3, "{momentum} {energy}");
    let Spin { momentum, .. } = spin_updated(10, updated_controls(true), find).unwrap();
    println!("paper spin: angular momentum {momentum:.1e}");
    assert!(momentum < -0.3, "{momentum}");
}
