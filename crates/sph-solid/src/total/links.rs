//! The pairs of a body, in a form that is walked twice a step; of a body at rest, or of one block of a body that moves.
//!
//! A pair (i, j) keeps V_i V_j grad_i W and V_i V_j |f| (f = W'/r), so that no kernel, distance or volume is touched
//! later. Particles stand in blocks of consecutive indices. A pair inside a block is kept once, in the row of its lower
//! index, and serves both; a pair across blocks is kept in both rows. So each block writes to its own particles only, and
//! sums run in an order that does not depend on the number of threads. Sort particles in space, or most pairs cross.

use super::lanes::{Columns, Lanes};
use sph_kernel::Row;

/// Particles in a block: what two passes touch of a block in 3-D (about 0.3 MB) stays in the second-level cache.
pub(crate) const BLOCK: usize = 2048;

/// All pairs, row by row: first those inside the block, then those across.
#[derive(Clone, Debug)]
pub(crate) struct Links {
    /// The particle of the first row.
    first: usize,
    starts: Vec<usize>,
    splits: Vec<usize>,
    others: Vec<u32>,
    /// V_i V_j grad_i W \[m^(D-1)\] and, as the fourth lane, V_i V_j |f| \[m^(D-2)\].
    weights: Vec<Lanes>,
}

impl Links {
    /// For rows from particle `first` on, of which `particles` are expected.
    pub fn new(first: usize, particles: usize) -> Self {
        let mut starts = Vec::with_capacity(particles + 1);
        starts.push(0);
        Self { first, starts, splits: Vec::with_capacity(particles), others: Vec::new(), weights: Vec::new() }
    }

    /// Appends the row of the next particle.
    pub fn push<const D: usize>(&mut self, row: &Row<'_, D>, volumes: &[f64]) {
        let block = row.index / BLOCK;
        let inside = |j: usize| j / BLOCK == block;
        self.append(row, volumes, |j| inside(j) && j > row.index);
        self.splits.push(self.others.len());
        self.append(row, volumes, |j| !inside(j));
        self.starts.push(self.others.len());
    }

    fn append<const D: usize>(&mut self, row: &Row<'_, D>, volumes: &[f64], kept: impl Fn(usize) -> bool) {
        for (k, &other) in row.neighbors.iter().enumerate() {
            if kept(other as usize) {
                let product = volumes[row.index] * volumes[other as usize];
                let stiffness = -product * row.gradient_factors[k];
                self.others.push(other);
                self.weights.push(Lanes::new(&(row.gradient(k) * product), stiffness));
            }
        }
    }

    /// Number of stored pairs.
    pub fn len(&self) -> usize {
        self.others.len()
    }

    /// sum_j V_i V_j (u_j - u_i) (x) grad_i W \[m^D\] of the particles from `first` on, one block of them.
    pub fn gradient_sums<const D: usize>(&self, first: usize, moved: &[Lanes], sums: &mut [Columns<D>]) {
        sums.fill([Lanes::default(); D]);
        for i in first..first + sums.len() {
            self.add_gradients(i, first, moved, sums);
        }
    }

    /// Adds what the row of particle `i` gives to the sums of its block, which begins with particle `first`.
    #[inline]
    pub fn add_gradients<const D: usize>(
        &self,
        i: usize,
        first: usize,
        moved: &[Lanes],
        sums: &mut [Columns<D>],
    ) {
        let row = i - self.first;
        let here = moved[i];
        let mut own = sums[i - first];
        for e in self.starts[row]..self.splits[row] {
            let (j, weight) = (self.others[e] as usize, self.weights[e]);
            let change = moved[j] - here;
            let other = &mut sums[j - first];
            for axis in 0..D {
                let product = change * weight.0[axis];
                own[axis] += product;
                other[axis] += product;
            }
        }
        for e in self.splits[row]..self.starts[row + 1] {
            let (j, weight) = (self.others[e] as usize, self.weights[e]);
            let change = moved[j] - here;
            for axis in 0..D {
                own[axis] = change.times_plus(weight.0[axis], own[axis]);
            }
        }
        sums[i - first] = own;
    }

    /// Adds to `forces`, one block of them from `first` on, what `force(i)(j, weight)` gives i; j gets the opposite.
    #[inline]
    pub fn add_forces<F: Fn(usize, Lanes) -> Lanes>(
        &self,
        first: usize,
        forces: &mut [Lanes],
        force: impl Fn(usize) -> F,
    ) {
        for local in 0..forces.len() {
            let (i, row) = (first + local, first + local - self.first);
            let force = force(i);
            let mut own = forces[local];
            // One loop over both kinds of pairs: a force that is called in one place only is compiled into it.
            for e in self.starts[row]..self.starts[row + 1] {
                let j = self.others[e] as usize;
                let pair = force(j, self.weights[e]);
                own += pair;
                if e < self.splits[row] {
                    forces[j - first] -= pair;
                }
            }
            forces[local] = own;
        }
    }

    /// Calls `visit(i, j, weight)` once for every pair that `i` keeps; pairs across blocks come twice, with both orders.
    pub fn for_each(&self, mut visit: impl FnMut(usize, usize, Lanes, bool)) {
        for i in 0..self.splits.len() {
            for e in self.starts[i]..self.starts[i + 1] {
                visit(i, self.others[e] as usize, self.weights[e], e < self.splits[i]);
            }
        }
    }
}
