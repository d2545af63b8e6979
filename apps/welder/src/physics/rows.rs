//! The fused sweep: each particle's row is built once, and every term is called once per row, never once per pair.
//!
//! Columns hold owned particles first and copies (mirror images, later those of other ranks) after them: a row reads
//! copies and writes only its own particle. Sums over a row run in the order of the list, rows are handed out in fixed
//! blocks, so results are the same bits for any number of threads.

use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::{KernelKind, Row, RowBuffer};
use sph_neighbors::NeighborList;

/// Rows to a block.
const BLOCK: usize = 512;

/// What a physics contributes to the rows of a sweep.
pub trait RowTerm<const D: usize>: Sync {
    /// Numbers that it writes for each particle.
    fn width(&self) -> usize;

    /// Writes what the particle of `row` receives into `out`, [`width`](Self::width) long.
    fn row(&self, row: &Row<'_, D>, out: &mut [f64]);
}

/// Particles, copies and who is near whom.
pub struct Sweep<const D: usize> {
    /// Particles that have rows.
    pub owned: usize,
    /// Positions of particles, then of copies \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Smoothing lengths in the same order \[m\]; a pair takes the mean of its two.
    pub smoothing_lengths: Vec<f64>,
    /// Neighbours among particles and copies.
    pub list: NeighborList,
    /// The kernel of all rows.
    pub kernel: KernelKind,
}

impl<const D: usize> Sweep<D> {
    /// Calls every term for every row. `out` holds the terms' numbers side by side, particle after particle: for each
    /// particle first those of the first term, then those of the next.
    ///
    /// # Panics
    /// If `out` is not as long as the owned particles times the widths of all terms.
    pub fn run(&self, terms: &[&dyn RowTerm<D>], out: &mut [f64]) {
        let stride: usize = terms.iter().map(|term| term.width()).sum();
        assert_eq!(out.len(), self.owned * stride, "out needs the widths of all terms for each particle");
        out.par_chunks_mut(BLOCK * stride).enumerate().for_each_init(
            RowBuffer::default,
            |buffer, (block, out)| {
                for (at, out) in out.chunks_exact_mut(stride).enumerate() {
                    let i = block * BLOCK + at;
                    let lengths = &self.smoothing_lengths;
                    let row = buffer.fill_with_mean_lengths(
                        i,
                        self.list.row(i),
                        &self.positions,
                        lengths,
                        self.kernel,
                    );
                    let mut rest = out;
                    for term in terms {
                        let (own, others) = rest.split_at_mut(term.width());
                        term.row(&row, own);
                        rest = others;
                    }
                }
            },
        );
    }

    /// Directed pairs that one run visits.
    pub fn pairs(&self) -> usize {
        (0..self.owned).map(|i| self.list.row(i).len()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;
    use sph_neighbors::{PairReach, SearchMethod};

    /// Number of neighbours, and sum of their distances.
    struct Count;
    struct Distances;

    impl RowTerm<2> for Count {
        fn width(&self) -> usize {
            1
        }
        fn row(&self, row: &Row<'_, 2>, out: &mut [f64]) {
            out[0] = row.len() as f64;
        }
    }

    impl RowTerm<2> for Distances {
        fn width(&self) -> usize {
            2
        }
        fn row(&self, row: &Row<'_, 2>, out: &mut [f64]) {
            out[0] = row.distances.iter().sum();
            out[1] = row.index as f64;
        }
    }

    #[test]
    fn terms_share_rows_and_write_side_by_side() {
        let positions: Vec<_> =
            (0..40 * 40).map(|n| Vector2::new((n % 40) as f64, (n / 40) as f64)).collect();
        let list = SearchMethod::default().find(&positions, PairReach::Uniform(1.2)).unwrap();
        let smoothing_lengths = vec![0.6; positions.len()];
        let owned = 1500;
        let sweep = Sweep { owned, positions, smoothing_lengths, list, kernel: KernelKind::WendlandC2 };
        let mut out = vec![f64::NAN; 3 * owned];
        sweep.run(&[&Count, &Distances], &mut out);
        for i in 0..owned {
            let [x, y] = [i % 40, i / 40];
            let expected = [x > 0, x < 39, y > 0, y < 39].iter().filter(|inside| **inside).count() as f64;
            assert_eq!(out[3 * i..3 * i + 3], [expected, expected, i as f64]);
        }
        assert_eq!(sweep.pairs(), out.chunks(3).map(|c| c[0] as usize).sum::<usize>());
    }
}
