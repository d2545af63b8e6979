//! The pairs of a block of particles that are inside the support now.

use super::quads::LANES;
use std::ops::Range;

/// Rows of a block of consecutive particles. A pair of the block stands once, in the row of its lower member; a pair with
/// a particle elsewhere stands in the row of the one of this block, and once more in another block.
///
/// So a block writes to its own particles only, and sums run in an order that does not depend on the number of threads.
#[derive(Clone, Debug)]
pub(super) struct NearPairs {
    particles: Range<usize>,
    within: Rows,
    across: Rows,
}

impl NearPairs {
    /// No pairs of these particles.
    pub fn new(particles: Range<usize>) -> Self {
        Self { particles, within: Rows::default(), across: Rows::default() }
    }

    /// The particles of the block.
    pub fn particles(&self) -> Range<usize> {
        self.particles.clone()
    }

    /// Forgets all rows, but keeps the memory.
    pub fn clear(&mut self) {
        self.within.clear();
        self.across.clear();
    }

    /// Begins the row of the next particle, which has up to `candidates` neighbours.
    pub fn begin_row(&mut self, candidates: usize) {
        self.within.begin_row(candidates);
        self.across.begin_row(candidates);
    }

    /// Appends to the row of particle `own` those of four candidates that are `near`, one bit to each.
    #[inline(always)]
    pub fn append(&mut self, own: usize, indices: [u32; LANES], near: u32) {
        let Range { start, end } = self.particles;
        let (mut later, mut elsewhere) = (0, 0);
        for (lane, index) in indices.into_iter().enumerate() {
            let index = index as usize;
            later |= u32::from(index > own && index < end) << lane;
            elsewhere |= u32::from(index < start || index >= end) << lane;
        }
        self.within.append(indices, later & near);
        self.across.append(indices, elsewhere & near);
    }

    /// Neighbours in the block, later than its `k`-th particle.
    pub fn within(&self, k: usize) -> &[u32] {
        self.within.row(k)
    }

    /// Neighbours of the `k`-th particle elsewhere.
    pub fn across(&self, k: usize) -> &[u32] {
        self.across.row(k)
    }
}

#[derive(Clone, Debug, Default)]
struct Rows {
    starts: Vec<usize>,
    /// Longer than what is in use, and never shortened: room need not be cleared anew.
    entries: Vec<u32>,
    end: usize,
}

impl Rows {
    fn clear(&mut self) {
        self.starts.clear();
        self.end = 0;
    }

    fn begin_row(&mut self, candidates: usize) {
        self.starts.push(self.end);
        let wanted = self.end + candidates + LANES;
        if self.entries.len() < wanted {
            self.entries.resize(wanted, 0);
        }
    }

    /// Four are written always and those that are kept stay: no branch to mispredict.
    #[inline(always)]
    fn append(&mut self, indices: [u32; LANES], kept: u32) {
        let room: &mut [u32; LANES] =
            (&mut self.entries[self.end..self.end + LANES]).try_into().expect("four");
        let mut count = 0;
        for (lane, index) in indices.into_iter().enumerate() {
            room[count % LANES] = index;
            count += (kept >> lane & 1) as usize;
        }
        self.end += count;
    }

    fn row(&self, k: usize) -> &[u32] {
        let end = self.starts.get(k + 1).copied().unwrap_or(self.end);
        &self.entries[self.starts[k]..end]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_of_the_block_stands_once_and_others_in_every_row() {
        let mut pairs = NearPairs::new(10..20);
        for _ in 0..2 {
            pairs.clear();
            pairs.begin_row(8);
            pairs.append(10, [9, 10, 11, 19], 0b1111);
            pairs.append(10, [20, 12, 13, 8], 0b1010);
            pairs.begin_row(4);
            pairs.append(11, [10, 15, 30, 9], 0b0111);
        }
        assert_eq!((pairs.within(0), pairs.across(0)), (&[11, 19, 12][..], &[9, 8][..]));
        assert_eq!((pairs.within(1), pairs.across(1)), (&[15][..], &[30][..]));
    }
}
