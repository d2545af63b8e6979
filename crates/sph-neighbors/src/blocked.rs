//! Pairs of particles that are sorted into cubic blocks.

use crate::cell_blocks::{BlockFrame, CellBlocks, Surroundings};
use crate::drift::Drift;
use crate::error::{Error, check_positions};
use crate::{PairReach, Permutation};
use nalgebra::SVector;
use rayon::prelude::*;
use wide::{f64x4, u32x4};

/// A list for sweeps whose unit of parallel work is a cubic block of particles.
///
/// Owned particles are sorted by block. A pair of one block stands once, in the row of its lower member; a pair of two
/// blocks stands in both rows. So a block writes to its own particles only, needs no atomics, and gives the same sums on
/// any number of threads, at little more than half of the visits of a full list. Particles behind the owned ones
/// (copies, walls) keep their places, have no rows, and stand in the rows of the owned ones that they are near to.
///
/// All storage is kept from one update to the next. Memory grows with pairs and with blocks that hold particles.
#[derive(Clone, Debug)]
pub struct BlockedPairs<const D: usize> {
    reach: f64,
    block_edge: f64,
    order: Permutation,
    owned: CellBlocks<D>,
    others: CellBlocks<D>,
    drift: Drift<D>,
    /// Rows of each block, and of blocks that there were once.
    rows: Vec<RowStore<D>>,
}

/// The rows of one block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockRows<'a> {
    /// The first particle of the block; its others follow.
    pub first: usize,
    /// Where the three parts of each row start in `neighbors`: entry 3 k is the start of what the k-th particle of the
    /// block has within the block, 3 k + 1 of the owned particles of other blocks, 3 k + 2 of particles not owned. One
    /// entry more ends the last row.
    pub starts: &'a [u32],
    /// All rows one after the other; the first and the third part of a row are ascending.
    pub neighbors: &'a [u32],
}

impl<const D: usize> BlockedPairs<D> {
    /// A list without particles, for pairs nearer than `reach` \[m\] and blocks of about `block_edge` \[m\]. Five to six
    /// times the reach is a good edge in 3-D: smaller blocks have more pairs across them, larger ones leave the cache.
    ///
    /// # Errors
    /// A reach or an edge that is not a positive length.
    pub fn new(reach: f64, block_edge: f64) -> Result<Self, Error> {
        PairReach::Uniform(reach).check(0)?;
        if !(block_edge.is_finite() && block_edge > 0.0) {
            return Err(Error::CellSize { size: block_edge });
        }
        Ok(Self {
            reach,
            block_edge,
            order: Permutation::identity(0),
            owned: CellBlocks::default(),
            others: CellBlocks::default(),
            drift: Drift::default(),
            rows: Vec::new(),
        })
    }

    /// Sorts the first `owned` particles and finds the pairs. Rows name owned particles by their new places, the others
    /// by their places in `positions` \[m\]. The caller then brings its columns of owned particles into the new
    /// [`order`](Self::order).
    ///
    /// # Errors
    /// Positions that are not finite, too many particles. The old list is then kept.
    ///
    /// # Panics
    /// If there are fewer positions than owned particles.
    pub fn update(&mut self, positions: &[SVector<f64, D>], owned: usize) -> Result<(), Error> {
        const { assert!(D == 2 || D == 3, "searches are for 2 and 3 dimensions") };
        check_positions(positions)?;
        let low = positions.iter().copied().reduce(|low, place| low.inf(&place)).unwrap_or(SVector::zeros());
        let frame = BlockFrame::new(low, self.reach, self.block_edge);
        self.owned.sort(&frame, &positions[..owned]);
        self.others.sort(&frame, &positions[owned..]);
        self.order.refill(self.owned.ids());
        self.rows.resize_with(self.rows.len().max(self.blocks()), RowStore::default);
        let Self { reach, owned: sorted, others, drift, rows, .. } = self;
        let all = (0..owned).map(|point| *sorted.point(point as u32));
        drift.begin(*reach, all.chain(positions[owned..].iter().copied()));
        let owned = sorted;
        rows[..owned.blocks()].par_iter_mut().enumerate().for_each(|(block, rows)| {
            rows.find(&frame, owned, others, block, *reach);
        });
        Ok(())
    }

