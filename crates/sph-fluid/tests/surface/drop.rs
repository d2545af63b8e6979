//! Drops under their own tension.

use crate::patch::find;
use sph_fluid::Renewal;
use sph_fluid::benchmarks::Scheme;
use sph_fluid::benchmarks::drop::{
    RESTING_VISCOSITY, SCHEME, SMALL, ball_at_rest, drop_at_rest, reach, round_drop, swinging_drop,
};

#[test]
fn a_drop_at_rest_has_the_pressure_of_its_curvature() {
    for across in [8, 12, 16] {
        let rest = drop_at_rest(across, 4.0, SCHEME, find).unwrap();
        let capillary = RESTING_VISCOSITY * rest.largest_speed;
        println!("drop R/dx {across}: p/p_exact {:.4}, Ca {capillary:.1e}", rest.pressure);
        assert!((rest.pressure - 1.0).abs() < 0.02, "{across}: {}", rest.pressure);
        assert!(capillary < 1e-3, "{across}: {capillary}");
    }
}

#[test]
fn a_drop_swings_with_the_period_of_rayleigh() {
    // Measured 1.0277 and 1.0078.
    for (across, mark) in [(10, 0.03), (20, 0.01)] {
        let ratio = swinging_drop(across, SMALL, SCHEME, find).unwrap().period();
        println!("oscillating drop R/dx {across}: period over Rayleigh's {ratio:.4}");
        assert!((ratio - 1.0).abs() < mark, "{ratio}");
    }
}

/// Stretched to one and a half of its radius; without shifting it bursts in its second swing.
#[test]
fn a_drop_that_is_shifted_swings_far_and_stays_whole() {
    // Measured 1.138, 1.093, 1.066: the period grows with the amplitude, which friction takes.
    let renewal = Some(Renewal { density_pull: 0.0, ..Renewal::default() });
    let swing = swinging_drop(10, 0.5, Scheme { renewal, ..SCHEME }, find).unwrap();
    let (periods, end) = (swing.periods, reach(&swing.patch));
    println!("drop that swings by {:.3} R: periods over Rayleigh's {periods:.4?}", swing.amplitude);
    assert!(swing.amplitude > 0.45 && swing.amplitude < 0.55, "{}", swing.amplitude);
    assert!(periods[0] > 1.08 && periods[0] < 1.2 && periods[2] < periods[0], "{periods:?}");
    assert!(end < 1.3, "{end}");
}

#[test]
fn plain_gradients_make_a_drop_swing_too_slowly() {
    // Measured 1.0798: the test of the corrected ones bites.
    let plain = Scheme { corrected_gradients: false, ..SCHEME };
    let ratio = swinging_drop(10, SMALL, plain, find).unwrap().period();
    println!("oscillating drop R/dx 10, plain gradients: period over Rayleigh's {ratio:.4}");
    assert!(ratio > 1.06 && ratio < 1.1, "{ratio}");
}

#[test]
fn a_ball_at_rest_has_the_pressure_of_its_curvature() {
    let rest = ball_at_rest(6, 2.0, SCHEME, find).unwrap();
    println!("ball R/dx 6: p/p_exact {:.4}, largest speed {:.2e}", rest.pressure, rest.largest_speed);
    assert!((rest.pressure - 1.0).abs() < 0.02, "{}", rest.pressure);
}

#[test]
fn one_thread_and_two_give_the_same_bits() {
    let bits = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut drop = round_drop(20, 0.01, SCHEME, find).unwrap();
            (0..40).for_each(|_| drop.step(1e-3));
            let columns = drop.positions().iter().chain(drop.velocities()).flat_map(|v| v.iter().copied());
            columns.chain(drop.densities().iter().copied()).map(f64::to_bits).collect::<Vec<_>>()
        })
    };
    assert_eq!(bits(1), bits(2));
}
