//! Disc and sphere with a hot centre.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::round::{hot_disc, hot_sphere};

pub(in super::super) const DISC: Benchmark = Benchmark {
    name: "solid/disc",
    tested_crate: "sph-solid",
    reference: "Timoshenko and Goodier (1970), plane strain, T = T1 exp(-r^2/(0.4 R)^2)",
    quantities: &[Quantity {
        suffix: "",
        text: "L2 error of stress within 0.85 R, relative; resolution: spacings to the radius",
        marks: &[
            Mark { resolution: 10.0, error: 0.04 },
            Mark { resolution: 20.0, error: 0.016 },
            Mark { resolution: 40.0, error: 0.006 },
        ],
    }],
    resolutions: [10.0, 20.0, 40.0],
    quick: 2,
    run: |resolution| {
        let (error, patch) = hot_disc(resolution as usize, find)?;
        Ok(outcome(&patch, vec![error]))
    },
};

pub(in super::super) const SPHERE: Benchmark = Benchmark {
    name: "solid/sphere",
    tested_crate: "sph-solid",
    reference: "Timoshenko and Goodier (1970), T = T1 (1 - r^2/R^2)",
    quantities: &[
        Quantity {
            suffix: "field",
            text: "L2 error of stress within 0.85 R, relative; resolution: spacings to the radius",
            marks: &[
                Mark { resolution: 8.0, error: 0.1 },
                Mark { resolution: 12.0, error: 0.04 },
                Mark { resolution: 15.0, error: 0.03 },
            ],
        },
        Quantity {
            suffix: "centre",
            text: "mean stress at the centre, relative; resolution: spacings to the radius",
            marks: &[Mark { resolution: 8.0, error: 0.03 }, Mark { resolution: 15.0, error: 0.03 }],
        },
        Quantity {
            suffix: "growth",
            text: "mean outward displacement from 0.85 R on, relative; resolution: spacings to the radius",
            marks: &[Mark { resolution: 8.0, error: 0.03 }, Mark { resolution: 15.0, error: 0.03 }],
        },
        Quantity {
            suffix: "hoop",
            text: "hoop stress at r = R, relative: the line in r^2 nearest to the stresses from R/2 to two spacings below the surface, continued; resolution: spacings to the radius",
            marks: &[Mark { resolution: 8.0, error: 0.03 }, Mark { resolution: 15.0, error: 0.03 }],
        },
    ],
    resolutions: [8.0, 12.0, 15.0],
    quick: 2,
    run: |resolution| {
        let sphere = hot_sphere(resolution as usize, find)?;
        Ok(outcome(
            &sphere.patch,
            vec![
                sphere.error,
                (sphere.centre - 1.0).abs(),
                (sphere.growth - 1.0).abs(),
                (sphere.hoop - 1.0).abs(),
            ],
        ))
    },
};
