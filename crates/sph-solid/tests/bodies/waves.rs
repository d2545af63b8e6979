//! Speeds of elastic waves.

use crate::find::find;
use sph_solid::benchmarks::waves::{bar_wave, plate_wave, pressure_wave, shear_wave};

#[test]
fn waves_are_as_fast_as_the_moduli_say() {
    for (name, ratio) in [
        ("pressure", pressure_wave(40, find).unwrap().0),
        ("shear", shear_wave(40, find).unwrap().0),
        ("bar", bar_wave(40, find).unwrap().0),
        ("plate", plate_wave(40, find).unwrap().0),
    ] {
        println!("{name} wave, 40 over the length: {ratio:.5} of the exact speed");
        assert!((ratio - 1.0).abs() < 0.01, "{name}: {ratio}");
    }
}
