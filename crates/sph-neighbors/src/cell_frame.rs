//! Where the cells of a grid lie.

use nalgebra::SVector;

/// Cells along one axis at most, so that cell numbers of three axes fit into 128 bits.
const MOST_CELLS_PER_AXIS: f64 = (1_u64 << 40) as f64;

/// A box of equal cells around a point set.
#[derive(Clone, Debug)]
pub(crate) struct CellFrame<const D: usize> {
    origin: SVector<f64, D>,
    inverse_size: SVector<f64, D>,
    counts: [u64; D],
}

impl<const D: usize> CellFrame<D> {
    /// Cells of the given size \[m\] over the box of the `members`; larger ones on an axis too long to count.
    pub fn around(positions: &[SVector<f64, D>], members: &[u32], size: f64) -> Self {
        let first = positions[members[0] as usize];
        let (mut low, mut high) = (first, first);
        for &member in members {
            low = low.inf(&positions[member as usize]);
            high = high.sup(&positions[member as usize]);
        }
        let extent = high - low;
        let inverse_size = extent.map(|length| (1.0 / size).min(MOST_CELLS_PER_AXIS / length));
        let counts = std::array::from_fn(|axis| (extent[axis] * inverse_size[axis]) as u64 + 1);
        Self { origin: low, inverse_size, counts }
    }

    /// Number of cells.
    pub fn cells(&self) -> u128 {
        self.counts.iter().map(|&count| u128::from(count)).product()
    }

    /// The coordinate of a place in units of cells; monotone in the place, which is all that exactness needs.
    #[inline]
    fn scaled(&self, axis: usize, place: f64) -> f64 {
        (place - self.origin[axis]) * self.inverse_size[axis]
    }

    /// The number of the cell that holds a point inside the box; x runs fastest.
    #[inline]
    pub fn key(&self, point: &SVector<f64, D>) -> u128 {
        self.key_of(&std::array::from_fn(|axis| self.scaled(axis, point[axis]) as u64))
    }

    /// The number of a cell given by its coordinates; x runs fastest.
    #[inline]
    pub fn key_of(&self, cell: &[u64; D]) -> u128 {
        let mut key = 0;
        for axis in (0..D).rev() {
            key = key * u128::from(self.counts[axis]) + u128::from(cell[axis]);
        }
        key
    }

    /// First and last cell that a ball may touch, or none if it misses the box.
    ///
    /// A member p nearer than the radius satisfies p <= center + radius up to round-off, which the hair on the radius
    /// covers; as [`scaled`](Self::scaled) is monotone, the cell of p is then inside the range.
    #[inline]
    pub fn around_ball(&self, center: &SVector<f64, D>, radius: f64) -> Option<([u64; D], [u64; D])> {
        let radius = radius * (1.0 + 1e-12);
        let (mut first, mut last) = ([0; D], [0; D]);
        for axis in 0..D {
            let low = self.scaled(axis, center[axis] - radius);
            let high = self.scaled(axis, center[axis] + radius);
            if high < 0.0 || low >= self.counts[axis] as f64 {
                return None;
            }
            // The cast takes negative numbers to zero.
            first[axis] = low as u64;
            last[axis] = (high as u64).min(self.counts[axis] - 1);
        }
        Some((first, last))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit_square() -> CellFrame<2> {
        CellFrame::around(&[SVector::from([0.0, 0.0]), SVector::from([1.0, 1.0])], &[0, 1], 0.3)
    }

    #[test]
    fn keys_count_with_x_fastest() {
        let frame = unit_square();
        assert_eq!(frame.cells(), 16);
        assert_eq!(frame.key(&SVector::from([0.0, 0.0])), 0);
        assert_eq!(frame.key(&SVector::from([0.95, 0.0])), 3);
        assert_eq!(frame.key(&SVector::from([0.35, 1.0])), 13);
    }

    #[test]
    fn a_ball_touches_its_cells_and_no_more() {
        let frame = unit_square();
        assert_eq!(frame.around_ball(&SVector::from([0.45, -0.1]), 0.1), Some(([1, 0], [1, 0])));
        assert_eq!(frame.around_ball(&SVector::from([0.65, 0.65]), 0.1), Some(([1, 1], [2, 2])));
        assert_eq!(frame.around_ball(&SVector::from([0.5, -0.2]), 0.1), None);
        assert_eq!(frame.around_ball(&SVector::from([1.4, 0.5]), 0.1), None);
    }

    #[test]
    fn a_far_point_makes_cells_large_on_its_axis_only() {
        let positions = [SVector::from([0.0, 0.0]), SVector::from([1e100, 1.0])];
        let frame = CellFrame::around(&positions, &[0, 1], 0.3);
        assert_eq!(frame.counts, [(1 << 40) + 1, 4]);
    }
}
