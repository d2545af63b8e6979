//! Points sorted into cubic blocks of cells.

use nalgebra::SVector;
use rayon::prelude::*;
use std::ops::Range;

/// Cells to a reach: finer ones test fewer pairs, coarser ones have longer runs.
const CELLS_PER_REACH: i64 = 2;

/// Cells along the edge of a block at most, which bounds the table of a block.
const MOST_CELLS_PER_EDGE: f64 = 32.0;

/// Cells along x whose points look for their pairs together, a home: long homes share the work of collecting candidates,
/// short ones have fewer of them.
const CELLS_PER_HOME: usize = 2;

/// Keeps points within reach within [`CELLS_PER_REACH`] cells against round-off: coordinates count to 2^31 at most.
const WIDENING: f64 = 1.0 + 1e-6;

/// How places become cells, and cells blocks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlockFrame<const D: usize> {
    low: SVector<f64, D>,
    inverse_cell: f64,
    /// Cells along the edge of a block; at least [`CELLS_PER_REACH`], so that a reach ends in the next block.
    edge: u64,
    cells_per_block: usize,
}

impl<const D: usize> BlockFrame<D> {
    /// Keys of cells fit into 64 bits.
    const LAST_CELL: u64 = (1 << (63 / D)) - 1;

    /// A frame with its corner at `low`, for pairs nearer than `reach` and blocks of about `block_edge` \[m\].
    pub fn new(low: SVector<f64, D>, reach: f64, block_edge: f64) -> Self {
        let cell = reach * WIDENING / CELLS_PER_REACH as f64;
        let edge = (block_edge / cell).round().clamp(CELLS_PER_REACH as f64, MOST_CELLS_PER_EDGE) as u64;
        Self { low, inverse_cell: 1.0 / cell, edge, cells_per_block: edge.pow(D as u32) as usize }
    }

    /// All cells of a block in runs of up to [`CELLS_PER_HOME`] along x, by ascending number.
    pub fn homes(&self) -> impl Iterator<Item = Range<usize>> {
        let edge = self.edge as usize;
        (0..self.cells_per_block).step_by(edge).flat_map(move |line| {
            let firsts = (line..line + edge).step_by(CELLS_PER_HOME);
            firsts.map(move |first| first..(first + CELLS_PER_HOME).min(line + edge))
        })
    }

    fn blocks_per_axis(&self) -> u64 {
        Self::LAST_CELL / self.edge + 1
    }

    /// Number of the block and of the cell within it; x runs fastest in both.
    ///
    /// Monotone in the place along each axis also where outliers share the last cell, so that no pair is missed.
    #[inline]
    fn key(&self, place: &SVector<f64, D>) -> u64 {
        let (mut block, mut local) = (0, 0);
        for axis in (0..D).rev() {
            let cell = ((place[axis] - self.low[axis]) * self.inverse_cell) as u64;
            let cell = cell.min(Self::LAST_CELL);
            block = block * self.blocks_per_axis() + cell / self.edge;
            local = local * self.edge + cell % self.edge;
        }
        block * self.cells_per_block as u64 + local
    }

    /// The number of the block that lies `step` blocks from another, if there can be one.
    fn neighbor(&self, number: u64, step: [i64; D]) -> Option<u64> {
        let (mut rest, mut stride, mut found) = (number, 1, 0);
        for axis in 0..D {
            let coordinate = (rest % self.blocks_per_axis()).checked_add_signed(step[axis])?;
            if coordinate >= self.blocks_per_axis() {
                return None;
            }
            found += coordinate * stride;
            rest /= self.blocks_per_axis();
            stride *= self.blocks_per_axis();
        }
        Some(found)
    }
}

/// Points sorted by block and by cell within the block. Memory grows with the points and the blocks that hold any.
#[derive(Clone, Debug)]
pub(crate) struct CellBlocks<const D: usize> {
    keyed: Vec<(u64, u32)>,
    points: Vec<SVector<f64, D>>,
    /// Numbers of the blocks that hold points, ascending.
    numbers: Vec<u64>,
    /// Where the cells of these blocks start, block after block; one entry more ends the last.
    cell_starts: Vec<u32>,
}

impl<const D: usize> Default for CellBlocks<D> {
    fn default() -> Self {
        Self { keyed: Vec::new(), points: Vec::new(), numbers: Vec::new(), cell_starts: vec![0] }
    }
}

impl<const D: usize> CellBlocks<D> {
    /// Sorts anew; points of one cell keep their order.
    pub fn sort(&mut self, frame: &BlockFrame<D>, positions: &[SVector<f64, D>]) {
        let keyed = positions.par_iter().enumerate().map(|(id, place)| (frame.key(place), id as u32));
        keyed.collect_into_vec(&mut self.keyed);
        self.keyed.par_sort_unstable();
        let sorted = self.keyed.par_iter().map(|&(_, id)| positions[id as usize]);
        sorted.collect_into_vec(&mut self.points);
        self.count_cells(frame.cells_per_block);
    }

