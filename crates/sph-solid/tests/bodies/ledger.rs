//! Mechanical energy that closes, and the heat of a changing volume.

use crate::find::find;
use nalgebra::{Matrix3, SVector, Vector2, Vector3};
use sph_solid::benchmarks::aluminium::{ALPHA, DENSITY, HEAT_CAPACITY, aluminium};
use sph_solid::benchmarks::shapes::lattice;
use sph_solid::{Controls, IsotropicModuli, Material, SolidPatch, SolidStart, YieldStress, gough_joule_rate};

const SPACING: f64 = 1e-3;

/// Largest change of the balance over the energy `scale` \[J/m\] that is at work, while 120 h/c_P pass in `steps` steps.
fn unbalanced<const D: usize>(patch: &mut SolidPatch<D>, steps: usize, scale: f64) -> f64 {
    let dt = patch.body().stable_step(120.0 / steps as f64);
    patch.evaluate();
    let start = patch.ledger().balance();
    let after = |_| {
        patch.step(dt);
        (patch.ledger().balance() - start).abs() / scale
    };
    (0..steps).map(after).fold(0.0, f64::max)
}

/// A bar of aluminium that is compressed along x, as fast as a share of the speed of pressure waves.
fn struck(controls: Controls, yield_stress: Option<YieldStress>, speed: f64) -> SolidPatch<2> {
    let material = Material { yield_stress, ..aluminium(ALPHA).unwrap() };
    let start = SolidStart::new(lattice([-0.02, -0.004], [40, 8], SPACING), SPACING, material);
    let mut patch = SolidPatch::new(SolidStart { controls, ..start }, find).unwrap();
    patch.set_velocities(|x| Vector2::new(-speed * x.x / 0.02, 0.0));
    patch
}

#[test]
fn energy_of_a_swinging_bar_stays() {
    let mut patch = struck(Controls::default(), None, 5.0);
    let kinetic = patch.ledger().kinetic;
    let wrong = unbalanced(&mut patch, 400, kinetic);
    println!("elastic bar: balance within {wrong:.1e} of the kinetic energy at the start");
    assert!(wrong < 1e-4, "{wrong}");
    assert!(patch.ledger().elastic > 1e-3 * kinetic);
}

#[test]
fn work_of_yield_is_what_is_missing() {
    let law = YieldStress::falling_to_zero(60e6, 293.0, 853.0).unwrap();
    let mut patch = struck(Controls::default(), Some(law), 40.0);
    let kinetic = patch.ledger().kinetic;
    let wrong = unbalanced(&mut patch, 400, kinetic);
    let plastic = patch.ledger().plastic / kinetic;
    println!("yielding bar: {plastic:.3} of the energy is plastic work, balance within {wrong:.1e}");
    assert!(plastic > 0.3, "{plastic}");
    assert!(wrong < 1e-3, "{wrong}");
}

#[test]
fn viscosity_and_damping_take_what_they_say() {
    let mut patch = struck(Controls { viscosity: 0.5, ..Controls::default() }, None, 5.0);
    let kinetic = patch.ledger().kinetic;
    let wrong = unbalanced(&mut patch, 400, kinetic);
    let viscous = patch.ledger().viscous / kinetic;
    println!("viscous bar: {viscous:.3} of the energy is taken, balance within {wrong:.1e}");
    assert!(viscous > 0.05, "{viscous}");
    assert!(wrong < 1e-3, "{wrong}");
    let before = patch.ledger();
    patch.settle(0.02, 4.0);
    let after = patch.ledger();
    let wrong = (after.balance() - before.balance()).abs() / kinetic;
    println!("  settled: {:.3} damped, balance within {wrong:.1e}", after.damped / kinetic);
    assert!(after.damped > 0.1 * kinetic && wrong < 1e-3, "{wrong}");
}

