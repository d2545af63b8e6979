//! A round drop at rest and drops that swing, little and far: pressure over tau/R, largest speed, periods over Rayleigh's.
//!
//! `cargo run --release -p sph-fluid --example drop -- 20` takes 20 spacings to the radius (10 without an argument).

#[path = "../tests/surface/patch.rs"]
mod patch;

use patch::find;
use sph_fluid::benchmarks::Scheme;
use sph_fluid::benchmarks::drop::{SCHEME, SMALL, drop_at_rest, reach, swinging_drop};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let across: usize = std::env::args().nth(1).map_or(Ok(10), |text| text.parse())?;
    if across < 6 {
        return Err("a drop needs 6 spacings to its radius, so that its kernel fits in".into());
    }
    let rest = drop_at_rest(across, 2.0, SCHEME, find)?;
    let (pressure, speed) = (rest.pressure, rest.largest_speed);
    println!("at rest: p/(tau/R) {pressure:.4}, largest speed {speed:.1e} sqrt(tau/(rho R))");
    for (gradients, corrected_gradients) in [("corrected", true), ("plain", false)] {
        let swing = swinging_drop(across, SMALL, Scheme { corrected_gradients, ..SCHEME }, find)?;
        println!("swinging, {gradients} gradients: period over Rayleigh's {:.4}", swing.period());
    }
    println!(
        "swinging far: amplitude reached over R, first to third period over Rayleigh's, reach at the end over R"
    );
    for amplitude in [SMALL, 0.2, 0.35, 0.5, 0.65] {
        let swing = swinging_drop(across, amplitude, SCHEME, find)?;
        let [first, second, third] = swing.periods;
        let (reached, end) = (swing.amplitude, reach(&swing.patch));
        println!("{amplitude:.2}: {reached:.3}  {first:.4} {second:.4} {third:.4}  {end:.3}");
    }
    Ok(())
}