    fn count_cells(&mut self, cells_per_block: usize) {
        self.numbers.clear();
        self.cell_starts.clear();
        self.cell_starts.push(0);
        for &(key, _) in &self.keyed {
            let number = key / cells_per_block as u64;
            if self.numbers.last() != Some(&number) {
                self.numbers.push(number);
                self.cell_starts.resize(self.numbers.len() * cells_per_block + 1, 0);
            }
            let first_cell = (self.numbers.len() - 1) * cells_per_block;
            self.cell_starts[first_cell + (key % cells_per_block as u64) as usize + 1] += 1;
        }
        for cell in 1..self.cell_starts.len() {
            self.cell_starts[cell] += self.cell_starts[cell - 1];
        }
    }

    /// Number of blocks that hold points.
    pub fn blocks(&self) -> usize {
        self.numbers.len()
    }

    /// The number that the frame gives to one of these blocks.
    pub fn number(&self, block: usize) -> u64 {
        self.numbers[block]
    }

    /// The first sorted point of a block.
    pub fn first(&self, block: usize) -> usize {
        let cells_per_block = (self.cell_starts.len() - 1) / self.numbers.len();
        self.cell_starts[block * cells_per_block] as usize
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Place before the sort of each sorted point.
    pub fn ids(&self) -> impl Iterator<Item = u32> {
        self.keyed.iter().map(|&(_, id)| id)
    }

    /// Place before the sort of one sorted point.
    #[inline]
    pub fn id(&self, point: u32) -> u32 {
        self.keyed[point as usize].1
    }

    /// A sorted point.
    #[inline]
    pub fn point(&self, point: u32) -> &SVector<f64, D> {
        &self.points[point as usize]
    }

    /// The sorted points of a run.
    #[inline]
    pub fn points(&self, run: Range<u32>) -> &[SVector<f64, D>] {
        &self.points[run.start as usize..run.end as usize]
    }

    /// The sorted points of some cells of a block.
    #[inline]
    pub fn cells(&self, frame: &BlockFrame<D>, block: usize, cells: &Range<usize>) -> Range<u32> {
        let offset = block * frame.cells_per_block;
        self.cell_starts[offset + cells.start]..self.cell_starts[offset + cells.end]
    }
}

/// A block and those around it, as one set of points sees them.
#[derive(Debug)]
pub(crate) struct Surroundings<'a, const D: usize> {
    frame: BlockFrame<D>,
    points: &'a CellBlocks<D>,
    /// The block at each step of -1, 0, 1 along each axis, x fastest; 2-D uses the first nine.
    blocks: [Option<usize>; 27],
}

impl<'a, const D: usize> Surroundings<'a, D> {
    /// What `points` have in and around the block with a number.
    pub fn of(frame: &BlockFrame<D>, points: &'a CellBlocks<D>, number: u64) -> Self {
        let blocks = std::array::from_fn(|slot| {
            let step = std::array::from_fn(|axis| (slot / 3_usize.pow(axis as u32) % 3) as i64 - 1);
            let neighbor = (slot < 3_usize.pow(D as u32)).then(|| frame.neighbor(number, step))??;
            points.numbers.binary_search(&neighbor).ok()
        });
        Self { frame: *frame, points, blocks }
    }

    /// Calls `visit` with each run of points in the cells that a reach from a home in the middle block may end in, and
    /// with whether it lies in the middle block. Runs of the middle block come in ascending order.
    pub fn runs(&self, home: &Range<usize>, mut visit: impl FnMut(bool, Range<u32>)) {
        let edge = self.frame.edge as i64;
        let cell = home.start as i64;
        let (x, y, z) = (cell % edge, cell / edge % edge, cell / (edge * edge));
        let flat = if D == 2 { 0 } else { CELLS_PER_REACH };
        for z in z - flat..=z + flat {
            let (layer, z) = self.wrapped(z);
            for y in y - CELLS_PER_REACH..=y + CELLS_PER_REACH {
                let (column, y) = self.wrapped(y);
                for step in 0..3 {
                    let shift = (step - 1) * edge;
                    let first = (x - CELLS_PER_REACH - shift).max(0);
                    let end = (x + home.len() as i64 + CELLS_PER_REACH - shift).min(edge);
                    let slot = step + 3 * column + if D == 2 { 0 } else { 9 * layer };
                    if let (true, Some(block)) = (first < end, self.blocks[slot as usize]) {
                        let line = (z * edge + y) * edge;
                        let cells = (line + first) as usize..(line + end) as usize;
                        visit(slot == Self::MIDDLE, self.points.cells(&self.frame, block, &cells));
                    }
                }
            }
        }
    }

    /// The slot of the middle block.
    const MIDDLE: i64 = if D == 2 { 4 } else { 13 };

    /// The block before, at or after the middle one (0, 1, 2) that a coordinate lies in, and the coordinate there.
    fn wrapped(&self, coordinate: i64) -> (i64, i64) {
        let edge = self.frame.edge as i64;
        match coordinate {
            _ if coordinate < 0 => (0, coordinate + edge),
            _ if coordinate >= edge => (2, coordinate - edge),
            _ => (1, coordinate),
        }
    }
}
