//! A cosine wave of temperature that decays: half a wave between adiabatic faces, which is the periodic wave.

use super::super::scene::{START, block, never_melting, run};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::run::Simulation;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Amplitude at the start \[K\].
const AMPLITUDE: f64 = 1.0;

/// Cells across the disordered block: kernels must not see a particle twice.
const ACROSS: usize = 8;

pub(in super::super) const LATTICE: Benchmark = Benchmark {
    name: "heat/cosine-decay",
    tested_crate: "sph-thermal",
    reference: "T0 + A cos(k x) exp(-a k² t) at a k² t = 1",
    quantities: &[Quantity {
        suffix: "",
        text: "root mean square error over that of the exact wave; resolution: spacings to a wavelength, on a lattice",
        marks: &[Mark { resolution: 20.0, error: 0.01 }, Mark { resolution: 80.0, error: 0.01 / 16.0 }],
    }],
    resolutions: [20.0, 40.0, 80.0],
    quick: 3,
    run: |resolution| wave(resolution, 0.0),
};

pub(in super::super) const DISORDERED: Benchmark = Benchmark {
    name: "heat/cosine-decay-disordered",
    tested_crate: "sph-thermal",
    reference: "T0 + A cos(k x) exp(-a k² t) at a k² t = 1",
    quantities: &[Quantity {
        suffix: "",
        text: "root mean square error over that of the exact wave; resolution: spacings to a wavelength, shifted by 0.2",
        marks: &[Mark { resolution: 20.0, error: 0.01 }],
    }],
    resolutions: [20.0, 40.0, 80.0],
    quick: 3,
    run: |resolution| wave(resolution, 0.2),
};

fn wave(resolution: f64, disorder: f64) -> Result<Outcome, BenchmarkError> {
    let across = if disorder > 0.0 { ACROSS } else { 1 };
    let counts = [(resolution / 2.0).round() as usize, across, across];
    let mut model = block(counts, 1.0 / resolution, vec![never_melting(1.0, 1.0, 1.0)])?;
    model.resolution.disorder = disorder;
    model.start = Arc::new(|[x, ..]| (0, START + AMPLITUDE * (TAU * x).cos()));
    model.end = 1.0 / (TAU * TAU);
    let simulation = run(model)?;
    let error = error(&simulation);
    Ok(Outcome::of(&simulation, vec![error]))
}

/// Root mean square of the error over that of the exact wave, at the particles.
fn error(simulation: &Simulation) -> f64 {
    let (particles, curve) = (simulation.particles(), &simulation.model().curves[0]);
    let decay = (-4.0 * PI * PI * simulation.time()).exp();
    let (mut wrong, mut right) = (0.0, 0.0);
    for (position, &enthalpy) in particles.position.iter().zip(&particles.enthalpy) {
        let exact = AMPLITUDE * (TAU * position.x).cos() * decay;
        wrong += (curve.temperature(enthalpy) - START - exact).powi(2);
        right += exact * exact;
    }
    (wrong / right).sqrt()
}
