//! Thermal stress of a disc (plane strain) and a sphere with a hot centre against exact solutions.
//!
//! `heated_disc [CELLS]...` over the radius of the sphere, 8 by default; 15 takes half a minute.

#[path = "../tests/bodies/find.rs"]
mod find;

use find::find;
use sph_solid::benchmarks::round::{hot_disc, hot_sphere};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for cells in [10, 20, 40] {
        let (error, _) = hot_disc(cells, find)?;
        println!("disc, {cells} over the radius: {:.2} % within 0.85 R", 100.0 * error);
    }
    let given: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    for cells in if given.is_empty() { vec![8] } else { given } {
        let sphere = hot_sphere(cells, find)?;
        println!(
            "sphere, {cells} over the radius: {:.2} % within 0.85 R, centre {:.3} of exact",
            100.0 * sphere.error,
            sphere.centre
        );
    }
    Ok(())
}
