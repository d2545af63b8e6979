//! The sweep over packed particles.

use super::block_sweep::BlockSweep;
use super::terms::Terms;
use super::{PackedFields, PackedParticle, PackedRates, PackedRows};
use crate::error::{Error, require};
use crate::{FluidControls, Friction, PressureForce};
use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::{CubicSpline, Gaussian, KernelKind, QuinticSpline, WendlandC2};

/// Particles that one task brings up to date.
const PARTICLES_PER_TASK: usize = 4096;

/// Continuity, pressure in the volume form, Morris viscosity, artificial viscosity and density diffusion of a fluid, in
/// one visit of each pair: the sums of [`density_rate`](crate::density_rate),
/// [`volume_pressure_acceleration`](crate::volume_pressure_acceleration),
/// [`viscous_acceleration`](crate::viscous_acceleration),
/// [`artificial_acceleration`](crate::artificial_acceleration) and [`plain_diffusion`](crate::plain_diffusion), to
/// round-off.
///
/// Diffusion leaves alone the density gradient rho_0 g/c^2 of fluid at rest under the body acceleration g: it is
/// [`corrected_diffusion`](crate::corrected_diffusion) with that one gradient everywhere (after Fourtakas, Dominguez,
/// Vacondio and Rogers 2019, who take the exact hydrostatic density).
///
/// Blocks of particles are the unit of parallel work and fix the order of all sums: results are bit-identical for any
/// number of threads. Nothing is allocated. Pairs are computed four at a time.
#[derive(Clone, Copy, Debug)]
pub struct PackedSweep<const D: usize> {
    controls: FluidControls<D>,
}

impl<const D: usize> PackedSweep<D> {
    /// The fast form of what the controls ask for.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a coefficient that is negative or not finite, for a surface, corrected gradients,
    /// pressure by its slope, thermal expansion and the heat of friction, which have no fast form.
    pub fn new(controls: FluidControls<D>) -> Result<Self, Error> {
        controls.check()?;
        let slow = controls.has_surface() || controls.corrected_gradients;
        require(!slow, "surface_tension, renewal or corrected_gradients", 1.0, "absent in a packed sweep")?;
        let paired = controls.pressure == PressureForce::Pairs;
        require(paired, "pressure", 1.0, "PressureForce::Pairs in a packed sweep")?;
        let warm = controls.thermal_expansion.is_some() || controls.viscous_heating;
        require(!warm, "thermal_expansion or viscous_heating", 1.0, "absent in a packed sweep")?;
        let sheared = controls.friction == Friction::Shear;
        require(sheared, "friction", 1.0, "Friction::Shear in a packed sweep")?;
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

    /// What each fluid particle receives of all others: rate of density and acceleration, in one visit of each pair.
    ///
    /// Both belong to the state of `fields`, so that a step must extrapolate. Where that is not wanted,
    /// [`density_rates`](Self::density_rates) and [`accelerations`](Self::accelerations) visit the pairs once each.
    /// `rates` has one entry per fluid particle, and is written.
    ///
    /// # Panics
    /// If rows name particles that there are not, or blocks are not in order.
    pub fn rates<'a, R: Fn(usize) -> PackedRows<'a> + Sync>(
        &self,
        fields: &PackedFields<'_, D, R>,
        rates: &mut [PackedRates<D>],
    ) {
        self.run::<_, true, true>(fields, self.controls.body_acceleration, rates);
    }

    /// The density rates alone, to advance the densities before forces are formed, as [`FluidSweep`](crate::FluidSweep)
    /// does; accelerations become zero. Reads no pressures.
    ///
    /// # Panics
    /// As [`rates`](Self::rates).
    pub fn density_rates<'a, R: Fn(usize) -> PackedRows<'a> + Sync>(
        &self,
        fields: &PackedFields<'_, D, R>,
        rates: &mut [PackedRates<D>],
    ) {
        self.run::<_, true, false>(fields, SVector::zeros(), rates);
    }

    /// The accelerations alone; density rates become zero.
    ///
    /// # Panics
    /// As [`rates`](Self::rates).
    pub fn accelerations<'a, R: Fn(usize) -> PackedRows<'a> + Sync>(
        &self,
        fields: &PackedFields<'_, D, R>,
        rates: &mut [PackedRates<D>],
    ) {
        self.run::<_, false, true>(fields, self.controls.body_acceleration, rates);
    }

    fn run<'a, R: Fn(usize) -> PackedRows<'a> + Sync, const DENSITY: bool, const FORCE: bool>(
        &self,
        fields: &PackedFields<'_, D, R>,
        body_acceleration: SVector<f64, D>,
        rates: &mut [PackedRates<D>],
    ) {
        assert!(fields.particles.len() >= rates.len() + fields.wall_velocities.len(), "particles");
        if fields.blocks == 0 {
            return;
        }
        macro_rules! run {
            ($shape:expr) => {{
                let terms = Terms::<_, D, DENSITY, FORCE>::new($shape, &self.controls);
                BlockSweep { terms, fields, body_acceleration }.run(0..fields.blocks, rates)
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
