//! A neighbour list that stays valid while particles move a little.

use crate::error::{Error, check_positions};
use crate::point_index::distance_squared;
use crate::{NeighborList, PairReach, SearchMethod};
use nalgebra::SVector;

/// A list that reaches a skin further than needed, and is rebuilt only when some particle has moved by more than half the
/// skin since the last build (Verlet 1967). Until then no pair can have come within reach unlisted.
///
/// The list holds pairs beyond their reach, too: whoever reads it drops those, as `sph_kernel`'s row buffer does.
#[derive(Clone, Debug)]
pub struct SkinnedList<const D: usize> {
    method: SearchMethod,
    skin: f64,
    reach: WidenedReach,
    list: NeighborList,
    reference: Vec<SVector<f64, D>>,
    rebuilds: u64,
    updates: u64,
}

/// The reaches of the list's pairs, with the skin in them.
#[derive(Clone, Debug)]
enum WidenedReach {
    Uniform(f64),
    Maximum(Vec<f64>),
    Mean(Vec<f64>),
}

impl WidenedReach {
    fn new(reach: PairReach<'_>, skin: f64) -> Self {
        let widen = |reaches: &[f64]| reaches.iter().map(|reach| reach + skin).collect();
        match reach {
            PairReach::Uniform(reach) => Self::Uniform(reach + skin),
            PairReach::Maximum(reaches) => Self::Maximum(widen(reaches)),
            PairReach::Mean(reaches) => Self::Mean(widen(reaches)),
        }
    }

    fn view(&self) -> PairReach<'_> {
        match self {
            Self::Uniform(reach) => PairReach::Uniform(*reach),
            Self::Maximum(reaches) => PairReach::Maximum(reaches),
            Self::Mean(reaches) => PairReach::Mean(reaches),
        }
    }
}

impl<const D: usize> SkinnedList<D> {
    /// Builds the list of pairs nearer than their `reach` plus the `skin` \[m\]. A skin of zero rebuilds at every move.
    ///
    /// # Errors
    /// A negative or infinite skin, and what [`SearchMethod::find`] refuses.
    pub fn new(
        method: SearchMethod,
        positions: &[SVector<f64, D>],
        reach: PairReach<'_>,
        skin: f64,
    ) -> Result<Self, Error> {
        if !(skin.is_finite() && skin >= 0.0) {
            return Err(Error::Skin { skin });
        }
        check_positions(positions)?;
        reach.check(positions.len())?;
        let reach = WidenedReach::new(reach, skin);
        let list = method.find(positions, reach.view())?;
        Ok(Self { method, skin, reach, list, reference: positions.to_vec(), rebuilds: 0, updates: 0 })
    }

    /// Rebuilds the list if `positions` \[m\] ask for it; returns whether it did.
    ///
    /// # Errors
    /// Positions that are not finite; a number of positions that does not fit the reaches. The old list is then kept.
    pub fn update(&mut self, positions: &[SVector<f64, D>]) -> Result<bool, Error> {
        self.updates += 1;
        if self.is_valid_for(positions) {
            return Ok(false);
        }
        self.list = self.method.find(positions, self.reach.view())?;
        self.reference.clear();
        self.reference.extend_from_slice(positions);
        self.rebuilds += 1;
        Ok(true)
    }

    /// Whether no particle has moved by more than half the skin. A position that is NaN counts as moved.
    fn is_valid_for(&self, positions: &[SVector<f64, D>]) -> bool {
        let limit = 0.25 * self.skin * self.skin;
        positions.len() == self.reference.len()
            && positions.iter().zip(&self.reference).all(|(now, then)| distance_squared(now, then) <= limit)
    }

    /// The list, with the pairs in the skin.
    #[inline]
    pub fn list(&self) -> &NeighborList {
        &self.list
    }

    /// How far the list reaches beyond the true reach \[m\].
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Builds after the first one.
    pub fn rebuilds(&self) -> u64 {
        self.rebuilds
    }

    /// Calls of [`update`](Self::update), with and without a rebuild.
    pub fn updates(&self) -> u64 {
        self.updates
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_sets::{brute_force, perturbed_lattice};
    use proptest::prelude::*;

    const METHOD: SearchMethod = SearchMethod::CellGrid;

    fn holds_every_pair(list: &NeighborList, positions: &[SVector<f64, 2>], reach: PairReach<'_>) -> bool {
        let true_rows = brute_force(positions, reach);
        (0..positions.len()).all(|i| true_rows[i].iter().all(|j| list.row(i).binary_search(j).is_ok()))
    }

    proptest! {
        #[test]
        fn no_pair_is_missed_on_a_random_walk(steps in prop::collection::vec((0_usize..64, -0.1..0.1, -0.1..0.1), 1..300)) {
            let mut positions = perturbed_lattice::<2>(8, 0.3);
            let reaches: Vec<f64> = (0..64).map(|k| 1.2 + 0.4 * (k % 3) as f64).collect();
            let reach = PairReach::Mean(&reaches);
            let mut skinned = SkinnedList::new(METHOD, &positions, reach, 0.25).unwrap();
            for (index, x, y) in steps {
                positions[index] += SVector::from([x, y]);
                skinned.update(&positions).unwrap();
                prop_assert!(holds_every_pair(skinned.list(), &positions, reach));
            }
        }
    }

    #[test]
    fn rebuilds_only_beyond_half_the_skin() {
        let mut positions = perturbed_lattice::<2>(5, 0.1);
        let mut skinned = SkinnedList::new(METHOD, &positions, PairReach::Uniform(1.2), 0.2).unwrap();
        for _ in 0..9 {
            positions[7].x += 0.011;
            assert_eq!(skinned.update(&positions), Ok(false));
        }
        positions[7].x += 0.011;
        assert_eq!(skinned.update(&positions), Ok(true));
        assert_eq!(skinned.update(&positions), Ok(false));
        assert_eq!((skinned.rebuilds(), skinned.updates()), (1, 11));
        assert_eq!(skinned.list(), &METHOD.find(&positions, PairReach::Uniform(1.4)).unwrap());
    }

    #[test]
    fn pairs_in_the_skin_are_listed() {
        let positions = [SVector::from([0.0, 0.0]), SVector::from([1.15, 0.0])];
        let listed =
            |skin| SkinnedList::new(METHOD, &positions, PairReach::Maximum(&[1.0, 0.5]), skin).unwrap();
        assert_eq!((listed(0.1).list().pairs(), listed(0.2).list().pairs()), (0, 2));
    }

    #[test]
    fn bad_input_is_an_error_and_keeps_the_list() {
        let mut positions = perturbed_lattice::<3>(3, 0.1);
        let reach = PairReach::Uniform(1.2);
        let refused = SkinnedList::new(METHOD, &positions, reach, -0.1).map(|_| ());
        assert_eq!(refused, Err(Error::Skin { skin: -0.1 }));
        let mut skinned = SkinnedList::new(METHOD, &positions, reach, 0.1).unwrap();
        let before = skinned.list().clone();
        positions[4].y = f64::NAN;
        assert_eq!(skinned.update(&positions), Err(Error::Position { index: 4 }));
        assert_eq!((skinned.list(), skinned.rebuilds()), (&before, 0));
    }
}
