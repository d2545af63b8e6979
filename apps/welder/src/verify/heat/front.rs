//! Where a front stands in a row of particles: isotherms between them, read in the Kirchhoff potential as the gauge does.

use super::super::scene::run_until;
use super::super::BenchmarkError;
use crate::measure::crossing;
use crate::model::Model;
use crate::run::Simulation;

/// Fronts are looked at this often ...
const SAMPLES: usize = 20;

/// ... from this share of the run on, so that no lucky moment passes a staircase.
const FROM: f64 = 0.8;

/// Distance from the hot low end to where the row falls below `temperature` \[m\].
fn front(simulation: &Simulation, temperature: f64) -> f64 {
    let (particles, curve) = (simulation.particles(), &simulation.model().curves[0]);
    let mut nodes: Vec<_> =
        (0..particles.len()).map(|i| (particles.position[i].x, curve.potential(particles.enthalpy[i]))).collect();
    nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let level = curve.potential_at(temperature);
    match nodes.iter().rposition(|node| node.1 > level) {
        Some(inside) if inside + 1 < nodes.len() => crossing(&nodes, inside, level),
        _ => 0.0,
    }
}

/// Runs `model` to its end and returns for each of `isotherms` (temperature, exact place over time) the largest error of
/// its place from 0.8 of the run on, over its place at the end.
pub(super) fn largest_front_errors(
    model: Model,
    isotherms: &[(f64, &dyn Fn(f64) -> f64)],
) -> Result<(Simulation, Vec<f64>), BenchmarkError> {
    let end = model.end;
    let mut simulation = Simulation::new(model)?;
    let mut errors = vec![0.0f64; isotherms.len()];
    for sample in 0..=SAMPLES {
        let time = end * (FROM + (1.0 - FROM) * sample as f64 / SAMPLES as f64);
        run_until(&mut simulation, time)?;
        for (error, (temperature, exact)) in errors.iter_mut().zip(isotherms) {
            let wrong = (front(&simulation, *temperature) - exact(time)).abs();
            *error = error.max(wrong / exact(end));
        }
    }
    Ok((simulation, errors))
}
