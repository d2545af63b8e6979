//! Two rubber rings collide, in the total-Lagrangian form and in the paper's, with and without artificial stress. Zigzag is in spacings.

#[path = "../tests/bodies/find.rs"]
mod find;

use find::find;
use sph_solid::Controls;
use sph_solid::benchmarks::rings::{Parting, Rings, collide, collide_updated};

fn row<Patch>(rings: &Rings, form: &str, end: &Parting<Patch>) {
    println!(
        "{:7}  {:8}  {form:23}  {:6}  {:6.3}  {:7.2}  {:7.4}  {:.0e}",
        rings.poisson, rings.speed, end.pieces, end.zigzag, end.rebound, end.lost, end.momentum
    );
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "poisson  speed/c0  {:23}  pieces  zigzag  rebound  lost     momentum",
        "form, artificial stress"
    );
    for (poisson, speed) in [(0.3975, 0.06), (0.3975, 0.12), (0.47, 0.06), (0.47, 0.12)] {
        let rings = Rings { cells: 6, poisson, speed };
        row(&rings, "total", &collide(&rings, Controls::default(), find)?);
        row(&rings, "paper, 0.3", &collide_updated(&rings, 0.3, find)?);
    }
    // What breaks in the paper's form, with more and without artificial stress.
    let rings = Rings { cells: 6, poisson: 0.3975, speed: 0.12 };
    for artificial_stress in [0.5, 0.0] {
        let form = format!("paper, {artificial_stress}");
        row(&rings, &form, &collide_updated(&rings, artificial_stress, find)?);
    }
    Ok(())
}
