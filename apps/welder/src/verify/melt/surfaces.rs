//! The area that the particles of a surface make up.

use super::super::benchmark::relative;
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::measure::{Areas, circle, plane, sphere};

/// Text of the weights of both forces.
const TENSION: &str =
    "sum of V 2 |grad C| over the true area, less one; resolution: spacings to the radius or depth";
const MARANGONI: &str = "sum of V 2 w1(depth), the weight of Marangoni's force, over the true area, less one";

fn errors(areas: &Areas) -> Vec<f64> {
    vec![relative(areas.tension, 1.0), relative(areas.marangoni, 1.0)]
}

pub(in super::super) const PLANE: Benchmark = Benchmark {
    name: "melt/plane-measure",
    tested_crate: "sph-fluid",
    reference: "length of two flat faces",
    quantities: &[
        Quantity { suffix: "tension", text: TENSION, marks: &[Mark { resolution: 8.0, error: 0.01 }] },
        Quantity { suffix: "marangoni", text: MARANGONI, marks: &[Mark { resolution: 8.0, error: 0.01 }] },
    ],
    resolutions: [8.0, 12.0, 16.0],
    quick: 1,
    run: |resolution| {
        let (areas, patch) = plane(resolution as usize, find)?;
        Ok(outcome(&patch, errors(&areas)))
    },
};

pub(in super::super) const CIRCLE: Benchmark = Benchmark {
    name: "melt/circle-measure",
    tested_crate: "sph-fluid",
    reference: "length of the circle that holds the volume of a drop, after two capillary times",
    quantities: &[
        Quantity {
            suffix: "tension",
            text: TENSION,
            marks: &[Mark { resolution: 16.0, error: 0.03 }, Mark { resolution: 32.0, error: 0.02 }],
        },
        Quantity {
            suffix: "marangoni",
            text: MARANGONI,
            marks: &[Mark { resolution: 16.0, error: 0.03 }, Mark { resolution: 32.0, error: 0.02 }],
        },
    ],
    resolutions: [8.0, 16.0, 32.0],
    quick: 2,
    run: |resolution| {
        let (areas, patch) = circle(resolution as usize, find)?;
        Ok(outcome(&patch, errors(&areas)))
    },
};

pub(in super::super) const SPHERE: Benchmark = Benchmark {
    name: "melt/sphere-measure",
    tested_crate: "sph-fluid",
    reference: "area of the sphere that holds the volume of a ball cut out of a lattice, after two capillary times",
    quantities: &[
        Quantity {
            suffix: "tension",
            text: TENSION,
            marks: &[Mark { resolution: 6.0, error: 0.12 }, Mark { resolution: 12.0, error: 0.06 }],
        },
        Quantity {
            suffix: "marangoni",
            text: MARANGONI,
            marks: &[Mark { resolution: 6.0, error: 0.06 }, Mark { resolution: 12.0, error: 0.06 }],
        },
    ],
    resolutions: [6.0, 9.0, 12.0],
    quick: 1,
    run: |resolution| {
        let (areas, patch) = sphere(resolution as usize, find)?;
        Ok(outcome(&patch, errors(&areas)))
    },
};
