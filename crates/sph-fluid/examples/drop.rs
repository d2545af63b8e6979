//! A round drop at rest and one that swings: pressure over tau/R, largest speed, period over Rayleigh's.
//!
//! `cargo run --release -p sph-fluid --example drop -- 20` takes 20 spacings to the radius (10 without an argument).

#[path = "../tests/surface/patch.rs"]
mod patch;

use patch::find;
use sph_fluid::benchmarks::drop::{drop_at_rest, swinging_drop};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let across: usize = std::env::args().nth(1).map_or(Ok(10), |text| text.parse())?;
    if across < 6 {
        return Err("a drop needs 6 spacings to its radius, so that its kernel fits in".into());
    }
    let rest = drop_at_rest(across, 2.0, find)?;
    let (pressure, speed) = (rest.pressure, rest.largest_speed);
    println!("at rest: p/(tau/R) {pressure:.4}, largest speed {speed:.1e} sqrt(tau/(rho R))");
    for (gradients, corrected) in [("corrected", true), ("plain", false)] {
        let (ratio, _) = swinging_drop(across, corrected, find)?;
        println!("swinging, {gradients} gradients: period over Rayleigh's {ratio:.4}");
    }
    Ok(())
}
