//! Drops under their own tension.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::drop::{
    RESTING_VISCOSITY, SCHEME, SMALL, ball_at_rest, drop_at_rest, swinging_drop,
};

pub(in super::super) const AT_REST: Benchmark = Benchmark {
    name: "melt/drop",
    tested_crate: "sph-fluid",
    reference: "Laplace: dp = tau/R in 2-D; no flow",
    quantities: &[
        Quantity {
            suffix: "pressure",
            text: "mean pressure of a drop at rest in 2-D, relative; resolution: spacings to the radius",
            marks: &[Mark { resolution: 8.0, error: 0.02 }, Mark { resolution: 16.0, error: 0.02 }],
        },
        Quantity {
            suffix: "spurious",
            text: "eta u/tau of the largest speed that is left; resolution: spacings to the radius",
            marks: &[Mark { resolution: 8.0, error: 1e-3 }, Mark { resolution: 16.0, error: 1e-3 }],
        },
    ],
    resolutions: [8.0, 12.0, 16.0],
    quick: 2,
    run: |resolution| {
        let rest = drop_at_rest(resolution as usize, 4.0, SCHEME, find)?;
        let capillary = RESTING_VISCOSITY * rest.largest_speed;
        Ok(outcome(&rest.patch, vec![(rest.pressure - 1.0).abs(), capillary]))
    },
};

pub(in super::super) const BALL: Benchmark = Benchmark {
    name: "melt/drop-3d",
    tested_crate: "sph-fluid",
    reference: "Laplace: dp = 2 tau/R",
    quantities: &[Quantity {
        suffix: "",
        text: "mean pressure of a ball cut out of a lattice, relative; resolution: spacings to the radius",
        marks: &[Mark { resolution: 6.0, error: 0.02 }, Mark { resolution: 9.0, error: 0.02 }],
    }],
    resolutions: [6.0, 7.0, 9.0],
    quick: 1,
    run: |resolution| {
        let rest = ball_at_rest(resolution as usize, 2.0, SCHEME, find)?;
        Ok(outcome(&rest.patch, vec![(rest.pressure - 1.0).abs()]))
    },
};

pub(in super::super) const SWINGING: Benchmark = Benchmark {
    name: "melt/swinging-drop",
    tested_crate: "sph-fluid",
    reference: "Rayleigh (1879), second mode in 2-D: T = 2 pi sqrt(rho R^3/(6 tau))",
    quantities: &[Quantity {
        suffix: "",
        text: "period over three periods, relative; resolution: spacings to the radius",
        marks: &[Mark { resolution: 10.0, error: 0.03 }, Mark { resolution: 20.0, error: 0.03 }],
    }],
    resolutions: [10.0, 14.0, 20.0],
    quick: 1,
    run: |resolution| {
        let swing = swinging_drop(resolution as usize, SMALL, SCHEME, find)?;
        Ok(outcome(&swing.patch, vec![(swing.period() - 1.0).abs()]))
    },
};
