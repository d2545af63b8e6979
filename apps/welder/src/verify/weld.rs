//! The aluminium spot against converged axisymmetric finite volumes of an independent program.

use super::benchmark::relative;
use super::scene::{block, reference_aluminium, run, spot, uniform_start};
use super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Levels};
use crate::model::{Model, ModelError};
use laser_source::{Beam, Gaussian};
use serde::Deserialize;

const REFERENCE: &str = include_str!("data/spot_reference.csv");

/// 1/e² radius of the beam \[m\], its time \[s\], and the start of the part \[K\].
const BEAM_RADIUS: f64 = 0.6e-3;
const PULSE: f64 = 15e-3;
const START: f64 = 293.0;

/// Half the edge of the part and its thickness \[m\]; the reference is a disc of this radius and thickness, which the
/// heat does not reach the rim of before all is solid.
const HALF_EDGE: f64 = 6e-3;
const THICKNESS: f64 = 3e-3;

/// One line of the reference.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
struct Reference {
    absorbed_power_w: f64,
    width_liquidus_m: f64,
    depth_liquidus_m: f64,
    width_solidus_m: f64,
    depth_solidus_m: f64,
    peak_temperature_k: f64,
    fully_solid_at_s: f64,
}

macro_rules! marks {
    ($($resolution:literal: $error:literal),+) => { &[$(Mark { resolution: $resolution, error: $error }),+] };
}

const WIDTH: &str = "worst relative error of the largest width at liquidus and solidus, 400, 500 and 600 W; resolution: \
                     spacings to the 1/e² radius (12 is 50 um)";
const DEPTH: &str = "the same of the largest depth";
const PEAK: &str = "worst relative error of the highest rise of the surface's centre";
const FREEZING: &str = "worst relative error of the time when all has frozen";

pub(super) const LATTICE: Benchmark = Benchmark {
    name: "weld/spot-aluminium",
    tested_crate: "welder",
    reference: "axisymmetric finite volumes, converged to 0.3 % on lengths",
    quantities: &[
        Quantity { suffix: "width", text: WIDTH, marks: marks!(12.0: 0.01, 24.0: 0.006) },
        Quantity { suffix: "depth", text: DEPTH, marks: marks!(12.0: 0.025, 24.0: 0.012) },
        Quantity { suffix: "peak-rise", text: PEAK, marks: marks!(12.0: 0.01, 24.0: 0.006) },
        Quantity { suffix: "freezing", text: FREEZING, marks: marks!(12.0: 0.02, 24.0: 0.01) },
    ],
    resolutions: [6.0, 12.0, 24.0],
    quick: 3,
    run: |resolution| all_powers(resolution, 0.0),
};

pub(super) const DISORDERED: Benchmark = Benchmark {
    name: "weld/spot-aluminium-disordered",
    tested_crate: "welder",
    reference: "axisymmetric finite volumes, converged to 0.3 % on lengths; particles shifted by up to 0.2 spacings",
    quantities: &[
        Quantity { suffix: "width", text: WIDTH, marks: marks!(12.0: 0.015) },
        Quantity { suffix: "depth", text: DEPTH, marks: marks!(12.0: 0.035) },
        Quantity { suffix: "peak-rise", text: PEAK, marks: marks!(12.0: 0.015) },
    ],
    resolutions: [6.0, 12.0, 24.0],
    quick: 2,
    run: |resolution| all_powers(resolution, 0.2),
};

fn references() -> Vec<Reference> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(REFERENCE.as_bytes());
    reader.deserialize().collect::<Result<_, _>>().expect("the file is part of the program; a test reads it")
}

/// The worst of all three powers.
fn all_powers(resolution: f64, disorder: f64) -> Result<Outcome, BenchmarkError> {
    let mut outcomes = references().into_iter().map(|reference| one_power(&reference, resolution, disorder));
    let first = outcomes.next().expect("the reference has lines")?;
    outcomes.try_fold(first, |worst, next| Ok(worst.worst(&next?)))
}

fn one_power(reference: &Reference, resolution: f64, disorder: f64) -> Result<Outcome, BenchmarkError> {
    let mut model = quarter(reference.absorbed_power_w, resolution)?;
    model.resolution.disorder = disorder;
    let simulation = run(model)?;
    let records = simulation.records();
    let worse = |found: [f64; 2], exact: [f64; 2]| relative(found[0], exact[0]).max(relative(found[1], exact[1]));
    let errors = vec![
        worse(
            [records.liquidus.width, records.solidus.width],
            [reference.width_liquidus_m, reference.width_solidus_m],
        ),
        worse(
            [records.liquidus.depth, records.solidus.depth],
            [reference.depth_liquidus_m, reference.depth_solidus_m],
        ),
        relative(records.peak_temperature - START, reference.peak_temperature_k - START),
        relative(records.solidified_at.unwrap_or(f64::NAN), reference.fully_solid_at_s),
    ];
    Ok(Outcome::of(&simulation, errors))
}

/// A quarter of the spot between two symmetry planes, with the program's levels.
fn quarter(power: f64, resolution: f64) -> Result<Model, ModelError> {
    let spacing = BEAM_RADIUS / resolution;
    let counts = [HALF_EDGE, HALF_EDGE, THICKNESS].map(|length| (length / spacing).round() as usize);
    let mut model = block(counts, spacing, vec![reference_aluminium()])?;
    model.start = uniform_start(START);
    model.resolution.levels = Levels::Auto;
    (model.faces.x_min, model.faces.y_min) = (Face::Symmetry, Face::Symmetry);
    model.laser = Some(spot(Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS)), power, PULSE)?);
    (model.end, model.stop_when_solid) = (2.0 * PULSE, true);
    Ok(model)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_has_three_powers() {
        let references = references();
        assert_eq!(references.len(), 3);
        assert_eq!(references[1].absorbed_power_w, 500.0);
        assert_eq!(references[1].depth_solidus_m, 0.00036425);
    }
}