#[test]
fn weight_and_warming_bring_what_they_say() {
    let moduli = IsotropicModuli::from_young_and_poisson(1e6, 0.3).unwrap();
    let start = SolidStart::new(
        lattice([0.0; 2], [20, 5], SPACING),
        SPACING,
        Material::elastic(moduli, 1000.0).unwrap(),
    );
    let mut beam = SolidPatch::new(start, find).unwrap();
    beam.hold(|x| x.x < 4.0 * SPACING);
    beam.body_acceleration = Vector2::new(0.0, -9.81);
    let fall = 1000.0 * 0.016 * 0.005 * 9.81 * 1e-4;
    let wrong = unbalanced(&mut beam, 400, fall);
    let weight = beam.ledger().weight;
    println!("beam under its weight: {weight:.2e} J/m brought, balance within {wrong:.1e} of {fall:.2e}");
    assert!(weight > 0.0 && wrong < 1e-3, "{wrong}");

    // Waves that start at once: the error is that of the step, of second order.
    let wrong = [400, 800].map(|steps| {
        let mut bar = struck(Controls::default(), None, 0.0);
        bar.hold(|x| x.x.abs() > 0.016);
        bar.evaluate();
        bar.set_temperatures(|_| 303.0);
        let warmed = bar.ledger().warmed;
        assert!(warmed > 0.0);
        unbalanced(&mut bar, steps, warmed)
    });
    println!(
        "held bar, at once 10 K warmer: balance within {:.1e} and, half the step, {:.1e}",
        wrong[0], wrong[1]
    );
    assert!(wrong[0] < 1e-2 && wrong[1] < 0.3 * wrong[0], "{wrong:?}");
}

#[test]
fn heat_of_a_growing_volume_is_that_of_the_law() {
    let start = SolidStart::new(lattice([0.0; 3], [7, 6, 5], SPACING), SPACING, aluminium(ALPHA).unwrap());
    let mut block = SolidPatch::new(start, find).unwrap();
    let stretch = Matrix3::new(2e-3, 1e-3, 0.0, 0.0, -1e-3, 0.0, 5e-4, 0.0, 4e-3);
    let rate = Matrix3::new(3.0, 1.0, 0.0, -1.0, 0.5, 0.0, 0.0, 2.0, -1.0);
    block.set_displacements(|x| stretch * x);
    block.set_velocities(|x| rate * x);
    let deformation = Matrix3::identity() + stretch;
    let volume_rate = (rate * deformation.try_inverse().unwrap()).trace();
    let volume = SPACING.powi(3) * deformation.determinant();
    let bulk_pa = 70e9 / (3.0 * (1.0 - 2.0 * 0.33));
    let law = gough_joule_rate(bulk_pa, ALPHA, 293.0, volume_rate, DENSITY, HEAT_CAPACITY);
    let expected = law * DENSITY * HEAT_CAPACITY * volume;
    assert!(expected < 0.0, "a growing body cools");
    let mut heats = vec![0.0; block.positions().len()];
    block.gough_joule_heats(&mut heats);
    for heat in heats {
        assert!((heat / expected - 1.0).abs() < 1e-10, "{heat} {expected}");
    }
}

#[test]
fn a_turning_block_takes_no_heat() {
    let start = SolidStart::new(lattice([0.0; 3], [5; 3], SPACING), SPACING, aluminium(ALPHA).unwrap());
    let mut block = SolidPatch::new(start, find).unwrap();
    let spin = Vector3::new(3.0, -2.0, 5.0);
    block.evaluate();
    block.set_velocities(|x: &SVector<f64, 3>| spin.cross(x));
    let mut heats = vec![1.0; 125];
    block.gough_joule_heats(&mut heats);
    // A pure stretch at the rate of the spin would give this.
    let scale = 3.0 * 68.6e9 * ALPHA * 293.0 * spin.norm() * SPACING.powi(3);
    assert!(heats.iter().all(|heat| heat.abs() < 1e-12 * scale), "{heats:?}");
}
