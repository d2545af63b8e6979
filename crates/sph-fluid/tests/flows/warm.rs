//! Friction warms what it slows.

use crate::patch::find;
use nalgebra::Vector2;
use sph_fluid::benchmarks::convection::{NUSSELT, SPEED, convection};
use sph_fluid::benchmarks::shapes::rings;
use sph_fluid::benchmarks::warm_shear::warm_shear;
use sph_fluid::{Conduction, FluidControls, FluidPatch, PatchStart, Tait};
use sph_kernel::KernelKind;

#[test]
fn sheared_fluid_between_plates_has_the_temperature_of_brinkman() {
    for (rows, mark) in [(8, 0.05), (16, 0.025)] {
        let (error, _) = warm_shear(rows, find).unwrap();
        println!("warm shear, {rows} rows: {error:.4}");
        assert!(error < mark, "{rows}: {error}");
    }
}

/// A free body that is sheared: what motion loses, temperature gains, but for the little that goes into pressure.
#[test]
fn energy_of_motion_becomes_heat() {
    let (positions, areas) = rings(12);
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 / 12.0);
    let controls = FluidControls {
        dynamic_viscosity: 0.1,
        artificial_viscosity: 0.1,
        viscous_heating: true,
        corrected_gradients: true,
        ..FluidControls::new(kernel, Tait::new(1.0, 15.0, 7.0).unwrap())
    };
    let speeds: Vec<_> =
        positions.iter().map(|x| Vector2::new(x.y, -x.x) * (0.5 - x.norm_squared())).collect();
    let start = PatchStart {
        conduction: Some(Conduction { diffusivity: 0.01, heat_capacity: 4.0, held: |_| None }),
        ..PatchStart::free(positions, areas, 1.0 / 12.0)
    };
    let mut body = FluidPatch::new(start, controls, find).unwrap();
    body.velocities_mut().copy_from_slice(&speeds);
    let motion = |body: &FluidPatch<2>| -> f64 {
        body.velocities().iter().zip(body.masses()).map(|(v, mass)| 0.5 * mass * v.norm_squared()).sum()
    };
    let before = motion(&body);
    body.run_to(1.0, 0.25 * 1.5 / 12.0 / 15.0);
    let heat: f64 =
        body.temperatures().iter().zip(body.masses()).map(|(warmth, mass)| 4.0 * mass * warmth).sum();
    let lost = before - motion(&body);
    println!("lost {:.3} of the motion; heat over it {:.4}", lost / before, heat / lost);
    assert!(lost > 0.3 * before, "{}", lost / before);
    assert!((heat / lost - 1.0).abs() < 0.02, "{}", heat / lost);
}

#[test]
fn warm_fluid_rises_and_carries_heat() {
    // Measured 1.066 and 1.082 of the Nusselt number, 1.055 of the speed.
    let (nusselt, speed, _) = convection(16, 20.0, find).unwrap();
    println!("convection, 16 rows: Nusselt number {nusselt:.3?} of {NUSSELT}, speed {speed:.2} of {SPEED}");
    assert!(nusselt.iter().all(|nusselt| (nusselt / NUSSELT - 1.0).abs() < 0.1), "{nusselt:?}");
    assert!((speed / SPEED - 1.0).abs() < 0.1, "{speed}");
}
