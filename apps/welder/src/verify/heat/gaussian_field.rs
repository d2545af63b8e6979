//! A Gaussian spot on a half space: the field below and around it, particle by particle.

use super::super::benchmark::{larger, relative};
use super::super::scene::{START, run};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::gaussian_spot::{EXACT, TIME, quarter};
use crate::run::Simulation;

/// Particles are compared up to this many beam radii from the axis and below the surface.
const REACH: f64 = 2.0;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/gaussian-field",
    tested_crate: "sph-thermal",
    reference: "(P/(pi k)) sqrt(a/pi) int_0^t exp(-z²/(4 a s) - r²/(w² + 4 a s))/(sqrt(s) (w² + 4 a s)) ds",
    quantities: &[Quantity {
        suffix: "",
        text: "largest relative error of all particles within two beam radii; resolution: spacings to the 1/e radius",
        marks: &[Mark { resolution: 5.0, error: 0.01 }, Mark { resolution: 10.0, error: 0.003 }],
    }],
    resolutions: [5.0, 10.0, 20.0],
    quick: 2,
    run: field,
};

fn field(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let simulation = run(quarter(resolution)?)?;
    let error = largest_error(&simulation);
    Ok(Outcome::of(&simulation, vec![error]))
}

fn largest_error(simulation: &Simulation) -> f64 {
    let (particles, curve) = (simulation.particles(), &simulation.model().curves[0]);
    let reach = REACH * EXACT.radius;
    let error = |i: usize| {
        let place = particles.position[i];
        let (r, z) = (place.x.hypot(place.y), -place.z);
        // One octant of the quarter: the other is its mirror image.
        let compared = r <= reach && z <= reach && place.y <= place.x;
        compared.then(|| relative(curve.temperature(particles.enthalpy[i]) - START, EXACT.rise(r, z, TIME)))
    };
    (0..particles.len()).filter_map(error).fold(0.0, larger)
}
