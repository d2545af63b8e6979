//! The area that the particles of a surface make up.

use crate::patch::find;
use sph_fluid::benchmarks::measure::{circle, plane, sphere};

#[test]
fn the_particles_of_a_surface_make_up_its_area() {
    let (found, _) = plane(12, find).unwrap();
    println!("plane: {found:?}");
    assert!((found.tension - 1.0).abs() < 0.01 && (found.marangoni - 1.0).abs() < 0.01);
    // Of the order of the spacing in 2-D; in 3-D twice that.
    let (found, _) = circle(16, find).unwrap();
    println!("circle, R/dx 16: {found:?}");
    assert!((found.tension - 1.0).abs() < 0.03 && (found.marangoni - 1.0).abs() < 0.03);
    let (found, _) = sphere(6, find).unwrap();
    println!("sphere, R/dx 6: {found:?}");
    assert!((found.tension - 1.0).abs() < 0.12 && (found.marangoni - 1.0).abs() < 0.06);
}
