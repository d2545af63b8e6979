//! A Gaussian spot on a half space: the temperature of its centre.

use super::super::benchmark::relative;
use super::super::exact::SurfaceGaussian;
use super::super::scene::{START, block, never_melting, run, spot};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Levels, Weights};
use crate::model::{Model, ModelError};
use laser_source::{Beam, Gaussian};

/// P 1000 W, w 0.5 mm (1/e), k 210 W/(m K), rho c 2.43e6 J/(m³ K).
pub(super) const EXACT: SurfaceGaussian =
    SurfaceGaussian { power: 1000.0, radius: 0.5e-3, conductivity: 210.0, diffusivity: 210.0 / CAPACITY };

const CAPACITY: f64 = 2.43e6;

/// \[s\]
pub(super) const TIME: f64 = 15e-3;

/// Edge of the modelled quarter in beam radii. Mirror images begin at twice that, 3.5 diffusion lengths away, and bring
/// erfc(3.5) = 7e-7 of what a source at that distance would.
const EDGE: f64 = 8.0;

/// Edge of the box of finest particles in beam radii.
const FINE_EDGE: f64 = 3.0;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/gaussian-spot",
    tested_crate: "sph-thermal",
    reference: "P/(pi^1.5 k w) atan(sqrt(4 a t)/w) = 2316.93 K",
    quantities: &[Quantity {
        suffix: "",
        text: "relative error of the centre's rise; resolution: spacings to the 1/e radius",
        marks: &[Mark { resolution: 5.0, error: 0.01 }, Mark { resolution: 10.0, error: 0.003 }],
    }],
    resolutions: [5.0, 10.0, 20.0],
    quick: 2,
    run: |resolution| centre(resolution, Weights::Auto),
};

/// Signed relative error of the centre's rise with the given weights: how the negative control shows its heat.
///
/// # Errors
/// [`BenchmarkError`] when the run has no answer.
pub fn error_with_weights(resolution: f64, weights: Weights) -> Result<f64, BenchmarkError> {
    let mut model = quarter(resolution)?;
    model.heat.weights = weights;
    Ok((run(model)?.records().now.peak_temperature - START) / EXACT.centre_rise(TIME) - 1.0)
}

fn centre(resolution: f64, weights: Weights) -> Result<Outcome, BenchmarkError> {
    let mut model = quarter(resolution)?;
    model.heat.weights = weights;
    let simulation = run(model)?;
    let rise = simulation.records().now.peak_temperature - START;
    Ok(Outcome::of(&simulation, vec![relative(rise, EXACT.centre_rise(TIME))]))
}

/// The quarter of the half space between two symmetry planes through the beam's axis.
pub(super) fn quarter(resolution: f64) -> Result<Model, ModelError> {
    let count = (EDGE * resolution).round() as usize;
    let material = never_melting(1.0, CAPACITY, EXACT.conductivity);
    let mut model = block([count; 3], EXACT.radius / resolution, vec![material])?;
    let edge = FINE_EDGE * EXACT.radius;
    model.resolution.levels = Levels::FineBox { low_m: [0.0, 0.0, -edge], high_m: [edge, edge, 0.0] };
    (model.faces.x_min, model.faces.y_min) = (Face::Symmetry, Face::Symmetry);
    model.laser = Some(spot(Beam::Gaussian(Gaussian { radius_1e_m: EXACT.radius }), EXACT.power, TIME)?);
    model.end = TIME;
    Ok(model)
}
