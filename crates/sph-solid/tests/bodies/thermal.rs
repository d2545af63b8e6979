//! Thermal stress of blocks that are warmed as a whole, and what reduced sound makes of it.

use crate::find::find;
use sph_solid::benchmarks::aluminium::{ALPHA, DENSITY, aluminium};
use sph_solid::benchmarks::gough_joule::{exact_change, stretched};
use sph_solid::benchmarks::shapes::ball;
use sph_solid::benchmarks::thermal::{FreeExpansion, free_expansion, held, held_stress, yielding_bar};
use sph_solid::{FindNeighbors, ReducedSound, SolidPatch, SolidStart};

/// Expands a free block and judges it against a largest stress and a largest error of displacement.
fn expands<const D: usize>(ratio: f64, strain: f64, marks: [f64; 2], find: FindNeighbors<D>) {
    let FreeExpansion { stress, displacement, .. } = free_expansion(8, ratio, strain, find).unwrap();
    println!("{D}-D h/dx {ratio}: stress {stress:.1e} E alpha dT, displacement {displacement:.1e}");
    assert!(stress < marks[0] && displacement < marks[1], "{stress} {displacement}");
}

#[test]
fn a_free_block_expands_without_stress_corners_included() {
    for ratio in [0.8, 1.2] {
        expands::<2>(ratio, 1e-3, [1e-4, 3e-3], find);
        expands::<3>(ratio, 1e-3, [1e-4, 1e-4], find);
    }
}

#[test]
fn expansion_up_to_melting_is_as_the_density_says() {
    expands::<3>(0.8, 0.0129, [1e-4, 1e-4], find);
}

#[test]
fn a_bar_held_at_its_ends() {
    for (warming, linear) in [(100.0, -161.7e6), (10.0, -16.17e6)] {
        let stress = held([20, 6, 6], 1, warming, find).unwrap().0.in_plane[(0, 0)];
        let exact = held_stress(1, warming);
        println!("bar {:.4} MPa, exact {:.4}, linear {:.2}", 1e-6 * stress, 1e-6 * exact, 1e-6 * linear);
        assert!((stress / exact - 1.0).abs() < 1e-4, "{stress}");
        // What is left of it is finite strain.
        assert!((stress / linear - 1.0).abs() < 7e-5 * warming, "{stress}");
    }
}

#[test]
fn a_bar_that_yields_when_hot_is_pulled_when_cold() {
    // Uniaxial: E alpha dT = 161.7 MPa against sigma_y(393 K) = 82.1 MPa; back at 293 K the rest of it is tension.
    let [hot, cold] = yielding_bar(find).unwrap().map(|stress| 1e-6 * stress);
    println!("bar with yield: hot {hot:.2} MPa, exact -82.14; cold {cold:.2} MPa, exact 79.56");
    assert!((hot / -82.14 - 1.0).abs() < 0.01 && (cold / 79.56 - 1.0).abs() < 0.02, "{hot} {cold}");
}

#[test]
fn a_plate_held_in_its_plane() {
    // Plane strain holds the second axis.
    let (stress, _) = held([20, 8], 1, 100.0, find).unwrap();
    let (along, across, exact) = (stress.in_plane[(0, 0)], stress.out_of_plane, held_stress(2, 100.0));
    println!("plate {:.3} and {:.3} MPa, exact {:.3}", 1e-6 * along, 1e-6 * across, 1e-6 * exact);
    assert!((along / exact - 1.0).abs() < 1e-4 && (across / exact - 1.0).abs() < 1e-4);
}

#[test]
fn a_block_held_on_all_sides() {
    let (stress, exact) = (held([6, 6, 6], 3, 100.0, find).unwrap().0.trace() / 3.0, held_stress(3, 100.0));
    println!("block {:.3} MPa, exact {:.3}", 1e-6 * stress, 1e-6 * exact);
    assert!((stress / exact - 1.0).abs() < 1e-9);
}

#[test]
fn reduced_sound_expands_alike_and_reports_true_stress() {
    let run = |reduced: bool| {
        let (spacing, mut material) = (1e-3, aluminium(ALPHA).unwrap());
        if reduced {
            material.sound = ReducedSound::to_speed(*material.sound.real(), DENSITY, 50.0).unwrap();
        }
        let start = SolidStart::new(ball::<2>(5, spacing), spacing, material);
        let mut patch = SolidPatch::new(SolidStart { smoothing_ratio: 1.0, ..start }, find).unwrap();
        patch.set_temperatures(|position| 293.0 + 50.0 * position.x / spacing);
        patch.relax(5.0 * spacing);
        (patch.displacements[3], patch.stresses()[40])
    };
    let ((moved, stress), (moved_slowly, reported)) = (run(false), run(true));
    assert!((moved - moved_slowly).norm() < 1e-9 * moved.norm());
    assert!((stress.in_plane - reported.in_plane).norm() < 1e-9 * stress.out_of_plane.abs());
    assert!((stress.out_of_plane / reported.out_of_plane - 1.0).abs() < 1e-9);
}

#[test]
fn a_compressed_block_warms_as_gough_and_joule_say() {
    for (strain, linear) in [(1e-3, -0.5754), (-1e-3, 0.5754)] {
        let (changes, _) = stretched(8, strain, find).unwrap();
        let exact = exact_change(strain).unwrap();
        println!("Gough-Joule, strain {strain}: {:.5} K, exact {exact:.5}, linear {linear}", changes[0]);
        assert!(changes.iter().all(|change| (change / exact - 1.0).abs() < 2e-4), "{changes:?}");
        assert!((exact / linear - 1.0).abs() < 1.2e-3, "{exact}");
    }
}
