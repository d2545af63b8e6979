//! The pairs of a body, in a form that is walked twice a step; of a body at rest, or of one block of a body that moves.
//!
//! A pair (i, j) keeps V_i V_j grad_i W and V_i V_j |f| (f = W'/r), so that no kernel, distance or volume is touched
//! later. Particles stand in blocks of consecutive indices. A pair inside a block is kept once, in the row of its lower
//! index, and serves both; a pair across blocks is kept in both rows. So each block writes to its own particles only, and
//! sums run in an order that does not depend on the number of threads. Sort particles in space, or most pairs cross.

use super::lanes::{Columns, Lanes};
use sph_kernel::{Row, ScaledKernel};

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

/// What [`Links::push_listed`] works in.
#[derive(Clone, Debug, Default)]
pub(crate) struct ListBuffer {
    inside: Vec<u32>,
    across: Vec<u32>,
    distances: Vec<f64>,
    values: Vec<f64>,
    factors: Vec<f64>,
}

impl Links {
    /// For rows from particle `first` on, of which `particles` are expected.
    pub fn new(first: usize, particles: usize) -> Self {
        let mut starts = Vec::with_capacity(particles + 1);
        starts.push(0);
        Self { first, starts, splits: Vec::with_capacity(particles), others: Vec::new(), weights: Vec::new() }
    }

    /// Forgets all rows, but keeps the memory.
    pub fn clear(&mut self) {
        self.starts.truncate(1);
        self.splits.clear();
        self.others.clear();
        self.weights.clear();
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

    /// Appends the row of the next particle from its list, which may have a skin; `places` are present positions \[m\] with
    /// volumes \[m^D\] beside.
    pub fn push_listed<const D: usize>(
        &mut self,
        list: &[u32],
        places: &[Lanes],
        kernel: &ScaledKernel<D>,
        buffer: &mut ListBuffer,
    ) {
        let index = self.first + self.splits.len();
        let block = index / BLOCK;
        let ListBuffer { inside, across, distances, .. } = buffer;
        inside.resize(list.len().max(inside.len()), 0);
        across.resize(list.len().max(across.len()), 0);
        // Sorted by index before any distance is taken: half of the list is another row's work. Written always and kept
        // only if wanted, here and below: no branch to mispredict.
        let (mut later, mut others) = (0, 0);
        for &j in list {
            let here = j as usize / BLOCK == block;
            inside[later] = j;
            later += usize::from(here && j as usize > index);
            across[others] = j;
            others += usize::from(!here);
        }
        let start = self.others.len();
        distances.clear();
        let limit = kernel.support_radius();
        self.append_near(index, &inside[..later], places, limit, distances);
        self.splits.push(self.others.len());
        self.append_near(index, &across[..others], places, limit, distances);
        self.starts.push(self.others.len());
        self.weigh(start, places[index].scalar(), kernel, buffer);
    }

    /// Appends those of the candidates that are nearer than `limit` \[m\]: separations with minus the volume of j beside,
    /// not yet weights.
    #[inline]
    fn append_near(
        &mut self,
        index: usize,
        candidates: &[u32],
        places: &[Lanes],
        limit: f64,
        distances: &mut Vec<f64>,
    ) {
        let (start, nearer) = (self.others.len(), distances.len());
        self.others.resize(start + candidates.len(), 0);
        self.weights.resize(start + candidates.len(), Lanes::default());
        distances.resize(nearer + candidates.len(), 0.0);
        let (others, weights) = (&mut self.others[start..], &mut self.weights[start..]);
        let mut here = places[index];
        here.0[3] = 0.0;
        let mut count = 0;
        for &j in candidates {
            let apart = here - places[j as usize];
            let [x, y, z, _] = apart.0;
            let distance_squared = x * x + y * y + z * z;
            others[count] = j;
            weights[count] = apart;
            distances[nearer + count] = distance_squared;
            count += usize::from(distance_squared < limit * limit);
        }
        self.others.truncate(start + count);
        self.weights.truncate(start + count);
        distances.truncate(nearer + count);
    }

    /// Makes weights of the separations from `start` on, for a row with this volume.
    #[inline]
    fn weigh<const D: usize>(
        &mut self,
        start: usize,
        volume: f64,
        kernel: &ScaledKernel<D>,
        buffer: &mut ListBuffer,
    ) {
        let ListBuffer { distances, values, factors, .. } = buffer;
        distances.iter_mut().for_each(|distance| *distance = distance.sqrt());
        values.resize(distances.len(), 0.0);
        factors.resize(distances.len(), 0.0);
        kernel.evaluate_slice(distances, values, factors);
        for (weight, factor) in self.weights[start..].iter_mut().zip(factors) {
            let stiffness = weight.scalar() * (volume * *factor);
            *weight = *weight * -stiffness;
            weight.0[3] = stiffness;
        }
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