    /// Whether the list still has all pairs nearer than its reach less a `skin` \[m\], with particles at their present
    /// positions \[m\], by the names that rows give them.
    ///
    /// It does as long as particles that were near each other have moved by less than the skin against each other, however
    /// far they went together, and no others can have met. Positions that are not finite count as moved.
    #[must_use]
    pub fn holds(&mut self, skin: f64, position: impl Fn(usize) -> SVector<f64, D> + Sync) -> bool {
        self.drift.holds(skin, position)
    }

    /// The old place of each owned particle.
    #[must_use]
    pub fn order(&self) -> &Permutation {
        &self.order
    }

    /// Number of blocks that hold owned particles.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.owned.blocks()
    }

    /// The rows of a block.
    ///
    /// # Panics
    /// If there never was such a block.
    #[inline]
    #[must_use]
    pub fn rows(&self, block: usize) -> BlockRows<'_> {
        let RowStore { starts, neighbors, .. } = &self.rows[block];
        BlockRows { first: self.owned.first(block), starts, neighbors: &neighbors.entries[..neighbors.end] }
    }

    /// Number of entries of all rows: what a sweep looks at.
    #[must_use]
    pub fn entries(&self) -> usize {
        (0..self.blocks()).map(|block| self.rows(block).neighbors.len()).sum()
    }
}

#[derive(Clone, Debug, Default)]
struct RowStore<const D: usize> {
    starts: Vec<u32>,
    neighbors: Rows,
    /// Candidates of one home for the three parts of its rows.
    within: Candidates<D>,
    across: Candidates<D>,
    beyond: Candidates<D>,
}

impl<const D: usize> RowStore<D> {
    fn find(
        &mut self,
        frame: &BlockFrame<D>,
        owned: &CellBlocks<D>,
        others: &CellBlocks<D>,
        block: usize,
        reach: f64,
    ) {
        self.starts.clear();
        self.neighbors.end = 0;
        let [near, far] = [owned, others].map(|points| Surroundings::of(frame, points, owned.number(block)));
        for home in frame.homes() {
            let members = owned.cells(frame, block, &home);
            if members.is_empty() {
                continue;
            }
            for candidates in [&mut self.within, &mut self.across, &mut self.beyond] {
                candidates.clear();
            }
            near.runs(&home, |same, run| match same {
                true if run.end <= members.start => {}
                true => self.within.extend(owned.points(run.clone()), run),
                false => self.across.extend(owned.points(run.clone()), run),
            });
            far.runs(&home, |_, run| {
                let ids = run.clone().map(|point| owned.len() as u32 + others.id(point));
                self.beyond.extend(others.points(run), ids);
            });
            for candidates in [&mut self.within, &mut self.across, &mut self.beyond] {
                candidates.fill_up();
            }
            members.for_each(|particle| self.find_row(particle, owned.point(particle), reach * reach));
        }
        self.starts.push(self.neighbors.end as u32);
    }

    fn find_row(&mut self, particle: u32, place: &SVector<f64, D>, limit: f64) {
        let Self { starts, neighbors, within, across, beyond } = self;
        let later = within.ids.partition_point(|&id| id <= particle);
        for (candidates, from) in [(within, later), (across, 0), (beyond, 0)] {
            starts.push(neighbors.end as u32);
            candidates.find_near(from, place, limit, neighbors);
        }
        neighbors.entries[starts[starts.len() - 1] as usize..neighbors.end].sort_unstable();
    }
}

/// Points that may be near to those of a home, copied into columns so that four are looked at together.
#[derive(Clone, Debug)]
struct Candidates<const D: usize> {
    places: [Vec<f64>; D],
    ids: Vec<u32>,
}

