//! The sweep over packed particles, block by block.

use super::terms::{Exchange, LANES, Neighbors, Terms, joined};
use super::{PackedParticle, PackedRates, PackedRows};
use crate::FluidControls;
use crate::error::{Error, require};
use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::{CubicSpline, Gaussian, KernelKind, QuinticSpline, Shape, WendlandC2};
use std::ops::Range;
use wide::f64x4;

/// Particles that one task brings up to date.
const PARTICLES_PER_TASK: usize = 4096;

/// Continuity, pressure in the volume form, Morris viscosity, artificial viscosity and plain density diffusion of a fluid, in one
/// visit of each pair: the sums of [`density_rate`](crate::density_rate),
/// [`volume_pressure_acceleration`](crate::volume_pressure_acceleration),
/// [`viscous_acceleration`](crate::viscous_acceleration), [`artificial_acceleration`](crate::artificial_acceleration) and
/// [`plain_diffusion`](crate::plain_diffusion), to round-off.
///
/// Diffusion leaves alone the density gradient rho_0 g/c^2 of fluid at rest under the body acceleration g, which is
/// [`corrected_diffusion`](crate::corrected_diffusion) with that one gradient (after Fourtakas, Dominguez, Vacondio and Rogers 2019,
/// who take the exact hydrostatic density).
///
/// Blocks of particles are the unit of parallel work and fix the order of all sums: results are bit-identical for any number of
/// threads. Nothing is allocated.
#[derive(Clone, Copy, Debug)]
pub struct PackedSweep<const D: usize> {
    controls: FluidControls<D>,
}

impl<const D: usize> PackedSweep<D> {
    /// The fast form of what the controls ask for.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a coefficient that is negative or not finite, and for a surface or corrected gradients, which
    /// have no fast form.
    pub fn new(controls: FluidControls<D>) -> Result<Self, Error> {
        controls.check()?;
        let slow = controls.has_surface() || controls.corrected_gradients;
        require(!slow, "surface_tension, renewal or corrected_gradients", 1.0, "absent in a packed sweep")?;
        Ok(Self { controls })
    }

    /// Volumes and pressures from masses and densities, of fluid.
    pub fn update_states(&self, particles: &mut [PackedParticle<D>]) {
        particles.par_chunks_mut(PARTICLES_PER_TASK).for_each(|particles| {
            for particle in particles {
                particle.volume = particle.mass / particle.density;
                particle.pressure = self.controls.state.pressure(particle.density);
            }
        });
    }

    /// What each fluid particle receives of all others.
    ///
    /// `particles` are the fluid in the order of `blocks` blocks, copies of fluid, then walls, which carry the pressure that the fluid
    /// shall see; `wall_velocities` \[m/s\] are those that friction sees of the walls, one each. `rows` gives the rows of
    /// each block. `rates` has one entry per fluid particle.
    ///
    /// # Panics
    /// If rows name particles that there are not, or blocks are not in order.
    pub fn rates<'a>(
        &self,
        particles: &[PackedParticle<D>],
        wall_velocities: &[SVector<f64, D>],
        blocks: usize,
        rows: impl Fn(usize) -> PackedRows<'a> + Sync,
        rates: &mut [PackedRates<D>],
    ) {
        assert!(particles.len() >= rates.len() + wall_velocities.len(), "particles");
        if blocks == 0 {
            return;
        }
        let walls = particles.len() - wall_velocities.len();
        let body_acceleration = self.controls.body_acceleration;
        macro_rules! run {
            ($shape:expr) => {{
                let terms = Terms::new($shape, &self.controls);
                let sweep = BlockSweep { terms, particles, wall_velocities, walls, body_acceleration, rows };
                sweep.run(0..blocks, rates)
            }};
        }
        match self.controls.kernel.kind() {
            KernelKind::WendlandC2 => run!(WendlandC2),
            KernelKind::Gaussian => run!(Gaussian),
            KernelKind::CubicSpline => run!(CubicSpline),
            KernelKind::QuinticSpline => run!(QuinticSpline),
        }
    }
}

struct BlockSweep<'p, S, R, const D: usize> {
    terms: Terms<S, D>,
    particles: &'p [PackedParticle<D>],
    wall_velocities: &'p [SVector<f64, D>],
    /// Index of the first wall.
    walls: usize,
    body_acceleration: SVector<f64, D>,
    rows: R,
}

impl<'a, S: Shape, R: Fn(usize) -> PackedRows<'a> + Sync, const D: usize> BlockSweep<'_, S, R, D> {
    /// Halves the range until one block is left; `rates` are those of the range.
    fn run(&self, blocks: Range<usize>, rates: &mut [PackedRates<D>]) {
        if blocks.len() == 1 {
            return self.sweep_block(&(self.rows)(blocks.start), rates);
        }
        let middle = blocks.start + blocks.len() / 2;
        let first = (self.rows)(blocks.start).first;
        let (left, right) = rates.split_at_mut((self.rows)(middle).first - first);
        rayon::join(|| self.run(blocks.start..middle, left), || self.run(middle..blocks.end, right));
    }

    fn sweep_block(&self, rows: &PackedRows<'_>, rates: &mut [PackedRates<D>]) {
        rates.fill(PackedRates::zero());
        for k in 0..rates.len() {
            let own = rows.first + k;
            let here = &self.particles[own];
            let [within, across, beyond] = rows.parts(k);
            let (copies, walls) = beyond.split_at(beyond.partition_point(|&j| (j as usize) < self.walls));
            let mut sum = Received::default();
            for indices in quads(within, own) {
                let exchange = self.visit(here, indices, &mut sum);
                give(&exchange, here.volume, indices, rows.first, rates);
            }
            for list in [across, copies] {
                for indices in quads(list, own) {
                    self.visit(here, indices, &mut sum);
                }
            }
            quads(walls, own).for_each(|indices| self.visit_walls(here, indices, &mut sum));
            let (force, rate) = sum.total();
            rates[k].acceleration = (rates[k].acceleration + force) / here.density + self.body_acceleration;
            rates[k].density_rate += rate;
        }
    }

    /// Four pairs of one particle with fluid.
    #[inline(always)]
    fn visit(&self, here: &PackedParticle<D>, indices: [u32; LANES], sum: &mut Received<D>) -> Exchange<D> {
        let there = Neighbors::read(self.particles, indices);
        let exchange = self.terms.exchange::<false>(here, &there, &there.velocities);
        sum.add(&exchange, there.volumes);
        exchange
    }

    /// Four pairs of one particle with walls, or with itself where there are not four.
    fn visit_walls(&self, here: &PackedParticle<D>, indices: [u32; LANES], sum: &mut Received<D>) {
        let there = Neighbors::read(self.particles, indices);
        let seen = indices.map(|index| match (index as usize).checked_sub(self.walls) {
            Some(wall) => self.wall_velocities[wall],
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
fn quads(list: &[u32], own: usize) -> impl Iterator<Item = [u32; LANES]> {
    let (whole, rest) = list.as_chunks::<LANES>();
    let last =
        (!rest.is_empty()).then(|| std::array::from_fn(|lane| rest.get(lane).copied().unwrap_or(own as u32)));
    whole.iter().copied().chain(last)
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
