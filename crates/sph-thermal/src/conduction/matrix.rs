//! The rows of particles at rest, stored for speed.
//!
//! Eight consecutive rows form a chunk. Particles on a lattice that are sorted along x see the same pattern of
//! neighbours: then a chunk stores one shift a neighbour instead of eight indices, its potentials are read as one
//! contiguous run, and the compiler makes plain vector code of it. Chunks without such a pattern (jumps of spacing,
//! disorder) store indices. Sums run in a fixed order, so results do not depend on the number of threads.

use super::ConductionRows;

/// Rows to a chunk.
pub const LANES: usize = 8;

/// A pattern may cost this much more slots than the longest row of its chunk before indices are cheaper.
const PATTERN_OVERHEAD: f64 = 1.6;

#[derive(Debug, Clone, Copy, PartialEq)]
struct Chunk {
    /// First slot in `weights`.
    slots: usize,
    /// First entry in `shifts` (pattern) or in `columns` (indices).
    places: usize,
    length: usize,
    /// Slots that there is room for.
    room: usize,
    /// Pairs of its rows.
    pairs: usize,
    pattern: bool,
}

/// Room over need where a chunk outgrows its place (see [`ConductionMatrix::replace_chunk`]).
const ROOM: f64 = 1.25;

/// Conduction rows in chunks of [`LANES`]; see the module.
#[derive(Debug, Clone, PartialEq)]
pub struct ConductionMatrix {
    particles: usize,
    chunks: Vec<Chunk>,
    weights: Vec<[f64; LANES]>,
    shifts: Vec<i32>,
    columns: Vec<[u32; LANES]>,
    pairs: usize,
}

impl ConductionMatrix {
    /// Stores `rows`.
    pub fn new(rows: &ConductionRows) -> Self {
        let particles = rows.particles();
        let mut matrix = Self {
            particles,
            chunks: Vec::with_capacity(particles.div_ceil(LANES)),
            weights: Vec::new(),
            shifts: Vec::new(),
            columns: Vec::new(),
            pairs: rows.pairs(),
        };
        let mut pattern = Vec::new();
        for first in (0..particles).step_by(LANES) {
            matrix.push_chunk(rows, first, &mut pattern);
        }
        matrix
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.particles
    }

    /// Length that a column of potentials must have: the particles, rounded up to whole chunks.
    pub fn padded_len(&self) -> usize {
        self.chunks.len() * LANES
    }

    /// Directed pairs that one product visits.
    pub fn pairs(&self) -> usize {
        self.pairs
    }

    /// Number of chunks.
    pub fn chunks(&self) -> usize {
        self.chunks.len()
    }

    /// Share of chunks that are stored as a pattern.
    pub fn pattern_share(&self) -> f64 {
        let patterns = self.chunks.iter().filter(|chunk| chunk.pattern).count();
        patterns as f64 / self.chunks.len().max(1) as f64
    }

    /// Heat \[W\] that the rows of one chunk receive at potentials `theta` (\[W/m\], [`padded_len`](Self::padded_len) long).
    #[inline]
    pub fn chunk_heat(&self, chunk: usize, theta: &[f64]) -> [f64; LANES] {
        let own: &[f64; LANES] = lanes(theta, chunk * LANES);
        let Chunk { slots, places, length, pattern, .. } = self.chunks[chunk];
        let weights = &self.weights[slots..slots + length];
        let mut sum = [0.0; LANES];
        if pattern {
            let base = (chunk * LANES) as i32;
            for (weight, shift) in weights.iter().zip(&self.shifts[places..places + length]) {
                let other: &[f64; LANES] = lanes(theta, (base + shift) as usize);
                for lane in 0..LANES {
                    sum[lane] += weight[lane] * (other[lane] - own[lane]);
                }
            }
        } else {
            for (weight, column) in weights.iter().zip(&self.columns[places..places + length]) {
                for lane in 0..LANES {
                    sum[lane] += weight[lane] * (theta[column[lane] as usize] - own[lane]);
                }
            }
        }
        sum
    }

    /// Heat \[W\] that the rows of one chunk receive by any pair law `exchange(weight, own, other)` over particle indices:
    /// the general form, for laws that are not linear in one potential.
    pub fn chunk_heat_by(&self, chunk: usize, exchange: impl Fn(f64, usize, usize) -> f64) -> [f64; LANES] {
        let Chunk { slots, places, length, pattern, .. } = self.chunks[chunk];
        let mut sum = [0.0; LANES];
        for slot in 0..length {
            for lane in 0..LANES {
                let (own, weight) = (chunk * LANES + lane, self.weights[slots + slot][lane]);
                if weight != 0.0 {
                    let other = if pattern {
                        (own as i64 + i64::from(self.shifts[places + slot])) as usize
                    } else {
                        self.columns[places + slot][lane] as usize
                    };
                    sum[lane] += exchange(weight, own, other);
                }
            }
        }
        sum
    }

