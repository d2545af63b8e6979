//! The list without its skin: who is within the support of whom at one evaluation.

use super::FluidFields;
use nalgebra::SVector;
use rayon::prelude::*;

/// Particles whose rows one task narrows.
const ROWS_PER_TASK: usize = 256;

/// Rows of a list, narrowed to the pairs nearer than a radius. Storage is kept from one evaluation to the next.
///
/// A list has a skin, so that a half of its entries or more are outside the support; an evaluation goes through its rows up to ten
/// times, and through the entries outside once.
#[derive(Clone, Debug, Default)]
pub(super) struct NearRows {
    tasks: Vec<Narrowed>,
    starts: Vec<usize>,
    neighbors: Vec<u32>,
}

/// Some consecutive rows: where each ends, and all one after the other.
#[derive(Clone, Debug, Default)]
struct Narrowed {
    ends: Vec<usize>,
    neighbors: Vec<u32>,
}

impl NearRows {
    /// Narrows all rows of the fields to a radius \[m\]; those of the copies behind so many particles of fluid, which nobody reads, to
    /// nothing.
    pub fn find<const D: usize>(&mut self, fields: &FluidFields<'_, D>, fluid: usize, radius: f64) {
        let (particles, copies) = (fields.positions.len(), fluid..fluid + fields.copies.len());
        self.tasks.resize_with(particles.div_ceil(ROWS_PER_TASK), Narrowed::default);
        self.tasks.par_iter_mut().enumerate().for_each(|(task, rows)| {
            let first = task * ROWS_PER_TASK;
            rows.ends.clear();
            rows.neighbors.clear();
            for i in first..(first + ROWS_PER_TASK).min(particles) {
                let row = if copies.contains(&i) { &[] } else { fields.neighbors(i) };
                narrow(i, row, fields.positions, radius, &mut rows.neighbors);
                rows.ends.push(rows.neighbors.len());
            }
        });
        self.starts.clear();
        self.neighbors.clear();
        self.starts.push(0);
        for rows in &self.tasks {
            let before = self.neighbors.len();
            self.starts.extend(rows.ends.iter().map(|end| before + end));
            self.neighbors.extend_from_slice(&rows.neighbors);
        }
    }

    /// The same fields with these rows.
    pub fn of<'a, const D: usize>(&'a self, fields: &FluidFields<'a, D>) -> FluidFields<'a, D> {
        FluidFields { list_starts: &self.starts, list_neighbors: &self.neighbors, ..*fields }
    }
}

/// Appends those of a row that are nearer than the radius, in their order.
#[inline]
fn narrow<const D: usize>(
    index: usize,
    row: &[u32],
    positions: &[SVector<f64, D>],
    radius: f64,
    near: &mut Vec<u32>,
) {
    let (here, limit) = (positions[index], radius * radius);
    let start = near.len();
    near.resize(start + row.len(), 0);
    let target = &mut near[start..];
    let mut count = 0;
    for &neighbor in row {
        // Written always and kept only if inside: no branch to mispredict at the edge of the support.
        target[count] = neighbor;
        count += usize::from((here - positions[neighbor as usize]).norm_squared() < limit);
    }
    near.truncate(start + count);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;

    #[test]
    fn rows_hold_those_within_the_radius_in_their_order() {
        let block = Block::<2>::new(20, 0.2);
        let count = block.positions.len();
        let starts: Vec<usize> = (0..=count).map(|i| i * (count - 1)).collect();
        let others = |i: usize| (0..count as u32).filter(move |&j| j as usize != i);
        let neighbors: Vec<u32> = (0..count).flat_map(others).collect();
        let fields = FluidFields {
            positions: &block.positions,
            list_starts: &starts,
            list_neighbors: &neighbors,
            ..FluidFields::default()
        };
        let mut rows = NearRows::default();
        for radius in [2.6, 1.3, 0.0] {
            rows.find(&fields, count, radius);
            let near = rows.of(&fields);
            for i in 0..count {
                let distance = |j: u32| (block.positions[i] - block.positions[j as usize]).norm();
                let expected: Vec<u32> = others(i).filter(|&j| distance(j) < radius).collect();
                assert_eq!(near.neighbors(i), expected, "row {i} to {radius}");
            }
        }
    }
}
