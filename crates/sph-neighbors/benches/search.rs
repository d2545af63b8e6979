//! Cell grid against k-d tree on lattices and on clustered sets, 10 000 and 100 000 particles, on one thread.

#![allow(missing_docs, reason = "criterion's macros make undocumented items")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use nalgebra::SVector;
use sph_neighbors::{PairReach, SearchMethod};
use std::hint::black_box;

type Points = Vec<SVector<f64, 3>>;

/// Uniform numbers from 0 to 1, the same at every run.
fn random_numbers() -> impl FnMut() -> f64 {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A cubic lattice of unit spacing with about `particles` points, disordered by a tenth of it.
fn lattice(particles: usize) -> Points {
    let side = (particles as f64).cbrt().round() as usize;
    let mut random = random_numbers();
    let place = |k: usize| [k % side, k / side % side, k / side / side];
    (0..side.pow(3)).map(|k| SVector::from(place(k)).map(|x| x as f64 + 0.2 * (random() - 0.5))).collect()
}

/// As many points in 64 clusters, spread a hundred times further than each is wide.
fn clusters(particles: usize) -> Points {
    let mut random = random_numbers();
    let width = (particles as f64 / 64.0).cbrt();
    let corners: Points = (0..64).map(|_| SVector::from_fn(|_, _| 100.0 * width * random())).collect();
    (0..particles).map(|k| corners[k * 64 / particles] + SVector::from_fn(|_, _| width * random())).collect()
}

fn search(criterion: &mut Criterion) {
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool of one thread");
    let mut group = criterion.benchmark_group("search");
    group.sample_size(10);
    for particles in [10_000, 100_000] {
        for (set, points) in [("lattice", lattice(particles)), ("clusters", clusters(particles))] {
            for reach in [1.2, 1.8, 2.6] {
                for method in [SearchMethod::CellGrid, SearchMethod::KdTree] {
                    let name = BenchmarkId::new(format!("{set}/{particles}/{reach}"), format!("{method:?}"));
                    let find = || method.find(black_box(&points), PairReach::Uniform(reach));
                    group.bench_function(name, |bencher| one_thread.install(|| bencher.iter(find)));
                }
            }
        }
    }
    group.finish();
}

criterion_group!(benches, search);
criterion_main!(benches);
