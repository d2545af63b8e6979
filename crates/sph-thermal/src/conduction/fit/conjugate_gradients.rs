//! Conjugate gradients on the moment system, with its block-Jacobi preconditioner.
//!
//! Each iteration is three passes over chunks. Scalar products are added up a chunk at a time and then in order, so that
//! they have the same bits on any number of threads.

use super::super::matrix::LANES;
use super::moment_rows::{Four, MomentRows};
use rayon::prelude::*;

/// Iterations beyond which the fit is given up; 20 to 80 are usual.
const LARGEST_ITERATION_COUNT: usize = 400;

/// Chunks below which a pass stays on one thread, and the least that a task takes.
const PARALLEL_CHUNKS: usize = 2500;
const CHUNKS_PER_TASK: usize = 512;

/// What the iterations found.
pub(super) struct Solution {
    pub(super) unknowns: Vec<Four>,
    pub(super) iterations: usize,
    /// Residual over that of zero unknowns, both in the norm of the preconditioner.
    pub(super) residual: f64,
}

/// What an iteration works on, a chunk each.
struct Lane {
    unknown: Four,
    residual: Four,
    image: Four,
    conditioned: Four,
    product: f64,
}

/// Solves `rows` x = `right_hand_side` from `guess`, until the relative residual is below `tolerance` or its square below
/// `floor`.
pub(super) fn conjugate_gradients(
    rows: &MomentRows,
    right_hand_side: &[Four],
    guess: Vec<Four>,
    tolerance: f64,
    floor: f64,
) -> Solution {
    let norm = |chunk: usize, b: &Four| dot(b, &rows.precondition(chunk, b));
    let scale = right_hand_side.iter().enumerate().map(|(chunk, b)| norm(chunk, b)).sum::<f64>().sqrt();
    let mut direction = vec![0.0; 4 * LANES * rows.chunks()];
    set_direction(&mut direction, |chunk, part, _| guess[chunk][part]);
    let mut lanes = begin(rows, right_hand_side, guess, &direction);
    set_direction(&mut direction, |chunk, part, _| lanes[chunk].conditioned[part]);
    let mut square = total(&lanes);
    let relative = |square: f64| if scale > 0.0 { square.max(0.0).sqrt() / scale } else { 0.0 };
    let mut iterations = 0;
    while relative(square) > tolerance && square > floor && iterations < LARGEST_ITERATION_COUNT {
        let next = advance(rows, &mut lanes, &direction, square);
        let ratio = next / square;
        set_direction(&mut direction, |chunk, part, old| {
            std::array::from_fn(|lane| lanes[chunk].conditioned[part][lane] + ratio * old[lane])
        });
        square = next;
        iterations += 1;
    }
    let residual = if square <= floor { 0.0 } else { relative(square) };
    Solution { unknowns: lanes.into_iter().map(|lane| lane.unknown).collect(), iterations, residual }
}

/// Residual and preconditioned residual of the guess, which `direction` holds too.
fn begin(rows: &MomentRows, right_hand_side: &[Four], guess: Vec<Four>, direction: &[f64]) -> Vec<Lane> {
    let start = |(chunk, unknown): (usize, Four)| {
        let image = rows.apply(chunk, direction);
        let residual = add(&right_hand_side[chunk], -1.0, &image);
        let conditioned = rows.precondition(chunk, &residual);
        Lane { unknown, residual, image, conditioned, product: dot(&residual, &conditioned) }
    };
    guess.into_iter().enumerate().map(start).collect()
}

/// One step along `direction`; returns the new square of the residual.
fn advance(rows: &MomentRows, lanes: &mut [Lane], direction: &[f64], square: f64) -> f64 {
    let along = |chunk: usize| -> Four {
        std::array::from_fn(|part| {
            let start = (part * rows.chunks() + chunk) * LANES;
            direction[start..start + LANES].try_into().expect("a slice of LANES entries")
        })
    };
    for_each(lanes, |chunk, lane| {
        lane.image = rows.apply(chunk, direction);
        lane.product = dot(&along(chunk), &lane.image);
    });
    let step = square / total(lanes);
    for_each(lanes, |chunk, lane| {
        lane.unknown = add(&lane.unknown, step, &along(chunk));
        lane.residual = add(&lane.residual, -step, &lane.image);
        lane.conditioned = rows.precondition(chunk, &lane.residual);
        lane.product = dot(&lane.residual, &lane.conditioned);
    });
    total(lanes)
}

/// Writes four columns, one after the other, from `of(chunk, part, what stood there)`.
fn set_direction(direction: &mut [f64], of: impl Fn(usize, usize, [f64; LANES]) -> [f64; LANES]) {
    let column = direction.len() / 4;
    for (part, column) in direction.chunks_exact_mut(column.max(1)).enumerate() {
        for (chunk, values) in column.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
            *values = of(chunk, part, *values);
        }
    }
}

fn for_each(lanes: &mut [Lane], work: impl Fn(usize, &mut Lane) + Sync + Send) {
    if lanes.len() < PARALLEL_CHUNKS {
        lanes.iter_mut().enumerate().for_each(|(chunk, lane)| work(chunk, lane));
    } else {
        let lanes = lanes.par_iter_mut().with_min_len(CHUNKS_PER_TASK).enumerate();
        lanes.for_each(|(chunk, lane)| work(chunk, lane));
    }
}

fn total(lanes: &[Lane]) -> f64 {
    lanes.iter().map(|lane| lane.product).sum()
}

#[inline]
fn dot(a: &Four, b: &Four) -> f64 {
    let mut sum = [0.0; LANES];
    for part in 0..4 {
        for lane in 0..LANES {
            sum[lane] += a[part][lane] * b[part][lane];
        }
    }
    sum.iter().sum()
}

#[inline]
fn add(a: &Four, factor: f64, b: &Four) -> Four {
    std::array::from_fn(|part| std::array::from_fn(|lane| a[part][lane] + factor * b[part][lane]))
}
