//! A round drop at rest and drops that swing, little and far: pressure over tau/R, largest speed, periods over Rayleigh's.
//!
//! `cargo run --release -p sph-fluid --example drop -- 20` takes 20 spacings to the radius (10 without an argument).

#[path = "../tests/surface/patch.rs"]
mod patch;

use patch::find;
use sph_fluid::benchmarks::Scheme;
use sph_fluid::benchmarks::drop::{SCHEME, SMALL, drop_at_rest, reach, swinging_drop};
use sph_fluid::{Error, Renewal};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let across: usize = std::env::args().nth(1).map_or(Ok(10), |text| text.parse())?;
    if across < 6 {
        return Err("a drop needs 6 spacings to its radius, so that its kernel fits in".into());
    }
    // Inside the pool: from outside each sweep would wait for a thread to wake up.
    Ok(rayon::scope(|_| report(across))?)
}

fn report(across: usize) -> Result<(), Error> {
    let rest = drop_at_rest(across, 2.0, SCHEME, find)?;
    let (pressure, speed) = (rest.pressure, rest.largest_speed);
    println!("at rest: p/(tau/R) {pressure:.4}, largest speed {speed:.1e} sqrt(tau/(rho R))");
    for (gradients, corrected_gradients) in [("corrected", true), ("plain", false)] {
        let swing = swinging_drop(across, SMALL, Scheme { corrected_gradients, ..SCHEME }, find)?;
        println!("swinging, {gradients} gradients: period over Rayleigh's {:.4}", swing.period());
    }
    // Where a drop is stretched far its pressure is negative, and its particles draw apart unless they are shifted.
    let shifted = Scheme { renewal: Some(Renewal { density_pull: 0.0, ..Renewal::default() }), ..SCHEME };
    println!(
        "with shifting: velocity's amplitude and reach less one over R, periods over Rayleigh's, reach at the end"
    );
    for amplitude in [SMALL, 0.2, 0.35, 0.5] {
        let swing = swinging_drop(across, amplitude, shifted, find)?;
        let [first, second, third] = swing.periods;
        let (reached, end) = (swing.amplitude, reach(&swing.patch));
        println!("{amplitude:.2}: {reached:.3}  {first:.4} {second:.4} {third:.4}  {end:.3}");
    }
    Ok(())
}
