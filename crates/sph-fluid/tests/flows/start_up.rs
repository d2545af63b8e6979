//! The sweep against the series of start-up, and the series against published values.

use crate::patch::find;
use sph_fluid::benchmarks::channel::{
    Channel, HEIGHT, TIMES, couette, couette_errors, poiseuille, poiseuille_errors,
};

fn largest((errors, _): ([f64; 5], Channel)) -> f64 {
    errors.into_iter().fold(0.0, f64::max)
}

#[test]
fn the_series_give_the_published_centre_speeds() {
    let of_force = [2.2327e-6, 4.2346e-6, 8.2499e-6, 1.10998e-5, 1.24993e-5];
    let of_wall = [2.3028e-7, 1.19475e-6, 3.62844e-6, 5.38629e-6, 6.24959e-6];
    for (k, time) in TIMES.into_iter().enumerate() {
        assert!((poiseuille(0.5 * HEIGHT, time) / of_force[k] - 1.0).abs() < 3e-5, "{time}");
        assert!((couette(0.5 * HEIGHT, time) / of_wall[k] - 1.0).abs() < 3e-5, "{time}");
    }
}

#[test]
fn poiseuille_start_up_converges() {
    // Measured 1.59 % and 0.57 %, both at the last time.
    let (coarse, fine) =
        (largest(poiseuille_errors(12, find).unwrap()), largest(poiseuille_errors(25, find).unwrap()));
    assert!(coarse < 0.0165 && fine < 0.006, "{coarse} {fine}");
    assert!(coarse / fine > 2.5, "{coarse} {fine}");
}

#[test]
fn couette_start_up_converges() {
    // Measured 0.67 % and 0.21 %, both at the first time, when the front is thin.
    let (coarse, fine) =
        (largest(couette_errors(12, find).unwrap()), largest(couette_errors(25, find).unwrap()));
    assert!(coarse < 0.007 && fine < 0.0022, "{coarse} {fine}");
    assert!(coarse / fine > 3.0, "{coarse} {fine}");
}
