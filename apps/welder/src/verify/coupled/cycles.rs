//! A small part that a pulsed laser melts a hundred times, and that freezes as often.
//!
//! The bottom loses heat to surroundings at the start temperature, so that after the last pulse all heat leaves again: what is
//! stored then is what a hundred cycles have lost or made.

use super::super::benchmark::relative;
use super::super::scene::{block, reference_aluminium, reference_flow, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Stress, Weights};
use crate::model::{Model, ModelError, StressModel};
use crate::physics::Column;
use crate::run::Simulation;
use laser_source::{Absorption, Beam, Gaussian, LaserSource, Path, PowerPoint, Pulse};
use sph_solid::{IsotropicModuli, ThermalExpansion, YieldStress};

/// Edge of the part \[m\]; it is half as thick.
const EDGE: f64 = 0.8e-3;

/// Temperature of the start and of the surroundings \[K\].
const START: f64 = 500.0;

/// Coefficient of the loss at the bottom \[W/(m² K)\]: heat leaves in 4 ms.
const CONVECTION: f64 = 5e5;

/// 1/e² radius of the beam \[m\].
const BEAM_RADIUS: f64 = 0.3e-3;

/// Pulses: how many, from one to the next, how long \[s\], and their highest power \[W\].
const CYCLES: usize = 100;
const PERIOD: f64 = 3e-3;
const PULSE: f64 = 1e-3;
const POWER: f64 = 250.0;

/// Time for the heat to leave after the last cycle \[s\].
const COOLING: f64 = 0.15;

/// Young's modulus \[Pa\], Poisson's ratio, expansion \[1/K\], and yield stress at 293 K \[Pa\], which falls to zero at the solidus.
const YOUNG: f64 = 70e9;
const POISSON: f64 = 0.33;
const EXPANSION: f64 = 2.31e-5;
const YIELD: f64 = 90e6;

const REFERENCE: &str = "a part that has cooled to its start temperature holds the energy of its start";
const ENERGY: Quantity = Quantity {
    suffix: "energy",
    text: "the larger of: energy stored at the end over that absorbed in a cycle; open share of the ledger; resolution: \
           particles along the edge",
    marks: &[Mark { resolution: 6.0, error: 1e-10 }, Mark { resolution: 10.0, error: 1e-10 }],
};
const COUNTED: Quantity = Quantity {
    suffix: "cycles",
    text: "how many times all melt has frozen, over a hundred, less one",
    marks: &[Mark { resolution: 6.0, error: 0.0 }, Mark { resolution: 10.0, error: 0.0 }],
};

pub(in super::super) const WITH_STRESS: Benchmark = Benchmark {
    name: "coupled/cycles-stress",
    tested_crate: "welder",
    reference: REFERENCE,
    quantities: &[
        ENERGY,
        COUNTED,
        Quantity {
            suffix: "stress-free",
            text: "largest von Mises stress at and above the solidus after any step, over E alpha (T_s - T_0)",
            marks: &[Mark { resolution: 6.0, error: 1e-6 }, Mark { resolution: 10.0, error: 1e-6 }],
        },
    ],
    resolutions: [6.0, 8.0, 10.0],
    quick: 1,
    run: |resolution| {
        let cycled = cycle(stressed(resolution)?)?;
        let scale = YOUNG * EXPANSION * (reference_aluminium().solidus - START);
        let errors = vec![cycled.energy(), cycled.counted(), cycled.stress_of_melt / scale];
        Ok(Outcome::of(&cycled.simulation, errors))
    },
};

pub(in super::super) const WITH_FLOW: Benchmark = Benchmark {
    name: "coupled/cycles-flow",
    tested_crate: "welder",
    reference: REFERENCE,
    quantities: &[
        ENERGY,
        COUNTED,
        Quantity {
            suffix: "lost",
            text: "share of particles farther outside the part than two spacings at the end, or still in motion",
            marks: &[Mark { resolution: 6.0, error: 0.0 }, Mark { resolution: 10.0, error: 0.0 }],
        },
    ],
    resolutions: [6.0, 8.0, 10.0],
    quick: 1,
    run: |resolution| {
        let cycled = cycle(flowing(resolution)?)?;
        let errors = vec![cycled.energy(), cycled.counted(), cycled.lost()];
        Ok(Outcome::of(&cycled.simulation, errors))
    },
};

/// A part after its cycles.
struct Cycled {
    simulation: Simulation,
    /// How many times the last melt froze.
    freezings: usize,
    /// Largest von Mises stress of particles at and above the solidus \[Pa\]; zero without stress.
    stress_of_melt: f64,
}

