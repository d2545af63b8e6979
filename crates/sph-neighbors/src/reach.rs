//! Which pairs belong into a list.

use crate::error::{Error, LARGEST, SMALLEST};

/// The distance \[m\] below which two particles are neighbours: one for all, or from the reaches of the two.
///
/// All three are symmetric, so j is a neighbour of i exactly if i is one of j. A pair at exactly its reach is not listed.
#[derive(Clone, Copy, Debug)]
pub enum PairReach<'a> {
    /// One reach for all pairs.
    Uniform(f64),
    /// The larger of the two reaches; one a particle.
    Maximum(&'a [f64]),
    /// The mean of the two reaches; one a particle.
    Mean(&'a [f64]),
}

impl<'a> PairReach<'a> {
    /// The reach of the pair (i, j) \[m\].
    #[inline]
    pub fn of_pair(&self, i: usize, j: usize) -> f64 {
        match self {
            Self::Uniform(reach) => *reach,
            Self::Maximum(reaches) => reaches[i].max(reaches[j]),
            Self::Mean(reaches) => 0.5 * (reaches[i] + reaches[j]),
        }
    }

    /// The reaches of all particles, if each has its own.
    pub(crate) fn per_particle(&self) -> Option<&'a [f64]> {
        match self {
            Self::Uniform(_) => None,
            Self::Maximum(reaches) | Self::Mean(reaches) => Some(reaches),
        }
    }

    /// Refuses reaches that are not positive lengths, or not one a particle.
    pub(crate) fn check(&self, particles: usize) -> Result<(), Error> {
        let uniform;
        let reaches = match self {
            Self::Uniform(reach) => {
                uniform = [*reach];
                &uniform
            }
            Self::Maximum(reaches) | Self::Mean(reaches) if reaches.len() == particles => *reaches,
            Self::Maximum(reaches) | Self::Mean(reaches) => {
                return Err(Error::ReachCount { reaches: reaches.len(), particles });
            }
        };
        match reaches.iter().position(|reach| !(SMALLEST..=LARGEST).contains(reach)) {
            Some(index) => Err(Error::Reach { index, reach: reaches[index] }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reach_of_a_pair() {
        let reaches = [1.0, 3.0];
        assert_eq!(PairReach::Uniform(2.5).of_pair(0, 1), 2.5);
        assert_eq!(PairReach::Maximum(&reaches).of_pair(0, 1), 3.0);
        assert_eq!(PairReach::Mean(&reaches).of_pair(1, 0), 2.0);
    }

    #[test]
    fn bad_reaches_are_named() {
        for bad in [0.0, -1.0, f64::INFINITY, 1e-160] {
            assert_eq!(PairReach::Uniform(bad).check(9), Err(Error::Reach { index: 0, reach: bad }));
            assert_eq!(PairReach::Mean(&[1.0, bad]).check(2), Err(Error::Reach { index: 1, reach: bad }));
        }
        assert!(matches!(PairReach::Maximum(&[f64::NAN]).check(1), Err(Error::Reach { index: 0, .. })));
        assert_eq!(PairReach::Maximum(&[1.0]).check(2), Err(Error::ReachCount { reaches: 1, particles: 2 }));
        assert_eq!(PairReach::Maximum(&[1.0, 2.0]).check(2), Ok(()));
    }
}
