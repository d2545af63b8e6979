//! Pairs of one particle, four at a time.

use nalgebra::SVector;
use sph_kernel::{ScaledKernel, Shape};
use wide::f64x4;

/// Pairs that are computed together.
pub(super) const LANES: usize = 4;

/// Keeps the vector of a record.
pub(super) const VECTOR: f64x4 = f64x4::new([1.0, 1.0, 1.0, 0.0]);

/// Keeps the scalar of a record.
pub(super) const SCALAR: f64x4 = f64x4::new([0.0, 0.0, 0.0, 1.0]);

/// A list in pieces of four, the last one filled up with the particle itself, which gives itself nothing.
#[inline(always)]
pub(super) fn for_each_quad(list: &[u32], own: usize, mut visit: impl FnMut([u32; LANES])) {
    let mut from = 0;
    // One call only, so that it is compiled into the loop.
    while from < list.len() {
        visit(match list[from..].first_chunk() {
            Some(indices) => *indices,
            None => std::array::from_fn(|lane| list.get(from + lane).copied().unwrap_or(own as u32)),
        });
        from += LANES;
    }
}

/// A vector and a scalar behind it, in the last lane.
#[inline(always)]
pub(super) fn joined<const D: usize>(vector: &SVector<f64, D>, scalar: f64) -> f64x4 {
    f64x4::new(std::array::from_fn(|lane| match lane {
        _ if lane < D => vector[lane],
        _ if lane == LANES - 1 => scalar,
        _ => 0.0,
    }))
}

/// One vector of each of four records, turned about: the first numbers of all, the second ones, and so on.
///
/// What `f64x4::transpose` gives, but always compiled into the caller. The vectors should be results, differences say, not
/// copies of what is in memory: those are gathered number by number.
#[inline(always)]
pub(super) fn turned<R>(records: [&R; LANES], vector: impl Fn(&R) -> f64x4) -> [f64x4; LANES] {
    let [first, second, third, fourth] = records;
    let [a, b, c, d] = vector(first).to_array();
    let [e, f, g, h] = vector(second).to_array();
    let [i, j, k, l] = vector(third).to_array();
    let [m, n, o, p] = vector(fourth).to_array();
    [[a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p]].map(f64x4::new)
}

/// A kernel whose shape the compiler knows.
#[derive(Clone, Copy, Debug)]
pub(super) struct QuadKernel<S> {
    shape: S,
    inverse_length: f64,
    value_scale: f64,
    factor_scale: f64,
}

impl<S: Shape> QuadKernel<S> {
    /// `shape` must be that of the kernel.
    pub fn new<const D: usize>(shape: S, kernel: &ScaledKernel<D>) -> Self {
        let (value, factor) = shape.evaluate(0.0);
        Self {
            shape,
            inverse_length: 1.0 / kernel.smoothing_length(),
            value_scale: kernel.value(0.0) / value,
            factor_scale: kernel.gradient_factor(0.0) / factor,
        }
    }

    /// W \[m^-D\] and f = W'/r \[m^-(D+2)\] of four squares of distances \[m^2\].
    #[inline(always)]
    pub fn evaluate(&self, squares: f64x4) -> (f64x4, f64x4) {
        let both = (squares.sqrt() * self.inverse_length).to_array().map(|q| self.shape.evaluate(q));
        let (values, factors) = (both.map(|(value, _)| value), both.map(|(_, factor)| factor));
        (f64x4::new(values) * self.value_scale, f64x4::new(factors) * self.factor_scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sph_kernel::{KernelKind, WendlandC2};

    #[test]
    fn a_list_is_filled_up_with_the_particle_itself() {
        let mut seen = Vec::new();
        for_each_quad(&[1, 2, 3, 4, 5, 6], 9, |indices| seen.push(indices));
        assert_eq!(seen, [[1, 2, 3, 4], [5, 6, 9, 9]]);
    }

    #[test]
    fn records_are_turned_about() {
        let records: [f64x4; LANES] =
            std::array::from_fn(|k| f64x4::new(std::array::from_fn(|lane| (10 * k + lane) as f64)));
        let turned = turned(records.each_ref(), |record| *record).map(|quad| quad.to_array());
        for (k, record) in records.iter().enumerate() {
            for lane in 0..LANES {
                assert_eq!(turned[lane][k], record.to_array()[lane]);
            }
        }
    }

    #[test]
    fn four_distances_at_once_give_what_one_gives() {
        let kernel = KernelKind::WendlandC2.with_smoothing_length::<3>(1.3);
        let distances = [0.0, 0.7, 1.9, 2.7];
        let squares = f64x4::new(distances.map(|distance| distance * distance));
        let (values, factors) = QuadKernel::new(WendlandC2, &kernel).evaluate(squares);
        for (lane, distance) in distances.into_iter().enumerate() {
            assert!((values.to_array()[lane] - kernel.value(distance)).abs() < 1e-15);
            assert!((factors.to_array()[lane] - kernel.gradient_factor(distance)).abs() < 1e-15);
        }
    }
}
