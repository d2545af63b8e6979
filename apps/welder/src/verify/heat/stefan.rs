//! Melting from a hot wall with a sharp front.

use super::super::exact::Stefan;
use super::super::scene::{block, constant, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::front::largest_front_errors;
use crate::case::scene::Face;
use sph_thermal::phase::ThermalMaterial;

/// The aluminium set of the reference.
pub(in super::super) const ALUMINIUM: Stefan = Stefan {
    wall: 1500.0,
    melting: 933.0,
    start: 293.0,
    conductivity: [210.0, 95.0],
    heat_capacity: [1080.0, 1180.0],
    density: 2500.0,
    latent_heat: 3.97e5,
};

/// \[s\]
const TIME: f64 = 1e-3;

/// The row is this many diffusion lengths of the solid long: erfc(5) = 1.5e-12.
const LENGTHS: f64 = 5.0;

/// The program melts over a range \[K\]; this one is 2e-5 of the wall's excess over the melting point.
const RANGE: f64 = 0.01;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/stefan",
    tested_crate: "sph-thermal",
    reference: "Neumann's solution, lambda 0.34310416: front at 123.14 um at 1 ms",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error of the front from 0.8 to 1 ms over the front at 1 ms; resolution: spacings to the front",
        marks: &[Mark { resolution: 50.0, error: 0.01 }],
    }],
    resolutions: [25.0, 50.0, 100.0],
    quick: 2,
    run: row,
};

fn row(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let spacing = ALUMINIUM.front(TIME) / resolution;
    let solid = ALUMINIUM.conductivity[0] / (ALUMINIUM.density * ALUMINIUM.heat_capacity[0]);
    let count = (LENGTHS * (4.0 * solid * TIME).sqrt() / spacing).ceil() as usize;
    let material = ThermalMaterial {
        density: ALUMINIUM.density,
        solidus: ALUMINIUM.melting - 0.5 * RANGE,
        liquidus: ALUMINIUM.melting + 0.5 * RANGE,
        latent_heat: ALUMINIUM.latent_heat,
        heat_capacity_solid: constant(ALUMINIUM.heat_capacity[0]),
        heat_capacity_liquid: constant(ALUMINIUM.heat_capacity[1]),
        conductivity_solid: constant(ALUMINIUM.conductivity[0]),
        conductivity_liquid: constant(ALUMINIUM.conductivity[1]),
    };
    let mut model = block([count, 1, 1], spacing, vec![material])?;
    model.faces.x_min = Face::FixedTemperature { temperature_k: ALUMINIUM.wall };
    model.start = uniform_start(ALUMINIUM.start);
    model.end = TIME;
    let (simulation, errors) =
        largest_front_errors(model, &[(ALUMINIUM.melting, &|time| ALUMINIUM.front(time))])?;
    Ok(Outcome::of(&simulation, errors))
}
