//! A closed channel under a force across it.

use crate::patch::find;
use nalgebra::Vector2;
use sph_fluid::benchmarks::channel::{Channel, DENSITY, HEIGHT};

#[test]
fn a_closed_channel_carries_the_weight_and_comes_to_rest() {
    let (across, force) = (12, 1e-4);
    let speed = (2.0 * force * HEIGHT).sqrt();
    let mut channel = Channel::new(across, Vector2::new(0.0, -force), 0.0, speed, find).unwrap();
    channel.run_to(1.0);
    // The force is switched on at once; what is left of the waves after 1 s was measured as 9e-5.
    assert!(channel.largest_error(|_, _| 0.0) < 2e-4 * speed);
    // From the lowest to the highest row of fluid, of rho g; measured 1.0012.
    let (positions, pressures) = (channel.patch.positions(), channel.patch.sweep().pressures());
    let last = positions.len() - 1;
    let height = positions[last].y - positions[0].y;
    let slope = (pressures[0] - pressures[last]) / height / (DENSITY * force);
    assert!((slope - 1.0).abs() < 2.5e-3, "{slope}");
}
