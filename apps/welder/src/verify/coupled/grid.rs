//! Welds with flow over a grid of powers, speeds, materials and starts: none may end in any other way than done or by name.

use super::super::scene::{block, reference_aluminium, reference_flow, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::Face;
use crate::model::{Model, ModelError};
use crate::run::Simulation;
use laser_source::{Absorption, Beam, Gaussian, LaserSource, Path, Pulse};
use sph_thermal::phase::EnthalpyCurve;

/// 1/e² radius of the beam \[m\]; the resolution is how many spacings it has.
const BEAM_RADIUS: f64 = 0.35e-3;

/// Absorbed power in the middle of the grid \[W\], and how long a spot is lit \[s\].
const POWER: f64 = 200.0;
const PULSE: f64 = 1.5e-3;

/// Length of a seam \[m\].
const TRACK: f64 = 0.6e-3;

/// Start of the part \[K\].
const START: f64 = 600.0;

/// Coefficient of the loss at a cooled bottom \[W/(m² K)\].
const CONVECTION: f64 = 5e5;

/// One weld of the grid: what differs from the middle one.
#[derive(Debug, Clone, Copy)]
struct Weld {
    /// Power over that in the middle.
    power: f64,
    /// Speed of the beam \[m/s\]; zero is a spot.
    speed: f64,
    /// Slope of tension over that in the middle.
    slope: f64,
    /// Range from solidus to liquidus \[K\].
    mush: f64,
    /// Disorder of the start.
    disorder: f64,
    /// Thickness in beam radii.
    thickness: f64,
    /// Whether the bottom is cooled, so that a slow beam does not melt the whole part.
    cooled: bool,
}

const MIDDLE: Weld =
    Weld { power: 1.0, speed: 0.0, slope: 1.0, mush: 58.0, disorder: 0.0, thickness: 1.5, cooled: false };

const WELDS: [Weld; 11] = [
    MIDDLE,
    Weld { power: 0.5, ..MIDDLE },
    Weld { power: 2.0, ..MIDDLE },
    Weld { slope: -1.0, ..MIDDLE },
    Weld { slope: -1.0, power: 2.0, ..MIDDLE },
    Weld { mush: 1.0, ..MIDDLE },
    Weld { mush: 100.0, ..MIDDLE },
    Weld { disorder: 0.2, ..MIDDLE },
    // Melted through, and held by nothing but its tension.
    Weld { thickness: 0.8, ..MIDDLE },
    // 6 and 0.6 m/min; 0.2 m/min would be a spot of 180 ms.
    Weld { speed: 0.1, power: 1.5, ..MIDDLE },
    Weld { speed: 0.01, power: 0.8, cooled: true, ..MIDDLE },
];

const MARKS: [f64; 3] = [4.0, 5.0, 7.0];

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "coupled/grid",
    tested_crate: "welder",
    reference: "energy and particles are kept in every weld with flow: power x0.5 to x2, spot to 6 m/min, both signs of the slope of \
                tension, mush of 1 and 100 K, disorder 0.2, a thin sheet melted through",
    quantities: &[
        Quantity {
            suffix: "stopped",
            text: "share of the welds that stopped before their end, by name; resolution: spacings in the radius of the beam",
            marks: &[Mark { resolution: MARKS[0], error: 0.0 }, Mark { resolution: MARKS[2], error: 0.0 }],
        },
        Quantity {
            suffix: "ledger",
            text: "largest open share of the energy ledger",
            marks: &[Mark { resolution: MARKS[0], error: 1e-6 }, Mark { resolution: MARKS[2], error: 1e-6 }],
        },
        Quantity {
            suffix: "lost",
            text: "largest share of particles more than ten spacings outside the part, or nowhere",
            marks: &[Mark { resolution: MARKS[0], error: 0.0 }, Mark { resolution: MARKS[2], error: 0.0 }],
        },
    ],
    resolutions: MARKS,
    quick: 1,
    run: |resolution| {
        let mut worst: Option<Outcome> = None;
        let mut stopped = 0;
        for weld in WELDS {
            let mut simulation = Simulation::new(model(&weld, resolution)?)?;
            if let Err(failure) = simulation.run_quietly() {
                tracing::warn!("{weld:?}: {failure}");
                stopped += 1;
            }
            tracing::info!(
                "{weld:?}: t = {:.4e} s, residual {:.1e}",
                simulation.time(),
                simulation.ledger().residual
            );
            let errors = vec![0.0, simulation.ledger().residual.abs(), lost(&simulation)];
            let outcome = Outcome::of(&simulation, errors);
            worst = Some(worst.map_or(outcome.clone(), |worst| worst.worst(&outcome)));
        }
        let mut outcome = worst
            .ok_or(ModelError::Unsupported("a grid without welds".into()))
            .map_err(BenchmarkError::Model)?;
        outcome.errors[0] = f64::from(stopped) / WELDS.len() as f64;
        Ok(outcome)
    },
};

