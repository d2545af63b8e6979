//! Who needs a row.

/// How particles follow each other in the columns: owned ones, copies of them (images across a period or in a mirror), then
/// others, such as walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Particles whose rows are complete.
    pub owned: usize,
    /// Copies behind them: they stand in rows of others, and their own are empty.
    pub copies: usize,
}

/// What a particle is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    Owned,
    Copy,
    /// Its row holds owned particles and copies only.
    Other,
}

impl Parts {
    /// So many particles, all with complete rows.
    #[must_use]
    pub fn all(owned: usize) -> Self {
        Self { owned, copies: 0 }
    }

    #[inline]
    pub(crate) fn part_of(&self, particle: usize) -> Part {
        match particle {
            _ if particle < self.owned => Part::Owned,
            _ if particle < self.owned + self.copies => Part::Copy,
            _ => Part::Other,
        }
    }
}
