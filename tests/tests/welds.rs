//! Welds of several metals, beams, plates, losses and speeds against independent finite volumes.
//!
//! The scenes stand in docs/references/welds/scenes, the values in tests/data/reference_welds.csv; docs/references/welds
//! says how they were made. Each scene has about 8.5 spacings to the beam's 1/e radius, where the marks hold: 1 % on the
//! width, 2.5 % on the depth, 1 % on the peak's rise, 2 % on the time of full freezing.

use std::path::{Path, PathBuf};
use welder::case;
use welder::model::Model;
use welder::run::Simulation;

/// What the finite volumes found.
struct Reference {
    width: f64,
    depth: f64,
    peak: f64,
    frozen: f64,
    start: f64,
}

/// Marks as shares of the value.
const WIDTH: f64 = 0.01;
const DEPTH: f64 = 0.025;
const PEAK_RISE: f64 = 0.01;
const FROZEN: f64 = 0.02;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn reference(name: &str) -> Reference {
    let text =
        std::fs::read_to_string(folder().join("data/reference_welds.csv")).expect("the stored references");
    let rows: Vec<Vec<&str>> =
        text.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').collect()).collect();
    let row = rows.iter().find(|row| row[0] == name).expect("a stored reference");
    let value = |column: &str| {
        let at = rows[0].iter().position(|head| *head == column).expect("a column of the references");
        row[at].parse::<f64>().expect("a number")
    };
    Reference {
        width: value("width_m"),
        depth: value("depth_m"),
        peak: value("peak_k"),
        frozen: value("frozen_s"),
        start: value("start_k"),
    }
}

/// Runs a scene and compares it with its reference.
fn check(name: &str) {
    let expected = reference(name);
    let scene = folder().join(format!("../docs/references/welds/scenes/{name}.ron"));
    let case = case::load(&scene, &[]).unwrap_or_else(|error| panic!("{}", error.report(false)));
    let mut simulation = Simulation::new(Model::from_case(&case).unwrap()).unwrap();
    simulation.run_quietly().unwrap();
    let records = simulation.records();
    let frozen = records.solidified_at.expect("frozen before the end");
    let rise = (records.peak_temperature - expected.start) / (expected.peak - expected.start);
    let found = [
        ("width", records.liquidus.width / expected.width, WIDTH),
        ("depth", records.liquidus.depth / expected.depth, DEPTH),
        ("peak rise", rise, PEAK_RISE),
        ("freezing time", frozen / expected.frozen, FROZEN),
    ];
    let line = found.map(|(what, ratio, _)| format!("{what} {:+.2} %", 100.0 * (ratio - 1.0))).join(", ");
    println!("{name}: {line}, {} particles", simulation.particles().len());
    for (what, ratio, mark) in found {
        assert!((ratio - 1.0).abs() <= mark, "{name}: {what} is off by more than {} %: {line}", 100.0 * mark);
    }
    assert_eq!(simulation.ledger().fault(), None, "{name}");
    assert!(!records.now.beyond_finest, "{name}: melt beyond the finest particles");
}

/// One test for each scene.
macro_rules! welds {
    ($($test:ident $name:literal)*) => { $( #[test] fn $test() { check($name); } )* };
}

welds! {
    aluminium_400_w "al-400"
    aluminium_600_w "al-600"
    melting_range_of_one_kelvin "al-1k"
    steel "steel"
    nickel_alloy "in625"
    thin_plate "thin-steel"
    melt_through_a_thin_plate "thin-steel-through"
    top_hat_on_an_odd_number_of_cells "top-hat"
    strong_losses_for_long "losses"
    melt_that_conducts_four_times_better "conducting-melt"
    short_pulse "short-pulse"
    two_ramps "two-ramps"
    start_near_the_solidus "hot-start"
    pool_larger_than_the_beam "small-beam"
    steel_seam "seam-steel-2"
}
