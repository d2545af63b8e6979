//! The aluminium spot against an independent solver, at 50 um; `welder verify weld` runs 25 um as well.

use welder::verify::{Benchmark, benchmarks};

/// Measures a benchmark at one resolution and asserts the marks that stand there.
fn holds_at(name: &str, resolution: f64) {
    let benchmark: &Benchmark = benchmarks().iter().find(|benchmark| benchmark.name == name).unwrap();
    let found = benchmark.measure(resolution).expect("an answer");
    for (quantity, level) in benchmark.quantities.iter().zip(found) {
        let mark = quantity.marks.iter().find(|mark| mark.resolution == resolution).expect("a mark");
        assert!(level.error <= mark.error, "{name}/{}: {} > {}", quantity.suffix, level.error, mark.error);
    }
}

#[test]
fn spot_on_a_lattice() {
    holds_at("weld/spot-aluminium", 12.0);
}

#[test]
fn spot_on_disordered_particles() {
    holds_at("weld/spot-aluminium-disordered", 12.0);
}

#[test]
fn the_ledger_closes_and_threads_agree() {
    holds_at("round-off/energy-ledger", 8.0);
    holds_at("round-off/threads", 44.0);
}
