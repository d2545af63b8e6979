//! Colliding rubber rings.

use crate::find::find;
use sph_solid::Controls;
use sph_solid::benchmarks::rings::{Rings, collide, collide_updated};

#[test]
fn rubber_rings_bounce_whole_with_artificial_stress_and_break_without() {
    let rings = Rings { cells: 6, poisson: 0.4, speed: 0.059 };
    let whole = collide_updated(&rings, 0.3, find).unwrap();
    println!("rings: {} pieces, momentum {:.1e}, rebound {:.2}", whole.pieces, whole.momentum, whole.rebound);
    assert!(whole.pieces == 2 && whole.momentum < 1e-12, "{}", whole.pieces);
    assert!((0.65..0.8).contains(&whole.rebound), "{}", whole.rebound);
    let broken = collide_updated(&rings, 0.0, find).unwrap();
    println!("rings without artificial stress: {} pieces, rebound {:.2}", broken.pieces, broken.rebound);
    assert!(broken.pieces > 2 && broken.momentum < 1e-12, "the test bites: {}", broken.pieces);
}

#[test]
fn rubber_rings_in_the_total_form_part_whole_and_keep_their_energy() {
    for (poisson, speed) in [(0.3975, 0.06), (0.3975, 0.12), (0.47, 0.06), (0.47, 0.12)] {
        let end = collide(&Rings { cells: 6, poisson, speed }, Controls::default(), find).unwrap();
        println!(
            "rings in the total form, nu {poisson}, {speed} c0: {} pieces, zigzag {:.4}, momentum {:.1e}, rebound {:.2}, lost {:.1e}",
            end.pieces, end.zigzag, end.momentum, end.rebound, end.lost
        );
        assert!(end.pieces == 2 && end.momentum < 1e-12, "{} {}", end.pieces, end.momentum);
        assert!(
            end.lost.abs() < 5e-3 && end.rebound > 0.2 && end.rebound < 1.0,
            "{} {}",
            end.lost,
            end.rebound
        );
        // Of the fold of the softest rings noise is left.
        let zigzag = if (poisson, speed) == (0.47, 0.12) { 0.22 } else { 0.05 };
        assert!(end.zigzag < zigzag, "{}", end.zigzag);
        // No cell is turned inside out.
        assert!(end.patch.body().deformations().iter().all(|f| f.determinant() > 0.2));
    }
}

#[test]
fn stiffness_or_viscosity_against_it_keeps_a_zigzag_away() {
    let zigzag = |poisson: f64, speed: f64, controls: Controls| {
        collide(&Rings { cells: 6, poisson, speed }, controls, find).unwrap().zigzag
    };
    let none = Controls { hourglass: 0.0, ..Controls::default() };
    let without = zigzag(0.3975, 0.06, none);
    // The fold of the softest rings sets noise free, which viscosity takes.
    let viscous = zigzag(0.47, 0.12, Controls { viscosity: 0.1, ..Controls::default() });
    println!(
        "zigzag without the stiffness {without:.4}, in the hardest case with viscosity {viscous:.4} spacings"
    );
    assert!(without > 0.1, "the measure sees it: {without}");
    assert!(viscous < 0.04, "{viscous}");
}
