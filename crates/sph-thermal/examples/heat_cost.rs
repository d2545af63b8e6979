//! What an explicit heat step costs where particles rest: the scene of `docs/references/peers/heat.in`, timed.
//!
//! `cargo run --release -p sph-thermal --example heat_cost -- [particles a side: 30] [steps: 50]`. Threads by
//! `RAYON_NUM_THREADS`. A cubic lattice with mirrored faces, 80 neighbours a particle, plain weights of Cleary and
//! Monaghan, stored once, forward Euler, T = e/c_v, a hot ball in the middle. Directed pairs are those that are stored:
//! mirror images are folded onto their sources. The line that begins with RESULT is for programs: seconds of the clock
//! and of the processor for the steps alone.

use nalgebra::Vector3;
use rayon::prelude::*;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{PairReach, SearchMethod};
use sph_thermal::conduction::{ConductionMatrix, Images, LANES, PairTable, Planes};
use std::time::Instant;

/// Distance between particles \[m\].
const SPACING: f64 = 0.01;

/// Support over spacing: 80 particles of a cubic lattice lie within it.
const SUPPORT: f64 = 2.6;

/// Diffusivity \[m²/s\].
const DIFFUSIVITY: f64 = 1e-4;

/// Rows that one task takes.
const BLOCK: usize = 512 * LANES;

fn main() {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse().expect("a whole number"));
    let side: usize = arguments.next().unwrap_or(30);
    let steps: usize = arguments.next().unwrap_or(50);
    let positions = lattice(side);
    let begun = Instant::now();
    let (matrix, searched) = conduction(side, &positions);
    let set_up = begun.elapsed().as_secs_f64();
    let mut energy = hot_ball(side, &positions, matrix.padded_len());
    let total: f64 = energy.iter().sum();
    let mut next = energy.clone();
    run(&matrix, &mut energy, &mut next, 5);
    let (begun, processor) = (Instant::now(), processor_seconds());
    run(&matrix, &mut energy, &mut next, steps);
    let (seconds, processor) = (begun.elapsed().as_secs_f64(), processor_seconds() - processor);
    let kept: f64 = energy.iter().sum();
    let (particles, pairs, threads) = (matrix.particles(), matrix.pairs(), rayon::current_num_threads());
    println!(
        "{particles} particles with {searched:.1} neighbours, {:.1} stored: {:.1} million particle-steps, {:.0} million \
         directed pairs a second",
        pairs as f64 / particles as f64,
        1e-6 * (particles * steps) as f64 / seconds,
        1e-6 * (pairs * steps) as f64 / seconds
    );
    println!("set up in {set_up:.2} s, relative change of energy {:.1e}", kept / total - 1.0);
    println!(
        "RESULT scene=heat form=stored-matrix particles={particles} pairs={pairs} steps={steps} seconds={seconds:.4} \
         processor_seconds={processor:.2} threads={threads}"
    );
}

/// Time of all threads of this process on processors \[s\] to a hundredth; zero where there is no /proc.
fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // User and system time, in ticks of a hundredth; the name before them may hold blanks, but ends with a bracket.
    let fields = text.rsplit(')').next().unwrap_or_default().split_whitespace();
    fields.skip(11).take(2).filter_map(|field| field.parse::<f64>().ok()).sum::<f64>() / 100.0
}

/// Cell centres of a cube with its low corner at the origin \[m\].
fn lattice(side: usize) -> Vec<Vector3<f64>> {
    let at = |n: usize| Vector3::new(n % side, n / side % side, n / side / side);
    (0..side.pow(3)).map(|n| at(n).map(|k| SPACING * (k as f64 + 0.5))).collect()
}

/// Plain weights, and the mean number of neighbours before mirror images are folded onto their sources.
fn conduction(side: usize, positions: &[Vector3<f64>]) -> (ConductionMatrix, f64) {
    let reach = SUPPORT * SPACING;
    let planes = Planes::adiabatic_box([0.0; 3], [side as f64 * SPACING; 3]);
    let images = Images::new(positions, &vec![reach; positions.len()], &planes);
    let everything: Vec<_> = positions.iter().chain(&images.position).copied().collect();
    let list =
        SearchMethod::default().find(&everything, PairReach::Uniform(reach)).expect("finite positions");
    let smoothing = reach / Kernel::<3>::support_radius(KernelKind::WendlandC2, 1.0);
    let factor =
        |_: usize, _: usize, r: f64| Kernel::<3>::gradient_factor(KernelKind::WendlandC2, r, smoothing);
    let volume = vec![SPACING.powi(3); positions.len()];
    let pairs =
        PairTable::new(positions, &volume, &images, |i| list.row(i), factor).expect("columns of one length");
    let searched = pairs.entries() as f64 / positions.len() as f64;
    (ConductionMatrix::new(&pairs.plain()), searched)
}

/// Specific energy \[J/kg\]: two inside a ball of half the block's width, zero outside (c_v = 1 J/(kg K)).
fn hot_ball(side: usize, positions: &[Vector3<f64>], padded: usize) -> Vec<f64> {
    let middle = Vector3::repeat(0.5 * side as f64 * SPACING);
    let hot = |p: &Vector3<f64>| (p - middle).norm() < 0.25 * side as f64 * SPACING;
    let mut energy: Vec<f64> = positions.iter().map(|p| if hot(p) { 2.0 } else { 0.0 }).collect();
    energy.resize(padded, 0.0);
    energy
}

/// Forward Euler steps of a tenth of spacing²/diffusivity.
fn run(matrix: &ConductionMatrix, energy: &mut Vec<f64>, next: &mut Vec<f64>, steps: usize) {
    let factor = 0.1 * SPACING * SPACING / DIFFUSIVITY * DIFFUSIVITY / SPACING.powi(3);
    for _ in 0..steps {
        next.par_chunks_mut(BLOCK).enumerate().for_each(|(block, next)| {
            for (at, next) in next.chunks_exact_mut(LANES).enumerate() {
                let chunk = block * BLOCK / LANES + at;
                let heat = matrix.chunk_heat(chunk, energy);
                let old = &energy[chunk * LANES..(chunk + 1) * LANES];
                for lane in 0..LANES {
                    next[lane] = old[lane] + factor * heat[lane];
                }
            }
        });
        std::mem::swap(energy, next);
    }
}
