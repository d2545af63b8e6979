//! Particles that are moved.

use crate::find::find;
use nalgebra::{Matrix2, Vector2};
use sph_kernel::KernelKind;
use sph_solid::benchmarks::aluminium::aluminium;
use sph_solid::benchmarks::shapes::centred;
use sph_solid::{
    SolidPatch, SolidStart, SymmetricTensor, UpdatedControls, UpdatedPatch, cauchy_stress, elastic_strain,
    second_stress,
};
use std::f64::consts::PI;

const SPACING: f64 = 1e-3;
const CELLS: [usize; 2] = [28, 6];
/// Strain along the bar at the end, and when that is \[s\].
const STRAIN: f64 = 1e-2;
const END: f64 = 5e-5;

/// Particles of the seven layers at either end: as many as may feel that the bar ends.
fn ends(positions: &[Vector2<f64>]) -> Vec<usize> {
    (0..positions.len()).filter(|&i| positions[i].x.abs() > 7.0 * SPACING).collect()
}

/// Velocity of a bar that is pulled apart evenly: what its ends are driven with.
fn pulled(positions: Vec<Vector2<f64>>) -> impl Fn(usize, f64) -> Vector2<f64> + Send + Sync + 'static {
    move |i, _| Vector2::new(STRAIN / END * positions[i].x, 0.0)
}

#[test]
fn a_bar_pulled_at_both_ends_is_strained_and_stressed_as_the_law_says() {
    let positions = centred(CELLS, SPACING);
    let start = SolidStart::new(positions.clone(), SPACING, aluminium(0.0).unwrap());
    let mut bar = SolidPatch::new(start, find).unwrap();
    bar.free.fill(Vector2::x());
    bar.drive(ends(&positions), pulled(positions.clone()));
    bar.set_velocities(|x| Vector2::new(STRAIN / END * x.x, 0.0));
    let kinetic = bar.ledger().kinetic;
    let steps = (END / bar.body().stable_step(0.6)).ceil();
    bar.run(steps as usize, END / steps);
    let deformation = Matrix2::new(1.0 + STRAIN, 0.0, 0.0, 1.0);
    let material = aluminium(0.0).unwrap();
    let second = second_stress(&elastic_strain(&deformation, 1.0), material.solver_moduli());
    let expected = cauchy_stress(&deformation, 1.0, &second);
    for (found, stress) in bar.body().deformations().iter().zip(bar.stresses()) {
        assert!((found - deformation).norm() < 1e-9 * STRAIN, "{found}");
        let off = (stress - expected).norm_squared() / expected.norm_squared();
        assert!(off < 1e-16, "{off}");
    }
    // Nothing is set in motion but what moved at the start: the drive's work is what the bar stores.
    let ledger = bar.ledger();
    println!("pulled bar: work {:.6} of the elastic energy", ledger.driven / ledger.elastic);
    assert!((ledger.kinetic / kinetic - 1.0).abs() < 1e-9 && ledger.elastic > 0.0);
    assert!((ledger.driven / ledger.elastic - 1.0).abs() < 1e-5, "{ledger:?}");
}

#[test]
fn so_it_is_in_the_updated_form() {
    let (positions, material) = (centred(CELLS, SPACING), aluminium(0.0).unwrap());
    let moduli = *material.solver_moduli();
    let controls =
        UpdatedControls::corrected(KernelKind::Gaussian.with_smoothing_length(1.2 * SPACING), SPACING);
    let mut bar = UpdatedPatch::new(positions.clone(), material, controls, find).unwrap();
    bar.free.fill(Vector2::x());
    bar.drive(ends(&positions), pulled(positions.clone()));
    bar.velocities.iter_mut().zip(&positions).for_each(|(v, x)| v.x = STRAIN / END * x.x);
    let steps = (END / bar.stable_step(0.6)).ceil();
    bar.run(steps as usize, END / steps);
    // Along one axis Jaumann's rate and ln(rho/rho_0) add up to Hencky's strain.
    let strain = SymmetricTensor { in_plane: Matrix2::new(STRAIN.ln_1p(), 0.0, 0.0, 0.0), out_of_plane: 0.0 };
    let expected = second_stress(&strain, &moduli);
    for (stress, (found, start)) in bar.stresses().iter().zip(bar.positions.iter().zip(&positions)) {
        assert!((found.x / start.x - 1.0 - STRAIN).abs() < 1e-9 * STRAIN, "{found}");
        let off = (*stress - expected).norm_squared() / expected.norm_squared();
        assert!(off < 1e-12, "{off}");
    }
    // Stored energy is written for small strain, and the area is that of the present.
    let ratio = bar.driven_work() / bar.elastic_energy();
    println!("pulled bar, updated: work {ratio:.4} of the elastic energy");
    assert!((ratio - 1.0).abs() < STRAIN, "{ratio}");
}

#[test]
fn a_bar_that_is_shaken_at_one_end_gets_what_the_drive_gives() {
    let (speed, time) = (2.0, 4e-5);
    let positions = centred([40, 6], SPACING);
    let start = SolidStart::new(positions.clone(), SPACING, aluminium(0.0).unwrap());
    let mut bar = SolidPatch::new(start, find).unwrap();
    let end: Vec<usize> = (0..positions.len()).filter(|&i| positions[i].x < -16.0 * SPACING).collect();
    bar.drive(end.clone(), move |_, now| {
        let sine = (PI * now / time).sin();
        Vector2::new(speed * sine * sine, 0.0)
    });
    let steps = (time / bar.body().stable_step(0.6)).ceil();
    bar.run(steps as usize, time / steps);
    let ledger = bar.ledger();
    println!("shaken bar: {:.3} J/m given, balance {:.1e}", ledger.driven, ledger.balance());
    assert!(ledger.driven > 0.0 && ledger.kinetic > 0.1 * ledger.driven, "{ledger:?}");
    assert!(ledger.balance().abs() < 2e-3 * ledger.driven, "{ledger:?}");
    for i in end {
        assert!((bar.displacements[i] - Vector2::new(0.5 * speed * time, 0.0)).norm() < 1e-9 * speed * time);
    }
    // What fades leaves what is driven alone: at rest now, and it takes no work.
    bar.settle(0.02, 16.0);
    assert!((bar.ledger().balance() - ledger.balance()).abs() < 2e-3 * ledger.driven, "{:?}", bar.ledger());
}
