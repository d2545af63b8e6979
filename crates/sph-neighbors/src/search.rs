//! The one entry to all search methods.

use crate::cell_grid::CellGrid;
use crate::error::{Error, check_positions};
use crate::kd_tree::KdTree;
use crate::rows::find_rows;
use crate::{NeighborList, PairReach, Parts};
use nalgebra::SVector;

/// How neighbours are found. All methods give the same list, to the last entry, on any number of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SearchMethod {
    /// A grid of cells, one for each power of two of the reach; dense or, for sets that spread far, only occupied cells.
    #[default]
    CellGrid,
    /// kiddo's immutable k-d tree, one for each power of two of the reach.
    KdTree,
}

impl SearchMethod {
    /// The neighbours of all particles: pairs nearer than their reach, without the particles themselves.
    ///
    /// `positions` \[m\] in `D` = 2 or 3 dimensions. Cost is close to linear in the number of particles and pairs, also where
    /// reaches differ by large factors. Rows are made in parallel on the current rayon pool.
    ///
    /// # Errors
    /// Positions that are not finite, reaches that are not positive or not one a particle, too many particles.
    pub fn find<const D: usize>(
        self,
        positions: &[SVector<f64, D>],
        reach: PairReach<'_>,
    ) -> Result<NeighborList, Error> {
        self.find_for(positions, reach, Parts::all(positions.len()))
    }

    /// The neighbours of owned particles, as [`find`](Self::find) gives them; of those behind the copies only the owned ones and the
    /// copies, and of copies none. Who is far from all owned particles costs next to nothing.
    ///
    /// # Errors
    /// As [`find`](Self::find).
    ///
    /// # Panics
    /// If there are fewer positions than owned particles and copies.
    pub fn find_for<const D: usize>(
        self,
        positions: &[SVector<f64, D>],
        reach: PairReach<'_>,
        parts: Parts,
    ) -> Result<NeighborList, Error> {
        const { assert!(D == 2 || D == 3, "searches are for 2 and 3 dimensions") };
        assert!(parts.owned + parts.copies <= positions.len(), "parts");
        check_positions(positions)?;
        reach.check(positions.len())?;
        Ok(match self {
            Self::CellGrid => find_rows::<CellGrid<D>, D>(positions, reach, parts),
            Self::KdTree => find_rows::<KdTree<D>, D>(positions, reach, parts),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_sets::{any_reach, any_set, brute_force};
    use proptest::prelude::*;

    fn check<const D: usize>(
        positions: &[SVector<f64, D>],
        reach: PairReach<'_>,
    ) -> Result<(), TestCaseError> {
        let expected = brute_force(positions, reach);
        let owned = positions.len() / 2;
        let parts = Parts { owned, copies: positions.len() / 4 };
        let mobile = owned + parts.copies;
        for method in [SearchMethod::CellGrid, SearchMethod::KdTree] {
            let list = method.find(positions, reach).unwrap();
            let part = method.find_for(positions, reach, parts).unwrap();
            for index in 0..positions.len() {
                let row = expected[index].as_slice();
                prop_assert_eq!(list.row(index), row, "{:?} row {}", method, index);
                let needed = match index {
                    _ if index < owned => row,
                    _ if index < mobile => &[],
                    _ => &row[..row.partition_point(|&other| (other as usize) < mobile)],
                };
                prop_assert_eq!(part.row(index), needed, "{:?} row {} of {:?}", method, index, parts);
            }
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn uniform_reach_matches_brute_force_2d(positions in any_set::<2>(), radius in 0.02..2.0) {
            check(&positions, PairReach::Uniform(radius))?;
        }

        #[test]
        fn uniform_reach_matches_brute_force_3d(positions in any_set::<3>(), radius in 0.02..2.0) {
            check(&positions, PairReach::Uniform(radius))?;
        }

        #[test]
        fn varying_reach_matches_brute_force_2d((positions, reaches) in any_reach::<2>()) {
            check(&positions, PairReach::Maximum(&reaches))?;
            check(&positions, PairReach::Mean(&reaches))?;
        }

        #[test]
        fn varying_reach_matches_brute_force_3d((positions, reaches) in any_reach::<3>()) {
            check(&positions, PairReach::Maximum(&reaches))?;
            check(&positions, PairReach::Mean(&reaches))?;
        }
    }

    #[test]
    fn large_sets_that_share_coordinates_match_brute_force() {
        let lattice = crate::test_sets::perturbed_lattice::<3>(12, 0.0);
        let plane: Vec<SVector<f64, 3>> =
            lattice.iter().map(|r| SVector::from([r.x + 12.0 * r.z, r.y, 0.5])).collect();
        let pile = vec![SVector::<f64, 3>::repeat(0.3); 300];
        for positions in [lattice, plane, pile] {
            check(&positions, PairReach::Uniform(1.5)).unwrap();
        }
    }

    #[test]
    fn no_particle_and_one_particle() {
        for method in [SearchMethod::CellGrid, SearchMethod::KdTree] {
            assert_eq!(method.find::<3>(&[], PairReach::Uniform(1.0)), Ok(NeighborList::default()));
            let alone = method.find(&[SVector::from([1.0, 2.0])], PairReach::Maximum(&[0.5])).unwrap();
            assert_eq!((alone.particles(), alone.pairs()), (1, 0));
        }
    }

    #[test]
    fn bad_input_is_an_error() {
        let positions = [SVector::from([0.0, 0.0]), SVector::from([f64::NAN, 0.0])];
        let method = SearchMethod::default();
        assert_eq!(method.find(&positions, PairReach::Uniform(1.0)), Err(Error::Position { index: 1 }));
        let reach = PairReach::Maximum(&[1.0, -1.0]);
        assert_eq!(method.find(&positions[..1], reach), Err(Error::ReachCount { reaches: 2, particles: 1 }));
    }

    #[test]
    fn the_list_is_the_same_on_one_and_two_threads() {
        let positions: Vec<SVector<f64, 3>> = crate::test_sets::perturbed_lattice(15, 0.3);
        let reaches: Vec<f64> = (0..positions.len()).map(|k| [1.1, 1.9, 3.1][k % 7 % 3]).collect();
        for method in [SearchMethod::CellGrid, SearchMethod::KdTree] {
            let on = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| method.find(&positions, PairReach::Mean(&reaches)).unwrap())
            };
            assert_eq!(on(1), on(2));
        }
    }
}
