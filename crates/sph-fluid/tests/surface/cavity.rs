//! Melt between a hot and a cold side.

use crate::patch::find;
use sph_fluid::benchmarks::cavity::{CASES, Cavity, CavityReference};

/// Re 100, 16 rows, t = 15: the flow, the heat that it carries, and that both sides agree.
#[test]
fn a_cavity_turns_and_carries_heat() {
    // Measured 0.952 of the speed, 1.053 of the stream function, 1.003 and 1.036 of the Nusselt number, and 0.144; with a pressure of
    // pairs the field was 0.288.
    let reference = CavityReference::new(32, CASES[0].reynolds, CASES[0].prandtl);
    let mut cavity = Cavity::new(16, CASES[0], true, find).unwrap();
    let found = cavity.means(15.0, &reference);
    println!("cavity, 16 rows, t = 15: {found:?}");
    assert!((found.speed / CASES[0].speed - 1.0).abs() < 0.08, "{}", found.speed);
    assert!((found.stream / CASES[0].stream - 1.0).abs() < 0.1, "{}", found.stream);
    for nusselt in found.nusselt {
        assert!((nusselt / CASES[0].nusselt - 1.0).abs() < 0.04, "{nusselt}");
    }
    assert!(found.field < 0.2, "{}", found.field);
}

#[test]
fn the_plain_scheme_stalls_in_a_cavity() {
    let reference = CavityReference::new(32, CASES[0].reynolds, CASES[0].prandtl);
    let mut cavity = Cavity::new(16, CASES[0], false, find).unwrap();
    let found = cavity.means(15.0, &reference);
    println!("cavity, plain scheme, 16 rows, t = 15: {found:?}");
    assert!(found.speed < 0.3 * CASES[0].speed, "the test of the cure no longer bites: {}", found.speed);
}
