//! Drops under their own tension: pressure of rest, and the period of a small oscillation (Rayleigh 1879).

use crate::patch::Patch;
use crate::shapes::{rings, tense};
use nalgebra::{SVector, Vector2};
use sph_fluid::FluidControls;

const SOUND_SPEED: f64 = 15.0;

/// A round drop of R = rho = tau = 1 that starts with the pressure of its curvature.
fn round_drop(across: usize, viscosity: f64) -> Patch<2> {
    let (positions, areas) = rings(across);
    let spacing = 1.0 / across as f64;
    let controls = FluidControls {
        dynamic_viscosity: viscosity,
        artificial_viscosity: 0.1,
        ..tense(spacing, SOUND_SPEED)
    };
    let density = controls.state.density(1.0);
    let masses = areas.iter().map(|area| area * density).collect();
    let mut drop = Patch::new(positions, masses, Vec::new(), spacing, f64::INFINITY, controls);
    drop.densities.fill(density);
    drop.evaluate(0.0);
    drop
}

/// Pressure over tau/R in time mean and the largest speed, over the second half of a run.
pub fn at_rest(across: usize, end: f64) -> (f64, f64) {
    let mut drop = round_drop(across, 0.05);
    let dt = 0.25 * 1.5 / across as f64 / SOUND_SPEED;
    let (mut pressure, mut speed, mut count) = (0.0, 0.0_f64, 0.0);
    while drop.time < end {
        drop.step(dt);
        if drop.time > 0.5 * end {
            let area: f64 = (0..drop.fluid).map(|i| drop.masses[i] / drop.densities[i]).sum();
            let radius = (area / std::f64::consts::PI).sqrt();
            let inner: Vec<usize> = (0..drop.fluid).filter(|&i| drop.positions[i].norm() < 0.5).collect();
            let sum: f64 = inner.iter().map(|&i| drop.sweep.pressures()[i]).sum();
            pressure += sum / inner.len() as f64 * radius;
            speed = speed.max(drop.largest_speed());
            count += 1.0;
        }
    }
    (pressure / count, speed)
}

#[test]
fn a_drop_at_rest_has_the_pressure_of_its_curvature() {
    for across in [8, 12, 16] {
        let (pressure, speed) = at_rest(across, 4.0);
        println!(
            "drop R/dx {across}: p/p_exact {pressure:.4}, largest speed {speed:.2e}, Ca {:.1e}",
            0.05 * speed
        );
        assert!((pressure - 1.0).abs() < 0.02, "{across}: {pressure}");
        assert!(0.05 * speed < 1e-3, "{across}: {speed}");
    }
}

/// Mean period over the exact one of the n = 2 oscillation, between zero crossings of sum m (x^2 - y^2) over three periods; the first
/// half period, in which the particles leave their rings, does not count.
pub fn period(across: usize) -> f64 {
    let exact: f64 = 2.565_100;
    let mut drop = round_drop(across, 0.01);
    let amplitude = 0.08 * std::f64::consts::TAU / exact;
    for i in 0..drop.fluid {
        let position = drop.positions[i];
        drop.velocities[i] = Vector2::new(position.x, -position.y) * amplitude;
    }
    let shape = |drop: &Patch<2>| -> f64 {
        let of = |i: usize| drop.masses[i] * (drop.positions[i].x.powi(2) - drop.positions[i].y.powi(2));
        (0..drop.fluid).map(of).sum()
    };
    let dt = 0.25 * 1.5 / across as f64 / SOUND_SPEED;
    let (mut before, mut crossings) = (0.0, Vec::new());
    while crossings.len() < 7 && drop.time < 4.0 * exact {
        drop.step(dt);
        let now = shape(&drop);
        if before * now < 0.0 {
            crossings.push(drop.time - dt * now / (now - before));
        }
        before = now;
    }
    assert_eq!(crossings.len(), 7, "{crossings:?}");
    (crossings[6] - crossings[0]) / 3.0 / exact
}

#[test]
fn a_drop_swings_with_the_period_of_rayleigh() {
    // Measured 1.0277 and 1.0078; with plain gradients 1.0798 and 1.0385, and that at 20 would miss the mark of 3 %.
    for (across, mark) in [(10, 0.03), (20, 0.01)] {
        let ratio = period(across);
        println!("oscillating drop R/dx {across}: period over Rayleigh's {ratio:.4}");
        assert!((ratio - 1.0).abs() < mark, "{ratio}");
    }
}

#[test]
fn one_thread_and_two_give_the_same_bits() {
    let bits = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut drop = round_drop(20, 0.01);
            (0..40).for_each(|_| drop.step(1e-3));
            let columns = drop.positions.iter().chain(&drop.velocities).flat_map(|v| v.iter().copied());
            columns.chain(drop.densities.iter().copied()).map(f64::to_bits).collect::<Vec<_>>()
        })
    };
    assert_eq!(bits(1), bits(2));
}

/// A ball cut out of a lattice.
fn ball(across: usize) -> Vec<SVector<f64, 3>> {
    let (n, spacing) = (2 * across, 1.0 / across as f64);
    let site = |k: usize| {
        SVector::<f64, 3>::new((k % n) as f64, (k / n % n) as f64, (k / n / n) as f64).add_scalar(0.5)
            * spacing
            - SVector::repeat(1.0)
    };
    (0..n * n * n).map(site).filter(|position| position.norm() < 1.0).collect()
}

#[test]
fn a_ball_at_rest_has_the_pressure_of_its_curvature() {
    let (across, end) = (6, 2.0);
    let spacing = 1.0 / across as f64;
    let controls =
        FluidControls { dynamic_viscosity: 0.05, artificial_viscosity: 0.1, ..tense(spacing, SOUND_SPEED) };
    let density = controls.state.density(2.0);
    let positions = ball(across);
    let masses = vec![density * spacing.powi(3); positions.len()];
    let mut drop = Patch::new(positions, masses, Vec::new(), spacing, f64::INFINITY, controls);
    drop.densities.fill(density);
    drop.evaluate(0.0);
    let dt = 0.5 * 1.5 * spacing / SOUND_SPEED;
    let (mut pressure, mut count) = (0.0, 0.0);
    while drop.time < end {
        drop.step(dt);
        if drop.time > 0.5 * end {
            let volume: f64 = (0..drop.fluid).map(|i| drop.masses[i] / drop.densities[i]).sum();
            let radius = (0.75 * volume / std::f64::consts::PI).cbrt();
            let inner: Vec<usize> = (0..drop.fluid).filter(|&i| drop.positions[i].norm() < 0.5).collect();
            let sum: f64 = inner.iter().map(|&i| drop.sweep.pressures()[i]).sum();
            pressure += sum / inner.len() as f64 * radius / 2.0;
            count += 1.0;
        }
    }
    let ratio: f64 = pressure / count;
    println!("ball R/dx {across}: p/p_exact {ratio:.4}, largest speed {:.2e}", drop.largest_speed());
    assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
}