impl<const D: usize> Default for Candidates<D> {
    fn default() -> Self {
        Self { places: std::array::from_fn(|_| Vec::new()), ids: Vec::new() }
    }
}

impl<const D: usize> Candidates<D> {
    fn clear(&mut self) {
        self.places.iter_mut().for_each(Vec::clear);
        self.ids.clear();
    }

    fn extend(&mut self, points: &[SVector<f64, D>], ids: impl Iterator<Item = u32>) {
        for axis in 0..D {
            self.places[axis].extend(points.iter().map(|point| point[axis]));
        }
        self.ids.extend(ids);
    }

    /// Fills the last four up with places that are near to none.
    fn fill_up(&mut self) {
        let length = self.ids.len().next_multiple_of(LANES);
        self.places.iter_mut().for_each(|places| places.resize(length, f64::INFINITY));
        self.ids.resize(length, u32::MAX);
    }

    /// Appends the candidates behind the first `from` that are nearer to a place than the root of `limit`. Squares are
    /// summed as in `distance_squared`, so that all searches find the same pairs.
    #[inline]
    fn find_near(&self, from: usize, place: &SVector<f64, D>, limit: f64, found: &mut Rows) {
        let columns: [&[[f64; LANES]]; D] = std::array::from_fn(|axis| self.places[axis].as_chunks().0);
        let (ids, _) = self.ids.as_chunks::<LANES>();
        let target = found.room(self.ids.len());
        let mut kept = 0;
        // Of the first four only those that are not before `from`.
        let mut wanted = 0b1111 << (from % LANES) & 0b1111;
        for k in from / LANES..ids.len() {
            let mut square = f64x4::ZERO;
            for axis in 0..D {
                let difference = place[axis] - f64x4::new(columns[axis][k]);
                square += difference * difference;
            }
            let near = square.simd_lt(f64x4::splat(limit)).to_bitmask() & wanted;
            // Four are written always, those that are near first: no branch to mispredict.
            let sorted = u32x4::new(ids[k]).shuffle(u32x4::new(NEAR_FIRST[near as usize]));
            target[kept..kept + LANES].copy_from_slice(sorted.as_array());
            kept += near.count_ones() as usize;
            wanted = 0b1111;
        }
        found.end += kept;
    }
}

/// Candidates that are looked at together.
const LANES: usize = 4;

/// For each set of lanes, an order that puts them first.
const NEAR_FIRST: [[u32; LANES]; 16] = {
    let mut orders = [[0; LANES]; 16];
    let mut set = 0;
    while set < 16 {
        let (mut lane, mut place) = (0, 0);
        while lane < LANES {
            if set >> lane & 1 == 1 {
                orders[set][place] = lane as u32;
                place += 1;
            }
            lane += 1;
        }
        set += 1;
    }
    orders
};

/// A vector that keeps its length when it is emptied: room for candidates need not be zeroed anew.
#[derive(Clone, Debug, Default)]
struct Rows {
    entries: Vec<u32>,
    end: usize,
}

