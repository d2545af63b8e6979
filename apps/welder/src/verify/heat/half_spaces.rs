//! Two half spaces in contact: the joint of two materials.

use super::super::benchmark::{larger, relative};
use super::super::exact::HalfSpaces;
use super::super::scene::{START, block, never_melting, profile, run};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::measure::lagrange;
use crate::run::Simulation;
use std::sync::Arc;

const TIME: f64 = 0.05;

/// Places where temperatures are compared.
const PLACES: [f64; 6] = [-1.0, -0.5, -0.1, 0.1, 0.5, 1.0];

/// The body ends this many diffusion lengths sqrt(4 a t) from the joint: erfc(5.5) = 7e-15.
const LENGTHS: f64 = 5.5;

const TEN: HalfSpaces = HalfSpaces { start: [1.0, 0.0], conductivity: [1.0, 10.0], capacity: [1.0; 2] };
const THOUSAND: HalfSpaces = HalfSpaces { start: [1.0, 0.0], conductivity: [1.0, 1000.0], capacity: [1.0; 2] };
const MARKS: &[Mark] = &[Mark { resolution: 50.0, error: 0.01 }];

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/half-spaces",
    tested_crate: "sph-thermal",
    reference: "T_i = (b1 T1 + b2 T2)/(b1 + b2), b = sqrt(k rho c), erf on each side; t = 0.05",
    quantities: &[
        Quantity {
            suffix: "ratio-10",
            text: "worst relative error of the joint's temperature and of T at x = -1, -0.5, -0.1, 0.1, 0.5, 1 for \
                   conductivities 1 and 10; resolution: spacings from x = -1 to 1",
            marks: MARKS,
        },
        Quantity {
            suffix: "ratio-1000",
            text: "the same for conductivities 1 and 1000",
            marks: MARKS,
        },
    ],
    resolutions: [25.0, 50.0, 100.0],
    quick: 2,
    run: both,
};

fn both(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let (ten, thousand) = (contact(&TEN, resolution)?, contact(&THOUSAND, resolution)?);
    Ok(Outcome {
        errors: vec![ten.errors[0], thousand.errors[0]],
        particles: ten.particles.max(thousand.particles),
        pair_visits: ten.pair_visits + thousand.pair_visits,
    })
}

fn contact(exact: &HalfSpaces, resolution: f64) -> Result<Outcome, BenchmarkError> {
    let spacing = 2.0 / resolution;
    let cells = [0, 1].map(|side| {
        let length = (4.0 * exact.conductivity[side] / exact.capacity[side] * TIME).sqrt();
        (LENGTHS * length.max(0.25) / spacing).ceil() as usize
    });
    let materials = [0, 1].map(|side| never_melting(1.0, exact.capacity[side], exact.conductivity[side]));
    let mut model = block([cells[0] + cells[1], 1, 1], spacing, materials.to_vec())?;
    model.low_corner[0] = -(cells[0] as f64) * spacing;
    let start = exact.start;
    model.start = Arc::new(move |[x, ..]| {
        let side = usize::from(x > 0.0);
        (side as u8, START + start[side])
    });
    model.end = TIME;
    let simulation = run(model)?;
    let error = error(exact, &simulation);
    Ok(Outcome::of(&simulation, vec![error]))
}

fn error(exact: &HalfSpaces, simulation: &Simulation) -> f64 {
    let nodes: Vec<_> = profile(simulation).into_iter().map(|(x, t)| (x, t - START)).collect();
    let middle = nodes.partition_point(|node| node.0 < 0.0);
    let sides = [&nodes[..middle], &nodes[middle..]];
    // The law of the joint: the flux from the last centre to the joint is that from the joint to the next centre.
    let [k1, k2] = exact.conductivity;
    let joint = (k1 * nodes[middle - 1].1 + k2 * nodes[middle].1) / (k1 + k2);
    let at = |x: f64| {
        let side = sides[usize::from(x > 0.0)];
        let next = side.partition_point(|node| node.0 < x).clamp(2, side.len() - 2);
        relative(lagrange(&side[next - 2..next + 2], x), exact.temperature(x, TIME))
    };
    PLACES.into_iter().map(at).fold(relative(joint, exact.joint_temperature()), larger)
}
