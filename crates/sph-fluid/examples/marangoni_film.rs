//! Layers driven by a surface temperature that rises along x: speed of the surface over the exact one.
//!
//! `cargo run --release -p sph-fluid --example marangoni_film -- 16` takes 16 rows (8 without an argument).

#[path = "../tests/surface/patch.rs"]
mod patch;

use patch::find;
use sph_fluid::benchmarks::layer::{SCHEME, film, return_flow};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rows: usize = std::env::args().nth(1).map_or(Ok(8), |text| text.parse())?;
    if rows < 6 {
        return Err("a layer needs 6 rows, so that its surface does not see the wall".into());
    }
    println!("open film, {rows} rows: u_s/exact {:.4}", film(rows, SCHEME, find)?.0);
    let (speed, force, _) = return_flow(rows, SCHEME, find)?;
    println!("return flow, {rows} rows: u_s/exact {speed:.4}, force that holds the flux/exact {force:.4}");
    Ok(())
}
