//! Heat against exact solutions: every benchmark of `welder verify` at sizes that cost seconds.

use welder::case::scene::Weights;
use welder::cli::Level;
use welder::verify::{benchmarks, error_with_weights, observed_order};

/// Runs a benchmark at the resolutions of a quick run and asserts every mark that they meet.
fn holds(name: &str) {
    let benchmark =
        benchmarks().iter().find(|benchmark| benchmark.name == name).expect("a benchmark of this name");
    for entry in benchmark.entries(Level::Quick).expect("an answer") {
        assert!(entry.passed, "{}: {:?}", entry.name, entry.levels);
    }
}

macro_rules! marks_hold {
    ($($test:ident: $name:literal),+ $(,)?) => { $(#[test] fn $test() { holds($name); })+ };
}

marks_hold! {
    cosine_decay: "heat/cosine-decay",
    cosine_decay_disordered: "heat/cosine-decay-disordered",
    half_spaces: "heat/half-spaces",
    constant_flux: "heat/constant-flux",
    gaussian_spot: "heat/gaussian-spot",
    gaussian_field: "heat/gaussian-field",
    top_hat: "heat/top-hat",
    stefan: "heat/stefan",
    mushy_stefan: "heat/mushy-stefan",
    moving_gaussian: "heat/moving-gaussian",
}

#[test]
fn conduction_on_a_lattice_is_of_second_order() {
    let benchmark = benchmarks().iter().find(|benchmark| benchmark.name == "heat/cosine-decay").unwrap();
    let levels: Vec<_> = benchmark.resolutions.iter().map(|&n| benchmark.measure(n).unwrap()[0]).collect();
    let order = observed_order(&levels).unwrap();
    assert!((order - 2.0).abs() < 0.1, "{order}: {levels:?}");
}

#[test]
fn plain_weights_are_too_hot_under_the_beam() {
    // The negative control: what misses the mark of gaussian-spot when the weights are not made exact.
    let plain = error_with_weights(5.0, Weights::Plain).unwrap();
    assert!(plain > 0.05 && plain < 0.16, "{plain}");
}
