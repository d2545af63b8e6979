//! What the laws of a row read.

use nalgebra::SVector;
use sph_kernel::Row;

/// Columns of all particles that the laws of a row read, borrowed from whoever owns them.
#[derive(Clone, Copy, Debug)]
pub struct Fields<'a, const D: usize> {
    /// Masses m \[kg; kg/m in 2-D\].
    pub masses: &'a [f64],
    /// Densities rho \[kg/m^3\].
    pub densities: &'a [f64],
    /// Volumes V = m/rho \[m^D\].
    pub volumes: &'a [f64],
    /// Pressures p \[Pa\].
    pub pressures: &'a [f64],
    /// Velocities v \[m/s\].
    pub velocities: &'a [SVector<f64, D>],
}

/// The part of a row whose neighbours have an index below `count`: with fluid stored first, its fluid neighbours.
///
/// The row's neighbours must be ascending, as in every list of sph-neighbors.
#[inline]
#[must_use]
pub fn leading_part<'a, const D: usize>(row: &Row<'a, D>, count: usize) -> Row<'a, D> {
    let end = row.neighbors.partition_point(|&neighbor| (neighbor as usize) < count);
    Row {
        index: row.index,
        neighbors: &row.neighbors[..end],
        separations: &row.separations[..end],
        distances: &row.distances[..end],
        values: &row.values[..end],
        gradient_factors: &row.gradient_factors[..end],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;

    #[test]
    fn the_leading_part_holds_all_neighbours_below_the_count_and_no_other() {
        let block = Block::<2>::new(6, 0.2);
        block.for_each_row(|row| {
            let part = leading_part(row, 17);
            let expected: Vec<u32> = row.neighbors.iter().copied().filter(|&j| j < 17).collect();
            assert_eq!(part.neighbors, expected);
            assert_eq!((part.index, part.values.len()), (row.index, expected.len()));
            assert_eq!(part.separations, &row.separations[..expected.len()]);
            assert_eq!(part.gradient_factors, &row.gradient_factors[..expected.len()]);
            assert_eq!(leading_part(row, 36).len(), row.len());
        });
    }
}
