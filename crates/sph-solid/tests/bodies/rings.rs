//! Colliding rubber rings.

use crate::find::find;
use sph_solid::benchmarks::rings::{Rings, collide};

#[test]
fn rubber_rings_bounce_whole_with_artificial_stress_and_break_without() {
    let rings = Rings { cells: 6, poisson: 0.4, speed: 0.059, artificial_stress: 0.3 };
    let whole = collide(&rings, find).unwrap();
    println!("rings: {} pieces, momentum {:.1e}, rebound {:.2}", whole.pieces, whole.momentum, whole.rebound);
    assert!(whole.pieces == 2 && whole.momentum < 1e-12, "{}", whole.pieces);
    assert!((0.65..0.8).contains(&whole.rebound), "{}", whole.rebound);
    let broken = collide(&Rings { artificial_stress: 0.0, ..rings }, find).unwrap();
    println!("rings without artificial stress: {} pieces, rebound {:.2}", broken.pieces, broken.rebound);
    assert!(broken.pieces > 2 && broken.momentum < 1e-12, "the test bites: {}", broken.pieces);
}
