//! Constant flux through a disc: the temperature of its centre.

use super::super::benchmark::relative;
use super::super::exact::top_hat_rise;
use super::super::scene::{START, block, never_melting, run, spot};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Levels};
use laser_source::{Beam, TopHat};
use std::f64::consts::PI;

/// Edge of the modelled quarter in disc radii: images begin three diffusion lengths away, erfc(4) = 2e-8.
const EDGE: f64 = 4.0;

/// Edge of the box of finest particles in disc radii.
const FINE_EDGE: f64 = 1.6;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/top-hat",
    tested_crate: "sph-thermal",
    reference: "2 q sqrt(a t)/k (1/sqrt(pi) - ierfc(b/(2 sqrt(a t)))) = 0.23207869 for P = k = a = b = t = 1",
    quantities: &[Quantity {
        suffix: "",
        text: "relative error of the centre's rise; resolution: spacings to the radius",
        marks: &[Mark { resolution: 5.0, error: 0.02 }],
    }],
    resolutions: [5.0, 10.0, 20.0],
    quick: 2,
    run: disc,
};

fn disc(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let count = (EDGE * resolution).round() as usize;
    let mut model = block([count; 3], 1.0 / resolution, vec![never_melting(1.0, 1.0, 1.0)])?;
    model.resolution.levels =
        Levels::FineBox { low_m: [0.0, 0.0, -FINE_EDGE], high_m: [FINE_EDGE, FINE_EDGE, 0.0] };
    (model.faces.x_min, model.faces.y_min) = (Face::Symmetry, Face::Symmetry);
    model.laser = Some(spot(Beam::TopHat(TopHat { radius_m: 1.0 }), 1.0, 1.0)?);
    model.end = 1.0;
    let simulation = run(model)?;
    let rise = simulation.records().now.peak_temperature - START;
    Ok(Outcome::of(&simulation, vec![relative(rise, top_hat_rise(1.0 / PI, 1.0, 1.0, 1.0, 1.0))]))
}
