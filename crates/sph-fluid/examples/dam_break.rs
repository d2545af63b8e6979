//! A column of water that falls into a dry channel: its front over that of the experiment, and what the walls have lost.
//!
//! `cargo run --release -p sph-fluid --example dam_break -- 20` takes 20 particles across the column (10 without an argument).

#[path = "../tests/surface/patch.rs"]
mod patch;

use patch::find;
use sph_fluid::benchmarks::dam::{DamBreak, FRONT};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let across: usize = std::env::args().nth(1).map_or(Ok(10), |text| text.parse())?;
    if across < 6 {
        return Err("a column needs 6 particles across, so that its kernel fits in".into());
    }
    let mut dam = DamBreak::new(across, find)?;
    println!("{across} across; t sqrt(2 g/a), front z/a of Martin and Moyce (1952), ahead of it [%]");
    for ((time, place), error) in FRONT.into_iter().zip(dam.front_errors()) {
        println!("{time:.3} {place:.3} {:+.1}", 100.0 * error);
    }
    dam.run_to(8.0);
    println!(
        "lost through walls after the far wall was hit: {} of {}",
        dam.lost(),
        dam.patch.positions().len()
    );
    Ok(())
}
