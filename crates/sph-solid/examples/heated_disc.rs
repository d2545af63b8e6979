//! Thermal stress of a disc (plane strain) and a sphere with a hot centre against exact solutions.
//!
//! `heated_disc [CELLS]...` over the radius of the sphere, 8 by default; 15 takes a minute.

#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/material.rs"]
mod material;
#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/round.rs"]
mod round;
#[allow(dead_code, reason = "shared with the tests, which use all of it")]
#[path = "../tests/bodies/scene.rs"]
mod scene;

fn main() {
    for cells in [10, 20, 40] {
        let error = round::disc_error(cells, 0.8);
        println!("disc, {cells} over the radius: {:.2} % within 0.85 R", 100.0 * error);
    }
    let given: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    for cells in if given.is_empty() { vec![8] } else { given } {
        let (error, centre) = round::sphere(cells);
        println!(
            "sphere, {cells} over the radius: {:.2} % within 0.85 R, centre {centre:.3} of exact",
            100.0 * error
        );
    }
}