    fn push_chunk(&mut self, rows: &ConductionRows, first: usize, pattern: &mut Vec<i32>) {
        let last = (first + LANES).min(self.particles);
        let (longest, pairs) = row_lengths(rows, first..last);
        collect_pattern(rows, first..last, pattern);
        let padded = self.particles.div_ceil(LANES) * LANES;
        let inside = pattern.iter().all(|&shift| {
            let start = first as i64 + i64::from(shift);
            start >= 0 && start as usize + LANES <= padded
        });
        let slots = self.weights.len();
        if inside && pattern.len() as f64 <= PATTERN_OVERHEAD * longest as f64 {
            let places = self.shifts.len();
            self.shifts.extend_from_slice(pattern);
            self.weights.resize(slots + pattern.len(), [0.0; LANES]);
            for i in first..last {
                let (neighbors, weights) = rows.row(i);
                for (&j, &weight) in neighbors.iter().zip(weights) {
                    let slot =
                        pattern.binary_search(&(j as i32 - i as i32)).expect("every shift is in the pattern");
                    self.weights[slots + slot][i - first] = weight;
                }
            }
            let (length, room) = (pattern.len(), pattern.len());
            self.chunks.push(Chunk { slots, places, length, room, pairs, pattern: true });
        } else {
            let place = self.new_place(longest);
            self.chunks.push(Chunk { length: longest, pairs, ..place });
            self.fill_chunk(rows, first / LANES);
        }
    }

    /// An empty place for a chunk of indices, behind all others.
    fn new_place(&mut self, room: usize) -> Chunk {
        let (slots, places) = (self.weights.len(), self.columns.len());
        self.weights.resize(slots + room, [0.0; LANES]);
        self.columns.resize(places + room, [0; LANES]);
        Chunk { slots, places, length: 0, room, pairs: 0, pattern: false }
    }

    /// Writes rows into a chunk of indices that has the length for them; what a shorter row leaves over points to itself.
    fn fill_chunk(&mut self, rows: &ConductionRows, chunk: usize) {
        let Chunk { slots, places, length, .. } = self.chunks[chunk];
        let first = chunk * LANES;
        self.weights[slots..slots + length].fill([0.0; LANES]);
        self.columns[places..places + length].fill([first as u32; LANES]);
        for i in first..(first + LANES).min(self.particles) {
            let (neighbors, weights) = rows.row(i);
            for (slot, (&j, &weight)) in neighbors.iter().zip(weights).enumerate() {
                self.weights[slots + slot][i - first] = weight;
                self.columns[places + slot][i - first] = j;
            }
        }
    }

    /// Stores the rows of one chunk anew, by their indices, after [`ConductionRows::replace_row`] has changed them.
    pub fn replace_chunk(&mut self, rows: &ConductionRows, chunk: usize) {
        let first = chunk * LANES;
        let (longest, pairs) = row_lengths(rows, first..(first + LANES).min(self.particles));
        let mut place = self.chunks[chunk];
        self.pairs = self.pairs - place.pairs + pairs;
        if place.pattern || longest > place.room {
            place = self.new_place((ROOM * longest as f64).ceil() as usize);
        }
        self.chunks[chunk] = Chunk { length: longest, pairs, ..place };
        self.fill_chunk(rows, chunk);
    }
}

#[inline]
fn lanes(column: &[f64], start: usize) -> &[f64; LANES] {
    column[start..start + LANES].try_into().expect("a slice of LANES entries")
}

/// The longest of some rows, and the pairs of all.
fn row_lengths(rows: &ConductionRows, range: std::ops::Range<usize>) -> (usize, usize) {
    let lengths = range.map(|i| rows.row(i).0.len());
    lengths.fold((0, 0), |(longest, pairs), length| (longest.max(length), pairs + length))
}

/// All distinct j - i of some rows, rising.
fn collect_pattern(rows: &ConductionRows, range: std::ops::Range<usize>, pattern: &mut Vec<i32>) {
    pattern.clear();
    for i in range {
        pattern.extend(rows.row(i).0.iter().map(|&j| j as i32 - i as i32));
    }
    pattern.sort_unstable();
    pattern.dedup();
}
