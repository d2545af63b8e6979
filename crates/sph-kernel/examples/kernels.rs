//! Prints W, f and the colour sum of a lattice for every kernel: how well each integrates at a given h/dx.

use nalgebra::SVector;
use sph_kernel::{KernelKind, RowBuffer, operators};

const SIDE: usize = 11;

fn main() {
    let positions: Vec<SVector<f64, 2>> =
        (0..SIDE * SIDE).map(|k| SVector::from([(k % SIDE) as f64, (k / SIDE) as f64])).collect();
    let volumes = vec![1.0; positions.len()];
    let middle = positions.len() / 2;
    let others: Vec<u32> = (0..positions.len() as u32).filter(|&j| j as usize != middle).collect();
    let mut buffer = RowBuffer::default();
    println!("{:14} {:>5} {:>6} {:>9} {:>9} {:>9}", "kernel", "h/dx", "pairs", "W(0)", "colour", "moment");
    for kind in KernelKind::ALL {
        for length in [1.0, 1.2, 1.5] {
            let kernel = kind.with_smoothing_length::<2>(length);
            let row = buffer.fill(middle, &others, &positions, &kernel);
            let colour = operators::summation(&row, &volumes, kernel.value(0.0));
            let moment = operators::laplacian_moment(&row, &volumes);
            let (pairs, centre) = (row.len(), kernel.value(0.0));
            println!("{kind:14} {length:5.2} {pairs:6} {centre:9.5} {colour:9.5} {moment:9.5}");
        }
    }
}
