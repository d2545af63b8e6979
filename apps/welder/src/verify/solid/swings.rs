//! Bending: plates and a beam that swing.

use super::super::benchmark::relative;
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::beam::{AMPLITUDE, FREQUENCY, MEAN, swinging_beam};
use sph_solid::benchmarks::plate::{BETWEEN_STRIPS, TIMOSHENKO, amplitude_after, between_strips, clamped};

pub(in super::super) const PLATE: Benchmark = Benchmark {
    name: "solid/oscillating-plate",
    tested_crate: "sph-solid",
    reference: "plate between strips (Gray, Monaghan, Swift 2001): T = 0.2616 s, converged plane-strain finite elements",
    quantities: &[
        Quantity {
            suffix: "period",
            text: "period, relative; resolution: spacings to the height",
            marks: &[Mark { resolution: 10.0, error: 0.03 }, Mark { resolution: 20.0, error: 0.015 }],
        },
        Quantity {
            suffix: "energy",
            text: "change of total energy in half a period, relative; resolution: spacings to the height",
            marks: &[Mark { resolution: 5.0, error: 1e-4 }, Mark { resolution: 10.0, error: 1e-4 }],
        },
    ],
    resolutions: [5.0, 10.0, 20.0],
    quick: 2,
    run: |resolution| {
        let swing = between_strips(resolution as usize, find)?;
        Ok(outcome(&swing.patch, vec![relative(swing.period, BETWEEN_STRIPS), swing.energy.abs()]))
    },
};

pub(in super::super) const CLAMPED: Benchmark = Benchmark {
    name: "solid/clamped-swing",
    tested_crate: "sph-solid",
    reference: "plate clamped by the layers behind its root: T = 0.2566 s, Timoshenko's beam, built in",
    quantities: &[
        Quantity {
            suffix: "period",
            text: "period, relative; resolution: spacings to the height",
            marks: &[
                Mark { resolution: 5.0, error: 0.13 },
                Mark { resolution: 10.0, error: 0.04 },
                Mark { resolution: 20.0, error: 0.012 },
            ],
        },
        Quantity {
            suffix: "energy",
            text: "change of total energy in half a period, relative; resolution: spacings to the height",
            marks: &[Mark { resolution: 5.0, error: 1e-4 }, Mark { resolution: 10.0, error: 1e-4 }],
        },
    ],
    resolutions: [5.0, 10.0, 20.0],
    quick: 2,
    run: |resolution| {
        let swing = clamped(resolution as usize, find)?;
        Ok(outcome(&swing.patch, vec![relative(swing.period, TIMOSHENKO), swing.energy.abs()]))
    },
};

pub(in super::super) const AMPLITUDE_KEPT: Benchmark = Benchmark {
    name: "solid/plate-amplitude",
    tested_crate: "sph-solid",
    reference: "a clamped plate swings without loss",
    quantities: &[Quantity {
        suffix: "",
        text: "change of amplitude after ten periods, relative; resolution: spacings to the height",
        marks: &[Mark { resolution: 4.0, error: 0.2 }],
    }],
    resolutions: [4.0, 5.0, 6.0],
    quick: 1,
    run: |resolution| {
        let (kept, patch) = amplitude_after(10, resolution as usize, find)?;
        Ok(outcome(&patch, vec![(kept - 1.0).abs()]))
    },
};

pub(in super::super) const BEAM: Benchmark = Benchmark {
    name: "solid/turek-csm3",
    tested_crate: "sph-solid",
    reference: "Turek and Hron (2006), CSM3: tip -64.09 +- 65.64 mm at 1.094 Hz",
    quantities: &[
        Quantity {
            suffix: "mean",
            text: "mean of the tip's extremes, relative; resolution: spacings to the height",
            marks: &[Mark { resolution: 4.0, error: 0.12 }, Mark { resolution: 8.0, error: 0.05 }],
        },
        Quantity {
            suffix: "amplitude",
            text: "half the difference of the tip's extremes, relative; resolution: spacings to the height",
            marks: &[Mark { resolution: 4.0, error: 0.1 }, Mark { resolution: 8.0, error: 0.05 }],
        },
        Quantity {
            suffix: "frequency",
            text: "frequency of the tip, relative; resolution: spacings to the height",
            marks: &[Mark { resolution: 4.0, error: 0.05 }, Mark { resolution: 8.0, error: 0.05 }],
        },
    ],
    resolutions: [4.0, 6.0, 8.0],
    quick: 1,
    run: |resolution| {
        let tip = swinging_beam(resolution as usize, find)?;
        let errors = [(tip.mean, MEAN), (tip.amplitude, AMPLITUDE), (tip.frequency, FREQUENCY)];
        Ok(outcome(&tip.patch, errors.map(|(found, exact)| relative(found, exact)).to_vec()))
    },
};
