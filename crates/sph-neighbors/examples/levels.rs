//! Particles of five sizes, each twice as large as the last: what the list costs where sizes differ, and that both search
//! methods agree.

use nalgebra::SVector;
use sph_neighbors::{PairReach, SearchMethod, spatial_order};
use std::time::Instant;

const SIDE: usize = 64;

/// Nested squares: spacing 2^level outside the square of the level below.
fn nested_levels() -> (Vec<SVector<f64, 2>>, Vec<f64>) {
    let (mut positions, mut reaches) = (Vec::new(), Vec::new());
    for level in 0..5 {
        let spacing = f64::from(1 << level);
        for k in 0..SIDE * SIDE {
            let cell =
                SVector::from([(k % SIDE) as f64, (k / SIDE) as f64]).add_scalar(0.5 - SIDE as f64 / 2.0);
            if level == 0 || cell.amax() > SIDE as f64 / 4.0 {
                positions.push(cell * spacing);
                reaches.push(2.0 * spacing);
            }
        }
    }
    (positions, reaches)
}

fn main() {
    let (positions, reaches) = nested_levels();
    let order = spatial_order(&positions, 4.0).expect("finite positions");
    let (positions, reaches) = (order.gather(&positions), order.gather(&reaches));
    for reach in [PairReach::Maximum(&reaches), PairReach::Mean(&reaches)] {
        let lists = [SearchMethod::CellGrid, SearchMethod::KdTree].map(|method| {
            let start = Instant::now();
            let list = method.find(&positions, reach).expect("valid input");
            let milliseconds = 1e3 * start.elapsed().as_secs_f64();
            let (particles, pairs, longest) = (list.particles(), list.pairs(), list.longest_row());
            println!("{method:?}: {particles} particles, {pairs} pairs, longest row {longest}, {milliseconds:.1} ms");
            list
        });
        assert_eq!(lists[0], lists[1]);
    }
}
