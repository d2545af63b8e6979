//! Standing waves in aluminium between free ends.

use super::super::{Benchmark, BenchmarkError, Mark, Outcome, Quantity};
use super::{find, outcome};
use sph_solid::benchmarks::waves::{bar_wave, plate_wave, pressure_wave, shear_wave};

pub(in super::super) const PRESSURE: Benchmark =
    wave("solid/waves/pressure", "c_P = sqrt((K + 4 G/3)/rho)", |resolution| {
        let (ratio, patch) = pressure_wave(resolution as usize, find)?;
        Ok(outcome(&patch, vec![(ratio - 1.0).abs()]))
    });

pub(in super::super) const SHEAR: Benchmark = wave("solid/waves/shear", "c_S = sqrt(G/rho)", |resolution| {
    let (ratio, patch) = shear_wave(resolution as usize, find)?;
    Ok(outcome(&patch, vec![(ratio - 1.0).abs()]))
});

pub(in super::super) const BAR: Benchmark =
    wave("solid/waves/bar", "sqrt(E/rho) in a slender bar", |resolution| {
        let (ratio, patch) = bar_wave(resolution as usize, find)?;
        Ok(outcome(&patch, vec![(ratio - 1.0).abs()]))
    });

pub(in super::super) const PLATE: Benchmark =
    wave("solid/waves/plate", "sqrt(E/((1 - nu^2) rho)) in a thin plate, plane strain", |resolution| {
        let (ratio, patch) = plate_wave(resolution as usize, find)?;
        Ok(outcome(&patch, vec![(ratio - 1.0).abs()]))
    });

const fn wave(
    name: &'static str,
    reference: &'static str,
    run: fn(f64) -> Result<Outcome, BenchmarkError>,
) -> Benchmark {
    Benchmark {
        name,
        tested_crate: "sph-solid",
        reference,
        quantities: &[Quantity {
            suffix: "",
            text: "speed from half a period of the lowest mode, relative; resolution: spacings to the length",
            marks: &[Mark { resolution: 40.0, error: 0.01 }],
        }],
        resolutions: [20.0, 40.0, 80.0],
        quick: 2,
        run,
    }
}
