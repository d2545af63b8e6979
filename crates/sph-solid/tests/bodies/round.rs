//! Disc and sphere with a hot centre.

use crate::find::find;
use sph_solid::benchmarks::round::{hot_disc, hot_sphere};

#[test]
fn disc_with_a_hot_centre() {
    for (cells, mark) in [(10, 0.04), (20, 0.016)] {
        let (error, _) = hot_disc(cells, find).unwrap();
        println!("disc, {cells} over the radius: {:.2} %", 100.0 * error);
        assert!(error < mark, "{error} at {cells}");
    }
}

#[test]
fn sphere_with_a_hot_centre() {
    let sphere = hot_sphere(8, find).unwrap();
    println!(
        "sphere, 8 over the radius: {:.2} %, centre {:.3}, growth {:.4}, hoop stress at the surface {:.3} of exact",
        100.0 * sphere.error,
        sphere.centre,
        sphere.growth,
        sphere.hoop
    );
    assert!(sphere.error < 0.10, "{}", sphere.error);
    assert!((sphere.centre - 1.0).abs() < 0.03, "{}", sphere.centre);
    assert!((sphere.growth - 1.0).abs() < 0.03, "{}", sphere.growth);
    assert!((sphere.hoop - 1.0).abs() < 0.03, "{}", sphere.hoop);
}
