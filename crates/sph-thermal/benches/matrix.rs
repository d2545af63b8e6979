//! Pair visits of stored rows on one thread: lattices of 6, 26 and 80 neighbours, and a disordered set (indexed path).
//!
//! Throughput is counted in directed pairs: elements a second are pair visits a second.

#![allow(missing_docs, reason = "criterion's macros make undocumented items")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{PairReach, SearchMethod};
use sph_thermal::conduction::{ConductionMatrix, Images, LANES, PairTable, Planes};
use std::hint::black_box;

/// A number from -1 to 1, scattered by `seed`.
fn noise(seed: usize) -> f64 {
    let mixed = (seed as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    (mixed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// Normalized rows of a cube of unit spacing, each particle shifted by up to `disorder`.
fn matrix(side: usize, ratio: f64, disorder: f64) -> ConductionMatrix {
    let shift = |n: usize| disorder * Vector3::new(noise(3 * n), noise(3 * n + 1), noise(3 * n + 2));
    let cell = |n: usize| Vector3::new(n % side, n / side % side, n / side / side).map(|k| k as f64 + 0.5);
    let positions: Vec<_> = (0..side.pow(3)).map(|n| cell(n) + shift(n)).collect();
    let planes = Planes::adiabatic_box([0.0; 3], [side as f64; 3]);
    let reach = ratio * Kernel::<3>::support_radius(KernelKind::WendlandC2, 1.0);
    let images = Images::new(&positions, &vec![reach; positions.len()], &planes);
    let everything: Vec<_> = positions.iter().chain(&images.position).copied().collect();
    let list =
        SearchMethod::default().find(&everything, PairReach::Uniform(reach)).expect("finite positions");
    let factor = |_: usize, _: usize, r: f64| Kernel::<3>::gradient_factor(KernelKind::WendlandC2, r, ratio);
    let volume = vec![1.0; positions.len()];
    let pairs =
        PairTable::new(&positions, &volume, &images, |i| list.row(i), factor).expect("columns of one length");
    ConductionMatrix::new(&pairs.normalized())
}

fn products(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("heat of all rows");
    group.sample_size(20);
    for (set, side, ratio, disorder) in [
        ("lattice 6", 24, 0.7, 0.0),
        ("lattice 26", 24, 1.0, 0.0),
        ("lattice 80", 24, 1.3, 0.0),
        ("disordered 27", 24, 1.0, 0.2),
        ("lattice 26", 60, 1.0, 0.0),
        ("disordered 27", 60, 1.0, 0.2),
    ] {
        let matrix = matrix(side, ratio, disorder);
        let theta: Vec<f64> = (0..matrix.padded_len()).map(noise).collect();
        let mut heat = vec![0.0; matrix.padded_len()];
        group.throughput(Throughput::Elements(matrix.pairs() as u64));
        group.bench_function(BenchmarkId::new(set, side.pow(3)), |bencher| {
            bencher.iter(|| {
                for (chunk, heat) in heat.chunks_exact_mut(LANES).enumerate() {
                    heat.copy_from_slice(&matrix.chunk_heat(chunk, black_box(&theta)));
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, products);
criterion_main!(benches);
