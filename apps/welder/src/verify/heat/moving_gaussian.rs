//! A Gaussian spot that moves over a half space, until its field moves with it.

use super::super::benchmark::{larger, relative};
use super::super::exact::MovingGaussian;
use super::super::scene::{START, block, never_melting, run};
use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use crate::case::scene::{Face, Levels};
use crate::measure::{Gauge, lagrange};
use crate::model::{Model, ModelError};
use laser_source::{Absorption, Beam, Gaussian, LaserSource, Path};

const EXACT: MovingGaussian =
    MovingGaussian { power: 1.0, deviation: 1.0, speed: 1.0, conductivity: 1.0, diffusivity: 1.0 };

/// Where temperatures are compared: relative to the beam, z below the surface.
const PLACES: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The beam comes from this far: what it did before would add 1e-4 of the rise.
const WAY: f64 = 20.0;

/// Free space behind the start and ahead of the end, and to the side and below. A mirror image of the beam at 2 W adds
/// exp(-v (W - 0.5)/a)/(4 pi W), 1e-4 of the rise; six instead of eight was seen to add 2e-3.
const BEHIND: f64 = 4.0;
const AHEAD: f64 = 4.0;
const ASIDE: f64 = 8.0;

/// The box of finest particles, relative to the end of the way.
const FINE_BEHIND: f64 = 6.0;
const FINE_AHEAD: f64 = 3.0;
const FINE_ASIDE: f64 = 3.5;

pub(in super::super) const BENCHMARK: Benchmark = Benchmark {
    name: "heat/moving-gaussian",
    tested_crate: "laser-source",
    // With the program's own steps: their rule of 0.08 beam radii leaves up to 1 % behind and ahead of the beam.
    reference: "Eagar and Tsai, Q = k = a = v = s = 1: 0.14562044, 0.13072460, 0.10630917, 0.05375322",
    quantities: &[Quantity {
        suffix: "",
        text: "worst relative error of the rise at (0, 0, 0), (-1, 0, 0), (0, 1, 0) and one below the beam; \
               resolution: spacings to s",
        marks: &[Mark { resolution: 8.0, error: 0.02 }],
    }],
    resolutions: [4.0, 8.0, 16.0],
    quick: 2,
    run: seam,
};

fn seam(resolution: f64) -> Result<Outcome, BenchmarkError> {
    let simulation = run(model(resolution)?)?;
    let spacing = simulation.model().spacing();
    let error = |place: [f64; 3]| {
        relative(temperature(simulation.gauge(), spacing, place) - START, EXACT.rise(place))
    };
    let error = PLACES.into_iter().map(error).fold(0.0, larger);
    Ok(Outcome::of(&simulation, vec![error]))
}

/// Half of the body, behind the symmetry plane y = 0; the beam ends at x = 0.
fn model(resolution: f64) -> Result<Model, ModelError> {
    let cells = |length: f64| (length * resolution).round() as usize;
    let counts = [cells(BEHIND + WAY + AHEAD), cells(ASIDE), cells(ASIDE)];
    let material = never_melting(1.0, 1.0, EXACT.conductivity);
    let mut model = block(counts, 1.0 / resolution, vec![material])?;
    model.low_corner = [-WAY - BEHIND, 0.0];
    model.faces.y_min = Face::Symmetry;
    model.resolution.levels =
        Levels::FineBox { low_m: [-FINE_BEHIND, 0.0, -FINE_ASIDE], high_m: [FINE_AHEAD, FINE_ASIDE, 0.0] };
    let beam = Beam::Gaussian(Gaussian { radius_1e_m: 2f64.sqrt() * EXACT.deviation });
    let path = Path::Straight {
        from_m: [-WAY, 0.0],
        to_m: [0.0, 0.0],
        speed_m_s: EXACT.speed,
        power_w: EXACT.power,
        start_s: 0.0,
    };
    model.laser = Some(LaserSource::new(beam, path, Absorption::Surface { absorptivity: 1.0 })?);
    model.end = WAY / EXACT.speed;
    Ok(model)
}

/// Temperature at a place, by cubics through the gauge's sections; y is mirrored at zero.
fn temperature(gauge: &Gauge, spacing: f64, [x, y, z]: [f64; 3]) -> f64 {
    let first = (y / spacing - 1.5).round() as i64;
    let node = |k: i64| {
        let row = (k as f64 + 0.5) * spacing;
        (row, in_section(gauge, row.abs(), x, z))
    };
    let nodes: Vec<_> = (first - 1..first + 3).map(node).collect();
    lagrange(&nodes, y)
}

/// Temperature at (x, z below the surface) of the section at `y` by cubics along both.
fn in_section(gauge: &Gauge, y: f64, x: f64, z: f64) -> f64 {
    let around =
        |nodes: &[f64], at: f64| nodes.partition_point(|&node| node < at).clamp(2, nodes.len() - 2) - 2;
    let (section, top) = (gauge.section(1, y), gauge.top());
    let width = section.x.len();
    let line = (0..top.y.len()).min_by(|&a, &b| (top.y[a] - y).abs().total_cmp(&(top.y[b] - y).abs()));
    let line = line.expect("the top face has rows");
    // From the top face down: its own values first, then the layers, which the section gives from below.
    let depths: Vec<f64> = std::iter::once(0.0).chain(section.y.iter().rev().map(|z| -z)).collect();
    let value = |k: usize, i: usize| match k {
        0 => top.value[line * width + i],
        _ => section.value[(section.y.len() - k) * width + i],
    };
    let (column, row) = (around(&section.x, x), around(&depths, z));
    let at_depth = |k: usize| {
        let nodes: Vec<_> = (column..column + 4).map(|i| (section.x[i], value(k, i))).collect();
        (depths[k], lagrange(&nodes, x))
    };
    let nodes: Vec<_> = (row..row + 4).map(at_depth).collect();
    lagrange(&nodes, z)
}
