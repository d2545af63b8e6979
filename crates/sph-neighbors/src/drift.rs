//! How far points have moved against those near them since a list was made.

use nalgebra::SVector;
use rayon::prelude::*;

/// Edge of a cell over the reach of the list, skin included: larger cells compare points that are further apart, smaller ones
/// let points that are not compared meet sooner.
const EDGE_OVER_REACH: f64 = 1.5;

/// Points in coarse cells, to compare the moves of those in one cell and in adjacent ones.
///
/// A fluid that moves as a whole changes no pairs. So a list is asked for not when a point has moved by half the skin
/// (Verlet 1967), but when two that were near each other may have moved by the skin against each other, or when two that were
/// not can have met.
#[derive(Clone, Debug, Default)]
pub(crate) struct Drift<const D: usize> {
    reach: f64,
    /// Cell of each point, and the point, ascending.
    keyed: Vec<(u64, u32)>,
    places: Vec<SVector<f64, D>>,
    cells: Vec<u64>,
    /// Where each cell starts in `keyed`; one entry more ends the last.
    starts: Vec<usize>,
    /// Pairs of cells that touch, each once, the lower first; and each cell with itself.
    touching: Vec<(u32, u32)>,
    moves: Vec<Moves<D>>,
}

/// The smallest box around the moves of the points of a cell.
#[derive(Clone, Copy, Debug)]
struct Moves<const D: usize> {
    low: SVector<f64, D>,
    high: SVector<f64, D>,
}

impl<const D: usize> Drift<D> {
    const BITS: usize = 63 / D;

    /// Begins anew with points at these places \[m\], for a list that reaches `reach` \[m\].
    pub fn begin(&mut self, reach: f64, places: impl Iterator<Item = SVector<f64, D>>) {
        self.reach = reach;
        self.places.clear();
        self.places.extend(places);
        let low =
            self.places.iter().copied().reduce(|low, place| low.inf(&place)).unwrap_or(SVector::zeros());
        let edge = EDGE_OVER_REACH * reach;
        let keyed = self.places.par_iter().enumerate().map(|(id, place)| {
            // The cast takes all beyond the last cell, and no number, to an end: a cell may be too large, never too small.
            let cell = |axis: usize| (((place - low)[axis] / edge) as u64).min((1 << Self::BITS) - 1);
            ((0..D).map(|axis| cell(axis) << (axis * Self::BITS)).sum(), id as u32)
        });
        keyed.collect_into_vec(&mut self.keyed);
        self.keyed.par_sort_unstable();
        self.cells.clear();
        self.starts.clear();
        for (k, &(key, _)) in self.keyed.iter().enumerate() {
            if self.cells.last() != Some(&key) {
                self.cells.push(key);
                self.starts.push(k);
            }
        }
        self.starts.push(self.keyed.len());
        self.find_touching();
    }

    fn find_touching(&mut self) {
        self.touching.clear();
        for (k, &key) in self.cells.iter().enumerate() {
            for step in 3_usize.pow(D as u32) / 2..3_usize.pow(D as u32) {
                let other = Self::stepped(key, step).and_then(|key| self.cells.binary_search(&key).ok());
                self.touching.extend(other.map(|other| (k as u32, other as u32)));
            }
        }
    }

    /// The cell at one of the steps of -1, 0, 1 along each axis, x fastest, if there can be one.
    fn stepped(key: u64, step: usize) -> Option<u64> {
        let (last, mut found) = ((1_u64 << Self::BITS) - 1, 0);
        for axis in 0..D {
            let coordinate = key >> (axis * Self::BITS) & last;
            let moved = (coordinate + (step / 3_usize.pow(axis as u32) % 3) as u64).checked_sub(1)?;
            if moved > last {
                return None;
            }
            found |= moved << (axis * Self::BITS);
        }
        Some(found)
    }

    /// Whether no two points that were `reach` apart or more at the beginning can be nearer than `reach` less `skin` \[m\]
    /// now. Places that are not numbers count as moved.
    pub fn holds(&mut self, skin: f64, place: impl Fn(usize) -> SVector<f64, D> + Sync) -> bool {
        let Self { reach, keyed, places, starts, touching, moves, .. } = self;
        let cells = starts.par_windows(2).map(|bounds| {
            let members = keyed[bounds[0]..bounds[1]].iter();
            let changes = members.map(|&(_, id)| place(id as usize) - places[id as usize]);
            Moves::around(changes)
        });
        cells.collect_into_vec(moves);
        let none = SVector::zeros();
        let farthest = moves.iter().map(|moves| moves.farthest_from(&Moves { low: none, high: none }));
        let farthest = largest(farthest);
        // Those in cells that do not touch were an edge apart.
        let meeting = EDGE_OVER_REACH * *reach - (*reach - skin);
        let compared = touching.iter().map(|&(a, b)| moves[a as usize].farthest_from(&moves[b as usize]));
        2.0 * farthest <= skin || (2.0 * farthest <= meeting && largest(compared) <= skin)
    }
}

