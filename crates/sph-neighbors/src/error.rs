//! What can be wrong with the input of a search.

use nalgebra::SVector;

/// Largest magnitude of a coordinate or reach \[m\]; squares of larger ones overflow.
pub(crate) const LARGEST: f64 = 1e150;
/// Smallest reach \[m\]; squares of smaller ones underflow.
pub(crate) const SMALLEST: f64 = 1e-150;

/// Why a search was refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// A coordinate is NaN, infinite or beyond 1e150 m.
    #[error("the position of particle {index} is not finite or beyond 1e150 m")]
    Position {
        /// The particle.
        index: usize,
    },
    /// A reach is NaN, infinite, zero, negative, or outside 1e-150 to 1e150 m. A uniform reach counts as particle 0.
    #[error("the reach of particle {index} is {reach} m; it must be positive and between 1e-150 and 1e150 m")]
    Reach {
        /// The particle.
        index: usize,
        /// Its reach \[m\].
        reach: f64,
    },
    /// As many reaches as particles are needed.
    #[error("{reaches} reaches for {particles} particles")]
    ReachCount {
        /// Number of reaches given.
        reaches: usize,
        /// Number of positions given.
        particles: usize,
    },
    /// Indices are 32 bits wide.
    #[error("{particles} particles; indices of 32 bits count to 4294967295")]
    TooManyParticles {
        /// Number of positions given.
        particles: usize,
    },
    /// A skin must be finite and not negative.
    #[error("the skin is {skin} m; it must be finite and not negative")]
    Skin {
        /// The skin given \[m\].
        skin: f64,
    },
    /// A cell size must be finite and positive.
    #[error("the cell size is {size} m; it must be finite and positive")]
    CellSize {
        /// The cell size given \[m\].
        size: f64,
    },
}

/// Refuses positions that no search can work with.
pub(crate) fn check_positions<const D: usize>(positions: &[SVector<f64, D>]) -> Result<(), Error> {
    if positions.len() > u32::MAX as usize {
        return Err(Error::TooManyParticles { particles: positions.len() });
    }
    // Written so that NaN fails too.
    let valid = |position: &SVector<f64, D>| position.iter().all(|x| x.abs() <= LARGEST);
    match positions.iter().position(|position| !valid(position)) {
        Some(index) => Err(Error::Position { index }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_positions_are_named() {
        for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e151] {
            let positions = [SVector::from([0.0, 1.0]), SVector::from([2.0, bad])];
            assert_eq!(check_positions(&positions), Err(Error::Position { index: 1 }));
        }
        assert_eq!(check_positions(&[SVector::from([1e150, -1e150])]), Ok(()));
    }

    #[test]
    fn messages_say_what_and_where() {
        let message = Error::Reach { index: 7, reach: -1.0 }.to_string();
        assert!(message.starts_with("the reach of particle 7 is -1 m"), "{message}");
    }
}
