//! The moment system of the fit, stored for speed: eight rows to a chunk, as in the conduction matrix.
//!
//! With q = sqrt(w) p an entry (i, j) adds q (q . phi_i) to row i, which all goes into the row's own 4 x 4 block, and
//! q (q' . phi_j) with q' = (-x, -y, -z, r²) of the same q. So an entry is four numbers. Mirror images of the particle
//! itself are part of its block too; images of others, whose q' has other signs, are few and stand in a list of their own.

use super::super::matrix::LANES;
use super::Entry;
use nalgebra::{Matrix4, Vector4};

/// Four numbers for each of eight particles.
pub(super) type Four = [[f64; LANES]; 4];

/// The upper triangle of a symmetric 4 x 4 block for each of eight particles.
type Blocks = [[f64; LANES]; 10];

/// Where the entry (row, column) of a symmetric block stands.
const TRIANGLE: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 4, 5, 6], [2, 5, 7, 8], [3, 6, 8, 9]];

/// What of a chunk's rows is where.
#[derive(Clone, Copy)]
struct Chunk {
    slots: usize,
    images: usize,
    /// Whether all lanes of each slot read consecutive columns.
    contiguous: bool,
}

/// An image of another particle: lane of its row, q, q', and the particle.
struct ImageEntry {
    lane: usize,
    own: Vector4<f64>,
    other: Vector4<f64>,
    index: u32,
}

/// The system's matrix and its block-Jacobi preconditioner.
pub(super) struct MomentRows {
    /// One longer than there are chunks.
    chunks: Vec<Chunk>,
    slots: Vec<Four>,
    columns: Vec<[u32; LANES]>,
    images: Vec<ImageEntry>,
    diagonal: Vec<Blocks>,
    inverse: Vec<Blocks>,
}

