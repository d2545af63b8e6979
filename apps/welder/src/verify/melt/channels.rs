//! Start-up of flow between plates (Morris, Fox and Zhu 1997).

use super::super::benchmark::larger;
use super::super::{Benchmark, Mark, Quantity};
use super::{find, outcome};
use sph_fluid::benchmarks::channel::{couette_errors, poiseuille_errors};

pub(in super::super) const POISEUILLE: Benchmark = Benchmark {
    name: "melt/poiseuille",
    tested_crate: "sph-fluid",
    reference: "series of Morris, Fox and Zhu (1997): a force starts flow between plates at rest, Re 0.0125",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error of any particle at five times, over the speed of the steady flow; resolution: particles \
               across",
        marks: &[
            Mark { resolution: 12.0, error: 0.021 },
            Mark { resolution: 25.0, error: 0.0075 },
            Mark { resolution: 50.0, error: 0.007 },
        ],
    }],
    resolutions: [12.0, 25.0, 50.0],
    quick: 2,
    run: |resolution| {
        let (errors, channel) = poiseuille_errors(resolution as usize, find)?;
        Ok(outcome(&channel.patch, vec![errors.into_iter().fold(0.0, larger)]))
    },
};

pub(in super::super) const COUETTE: Benchmark = Benchmark {
    name: "melt/couette",
    tested_crate: "sph-fluid",
    reference: "series of Morris, Fox and Zhu (1997): the upper plate starts flow, Re 0.0125",
    quantities: &[Quantity {
        suffix: "",
        text: "largest error of any particle at five times, over the speed of the plate; resolution: particles across",
        marks: &[
            Mark { resolution: 12.0, error: 0.009 },
            Mark { resolution: 25.0, error: 0.0028 },
            Mark { resolution: 50.0, error: 0.007 },
        ],
    }],
    resolutions: [12.0, 25.0, 50.0],
    quick: 2,
    run: |resolution| {
        let (errors, channel) = couette_errors(resolution as usize, find)?;
        Ok(outcome(&channel.patch, vec![errors.into_iter().fold(0.0, larger)]))
    },
};
