//! A clamped plate that is melted in a spot, in three dimensions.

use crate::find::find;
use sph_solid::benchmarks::clamped_plate::clamped_plate;

#[test]
fn a_clamped_plate_keeps_the_stress_that_finite_elements_find() {
    let found = clamped_plate(8, find).unwrap();
    println!("clamped plate, 8 over the radius: {:.1} % from finite elements", 100.0 * found.error);
    assert!(found.error < 0.3, "{}", found.error);
    assert!(found.strength < 1.05, "{}", found.strength);
}
