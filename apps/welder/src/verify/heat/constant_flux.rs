//! Constant flux into a half space: a column whose top face takes up heat.

use super::super::benchmark::relative;
use super::super::exact::plane_flux_rise;
use super::super::scene::{START, block, never_melting, run};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::Face;

/// Flux \[W/m²\], conductivity \[W/(m K)\], density times heat capacity \[J/(m³ K)\], time \[s\].
const FLUX: f64 = 1e9;
const CONDUCTIVITY: f64 = 200.0;
const CAPACITY: f64 = 2.625e6;
const TIME: f64 = 1e-3;

/// The column is this many diffusion lengths sqrt(4 a t) deep: ierfc(5) = 8e-14 of the rise is missing.
const LENGTHS: f64 = 5.0;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/constant-flux",
    tested_crate: "sph-thermal",
    reference: "2 q sqrt(a t/pi)/k = 1557.311 K",
    quantities: &[Quantity {
        suffix: "",
        text: "relative error of the surface's rise; resolution: spacings to sqrt(4 a t)",
        marks: &[Mark { resolution: 5.0, error: 0.01 }],
    }],
    resolutions: [5.0, 10.0, 20.0],
    quick: 3,
    run: column,
};

fn column(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let diffusivity = CONDUCTIVITY / CAPACITY;
    let spacing = (4.0 * diffusivity * TIME).sqrt() / resolution;
    let counts = [1, 1, (LENGTHS * resolution).round() as usize];
    let mut model = block(counts, spacing, vec![never_melting(1.0, CAPACITY, CONDUCTIVITY)])?;
    model.faces.top = Face::Flux { flux_w_m2: FLUX };
    model.end = TIME;
    let simulation = run(model)?;
    let rise = simulation.records().now.peak_temperature - START;
    let error = relative(rise, plane_flux_rise(FLUX, CONDUCTIVITY, diffusivity, TIME));
    Ok(Outcome::of(&simulation, vec![error]))
}
