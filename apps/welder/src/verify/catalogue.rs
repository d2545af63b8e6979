//! All benchmarks, in the order in which they run.

use super::coupled::{cup, cycles, gallium, gate, grid, nist_tracks, rest};
use super::heat::{
    constant_flux, cosine_decay, evaporation, gaussian_field, gaussian_spot, half_spaces, moving_gaussian,
    mushy_stefan, stefan, top_hat,
};
use super::melt::{cavities, channels, drops, layers, pools, squares, surfaces, vortices, warmths, waters};
use super::solid::{clamped_plate, heated, rings, rotation, round, stability, swings, waves};
use super::{Benchmark, round_off, weld};

static BENCHMARKS: &[Benchmark] = &[
    cosine_decay::LATTICE,
    cosine_decay::DISORDERED,
    half_spaces::BENCHMARK,
    constant_flux::BENCHMARK,
    evaporation::BENCHMARK,
    gaussian_spot::BENCHMARK,
    gaussian_field::BENCHMARK,
    top_hat::BENCHMARK,
    stefan::BENCHMARK,
    mushy_stefan::BENCHMARK,
    moving_gaussian::BENCHMARK,
    channels::POISEUILLE,
    channels::COUETTE,
    waters::TANK,
    waters::STANDING_WAVE,
    waters::DAM_BREAK,
    vortices::TAYLOR_GREEN,
    squares::ROTATING,
    drops::AT_REST,
    drops::BALL,
    drops::SWINGING,
    layers::FILM,
    layers::RETURN_FLOW,
    layers::CLOSED_LAYER,
    cavities::RE_100,
    pools::RESTING,
    pools::HALF_DISC,
    pools::HALF_SPHERE,
    pools::HOT,
    surfaces::PLANE,
    surfaces::CIRCLE,
    surfaces::SPHERE,
    warmths::SHEAR,
    warmths::CONVECTION,
    waves::PRESSURE,
    waves::SHEAR,
    waves::BAR,
    waves::PLATE,
    stability::PLANE,
    stability::SPACE,
    swings::PLATE,
    swings::CLAMPED,
    swings::AMPLITUDE_KEPT,
    swings::BEAM,
    rotation::TURNED,
    rotation::TURNED_UPDATED,
    rotation::SHEARED,
    rotation::SPIN,
    heated::FREE,
    heated::BAR,
    heated::PLATE,
    heated::BLOCK,
    heated::GOUGH_JOULE,
    round::DISC,
    round::SPHERE,
    clamped_plate::BENCHMARK,
    rings::RINGS,
    rings::PAPER_RINGS,
    weld::LATTICE,
    weld::DISORDERED,
    nist_tracks::BENCHMARK,
    rest::BENCHMARK,
    cup::BENCHMARK,
    cycles::WITH_STRESS,
    cycles::WITH_FLOW,
    gate::BENCHMARK,
    grid::BENCHMARK,
    gallium::BENCHMARK,
    round_off::LEDGER,
    round_off::MELT_MOMENTUM,
    round_off::THREADS,
    round_off::RESUME,
];

/// All benchmarks.
pub fn benchmarks() -> &'static [Benchmark] {
    BENCHMARKS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_every_quick_run_meets_a_mark() {
        let mut names: Vec<String> = benchmarks().iter().flat_map(Benchmark::entry_names).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count);
        for benchmark in benchmarks() {
            let quick = &benchmark.resolutions[..benchmark.quick];
            assert!(benchmark.resolutions.windows(2).all(|pair| pair[0] < pair[1]), "{}", benchmark.name);
            for quantity in benchmark.quantities {
                let met = |resolutions: &[f64], all: bool| {
                    let mut runs = quantity.marks.iter().map(|mark| resolutions.contains(&mark.resolution));
                    if all { runs.all(|run| run) } else { runs.any(|run| run) }
                };
                assert!(met(quick, false), "{}: a quick run judges nothing", benchmark.name);
                assert!(met(&benchmark.resolutions, true), "{}: a mark no run meets", benchmark.name);
            }
        }
    }
}
