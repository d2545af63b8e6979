//! The neighbour list.

/// The neighbours of every particle: compressed rows, each sorted ascending and without the particle itself.
///
/// The list is full: a pair (i, j) stands in row i and in row j.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NeighborList {
    starts: Vec<usize>,
    indices: Vec<u32>,
}

impl Default for NeighborList {
    fn default() -> Self {
        Self { starts: vec![0], indices: Vec::new() }
    }
}

impl NeighborList {
    /// `starts` has one entry more than there are rows, rises from 0 to the number of `indices`.
    pub(crate) fn new(starts: Vec<usize>, indices: Vec<u32>) -> Self {
        debug_assert_eq!(starts.last(), Some(&indices.len()));
        Self { starts, indices }
    }

    /// The neighbours of particle `index`, ascending.
    ///
    /// # Panics
    /// If there is no such particle.
    #[inline]
    pub fn row(&self, index: usize) -> &[u32] {
        &self.indices[self.starts[index]..self.starts[index + 1]]
    }

    /// Number of particles.
    #[inline]
    pub fn particles(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of directed pairs, the sum of the lengths of all rows: twice the number of unordered pairs.
    #[inline]
    pub fn pairs(&self) -> usize {
        self.indices.len()
    }

    /// Length of the longest row, for buffers that shall not grow.
    pub fn longest_row(&self) -> usize {
        self.starts.windows(2).map(|bounds| bounds[1] - bounds[0]).max().unwrap_or(0)
    }

    /// Where each row starts in [`indices`](Self::indices); one entry more than there are particles.
    #[inline]
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }

    /// All rows one after the other.
    #[inline]
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_pairs_and_the_longest() {
        let list = NeighborList::new(vec![0, 2, 3, 3, 4], vec![1, 3, 0, 0]);
        assert_eq!((list.particles(), list.pairs(), list.longest_row()), (4, 4, 2));
        assert_eq!((list.row(0), list.row(2), list.row(3)), (&[1, 3][..], &[][..], &[0][..]));
    }

    #[test]
    fn the_default_has_no_particles() {
        let list = NeighborList::default();
        assert_eq!((list.particles(), list.pairs(), list.longest_row()), (0, 0, 0));
    }
}
