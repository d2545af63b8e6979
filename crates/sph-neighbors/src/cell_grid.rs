//! Search by a grid of cells.

use crate::cell_frame::{CellFrame, CellRange};
use crate::point_index::{PointIndex, distance_squared};
use nalgebra::SVector;
use std::ops::Range;

/// Cells per member up to which every cell gets an entry, empty or not.
const DENSE_CELLS_PER_MEMBER: u128 = 4;

/// Points sorted by the cells of a grid, x fastest, so that a run of cells along x is one slice.
pub(crate) struct CellGrid<const D: usize> {
    frame: CellFrame<D>,
    radius: f64,
    cells: Cells,
    points: Vec<SVector<f64, D>>,
    ids: Vec<u32>,
}

/// Where the points of a cell start.
enum Cells {
    /// One entry for every cell of the box.
    Dense { starts: Vec<u32> },
    /// Only cells that hold points, by ascending key: memory stays linear in the points however far they spread.
    Sparse { keys: Vec<u128>, starts: Vec<u32> },
}

impl Cells {
    /// The points in the cells with keys `first..=last`.
    #[inline]
    fn run(&self, first: u128, last: u128) -> Range<usize> {
        match self {
            Self::Dense { starts } => starts[first as usize] as usize..starts[last as usize + 1] as usize,
            Self::Sparse { keys, starts } => {
                let begin = keys.partition_point(|&key| key < first);
                let end = begin + keys[begin..].iter().take_while(|&&key| key <= last).count();
                starts[begin] as usize..starts[end] as usize
            }
        }
    }
}

/// Sorts members by cell with a counting sort, which keeps their order within a cell.
fn sort_dense<const D: usize>(
    positions: &[SVector<f64, D>],
    members: &[u32],
    frame: &CellFrame<D>,
) -> (Cells, Vec<u32>) {
    let keys: Vec<u32> =
        members.iter().map(|&member| frame.key(&positions[member as usize]) as u32).collect();
    let mut starts = vec![0_u32; frame.cells() as usize + 1];
    for &key in &keys {
        starts[key as usize + 1] += 1;
    }
    for cell in 1..starts.len() {
        starts[cell] += starts[cell - 1];
    }
    let mut next = starts.clone();
    let mut ids = vec![0; members.len()];
    for (&member, &key) in members.iter().zip(&keys) {
        ids[next[key as usize] as usize] = member;
        next[key as usize] += 1;
    }
    (Cells::Dense { starts }, ids)
}

/// Sorts members by cell where there are far more cells than members.
fn sort_sparse<const D: usize>(
    positions: &[SVector<f64, D>],
    members: &[u32],
    frame: &CellFrame<D>,
) -> (Cells, Vec<u32>) {
    let mut keyed: Vec<(u128, u32)> =
        members.iter().map(|&member| (frame.key(&positions[member as usize]), member)).collect();
    keyed.sort_unstable();
    let (mut keys, mut starts) = (Vec::new(), Vec::new());
    for (place, &(key, _)) in keyed.iter().enumerate() {
        if keys.last() != Some(&key) {
            keys.push(key);
            starts.push(place as u32);
        }
    }
    starts.push(members.len() as u32);
    (Cells::Sparse { keys, starts }, keyed.into_iter().map(|(_, member)| member).collect())
}

impl<const D: usize> CellGrid<D> {
    /// Scans the runs along x of one plane of cells; `key` and `gap` \[m^2\] are what its place on further axes adds.
    #[inline]
    fn scan_plane(
        &self,
        range: &CellRange<D>,
        key: u128,
        gap: f64,
        center: &SVector<f64, D>,
        found: &mut Vec<u32>,
    ) {
        for y in range.first[1]..=range.last[1] {
            if gap + self.frame.gap_squared(range, 1, y) < self.radius * self.radius {
                let key = key + u128::from(y) * self.frame.stride(1);
                let run = self.cells.run(key + u128::from(range.first[0]), key + u128::from(range.last[0]));
                self.scan(run, center, found);
            }
        }
    }

    /// Appends the points of one run of cells that are inside the radius.
    #[inline]
    fn scan(&self, run: Range<usize>, center: &SVector<f64, D>, found: &mut Vec<u32>) {
        let limit = self.radius * self.radius;
        let start = found.len();
        found.resize(start + run.len(), 0);
        let target = &mut found[start..];
        let mut count = 0;
        for (&id, point) in self.ids[run.clone()].iter().zip(&self.points[run]) {
            // Written always and kept only if inside: half of the candidates are outside, in no predictable order.
            target[count] = id;
            count += usize::from(distance_squared(center, point) < limit);
        }
        found.truncate(start + count);
    }
}

impl<const D: usize> PointIndex<D> for CellGrid<D> {
    fn build(positions: &[SVector<f64, D>], members: &[u32], radius: f64) -> Self {
        let fine = CellFrame::around(positions, members, 0.5 * radius);
        let crowded = fine.cells() <= members.len() as u128;
        let frame = if crowded { fine } else { CellFrame::around(positions, members, radius) };
        let dense = frame.cells() <= DENSE_CELLS_PER_MEMBER * members.len() as u128 + 64;
        let sort = if dense { sort_dense } else { sort_sparse };
        let (cells, ids) = sort(positions, members, &frame);
        let points = ids.iter().map(|&id| positions[id as usize]).collect();
        Self { frame, radius, cells, points, ids }
    }

    #[inline]
    fn collect_within(&self, center: &SVector<f64, D>, found: &mut Vec<u32>) {
        let Some(range) = self.frame.around_ball(center, self.radius) else { return };
        if D == 2 {
            return self.scan_plane(&range, 0, 0.0, center, found);
        }
        for z in range.first[D - 1]..=range.last[D - 1] {
            let gap = self.frame.gap_squared(&range, D - 1, z);
            self.scan_plane(&range, u128::from(z) * self.frame.stride(D - 1), gap, center, found);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found_by(positions: &[SVector<f64, 3>], radius: f64, center: usize) -> (CellGrid<3>, Vec<u32>) {
        let members: Vec<u32> = (0..positions.len() as u32).collect();
        let grid = CellGrid::build(positions, &members, radius);
        let mut found = Vec::new();
        grid.collect_within(&positions[center], &mut found);
        found.sort_unstable();
        (grid, found)
    }

    #[test]
    fn a_compact_set_is_stored_dense() {
        let positions: Vec<_> = (0..100).map(|k| SVector::from([k as f64, 0.0, 0.0])).collect();
        let (grid, found) = found_by(&positions, 1.5, 50);
        assert!(matches!(grid.cells, Cells::Dense { .. }));
        assert_eq!(found, [49, 50, 51]);
    }

    #[test]
    fn a_spread_set_is_stored_sparse_in_linear_memory() {
        let positions: Vec<_> = (0..100).map(|k| SVector::repeat((k / 2) as f64 * 1e6)).collect();
        let (grid, found) = found_by(&positions, 1.5, 51);
        let Cells::Sparse { keys, .. } = &grid.cells else { panic!("dense") };
        assert_eq!((keys.len(), found), (50, vec![50, 51]));
    }
}
