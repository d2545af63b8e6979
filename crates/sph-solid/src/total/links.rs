//! The pairs of a body at rest, in a form that is walked twice a step.
//!
//! A pair (i, j) keeps V_i V_j grad0_i W and V_i V_j |f| (f = W'/r), so that no kernel, distance or volume is touched
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
    starts: Vec<usize>,
    splits: Vec<usize>,
    others: Vec<u32>,
    /// V_i V_j grad0_i W \[m^(D-1)\] and, as the fourth lane, V_i V_j |f| \[m^(D-2)\].
    weights: Vec<Lanes>,
}

impl Links {
    pub fn with_capacity(particles: usize) -> Self {
        let mut starts = Vec::with_capacity(particles + 1);
        starts.push(0);
        Self { starts, splits: Vec::with_capacity(particles), others: Vec::new(), weights: Vec::new() }
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

    /// sum_j V_i V_j (u_j - u_i) (x) grad0_i W \[m^D\] of the particles from `first` on, one block of them.
    pub fn gradient_sums<const D: usize>(&self, first: usize, moved: &[Lanes], sums: &mut [Columns<D>]) {
        sums.fill([Lanes::default(); D]);
        for local in 0..sums.len() {
            let i = first + local;
            let here = moved[i];
            let mut own = sums[local];
            for e in self.starts[i]..self.splits[i] {
                let (j, weight) = (self.others[e] as usize, self.weights[e]);
                let change = moved[j] - here;
                let other = &mut sums[j - first];
                for axis in 0..D {
                    let product = change * weight.0[axis];
                    own[axis] += product;
                    other[axis] += product;
                }
            }
            for e in self.splits[i]..self.starts[i + 1] {
                let (j, weight) = (self.others[e] as usize, self.weights[e]);
                let change = moved[j] - here;
                for axis in 0..D {
                    own[axis] = change.times_plus(weight.0[axis], own[axis]);
                }
            }
            sums[local] = own;
        }
    }

    /// Adds to `forces`, one block of them from `first` on, what `force(i, j, weight)` gives i; j gets the opposite.
    #[inline]
    pub fn add_forces(
        &self,
        first: usize,
        forces: &mut [Lanes],
        force: impl Fn(usize, usize, Lanes) -> Lanes,
    ) {
        for local in 0..forces.len() {
            let i = first + local;
            let mut own = forces[local];
            for e in self.starts[i]..self.splits[i] {
                let j = self.others[e] as usize;
                let pair = force(i, j, self.weights[e]);
                own += pair;
                forces[j - first] -= pair;
            }
            for e in self.splits[i]..self.starts[i + 1] {
                own += force(i, self.others[e] as usize, self.weights[e]);
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