/// Share of the particles that are no longer at the part.
fn lost(simulation: &Simulation) -> f64 {
    let (low, high) = simulation.model().bounds();
    let far = 10.0 * simulation.model().spacing();
    let positions = &simulation.particles().position;
    let kept = |x: &&nalgebra::Vector3<f64>| {
        (0..3).all(|axis| x[axis] > low[axis] - far && x[axis] < high[axis] + far)
    };
    1.0 - positions.iter().filter(kept).count() as f64 / positions.len() as f64
}

/// A quarter of a spot, or half of a seam.
fn model(weld: &Weld, resolution: f64) -> Result<Model, ModelError> {
    let spacing = BEAM_RADIUS / resolution;
    let cells = |radii: f64| (radii * resolution).round() as usize;
    let (across, deep) = (cells(2.4), cells(weld.thickness));
    let along = if weld.speed > 0.0 { cells(4.4 + TRACK / BEAM_RADIUS) } else { across };
    let mut material = reference_aluminium();
    material.liquidus = material.solidus + weld.mush;
    let mut model = block([along, across, deep], spacing, vec![material.clone()])?;
    model.curves = vec![EnthalpyCurve::continuous(&material)?];
    model.start = uniform_start(START);
    model.faces.y_min = Face::Symmetry;
    if weld.cooled {
        model.faces.bottom = Face::Losses {
            convection_w_m2_k: CONVECTION,
            emissivity: 0.0,
            ambient_k: START,
            evaporation: false,
        };
    }
    model.resolution.disorder = weld.disorder;
    let power = weld.power * POWER;
    let path = if weld.speed > 0.0 {
        let start = 2.2 * BEAM_RADIUS;
        let (from_m, to_m) = ([start, 0.0], [start + TRACK, 0.0]);
        Path::Straight { from_m, to_m, speed_m_s: weld.speed, power_w: power, start_s: 0.0 }
    } else {
        model.faces.x_min = Face::Symmetry;
        Path::Spot {
            position_m: [0.0; 2],
            pulse: Pulse::Constant { start_s: 0.0, duration_s: PULSE, power_w: power },
        }
    };
    let beam = Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS));
    let laser = LaserSource::new(beam, path, Absorption::Surface { absorptivity: 1.0 })?;
    model.end = 2.0 * laser.track().end_time();
    model.laser = Some(laser);
    model.stop_when_solid = true;
    model.flow = Some(reference_flow(weld.slope)?);
    Ok(model)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_melted_through_is_held_by_its_tension_and_keeps_its_energy() {
        let sheet = WELDS.into_iter().find(|weld| weld.thickness < 1.0).unwrap();
        let mut simulation = Simulation::new(model(&sheet, 4.0).unwrap()).unwrap();
        simulation.run_quietly().unwrap();
        let [low, high] = simulation.records().liquidus.bounds.unwrap();
        assert!(high[2] - low[2] > 0.9 * simulation.model().size[2], "it has melted through");
        let spacing = simulation.model().spacing();
        let outside = |x: &nalgebra::Vector3<f64>| x.z.max(-simulation.model().size[2] - x.z);
        let farthest = simulation.particles().position.iter().map(outside).fold(0.0, f64::max);
        assert!(farthest < 1.5 * spacing, "{farthest}");
        assert!(simulation.ledger().residual.abs() < 1e-12, "{}", simulation.ledger().residual);
    }
}
