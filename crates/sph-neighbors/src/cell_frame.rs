//! Where the cells of a grid lie.

use nalgebra::SVector;

/// Cells along one axis at most, so that cell numbers of three axes fit into 128 bits.
const MOST_CELLS_PER_AXIS: f64 = (1_u64 << 40) as f64;

/// What a distance in units of cells may be wrong by: coordinates count to 2^40 at most, and round-off is 2^-52 of that.
const ROUND_OFF_IN_CELLS: f64 = 1e-3;

/// A box of equal cells around a point set.
#[derive(Clone, Debug)]
pub(crate) struct CellFrame<const D: usize> {
    origin: SVector<f64, D>,
    inverse_size: SVector<f64, D>,
    size: SVector<f64, D>,
    counts: [u64; D],
    strides: [u128; D],
}

/// The cells that a ball may touch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellRange<const D: usize> {
    /// First cell on each axis.
    pub first: [u64; D],
    /// Last cell on each axis, included.
    pub last: [u64; D],
    /// The centre in units of cells.
    center: SVector<f64, D>,
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
        let strides =
            std::array::from_fn(|axis| counts[..axis].iter().map(|&count: &u64| u128::from(count)).product());
        Self { origin: low, inverse_size, size: inverse_size.map(f64::recip), counts, strides }
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
        (0..D).map(|axis| u128::from(self.scaled(axis, point[axis]) as u64) * self.strides[axis]).sum()
    }

    /// What one step along an axis adds to the number of a cell.
    #[inline]
    pub fn stride(&self, axis: usize) -> u128 {
        self.strides[axis]
    }

    /// Square of the distance \[m^2\] along one axis between the centre of a ball and a layer of cells, never too large.
    #[inline]
    pub fn gap_squared(&self, range: &CellRange<D>, axis: usize, cell: u64) -> f64 {
        let below = cell as f64 - range.center[axis];
        let gap = (below.max(-1.0 - below) - ROUND_OFF_IN_CELLS).max(0.0) * self.size[axis];
        gap * gap
    }

    /// The cells that a ball may touch, or none if it misses the box.
    ///
    /// A member p nearer than the radius satisfies p <= center + radius up to round-off, which the hair on the radius
    /// covers; as [`scaled`](Self::scaled) is monotone, the cell of p is then inside the range.
    #[inline]
    pub fn around_ball(&self, center: &SVector<f64, D>, radius: f64) -> Option<CellRange<D>> {
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
        let center = SVector::from_fn(|axis, _| self.scaled(axis, center[axis]));
        Some(CellRange { first, last, center })
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
        let touched = |x, y| {
            unit_square().around_ball(&SVector::from([x, y]), 0.1).map(|range| (range.first, range.last))
        };
        assert_eq!(touched(0.45, -0.05), Some(([1, 0], [1, 0])));
        assert_eq!(touched(0.65, 0.65), Some(([1, 1], [2, 2])));
        assert_eq!(touched(0.5, -0.2), None);
        assert_eq!(touched(1.4, 0.5), None);
    }

    #[test]
    fn the_gap_to_a_layer_of_cells() {
        let frame = unit_square();
        let range = frame.around_ball(&SVector::from([0.45, 0.45]), 0.3).unwrap();
        for (cell, gap) in [(0, 0.15), (1, 0.0), (2, 0.15), (3, 0.45)] {
            let found = frame.gap_squared(&range, 1, cell).sqrt();
            assert!(found <= gap && found > gap - 4e-4, "layer {cell}: {found}");
        }
    }

    #[test]
    fn a_far_point_makes_cells_large_on_its_axis_only() {
        let positions = [SVector::from([0.0, 0.0]), SVector::from([1e100, 1.0])];
        let frame = CellFrame::around(&positions, &[0, 1], 0.3);
        assert_eq!(frame.counts, [(1 << 40) + 1, 4]);
    }
}
