//! Spatial order: a permutation that puts particles that are near in space near in memory.

use crate::error::{Error, check_positions};
use nalgebra::SVector;
use rayon::prelude::*;

/// A reordering of particles: new place k holds what was at `order()[k]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Permutation {
    order: Vec<u32>,
}

impl Permutation {
    /// Leaves `particles` particles where they are.
    pub fn identity(particles: usize) -> Self {
        Self { order: (0..particles as u32).collect() }
    }

    /// Becomes the permutation with another order, in the storage of this one.
    pub(crate) fn refill(&mut self, order: impl Iterator<Item = u32>) {
        self.order.clear();
        self.order.extend(order);
    }

    /// The old place of each new one.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// A column in the new order.
    ///
    /// # Panics
    /// If the column has not as many entries as the permutation.
    pub fn gather<T: Clone>(&self, column: &[T]) -> Vec<T> {
        assert_eq!(column.len(), self.order.len(), "a column has one entry a particle");
        self.order.iter().map(|&old| column[old as usize].clone()).collect()
    }

    /// A column in the new order, in the storage of another, on the current rayon pool.
    ///
    /// # Panics
    /// If the column has not as many entries as the permutation.
    pub fn gather_into<T: Copy + Send + Sync>(&self, column: &[T], gathered: &mut Vec<T>) {
        assert_eq!(column.len(), self.order.len(), "a column has one entry a particle");
        self.order.par_iter().map(|&old| column[old as usize]).collect_into_vec(gathered);
    }

    /// Puts a column into the new order.
    ///
    /// # Panics
    /// If the column has not as many entries as the permutation.
    pub fn apply<T: Clone>(&self, column: &mut Vec<T>) {
        *column = self.gather(column);
    }

    /// The permutation that undoes this one. Its `order()` is the new place of each old one, which also renumbers
    /// stored particle indices.
    pub fn inverse(&self) -> Self {
        let mut order = vec![0; self.order.len()];
        for (new, &old) in self.order.iter().enumerate() {
            order[old as usize] = new as u32;
        }
        Self { order }
    }

    /// First this one, then `next`, as one permutation.
    ///
    /// # Panics
    /// If the two differ in length.
    pub fn then(&self, next: &Self) -> Self {
        Self { order: next.gather(&self.order) }
    }
}

/// The order of particles along the Morton curve through cells of `cell_size` \[m\]; particles of one cell keep their order.
///
/// On the Morton (Z) curve, every cube of 2^k cells a side is one contiguous range, for every k at once: the neighbours of a
/// particle fit each size of cache, and blocks for blocked sweeps are ranges. Rows with x fastest would keep only neighbours in
/// x near.
///
/// # Errors
/// Positions that are not finite, a cell size that is not positive, too many particles.
pub fn spatial_order<const D: usize>(
    positions: &[SVector<f64, D>],
    cell_size: f64,
) -> Result<Permutation, Error> {
    check_positions(positions)?;
    if !(cell_size.is_finite() && cell_size > 0.0) {
        return Err(Error::CellSize { size: cell_size });
    }
    let low = positions
        .iter()
        .fold(SVector::repeat(f64::INFINITY), |low: SVector<f64, D>, position| low.inf(position));
    let mut keyed: Vec<(u64, u32)> = positions
        .iter()
        .zip(0..)
        .map(|(position, index)| (morton_key(&((position - low) / cell_size)), index))
        .collect();
    keyed.sort_unstable();
    Ok(Permutation { order: keyed.into_iter().map(|(_, index)| index).collect() })
}

/// Interleaves the bits of the whole parts, x lowest. Coordinates beyond 2^(64/D) cells share the last one.
fn morton_key<const D: usize>(cell: &SVector<f64, D>) -> u64 {
    let bits = 64 / D;
    let largest = (1_u64 << bits) - 1;
    let mut key = 0;
    for axis in 0..D {
        let coordinate = (cell[axis] as u64).min(largest);
        let used_bits = (u64::BITS - coordinate.leading_zeros()) as usize;
        for bit in 0..used_bits {
            key |= (coordinate >> bit & 1) << (bit * D + axis);
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_sets::{any_set, perturbed_lattice};
    use proptest::prelude::*;

    #[test]
    fn keys_interleave_with_x_lowest() {
        assert_eq!(morton_key(&SVector::from([1.5, 0.0])), 1);
        assert_eq!(morton_key(&SVector::from([0.0, 1.0])), 2);
        assert_eq!(morton_key(&SVector::from([2.0, 3.9])), 0b1110);
        assert_eq!(morton_key(&SVector::from([1.0, 1.0, 2.0])), 0b100_011);
        assert_eq!(morton_key(&SVector::from([1e300, 1e300])), u64::MAX);
    }

    #[test]
    fn every_cube_of_cells_is_one_range() {
        let positions = perturbed_lattice::<3>(8, 0.0);
        let order = spatial_order(&positions, 1.0).unwrap();
        for (block, places) in order.order().chunks(8).enumerate() {
            let corner = positions[places[0] as usize];
            for &place in places {
                let offset = positions[place as usize] - corner;
                assert!(offset.min() >= 0.0 && offset.max() <= 1.0, "block {block}");
            }
        }
    }

    #[test]
    fn renumbering_follows_the_particles() {
        let order = Permutation { order: vec![2, 0, 1] };
        let renumbered = order.inverse();
        let names = order.gather(&["a", "b", "c"]);
        assert_eq!(names, ["c", "a", "b"]);
        let mut stored = vec!["x"];
        order.gather_into(&["a", "b", "c"], &mut stored);
        assert_eq!(stored, names);
        assert_eq!(names[renumbered.order()[1] as usize], "b");
    }

    #[test]
    fn bad_input_is_an_error() {
        let positions = [SVector::from([0.0, f64::NAN])];
        assert_eq!(spatial_order(&positions, 1.0), Err(Error::Position { index: 0 }));
        assert_eq!(spatial_order(&positions[..0], 0.0), Err(Error::CellSize { size: 0.0 }));
    }

    proptest! {
        #[test]
        fn is_a_bijection_and_its_inverse_undoes_it(positions in any_set::<3>(), cell_size in 0.01..1.0) {
            let order = spatial_order(&positions, cell_size).unwrap();
            let mut seen = order.order().to_vec();
            seen.sort_unstable();
            prop_assert_eq!(Permutation { order: seen }, Permutation::identity(positions.len()));
            let mut column = positions.clone();
            order.apply(&mut column);
            prop_assert_eq!(&column, &order.gather(&positions));
            order.inverse().apply(&mut column);
            prop_assert_eq!(column, positions);
        }

        #[test]
        fn composition_is_one_after_the_other(positions in any_set::<2>()) {
            let coarse = spatial_order(&positions, 0.5).unwrap();
            let fine = spatial_order(&coarse.gather(&positions), 0.1).unwrap();
            prop_assert_eq!(coarse.then(&fine).gather(&positions), fine.gather(&coarse.gather(&positions)));
            prop_assert_eq!(coarse.then(&coarse.inverse()), Permutation::identity(positions.len()));
        }
    }
}