fn cycle(model: Model) -> Result<Cycled, BenchmarkError> {
    let mut cycled = Cycled { simulation: Simulation::new(model)?, freezings: 0, stress_of_melt: 0.0 };
    let mut molten = false;
    while !cycled.simulation.finished() {
        cycled.simulation.step(f64::INFINITY)?;
        let now = cycled.simulation.records().now.over_solidus > 0.0;
        cycled.freezings += usize::from(molten && !now);
        molten = now;
        if molten {
            cycled.stress_of_melt = cycled.stress_of_melt.max(stress_of_melt(&cycled.simulation));
        }
    }
    Ok(cycled)
}

impl Cycled {
    fn energy(&self) -> f64 {
        let ledger = self.simulation.ledger();
        let stored = (ledger.sensible + ledger.latent).abs();
        (stored * CYCLES as f64 / ledger.absorbed).max(ledger.residual.abs())
    }

    fn counted(&self) -> f64 {
        relative(self.freezings as f64, CYCLES as f64)
    }

    fn lost(&self) -> f64 {
        let (low, high) = self.simulation.model().bounds();
        let far = 2.0 * self.simulation.model().spacing();
        let Some(Column::Vector(velocities)) = column(&self.simulation, "velocity_m_s") else {
            return f64::NAN;
        };
        let positions = &self.simulation.particles().position;
        let kept = |i: usize| {
            let inside = (0..3)
                .all(|axis| positions[i][axis] > low[axis] - far && positions[i][axis] < high[axis] + far);
            inside && velocities[i].norm() == 0.0
        };
        let lost = (0..positions.len()).filter(|&i| !kept(i)).count();
        lost as f64 / positions.len() as f64
    }
}

fn column(simulation: &Simulation, wanted: &str) -> Option<Column<3>> {
    simulation.columns().into_iter().find(|(name, _)| *name == wanted).map(|(_, column)| column)
}

fn stress_of_melt(simulation: &Simulation) -> f64 {
    let Some(Column::Scalar(stresses)) = column(simulation, "von_mises_pa") else { return 0.0 };
    let solidus = simulation.model().curves[0].enthalpy_solidus();
    let enthalpies = &simulation.particles().enthalpy;
    let molten = stresses.iter().zip(enthalpies).filter(|(_, enthalpy)| **enthalpy >= solidus);
    molten.map(|(stress, _)| *stress).fold(0.0, f64::max)
}

fn stressed(resolution: f64) -> Result<Model, ModelError> {
    let density = reference_aluminium().density;
    let stress = StressModel {
        settings: Stress { crossings: 0.25, ..Stress::default() },
        moduli: IsotropicModuli::from_young_and_poisson(YOUNG, POISSON)?,
        expansion: ThermalExpansion::constant(density, START, EXPANSION)?,
        yield_stress: YieldStress::falling_to_zero(YIELD, 293.0, reference_aluminium().solidus)?,
    };
    Ok(Model { stress: Some(stress), ..pulsed(resolution)? })
}

fn flowing(resolution: f64) -> Result<Model, ModelError> {
    let mut model = Model { flow: Some(reference_flow(1.0)?), ..pulsed(resolution)? };
    model.heat.weights = Weights::Normalized;
    Ok(model)
}

/// The part with its laser and heat alone.
fn pulsed(resolution: f64) -> Result<Model, ModelError> {
    let edge = resolution as usize;
    let mut model = block([edge, edge, edge / 2], EDGE / resolution, vec![reference_aluminium()])?;
    model.low_corner = [-0.5 * EDGE; 2];
    model.start = uniform_start(START);
    model.faces.bottom =
        Face::Losses { convection_w_m2_k: CONVECTION, emissivity: 0.0, ambient_k: START, evaporation: false };
    let point = |time_s: f64, power_w: f64| PowerPoint { time_s, power_w };
    let pulse = |k: usize| {
        let start = k as f64 * PERIOD;
        [point(start, 0.0), point(start + 0.5 * PULSE, POWER), point(start + PULSE, 0.0)]
    };
    let pulse = Pulse::Table { start_s: 0.0, points: (0..CYCLES).flat_map(pulse).collect() };
    let beam = Beam::Gaussian(Gaussian::from_radius_1e2(BEAM_RADIUS));
    let path = Path::Spot { position_m: [0.0; 2], pulse };
    model.laser = Some(LaserSource::new(beam, path, Absorption::Surface { absorptivity: 1.0 })?);
    model.end = CYCLES as f64 * PERIOD + COOLING;
    Ok(model)
}
