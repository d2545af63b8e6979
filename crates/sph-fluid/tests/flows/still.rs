//! A fluid at rest and a small wave on water.

use crate::patch::find;
use sph_fluid::Friction;
use sph_fluid::benchmarks::tank::tank;
use sph_fluid::benchmarks::wave::standing_wave;

#[test]
fn a_fluid_in_a_tank_carries_its_weight_and_rests() {
    // Measured 1.7 % and 2e-4.
    let tank = tank(10, 20.0, find).unwrap();
    println!("tank, 10 rows: pressure {:.4}, speed {:.1e}", tank.pressure_error, tank.largest_speed);
    assert!(tank.pressure_error < 0.02, "{}", tank.pressure_error);
    assert!(tank.largest_speed < 1e-3, "{}", tank.largest_speed);
}

#[test]
fn a_standing_wave_has_its_period_and_decays_by_strain() {
    // Measured 1.021 and 1.08.
    let wave = standing_wave(14, Friction::Strain, find).unwrap();
    println!("standing wave, 14 rows: period {:.4}, decay {:.3}", wave.period, wave.decay_rate);
    assert!((wave.period - 1.0).abs() < 0.03, "{}", wave.period);
    assert!((wave.decay_rate - 1.0).abs() < 0.15, "{}", wave.decay_rate);
}

#[test]
fn friction_of_shear_damps_a_wave_too_little() {
    // Measured 0.66. In potential flow eta grad v:grad v is half of 2 eta e:e.
    let wave = standing_wave(14, Friction::Shear, find).unwrap();
    println!("standing wave, 14 rows, friction of shear: decay {:.3}", wave.decay_rate);
    assert!(wave.decay_rate < 0.8, "the test of the cure no longer bites: {}", wave.decay_rate);
}
