//! A spot in the middle of a disc is heated beyond the solidus and cools again: the melting line crosses a stressed body.

use crate::find::find;
use nalgebra::SMatrix;
use sph_solid::benchmarks::aluminium::{ALPHA, aluminium};
use sph_solid::benchmarks::shapes::ball;
use sph_solid::{SolidPatch, SolidStart, SymmetricTensor, YieldStress};

const SPACING: f64 = 1e-3;
const CELLS: usize = 10;
const RADIUS: f64 = CELLS as f64 * SPACING;
const COLD_YIELD: f64 = 90e6;
const SOLIDUS: f64 = 853.0;

fn disc() -> SolidPatch<2> {
    let mut material = aluminium(ALPHA).unwrap();
    material.yield_stress = Some(YieldStress::falling_to_zero(COLD_YIELD, 293.0, SOLIDUS).unwrap());
    SolidPatch::new(SolidStart::new(ball(CELLS, SPACING), SPACING, material), find).unwrap()
}

/// Sets T = 293 K + `rise` exp(-r^2/(0.4 R)^2) and lets the body settle for a tenth of its usual time.
fn warm(disc: &mut SolidPatch<2>, rise: f64) {
    disc.set_temperatures(|position| 293.0 + rise * (-(position.norm() / (0.4 * RADIUS)).powi(2)).exp());
    disc.relax(0.1 * RADIUS);
}

/// Heats the spot to 993 K and cools it; the stresses when hot and when cold.
fn heat_and_cool(disc: &mut SolidPatch<2>) -> [Vec<SymmetricTensor<2>>; 2] {
    (1..=100).for_each(|step| warm(disc, 7.0 * f64::from(step)));
    let hot = disc.stresses();
    let temperatures = disc.temperatures.clone();
    assert!(temperatures.iter().any(|&temperature| temperature > SOLIDUS + 100.0), "it melts");
    (0..100).rev().for_each(|step| warm(disc, 7.0 * f64::from(step)));
    disc.relax(RADIUS);
    [hot, disc.stresses()]
}

/// Radial, hoop and axial residual stress \[MPa\] at r/R = 0.1, 0.2 ... 0.9: `hot_spot_reference.py 160 200`, finite elements
/// with small strain.
const REFERENCE: [[f64; 3]; 9] = [
    [132.95, 127.32, 220.00],
    [124.33, 101.00, 200.37],
    [109.71, 57.73, 161.65],
    [90.68, 10.45, 107.76],
    [70.84, -25.09, 57.48],
    [52.75, -48.92, 20.57],
    [36.92, -66.40, -5.09],
    [23.10, -80.60, -22.77],
    [10.88, -92.71, -33.80],
];

/// Relative L2 error of the stresses \[Pa\] against the reference, 0.1 R < r < 0.85 R.
fn error(disc: &SolidPatch<2>, stresses: &[SymmetricTensor<2>]) -> f64 {
    let (mut wrong, mut right) = (0.0, 0.0);
    for (position, stress) in disc.positions().iter().zip(stresses) {
        let place = 10.0 * position.norm() / RADIUS;
        if (1.0..8.5).contains(&place) {
            let (below, share) = (place as usize - 1, place.fract());
            let [radial, hoop, axial]: [f64; 3] = std::array::from_fn(|k| {
                1e6 * (REFERENCE[below][k] * (1.0 - share) + REFERENCE[below + 1][k] * share)
            });
            let outward = position.normalize();
            let in_plane = SMatrix::identity() * hoop + outward * outward.transpose() * (radial - hoop);
            let exact = SymmetricTensor { in_plane, out_of_plane: axial };
            wrong += (*stress - exact).norm_squared();
            right += exact.norm_squared();
        }
    }
    f64::sqrt(wrong / right)
}

#[test]
fn a_spot_that_melts_carries_no_shear_when_hot_and_is_torn_when_cold() {
    let mut disc = disc();
    let molten_radius = 0.4 * RADIUS * (700.0_f64 / (SOLIDUS - 293.0)).ln().sqrt();
    let [hot, cold] = heat_and_cool(&mut disc);
    let molten = |i: usize| disc.positions()[i].norm() < molten_radius - 0.5 * SPACING;
    for i in 0..hot.len() {
        assert!(!molten(i) || hot[i].von_mises() < 0.02 * COLD_YIELD, "{:.3e}", hot[i].von_mises());
        assert!(cold[i].von_mises() < 1.02 * COLD_YIELD, "{:.3e}", cold[i].von_mises());
    }
    let core = |value: &dyn Fn(usize) -> f64| disc.mean(|x| x.norm() < 2.0 * SPACING, value);
    let mean = core(&|i| cold[i].trace() / 3.0) / COLD_YIELD;
    let shear = core(&|i| cold[i].von_mises()) / COLD_YIELD;
    let plastic = core(&|i| disc.equivalents[i]);
    println!(
        "hot spot, cold again: mean stress {mean:.2} and von Mises {shear:.2} of the yield stress, plastic strain {plastic:.1e}"
    );
    // The core shrinks within what stayed cold: it flows in tension. Nothing is left of its motion.
    assert!(mean > 0.3 && (shear - 1.0).abs() < 0.04 && plastic > ALPHA * 700.0, "{mean} {shear} {plastic}");
    let error = error(&disc, &cold);
    println!("residual stress, 10 over the radius: {:.1} % from finite elements", 100.0 * error);
    assert!(error < 0.07, "{error}");
    let [kinetic, elastic, hourglass] = disc.energies();
    println!(
        "kinetic {:.1e} and hourglass {:.1e} of the elastic energy",
        kinetic / elastic,
        hourglass / elastic
    );
    assert!(kinetic < 1e-4 * elastic && hourglass < 0.1 * elastic, "{kinetic} {hourglass} {elastic}");
}
