//! Melting from a hot wall over a mushy range.

use super::super::exact::MushyStefan;
use super::super::scene::{block, constant, uniform_start};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::front::largest_front_errors;
use crate::case::scene::Face;
use sph_thermal::phase::{Table, ThermalMaterial};

/// The aluminium of the reference, with one conductivity in the mush.
pub(in super::super) const ALUMINIUM: MushyStefan = MushyStefan {
    wall: 1500.0,
    liquidus: 905.0,
    solidus: 847.0,
    start: 293.0,
    conductivity: [200.0, 147.5, 95.0],
    heat_capacity: [1050.0, 1115.0, 1180.0],
    density: 2500.0,
    latent_heat: 3.97e5,
};

/// \[s\]
const TIME: f64 = 1e-3;

/// The row is this many diffusion lengths of the solid long: erfc(5) = 1.5e-12.
const LENGTHS: f64 = 5.0;

/// The program's conductivity is linear through the mush: it jumps to that of the mush this far outside \[K\].
const JUMP: f64 = 1e-3;

const MARKS: &[Mark] = &[Mark { resolution: 50.0, error: 0.01 }];

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/mushy-stefan",
    tested_crate: "sph-thermal",
    reference: "similarity solution in three zones: liquidus at 132.93 um, solidus at 157.70 um at 1 ms",
    quantities: &[
        Quantity {
            suffix: "liquidus",
            text: "largest error of the liquidus from 0.8 to 1 ms over its place at 1 ms; resolution: spacings to it",
            marks: MARKS,
        },
        Quantity {
            suffix: "solidus",
            text: "largest error of the solidus from 0.8 to 1 ms over its place at 1 ms; resolution: spacings to the \
                   liquidus",
            marks: MARKS,
        },
    ],
    resolutions: [25.0, 50.0, 100.0],
    quick: 2,
    run: row,
};

fn row(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let spacing = ALUMINIUM.fronts(TIME)[0] / resolution;
    let solid = ALUMINIUM.conductivity[0] / (ALUMINIUM.density * ALUMINIUM.heat_capacity[0]);
    let count = (LENGTHS * (4.0 * solid * TIME).sqrt() / spacing).ceil() as usize;
    let mut model = block([count, 1, 1], spacing, vec![material()])?;
    model.faces.x_min = Face::FixedTemperature { temperature_k: ALUMINIUM.wall };
    model.start = uniform_start(ALUMINIUM.start);
    model.end = TIME;
    let liquidus = |time: f64| ALUMINIUM.fronts(time)[0];
    let solidus = |time: f64| ALUMINIUM.fronts(time)[1];
    let isotherms: [(f64, &dyn Fn(f64) -> f64); 2] =
        [(ALUMINIUM.liquidus, &liquidus), (ALUMINIUM.solidus, &solidus)];
    let (simulation, errors) = largest_front_errors(model, &isotherms)?;
    Ok(Outcome::of(&simulation, errors))
}

fn material() -> ThermalMaterial {
    let table = |nodes: [(f64, f64); 2]| Table::new(nodes.to_vec()).expect("rising temperatures, positive values");
    let [solid, mush, liquid] = ALUMINIUM.conductivity;
    ThermalMaterial {
        density: ALUMINIUM.density,
        solidus: ALUMINIUM.solidus,
        liquidus: ALUMINIUM.liquidus,
        latent_heat: ALUMINIUM.latent_heat,
        heat_capacity_solid: constant(ALUMINIUM.heat_capacity[0]),
        heat_capacity_liquid: constant(ALUMINIUM.heat_capacity[2]),
        conductivity_solid: table([(ALUMINIUM.solidus - JUMP, solid), (ALUMINIUM.solidus, mush)]),
        conductivity_liquid: table([(ALUMINIUM.liquidus, mush), (ALUMINIUM.liquidus + JUMP, liquid)]),
    }
}
