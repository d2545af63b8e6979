//! A beam that swings by a third of its length.

use crate::find::find;
use sph_solid::benchmarks::beam::{AMPLITUDE, FREQUENCY, MEAN, swinging_beam};

#[test]
fn a_beam_swings_as_turek_and_hron_say() {
    let tip = swinging_beam(4, find).unwrap();
    let [mean, amplitude, frequency] =
        [tip.mean / MEAN, tip.amplitude / AMPLITUDE, tip.frequency / FREQUENCY];
    println!(
        "beam, 4 across: mean {mean:.4}, amplitude {amplitude:.4}, frequency {frequency:.4} of the reference"
    );
    for ratio in [mean, amplitude, frequency] {
        assert!((ratio - 1.0).abs() < 0.12, "{ratio}");
    }
}
