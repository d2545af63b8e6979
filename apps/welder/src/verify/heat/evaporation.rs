//! A column that a steady flux heats from below until its top face evaporates as much.

use super::super::benchmark::relative;
use super::super::scene::{block, fine_steps, never_melting, run, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::Face;
use sph_thermal::boundary::Evaporation;

/// Flux \[W/m²\], conductivity \[W/(m K)\], density times heat capacity \[J/(m³ K)\], depth \[m\].
const FLUX: f64 = 5e7;
const CONDUCTIVITY: f64 = 100.0;
const CAPACITY: f64 = 2.95e6;
const DEPTH: f64 = 1e-3;

/// Boiling point \[K\], heat of evaporation \[J/kg\] and molar mass \[kg/mol\] of aluminium.
const BOILING: f64 = 2790.0;
const HEAT: f64 = 1.09e7;
const MOLAR_MASS: f64 = 0.02698;

/// Start \[K\], and a time \[s\] of eight diffusion times and fourteen of the face's own.
const START: f64 = 2300.0;
const TIME: f64 = 0.25;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/evaporation",
    tested_crate: "sph-thermal",
    reference: "T of L 0.82 p_0 exp(L M/R (1/T_b - 1/T)) sqrt(M/(2 pi R T)) = q, by bisection",
    quantities: &[Quantity {
        suffix: "",
        text: "relative error of the temperature of a face that evaporates all of a steady flux; resolution: rows",
        marks: &[Mark { resolution: 5.0, error: 1e-5 }],
    }],
    resolutions: [5.0, 10.0, 20.0],
    quick: 3,
    run: column,
};

fn column(rows: f64) -> Result<Outcome, BenchmarkError> {
    let metal = never_melting(1.0, CAPACITY, CONDUCTIVITY);
    let mut model = block([1, 1, rows as usize], DEPTH / rows, vec![metal])?;
    model.evaporation =
        vec![Some(Evaporation::new(BOILING, HEAT, MOLAR_MASS).map_err(crate::model::ModelError::from)?)];
    model.faces.bottom = Face::Flux { flux_w_m2: FLUX };
    model.faces.top =
        Face::Losses { convection_w_m2_k: 0.0, emissivity: 0.0, ambient_k: 293.0, evaporation: true };
    model.start = uniform_start(START);
    model.heat.stepping = fine_steps();
    model.end = TIME;
    let simulation = run(model)?;
    let error = relative(simulation.records().now.peak_temperature, face_temperature());
    Ok(Outcome::of(&simulation, vec![error]))
}

/// The temperature at which the face evaporates the flux.
fn face_temperature() -> f64 {
    let gas = 8.314_462_618;
    let evaporated = |t: f64| {
        let pressure = 101_325.0 * (HEAT * MOLAR_MASS / gas * (1.0 / BOILING - 1.0 / t)).exp();
        HEAT * 0.82 * pressure * (MOLAR_MASS / (2.0 * std::f64::consts::PI * gas * t)).sqrt()
    };
    let (mut low, mut high) = (1500.0, 4000.0);
    while high - low > 1e-9 {
        let middle = 0.5 * (low + high);
        if evaporated(middle) < FLUX { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
