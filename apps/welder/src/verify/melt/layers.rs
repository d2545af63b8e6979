//! Layers that the change of tension with temperature drives.

use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::layer::{CLOSED_SCHEME, ClosedLayer, SCHEME, film, return_flow};

pub(in super::super) const FILM: Benchmark = Benchmark {
    name: "melt/film",
    tested_crate: "sph-fluid",
    reference: "one-sided shear, u = tau_T G z/eta",
    quantities: &[Quantity {
        suffix: "",
        text: "speed of the surface of an open film, relative; resolution: rows",
        marks: &[Mark { resolution: 8.0, error: 0.02 }],
    }],
    resolutions: [8.0, 16.0, 24.0],
    quick: 2,
    run: |resolution| {
        let (ratio, patch) = film(resolution as usize, SCHEME, find)?;
        Ok(outcome(&patch, vec![(ratio - 1.0).abs()]))
    },
};

pub(in super::super) const RETURN_FLOW: Benchmark = Benchmark {
    name: "melt/return-flow",
    tested_crate: "sph-fluid",
    reference: "Birikh (1966): u_s = tau_T G H/(4 eta) without net flux",
    quantities: &[Quantity {
        suffix: "",
        text: "speed of the surface of a shallow layer, relative; resolution: rows",
        marks: &[
            Mark { resolution: 8.0, error: 0.04 },
            Mark { resolution: 16.0, error: 0.03 },
            Mark { resolution: 32.0, error: 0.02 },
        ],
    }],
    resolutions: [8.0, 16.0, 32.0],
    quick: 2,
    run: |resolution| {
        let (ratio, _, patch) = return_flow(resolution as usize, SCHEME, find)?;
        Ok(outcome(&patch, vec![(ratio - 1.0).abs()]))
    },
};

pub(in super::super) const CLOSED_LAYER: Benchmark = Benchmark {
    name: "melt/closed-layer",
    tested_crate: "sph-fluid",
    reference: "Birikh (1966) in the middle of a layer of length 6 between end walls",
    quantities: &[
        Quantity {
            suffix: "",
            text: "speed of the surface in the middle at t = 28, relative; resolution: rows",
            marks: &[Mark { resolution: 8.0, error: 0.05 }],
        },
        Quantity {
            suffix: "late",
            text: "the same at t = 56",
            marks: &[Mark { resolution: 8.0, error: 0.05 }],
        },
        Quantity {
            suffix: "growth",
            text: "L2 error of the velocities in the middle over their L2 norm, mean of four times from 35 to 56 less that \
                   of four from 7 to 28; below zero it falls",
            marks: &[Mark { resolution: 8.0, error: 0.02 }],
        },
        Quantity {
            suffix: "thickness",
            text: "change of the mean height of the upper row between t = 28 and 56, over the layer's",
            marks: &[Mark { resolution: 8.0, error: 0.01 }],
        },
    ],
    resolutions: [8.0, 10.0, 12.0],
    quick: 1,
    run: |resolution| {
        let mut layer = ClosedLayer::new(resolution as usize, CLOSED_SCHEME, find)?;
        let looks: [_; 8] = std::array::from_fn(|k| {
            layer.run_to(7.0 * (k + 1) as f64);
            let (ratio, field) = layer.middle();
            ((ratio - 1.0).abs(), field, layer.height())
        });
        let field =
            |part: &[(f64, f64, f64)]| part.iter().map(|look| look.1).sum::<f64>() / part.len() as f64;
        let (early, late) = (looks[3], looks[7]);
        let growth = field(&looks[4..]) - field(&looks[..4]);
        Ok(outcome(&layer.patch, vec![early.0, late.0, growth, (late.2 - early.2).abs()]))
    },
};