/// The largest of lengths; infinity where one is no number.
fn largest(lengths: impl Iterator<Item = f64>) -> f64 {
    lengths.fold(0.0, |largest, length| if length.is_nan() { f64::INFINITY } else { length.max(largest) })
}

impl<const D: usize> Moves<D> {
    fn around(changes: impl Iterator<Item = SVector<f64, D>>) -> Self {
        let nothing = Self { low: SVector::repeat(f64::INFINITY), high: SVector::repeat(f64::NEG_INFINITY) };
        // What is no number stays.
        changes.fold(nothing, |moves, change| Self {
            low: moves.low.zip_map(&change, |a, b| if b >= a || a.is_nan() { a } else { b }),
            high: moves.high.zip_map(&change, |a, b| if b <= a || a.is_nan() { a } else { b }),
        })
    }

    /// Length of the longest difference that a move of one box and a move of the other can have.
    fn farthest_from(&self, other: &Self) -> f64 {
        let [one, two] = [self.high - other.low, other.high - self.low].map(|moves| moves.abs());
        // Not `sup`, which would forget what is no number.
        one.zip_map(&two, |a, b| if b <= a || a.is_nan() { a } else { b }).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PairReach;
    use crate::test_sets::{brute_force, perturbed_lattice};
    use proptest::prelude::*;

    const REACH: f64 = 2.0;
    const SKIN: f64 = 0.3;

    fn holds<const D: usize>(then: &[SVector<f64, D>], now: &[SVector<f64, D>]) -> bool {
        let mut drift = Drift::default();
        // Another set before: nothing of it may be left.
        drift.begin(0.7 * REACH, then.iter().take(3).copied());
        drift.begin(REACH, then.iter().copied());
        drift.holds(SKIN, |k| now[k])
    }

    proptest! {
        #[test]
        fn no_pair_is_missed_while_it_holds(
            spread in 3.0..9.0_f64,
            common in prop::array::uniform2(-1.0..1.0_f64),
            places in prop::collection::vec(prop::array::uniform4(-1.0..1.0_f64), 2..60),
            size in 0.0..0.5_f64,
        ) {
            let then: Vec<SVector<f64, 2>> =
                places.iter().map(|[x, y, ..]| SVector::from([*x, *y]) * spread).collect();
            let moved = places.iter().map(|[.., u, v]| SVector::from([*u, *v]) * size + SVector::from(common));
            let now: Vec<_> = then.iter().zip(moved).map(|(place, change)| place + change).collect();
            if holds(&then, &now) {
                let listed = brute_force(&then, PairReach::Uniform(REACH));
                let needed = brute_force(&now, PairReach::Uniform(REACH - SKIN));
                for (listed, needed) in listed.iter().zip(&needed) {
                    prop_assert!(needed.iter().all(|j| listed.contains(j)));
                }
            }
        }
    }

    #[test]
    fn what_moves_together_keeps_its_list_longer() {
        let then = perturbed_lattice::<3>(12, 0.2);
        let moved = |change: &dyn Fn(&SVector<f64, 3>) -> SVector<f64, 3>| {
            holds(&then, &then.iter().map(|place| place + change(place)).collect::<Vec<_>>())
        };
        assert!(moved(&|_| SVector::from([0.5, 0.2, 0.0])), "more than half the skin, together");
        assert!(!moved(&|_| SVector::from([0.8, 0.2, 0.0])), "points far off may come that way");
        assert!(moved(&|place| SVector::from([0.03 * place.y, 0.0, 0.0])), "a slow shear");
        assert!(!moved(&|place| SVector::from([0.06 * place.y, 0.0, 0.0])), "a faster one");
    }

    #[test]
    fn what_moves_against_its_neighbours_does_not() {
        let then = perturbed_lattice::<3>(6, 0.2);
        let one_moved = |length: f64| {
            let mut now = then.clone();
            now[77].y += length;
            holds(&then, &now)
        };
        assert!(one_moved(0.99 * SKIN) && !one_moved(1.01 * SKIN) && !one_moved(f64::NAN));
    }

    #[test]
    fn groups_that_come_from_far_are_seen() {
        // Four spacings apart, in cells that do not touch; each group moves as one.
        let then = [SVector::from([0.0, 0.0]), SVector::from([7.0, 0.0])];
        let closer = |length: f64| [SVector::from([length, 0.0]), SVector::from([7.0 - length, 0.0])];
        assert!(holds(&then, &closer(0.6)) && !holds(&then, &closer(2.9)));
    }
}
