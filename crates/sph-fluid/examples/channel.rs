//! Start-up of Poiseuille and Couette flow: largest error of any particle against the series, at five times.
//!
//! `cargo run --release -p sph-fluid --example channel -- 50` takes 50 particles across (25 without an argument).

#[path = "../tests/surface/patch.rs"]
mod patch;

use patch::find;
use sph_fluid::benchmarks::channel::{TIMES, couette_errors, poiseuille_errors};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let across: usize = std::env::args().nth(1).map_or(Ok(25), |text| text.parse())?;
    if across < 8 {
        return Err("a channel needs 8 particles across, so that its walls do not see each other".into());
    }
    println!("{across} across; time [s], largest error of Poiseuille and Couette flow [% of 1.25e-5 m/s]");
    let (driven, _) = poiseuille_errors(across, find)?;
    let (dragged, _) = couette_errors(across, find)?;
    for (k, time) in TIMES.into_iter().enumerate() {
        println!("{time:7.4} {:8.3} {:8.3}", 100.0 * driven[k], 100.0 * dragged[k]);
    }
    Ok(())
}