impl Rows {
    fn room(&mut self, count: usize) -> &mut [u32] {
        if self.entries.len() < self.end + count {
            self.entries.resize(2 * (self.end + count), 0);
        }
        &mut self.entries[self.end..self.end + count]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_sets::{any_set, brute_force, perturbed_lattice};
    use proptest::prelude::*;

    /// The full rows that a blocked list stands for, in the old numbering.
    fn full_rows<const D: usize>(pairs: &BlockedPairs<D>, particles: usize, owned: usize) -> Vec<Vec<u32>> {
        let old = |new: u32| pairs.order().order().get(new as usize).copied().unwrap_or(new);
        let mut rows = vec![Vec::new(); particles];
        let mut particle = 0;
        for block in 0..pairs.blocks() {
            let BlockRows { first, starts, neighbors } = pairs.rows(block);
            assert_eq!(first, particle as usize);
            for bounds in starts[..starts.len() - 1].chunks_exact(3).zip(starts[3..].iter().step_by(3)) {
                let (&[within, across, beyond], &end) = bounds else { unreachable!() };
                let [own, others, foreign] = [(within, across), (across, beyond), (beyond, end)]
                    .map(|(from, to)| &neighbors[from as usize..to as usize]);
                assert!(own.iter().all(|&j| j > particle));
                assert!(foreign.is_sorted() && foreign.iter().all(|&j| j as usize >= owned));
                rows[old(particle) as usize].extend([own, others, foreign].concat().into_iter().map(old));
                own.iter().for_each(|&j| rows[old(j) as usize].push(old(particle)));
                particle += 1;
            }
        }
        assert_eq!(particle as usize, owned);
        rows.iter_mut().for_each(|row| row.sort_unstable());
        rows
    }

    fn check<const D: usize>(
        positions: &[SVector<f64, D>],
        reach: f64,
        edge: f64,
    ) -> Result<(), TestCaseError> {
        let expected = brute_force(positions, PairReach::Uniform(reach));
        let mut pairs = BlockedPairs::new(reach, edge).unwrap();
        // Fewer, then all: what an earlier update has left must not matter.
        for owned in [positions.len() / 2, positions.len()] {
            pairs.update(positions, owned).unwrap();
            let found = full_rows(&pairs, positions.len(), owned);
            prop_assert_eq!(&found[..owned], &expected[..owned]);
            prop_assert!(found[owned..].iter().all(Vec::is_empty));
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn stands_for_the_pairs_of_brute_force_2d(positions in any_set::<2>(), reach in 0.02..2.0, edge in 0.1..20.0) {
            check(&positions, reach, edge * reach)?;
        }

        #[test]
        fn stands_for_the_pairs_of_brute_force_3d(positions in any_set::<3>(), reach in 0.02..2.0, edge in 0.1..20.0) {
            check(&positions, reach, edge * reach)?;
        }
    }

    #[test]
    fn large_sets_match_brute_force() {
        for amplitude in [0.0, 0.3] {
            check(&perturbed_lattice::<3>(14, amplitude), 2.5, 7.0).unwrap();
            check(&perturbed_lattice::<2>(40, amplitude), 2.5, 12.0).unwrap();
        }
    }

    #[test]
    fn pairs_of_a_block_stand_once() {
        let positions = perturbed_lattice::<3>(12, 0.2);
        let entries = |edge| {
            let mut pairs = BlockedPairs::new(1.8, edge).unwrap();
            pairs.update(&positions, positions.len()).unwrap();
            pairs.entries()
        };
        let directed: usize = brute_force(&positions, PairReach::Uniform(1.8)).iter().map(Vec::len).sum();
        assert_eq!(2 * entries(100.0), directed);
        let share = entries(6.0) as f64 / directed as f64;
        assert!(share > 0.5 && share < 0.7, "{share}");
    }

    #[test]
    fn is_the_same_on_one_and_two_threads() {
        let positions = perturbed_lattice::<3>(20, 0.3);
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut pairs = BlockedPairs::new(2.0, 7.0).unwrap();
            pool.install(|| pairs.update(&positions, 7000).unwrap());
            pairs
        };
        let (one, two) = (on(1), on(2));
        assert_eq!(one.order(), two.order());
        assert!(one.blocks() > 8 && (0..one.blocks()).all(|block| one.rows(block) == two.rows(block)));
    }

    #[test]
    fn bad_input_is_an_error() {
        assert!(matches!(BlockedPairs::<2>::new(0.0, 1.0), Err(Error::Reach { .. })));
        assert!(matches!(BlockedPairs::<2>::new(1.0, f64::NAN), Err(Error::CellSize { .. })));
        let mut pairs = BlockedPairs::<2>::new(1.0, 5.0).unwrap();
        assert_eq!(pairs.update(&[SVector::from([0.0, f64::NAN])], 1), Err(Error::Position { index: 0 }));
        assert_eq!(pairs.update(&[], 0), Ok(()));
        assert_eq!((pairs.blocks(), pairs.entries()), (0, 0));
    }
}
