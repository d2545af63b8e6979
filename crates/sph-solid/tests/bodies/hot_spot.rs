//! A spot in the middle of a disc is heated beyond the solidus and cools again: the melting line crosses a stressed body.

use crate::material::{ALPHA, DENSITY, aluminium};
use crate::scene::{Scene, ball};
use sph_solid::{Controls, SymmetricTensor, YieldStress, pressure_wave_speed};

const SPACING: f64 = 1e-3;
const CELLS: usize = 10;
const RADIUS: f64 = CELLS as f64 * SPACING;
const COLD_YIELD: f64 = 90e6;
const SOLIDUS: f64 = 853.0;

fn disc() -> Scene<2> {
    let mut material = aluminium(ALPHA);
    material.yield_stress = Some(YieldStress::falling_to_zero(COLD_YIELD, 293.0, SOLIDUS).unwrap());
    Scene::new(ball::<2>(CELLS, SPACING), SPACING, 0.8, material, Controls::default())
}

/// Sets T = 293 K + `rise` exp(-r^2/(0.4 R)^2) and lets the body settle for a tenth of its usual time.
fn warm(scene: &mut Scene<2>, rise: f64) {
    for (position, temperature) in scene.positions.iter().zip(&mut scene.temperatures) {
        *temperature = 293.0 + rise * (-(position.norm() / (0.4 * RADIUS)).powi(2)).exp();
    }
    scene.relax(0.1 * RADIUS, pressure_wave_speed(aluminium(ALPHA).solver_moduli(), DENSITY));
}

/// Heats the spot to 993 K and cools it; the stresses when hot and when cold.
fn heat_and_cool(scene: &mut Scene<2>) -> [Vec<SymmetricTensor<2>>; 2] {
    (1..=100).for_each(|step| warm(scene, 7.0 * f64::from(step)));
    let hot = scene.stresses();
    let temperatures = scene.temperatures.clone();
    assert!(temperatures.iter().any(|&temperature| temperature > SOLIDUS + 100.0), "it melts");
    (0..100).rev().for_each(|step| warm(scene, 7.0 * f64::from(step)));
    scene.relax(RADIUS, 6200.0);
    [hot, scene.stresses()]
}

#[test]
fn a_spot_that_melts_carries_no_shear_when_hot_and_is_torn_when_cold() {
    let mut scene = disc();
    let molten_radius = 0.4 * RADIUS * (700.0_f64 / (SOLIDUS - 293.0)).ln().sqrt();
    let [hot, cold] = heat_and_cool(&mut scene);
    let molten = |i: usize| scene.positions[i].norm() < molten_radius - 0.5 * SPACING;
    for i in 0..hot.len() {
        assert!(!molten(i) || hot[i].von_mises() < 0.02 * COLD_YIELD, "{:.3e}", hot[i].von_mises());
        assert!(cold[i].von_mises() < 1.02 * COLD_YIELD, "{:.3e}", cold[i].von_mises());
    }
    let core = |value: &dyn Fn(usize) -> f64| scene.mean(|x| x.norm() < 2.0 * SPACING, value);
    let mean = core(&|i| cold[i].trace() / 3.0) / COLD_YIELD;
    let shear = core(&|i| cold[i].von_mises()) / COLD_YIELD;
    let plastic = core(&|i| scene.equivalents[i]);
    println!(
        "hot spot, cold again: mean stress {mean:.2} and von Mises {shear:.2} of the yield stress, plastic strain {plastic:.1e}"
    );
    // The core shrinks within what stayed cold: it flows in tension. Nothing is left of its motion.
    assert!(mean > 0.3 && (shear - 1.0).abs() < 0.04 && plastic > ALPHA * 700.0, "{mean} {shear} {plastic}");
    let [kinetic, elastic, hourglass] = scene.energies();
    println!(
        "kinetic {:.1e} and hourglass {:.1e} of the elastic energy",
        kinetic / elastic,
        hourglass / elastic
    );
    assert!(kinetic < 1e-4 * elastic && hourglass < 0.1 * elastic, "{kinetic} {hourglass} {elastic}");
}
