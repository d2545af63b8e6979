//! From indexed levels to the finished list.

use crate::id_set::IdSet;
use crate::levels::split;
use crate::parts::{Part, Parts};
use crate::point_index::{PointIndex, distance_squared};
use crate::{NeighborList, PairReach};
use nalgebra::SVector;
use rayon::prelude::*;

/// Rows that one task makes. Fixed, and rows are independent: the list is the same for any number of threads.
const ROWS_PER_TASK: usize = 512;

/// The rows that the parts of a checked input need, with the index `I` on every level.
pub(crate) fn find_rows<I: PointIndex<D>, const D: usize>(
    positions: &[SVector<f64, D>],
    reach: PairReach<'_>,
    parts: Parts,
) -> NeighborList {
    let (levels, level_of) = split(&reach, positions.len());
    let mobile = parts.owned + parts.copies;
    let build =
        |members: &[u32], radius: f64| (!members.is_empty()).then(|| I::build(positions, members, radius));
    let leading = |members: &[u32]| members.partition_point(|&member| (member as usize) < mobile);
    let search = LeveledSearch::<I, D> {
        positions,
        reach,
        parts,
        all: levels.iter().map(|level| build(&level.members, level.radius)).collect(),
        mobile: if mobile < positions.len() {
            let led = levels.iter().map(|level| (&level.members[..leading(&level.members)], level.radius));
            led.map(|(members, radius)| build(members, radius)).collect()
        } else {
            Vec::new()
        },
        level_of: &level_of,
    };
    let tasks: Vec<Rows> = (0..positions.len().div_ceil(ROWS_PER_TASK))
        .into_par_iter()
        .map(|task| search.rows_of_task(task))
        .collect();
    let upward = concatenate(tasks);
    if levels.len() > 1 { with_mirrored(&upward, &level_of, parts) } else { upward }
}

/// Some consecutive rows: the length of each, and all one after the other.
struct Rows {
    lengths: Vec<u32>,
    indices: Vec<u32>,
}

struct LeveledSearch<'a, I, const D: usize> {
    positions: &'a [SVector<f64, D>],
    reach: PairReach<'a>,
    parts: Parts,
    /// Of all particles, one index for each level.
    all: Vec<Option<I>>,
    /// Of those whom others than owned ones and copies see.
    mobile: Vec<Option<I>>,
    level_of: &'a [u16],
}

impl<I: PointIndex<D>, const D: usize> LeveledSearch<'_, I, D> {
    fn rows_of_task(&self, task: usize) -> Rows {
        let first = task * ROWS_PER_TASK;
        let particles = first..(first + ROWS_PER_TASK).min(self.positions.len());
        let mut rows = Rows { lengths: Vec::with_capacity(particles.len()), indices: Vec::new() };
        let (mut found, mut set) = (Vec::new(), IdSet::new(self.positions.len()));
        for particle in particles {
            self.find_upward(particle, &mut found);
            let before = rows.indices.len();
            set.sort_into(&found, particle as u32, &mut rows.indices);
            rows.lengths.push((rows.indices.len() - before) as u32);
        }
        rows
    }

    /// The neighbours of a particle on its own and on all higher levels, and itself, in any order. A copy needs no row, but who is
    /// larger learns of it from there.
    fn find_upward(&self, particle: usize, found: &mut Vec<u32>) {
        found.clear();
        let position = &self.positions[particle];
        let level = usize::from(self.level_of[particle]);
        let indices = match self.parts.part_of(particle) {
            Part::Owned => &self.all[level..],
            Part::Copy => &self.all[level + 1..],
            Part::Other => &self.mobile[level..],
        };
        for index in indices.iter().flatten() {
            index.collect_within(position, found);
        }
        if self.reach.per_particle().is_some() {
            found.retain(|&other| self.is_pair(particle, other as usize));
        }
    }

    fn is_pair(&self, i: usize, j: usize) -> bool {
        let reach = self.reach.of_pair(i, j);
        distance_squared(&self.positions[i], &self.positions[j]) < reach * reach
    }
}

fn concatenate(tasks: Vec<Rows>) -> NeighborList {
    let mut starts = vec![0];
    let mut total = 0;
    for &length in tasks.iter().flat_map(|rows| &rows.lengths) {
        total += length as usize;
        starts.push(total);
    }
    let mut indices = vec![0; total];
    let mut rest = indices.as_mut_slice();
    let mut parts = Vec::with_capacity(tasks.len());
    for rows in &tasks {
        let (part, others) = rest.split_at_mut(rows.indices.len());
        parts.push((part, rows));
        rest = others;
    }
    parts.into_par_iter().for_each(|(part, rows)| part.copy_from_slice(&rows.indices));
    NeighborList::new(starts, indices)
}

/// Completes a list whose pairs across levels stand only in the row of the lower member.
fn with_mirrored(upward: &NeighborList, level_of: &[u16], parts: Parts) -> NeighborList {
    let mirrored = mirror(upward, level_of);
    let mut starts = vec![0];
    let mut indices = Vec::with_capacity(upward.pairs() + mirrored.pairs());
    for particle in 0..upward.particles() {
        if parts.part_of(particle) != Part::Copy {
            merge(upward.row(particle), mirrored.row(particle), &mut indices);
        }
        starts.push(indices.len());
    }
    NeighborList::new(starts, indices)
}

/// For each particle, the particles of lower levels that list it; ascending, since rows are visited in order.
fn mirror(upward: &NeighborList, level_of: &[u16]) -> NeighborList {
    let across = |i: usize| upward.row(i).iter().filter(move |&&j| level_of[j as usize] > level_of[i]);
    let mut starts = vec![0; upward.particles() + 1];
    for i in 0..upward.particles() {
        across(i).for_each(|&j| starts[j as usize + 1] += 1);
    }
    for row in 1..starts.len() {
        starts[row] += starts[row - 1];
    }
    let mut next = starts.clone();
    let mut indices = vec![0; starts[upward.particles()]];
    for i in 0..upward.particles() {
        for &j in across(i) {
            indices[next[j as usize]] = i as u32;
            next[j as usize] += 1;
        }
    }
    NeighborList::new(starts, indices)
}

/// Appends two ascending rows as one.
fn merge<'a>(mut left: &'a [u32], mut right: &'a [u32], merged: &mut Vec<u32>) {
    while let (Some(l), Some(r)) = (left.first(), right.first()) {
        let from = if l < r { &mut left } else { &mut right };
        merged.push(from[0]);
        *from = &from[1..];
    }
    merged.extend_from_slice(left);
    merged.extend_from_slice(right);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merging_keeps_the_order() {
        for (left, right) in [(&[1, 4, 9][..], &[2, 3, 11][..]), (&[], &[5]), (&[5], &[]), (&[7, 8], &[1])] {
            let mut merged = Vec::new();
            merge(left, right, &mut merged);
            let mut expected = [left, right].concat();
            expected.sort_unstable();
            assert_eq!(merged, expected);
        }
    }

    #[test]
    fn only_pairs_across_levels_are_mirrored() {
        // 0 and 1 are fine, 2 is coarse; 0 lists 1 and 2, 1 lists 0.
        let upward = NeighborList::new(vec![0, 2, 3, 3], vec![1, 2, 0]);
        let full = with_mirrored(&upward, &[0, 0, 1], Parts::all(3));
        assert_eq!(full, NeighborList::new(vec![0, 2, 3, 4], vec![1, 2, 0, 0]));
    }
}
