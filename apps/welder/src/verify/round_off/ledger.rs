//! The energy ledger of a closed scene.

use super::super::scene::{block, reference_aluminium, run, spot, uniform_start};
use super::super::{Benchmark, Mark, Outcome, Quantity};
use super::BEAM_RADIUS;
use crate::case::scene::{Face, Levels};
use crate::model::{Model, ModelError};
use laser_source::{Beam, Gaussian};

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "round-off/energy-ledger",
    tested_crate: "sph-thermal",
    reference: "absorbed laser energy = rise of stored enthalpy (closed scene that melts and freezes, disordered, levels)",
    quantities: &[Quantity {
        suffix: "",
        text: "what is missing over the energy turned over; resolution: spacings to the 1/e² radius",
        marks: &[
            Mark { resolution: 6.0, error: 1e-12 },
            Mark { resolution: 8.0, error: 1e-12 },
            Mark { resolution: 12.0, error: 1e-12 },
        ],
    }],
    resolutions: [6.0, 8.0, 12.0],
    quick: 3,
    run: |resolution| {
        let simulation = run(closed_spot(resolution)?)?;
        let residual = simulation.ledger().residual.abs();
        Ok(Outcome::of(&simulation, vec![residual]))
    },
};

/// A quarter of a 500 W spot on aluminium that freezes before the run ends.
pub(super) fn closed_spot(resolution: f64) -> Result<Model, ModelError> {
    let count = |radii: f64| (radii * resolution).round() as usize;
    let counts = [count(4.0), count(4.0), count(3.0)];
    let mut model = block(counts, BEAM_RADIUS / resolution, vec![reference_aluminium()])?;
    model.start = uniform_start(293.0);
    (model.faces.x_min, model.faces.y_min) = (Face::Symmetry, Face::Symmetry);
    (model.resolution.disorder, model.resolution.levels) = (0.2, Levels::Auto);
    model.laser = Some(spot(Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS)), 500.0, 5e-3)?);
    (model.end, model.stop_when_solid) = (20e-3, true);
    Ok(model)
}
