//! The work of one block.

use super::terms::{Exchange, LANES, Neighbors, Terms, joined};
use super::{PackedFields, PackedParticle, PackedRates, PackedRows};
use nalgebra::SVector;
use sph_kernel::Shape;
use std::ops::Range;
use wide::f64x4;

/// A sweep with its kernel and its terms chosen.
pub(super) struct BlockSweep<'p, S, R, const D: usize, const DENSITY: bool, const FORCE: bool> {
    pub terms: Terms<S, D, DENSITY, FORCE>,
    pub fields: &'p PackedFields<'p, D, R>,
    pub body_acceleration: SVector<f64, D>,
}

impl<'a, S, R, const D: usize, const DENSITY: bool, const FORCE: bool> BlockSweep<'_, S, R, D, DENSITY, FORCE>
where
    S: Shape,
    R: Fn(usize) -> PackedRows<'a> + Sync,
{
    /// Halves the range until one block is left; `rates` are those of the range.
    pub fn run(&self, blocks: Range<usize>, rates: &mut [PackedRates<D>]) {
        if blocks.len() == 1 {
            return self.sweep_block(&(self.fields.rows)(blocks.start), rates);
        }
        let middle = blocks.start + blocks.len() / 2;
        let first = (self.fields.rows)(blocks.start).first;
        let (left, right) = rates.split_at_mut((self.fields.rows)(middle).first - first);
        rayon::join(|| self.run(blocks.start..middle, left), || self.run(middle..blocks.end, right));
    }

    fn first_wall(&self) -> usize {
        self.fields.particles.len() - self.fields.wall_velocities.len()
    }

    fn sweep_block(&self, rows: &PackedRows<'_>, rates: &mut [PackedRates<D>]) {
        rates.fill(PackedRates::zero());
        let first_wall = self.first_wall();
        for k in 0..rates.len() {
            let own = rows.first + k;
            let here = &self.fields.particles[own];
            let [within, across, beyond] = rows.parts(k);
            let (copies, walls) = beyond.split_at(beyond.partition_point(|&j| (j as usize) < first_wall));
            let mut sum = Received::default();
            for_each_quad(within, own, |indices| {
                let exchange = self.visit(here, indices, &mut sum);
                give(&exchange, here.volume, indices, rows.first, rates);
            });
            for list in [across, copies] {
                for_each_quad(list, own, |indices| {
                    self.visit(here, indices, &mut sum);
                });
            }
            for_each_quad(walls, own, |indices| self.visit_walls(here, indices, &mut sum));
            let (force, rate) = sum.total();
            rates[k].acceleration = (rates[k].acceleration + force) / here.density + self.body_acceleration;
            rates[k].density_rate += rate;
        }
    }

    /// Four pairs of one particle with fluid.
    #[inline(always)]
    fn visit(&self, here: &PackedParticle<D>, indices: [u32; LANES], sum: &mut Received<D>) -> Exchange<D> {
        let there = Neighbors::read(self.fields.particles, indices);
        let exchange = self.terms.exchange::<false>(here, &there, &there.velocities);
        sum.add(&exchange, there.volumes);
        exchange
    }

    /// Four pairs of one particle with walls, or with itself where there are not four.
    fn visit_walls(&self, here: &PackedParticle<D>, indices: [u32; LANES], sum: &mut Received<D>) {
        let there = Neighbors::read(self.fields.particles, indices);
        let seen = indices.map(|index| match (index as usize).checked_sub(self.first_wall()) {
            Some(wall) => self.fields.wall_velocities[wall],
            None => here.velocity,
        });
        let seen = std::array::from_fn(|axis| f64x4::new(seen.map(|velocity| velocity[axis])));
        sum.add(&self.terms.exchange::<true>(here, &there, &seen), there.volumes);
    }
}

/// What one particle has received, lane by lane.
struct Received<const D: usize> {
    forces: [f64x4; D],
    rates: f64x4,
}

impl<const D: usize> Default for Received<D> {
    fn default() -> Self {
        Self { forces: [f64x4::ZERO; D], rates: f64x4::ZERO }
    }
}

impl<const D: usize> Received<D> {
    #[inline(always)]
    fn add(&mut self, exchange: &Exchange<D>, volumes: f64x4) {
        for axis in 0..D {
            self.forces[axis] = volumes.mul_add(exchange.forces[axis], self.forces[axis]);
        }
        self.rates = volumes.mul_add(exchange.own_rates, self.rates);
    }

    fn total(&self) -> (SVector<f64, D>, f64) {
        (SVector::from_fn(|axis, _| self.forces[axis].reduce_add()), self.rates.reduce_add())
    }
}

/// A list in pieces of four, the last one filled up with the particle itself, which exchanges nothing with itself.
#[inline(always)]
fn for_each_quad(list: &[u32], own: usize, mut visit: impl FnMut([u32; LANES])) {
    let mut from = 0;
    while from < list.len() {
        let indices = match list[from..].first_chunk() {
            Some(indices) => *indices,
            None => std::array::from_fn(|lane| list.get(from + lane).copied().unwrap_or(own as u32)),
        };
        visit(indices);
        from += LANES;
    }
}

/// Gives four particles of a block their share of the pairs: the opposite force, and their rate.
#[inline(always)]
fn give<const D: usize>(
    exchange: &Exchange<D>,
    volume: f64,
    indices: [u32; LANES],
    first: usize,
    rates: &mut [PackedRates<D>],
) {
    let shares = f64x4::transpose(std::array::from_fn(|field| match field {
        _ if field < D => exchange.forces[field] * -volume,
        _ if field == D => exchange.other_rates * volume,
        _ => f64x4::ZERO,
    }));
    for (index, share) in indices.into_iter().zip(shares) {
        let received = &mut rates[index as usize - first];
        let sum = (joined(&received.acceleration, received.density_rate) + share).to_array();
        received.acceleration = SVector::from_fn(|axis, _| sum[axis]);
        received.density_rate = sum[D];
    }
}