impl MomentRows {
    /// The rows of `particles` particles in `dimensions` dimensions, from the entries of each.
    pub(super) fn new<'e>(particles: usize, dimensions: usize, row: impl Fn(usize) -> &'e [Entry]) -> Self {
        let chunks = particles.div_ceil(LANES);
        let mut rows = Self {
            chunks: Vec::with_capacity(chunks + 1),
            slots: Vec::new(),
            columns: Vec::new(),
            images: Vec::new(),
            diagonal: vec![[[0.0; LANES]; 10]; chunks],
            inverse: vec![[[0.0; LANES]; 10]; chunks],
        };
        let mut shifts = Vec::new();
        for first in (0..particles).step_by(LANES) {
            rows.push_chunk(first..(first + LANES).min(particles), &row, &mut shifts);
            for i in first..(first + LANES).min(particles) {
                rows.set_blocks(i, dimensions, row(i));
            }
        }
        rows.close_chunk(false);
        rows
    }

    /// Number of chunks.
    pub(super) fn chunks(&self) -> usize {
        self.diagonal.len()
    }

    /// Rows of one chunk times `phi`, four columns one after the other.
    pub(super) fn apply(&self, chunk: usize, phi: &[f64]) -> Four {
        let padded = self.chunks() * LANES;
        let columns: [&[f64]; 4] = std::array::from_fn(|part| &phi[part * padded..(part + 1) * padded]);
        let own = columns.map(|column| load(column, chunk * LANES));
        let mut sum = times(&self.diagonal[chunk], &own);
        let [Chunk { slots, images, contiguous }, end] = [self.chunks[chunk], self.chunks[chunk + 1]];
        for (q, column) in self.slots[slots..end.slots].iter().zip(&self.columns[slots..end.slots]) {
            let other = if contiguous {
                columns.map(|values| load(values, column[0] as usize))
            } else {
                columns.map(|values| column.map(|index| values[index as usize]))
            };
            for lane in 0..LANES {
                let met = q[3][lane] * other[3][lane]
                    - (q[0][lane] * other[0][lane] + q[1][lane] * other[1][lane] + q[2][lane] * other[2][lane]);
                for part in 0..4 {
                    sum[part][lane] += q[part][lane] * met;
                }
            }
        }
        for image in &self.images[images..end.images] {
            let met: f64 = (0..4).map(|part| image.other[part] * columns[part][image.index as usize]).sum();
            (0..4).for_each(|part| sum[part][image.lane] += image.own[part] * met);
        }
        sum
    }

    /// The preconditioner on one chunk.
    pub(super) fn precondition(&self, chunk: usize, residual: &Four) -> Four {
        times(&self.inverse[chunk], residual)
    }

    fn close_chunk(&mut self, contiguous: bool) {
        self.chunks.push(Chunk { slots: self.slots.len(), images: self.images.len(), contiguous });
    }

    /// Stores the entries of some consecutive rows: a slot for each shift j - i where that is not many more than the
    /// longest row, else slot after slot with a column a lane.
    fn push_chunk<'e>(
        &mut self,
        range: std::ops::Range<usize>,
        row: &impl Fn(usize) -> &'e [Entry],
        shifts: &mut Vec<i64>,
    ) {
        let shift = |i: usize, entry: &Entry| i64::from(entry.index) - i as i64;
        let direct = |i: usize| row(i).iter().filter(|entry| !entry.image);
        shifts.clear();
        shifts.extend(range.clone().flat_map(|i| direct(i).map(move |entry| shift(i, entry))));
        shifts.sort_unstable();
        shifts.dedup();
        let longest = range.clone().map(|i| direct(i).count()).max().unwrap_or(0);
        let (first, start) = (range.start as i64, self.slots.len());
        let last_start = (self.chunks() * LANES - LANES) as i64;
        let inside = shifts.iter().all(|shift| (0..=last_start).contains(&(first + shift)));
        let contiguous = inside && 2 * shifts.len() <= 3 * longest;
        self.close_chunk(contiguous);
        let slots = if contiguous { shifts.len() } else { longest };
        self.slots.resize(start + slots, [[0.0; LANES]; 4]);
        self.columns.resize(start + slots, [range.start as u32; LANES]);
        for i in range.clone() {
            for (place, entry) in direct(i).enumerate() {
                let place = if contiguous { shifts.partition_point(|&s| s < shift(i, entry)) } else { place };
                self.set_slot(start + place, i - range.start, entry);
            }
            self.push_images(i, range.start, row(i));
        }
        if contiguous {
            for (columns, shift) in self.columns[start..].iter_mut().zip(shifts.iter()) {
                columns[0] = (first + shift) as u32;
            }
        }
    }

    fn set_slot(&mut self, slot: usize, lane: usize, entry: &Entry) {
        let root = entry.weight.sqrt();
        (0..4).for_each(|part| self.slots[slot][part][lane] = root * entry.own[part]);
        self.columns[slot][lane] = entry.index;
    }

    fn push_images(&mut self, i: usize, first: usize, row: &[Entry]) {
        let others = row.iter().filter(|entry| entry.image && !entry.is_own_image(i));
        self.images.extend(others.map(|entry| ImageEntry {
            lane: i - first,
            own: entry.weight * entry.own,
            other: entry.other,
            index: entry.index,
        }));
    }

    /// The row's own block with its own images, and the inverse of the part that does not depend on images' signs.
    fn set_blocks(&mut self, i: usize, dimensions: usize, row: &[Entry]) {
        let mut own = Matrix4::zeros();
        let mut folded = Matrix4::zeros();
        for entry in row {
            own += entry.weight * entry.own * entry.own.transpose();
            if entry.is_own_image(i) {
                folded += entry.weight * entry.own * entry.other.transpose();
            }
        }
        let mut guarded = own;
        (dimensions..3).for_each(|unused| guarded[(unused, unused)] = 1.0);
        let inverse = guarded.try_inverse().unwrap_or_else(Matrix4::identity);
        let (chunk, lane) = (i / LANES, i % LANES);
        for (row, column) in (0..4).flat_map(|row| (row..4).map(move |column| (row, column))) {
            let place = TRIANGLE[row][column];
            self.diagonal[chunk][place][lane] = own[(row, column)] + folded[(row, column)];
            self.inverse[chunk][place][lane] = inverse[(row, column)];
        }
    }
}

#[inline]
fn load(column: &[f64], start: usize) -> [f64; LANES] {
    column[start..start + LANES].try_into().expect("a slice of LANES entries")
}

/// Symmetric blocks times vectors.
#[inline]
fn times(blocks: &Blocks, vectors: &Four) -> Four {
    let mut product = [[0.0; LANES]; 4];
    for row in 0..4 {
        for column in 0..4 {
            for lane in 0..LANES {
                product[row][lane] += blocks[TRIANGLE[row][column]][lane] * vectors[column][lane];
            }
        }
    }
    product
}
