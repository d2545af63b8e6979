//! Two rubber rings collide, with and without artificial stress: only with it they stay whole.

#[path = "../tests/bodies/find.rs"]
mod find;

use find::find;
use sph_solid::benchmarks::rings::{Rings, collide};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("poisson  speed/c0  artificial stress  pieces  rebound  momentum");
    for (poisson, speed, artificial_stress) in [
        (0.4, 0.059, 0.3),
        (0.4, 0.059, 0.0),
        (0.3975, 0.06, 0.3),
        (0.3975, 0.12, 0.3),
        (0.47, 0.06, 0.3),
        (0.47, 0.12, 0.3),
    ] {
        let end = collide(&Rings { cells: 6, poisson, speed, artificial_stress }, find)?;
        println!(
            "{poisson:7}  {speed:8}  {artificial_stress:17}  {:6}  {:7.2}  {:.0e}",
            end.pieces, end.rebound, end.momentum
        );
    }
    Ok(())
}
