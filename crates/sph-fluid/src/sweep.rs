//! The stand-alone sweep of a weakly compressible fluid.

use crate::error::{Error, require};
use crate::{
    Fields, Tait, artificial_acceleration, corrected_diffusion, density_rate, leading_part,
    viscous_acceleration, volume_pressure_acceleration, wall_state, wall_velocity,
};
use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::operators::{gradient, moment, regularised_inverse};
use sph_kernel::{RowBuffer, ScaledKernel};

/// Constants of the fluid and of the scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FluidControls<const D: usize> {
    /// Kernel of all particles.
    pub kernel: ScaledKernel<D>,
    /// Equation of state.
    pub state: Tait,
    /// Dynamic viscosity eta \[Pa s\].
    pub dynamic_viscosity: f64,
    /// Artificial viscosity alpha \[-\]; 0 is none.
    pub artificial_viscosity: f64,
    /// Density diffusion delta \[-\]; 0.02 to 0.1, 0 is none.
    pub density_diffusion: f64,
    /// Acceleration of every particle, for example gravity \[m/s^2\].
    pub body_acceleration: SVector<f64, D>,
}

impl<const D: usize> FluidControls<D> {
    fn check(&self) -> Result<(), Error> {
        for (name, value) in [
            ("dynamic_viscosity", self.dynamic_viscosity),
            ("artificial_viscosity", self.artificial_viscosity),
            ("density_diffusion", self.density_diffusion),
        ] {
            require(value >= 0.0, name, value, "zero or above")?;
        }
        self.body_acceleration
            .iter()
            .try_for_each(|&value| require(true, "body_acceleration", value, "finite"))
    }
}

/// What the caller owns and the sweep reads. Order of all columns: fluid, copies of fluid, walls.
#[derive(Clone, Copy, Debug)]
pub struct FluidFields<'a, const D: usize> {
    /// Positions at the end of the drift \[m\].
    pub positions: &'a [SVector<f64, D>],
    /// Velocities of the drift that led there \[m/s\]; walls and copies included.
    pub velocities: &'a [SVector<f64, D>],
    /// Masses \[kg; kg/m in 2-D\].
    pub masses: &'a [f64],
    /// For each copy (periodic images) the fluid particle that it shows.
    pub copies: &'a [u32],
    /// Where each particle's row starts in `list_neighbors`; one entry more than particles.
    pub list_starts: &'a [usize],
    /// A full list with ascending rows; entries outside the support do no harm.
    pub list_neighbors: &'a [u32],
}

impl<'a, const D: usize> FluidFields<'a, D> {
    #[inline]
    fn neighbors(&self, i: usize) -> &'a [u32] {
        &self.list_neighbors[self.list_starts[i]..self.list_starts[i + 1]]
    }
}

/// A weakly compressible fluid between walls: density by continuity, pressure by Tait's law, Morris viscosity,
/// Antuono's density diffusion, walls that carry the fluid's pressure and mirror its speed.
///
/// Two passes over the rows a step, each with all its terms: density first, then forces. The density gradients of the
/// diffusion are those of the previous evaluation. Columns are kept from step
/// to step; each pass still makes row buffers, one for each piece of work of rayon.
#[derive(Clone, Debug)]
pub struct FluidSweep<const D: usize> {
    controls: FluidControls<D>,
    rates: Vec<f64>,
    volumes: Vec<f64>,
    pressures: Vec<f64>,
    /// Velocities that friction sees.
    seen: Vec<SVector<f64, D>>,
    density_gradients: Vec<SVector<f64, D>>,
}

impl<const D: usize> FluidSweep<D> {
    /// A fluid that has seen no particles.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a coefficient that is negative or a number that is not finite.
    pub fn new(controls: FluidControls<D>) -> Result<Self, Error> {
        controls.check()?;
        let (rates, volumes, pressures) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Self { controls, rates, volumes, pressures, seen: Vec::new(), density_gradients: Vec::new() })
    }

    /// Pressures \[Pa\] of all particles at the last evaluation; of walls that of the fluid carried to them.
    #[must_use]
    pub fn pressures(&self) -> &[f64] {
        &self.pressures
    }

    /// The work between drift and second kick: advances the densities over `dt_s` with the velocities of the drift,
    /// then writes the accelerations \[m/s^2\] of the fluid. `dt_s` = 0 only evaluates.
    ///
    /// `accelerations` has one entry per fluid particle, `densities` \[kg/m^3\] one per particle: those of copies are written,
    /// those of walls only read.
    ///
    /// # Panics
    /// If columns differ in length.
    pub fn accelerations(
        &mut self,
        fields: &FluidFields<'_, D>,
        densities: &mut [f64],
        dt_s: f64,
        accelerations: &mut [SVector<f64, D>],
    ) {
        let (particles, fluid) = (fields.positions.len(), accelerations.len());
        assert_eq!(fields.velocities.len(), particles, "velocities");
        assert_eq!(fields.masses.len(), particles, "masses");
        assert_eq!(densities.len(), particles, "densities");
        self.fit(particles, fluid);
        copy_images(densities, fluid, fields.copies);
        self.measure_volumes(fields, densities);
        self.measure_rates(fields, densities, fluid);
        for i in 0..fluid {
            densities[i] += self.rates[i] * dt_s;
        }
        copy_images(densities, fluid, fields.copies);
        self.measure_volumes(fields, densities);
        self.update_states(fields, densities, fluid);
        self.sum_forces(fields, densities, accelerations);
        copy_images(&mut self.density_gradients, fluid, fields.copies);
    }

    fn fit(&mut self, particles: usize, fluid: usize) {
        self.rates.resize(fluid, 0.0);
        self.volumes.resize(particles, 0.0);
        self.pressures.resize(particles, 0.0);
        self.seen.resize(particles, SVector::zeros());
        self.density_gradients.resize(particles, SVector::zeros());
    }

    fn measure_volumes(&mut self, fields: &FluidFields<'_, D>, densities: &[f64]) {
        for (i, volume) in self.volumes.iter_mut().enumerate() {
            *volume = fields.masses[i] / densities[i];
        }
    }

    /// First pass: continuity over all neighbours, diffusion over fluid ones.
    fn measure_rates(&mut self, fields: &FluidFields<'_, D>, densities: &[f64], fluid: usize) {
        let Self { controls, volumes, pressures, density_gradients, .. } = self;
        let columns =
            Fields { masses: fields.masses, densities, volumes, pressures, velocities: fields.velocities };
        let diffusivity = controls.density_diffusion
            * controls.kernel.smoothing_length()
            * controls.state.reference_sound_speed();
        let mobile = fluid + fields.copies.len();
        self.rates.par_iter_mut().enumerate().for_each_init(RowBuffer::default, |buffer, (i, rate)| {
            let row = buffer.fill(i, fields.neighbors(i), fields.positions, &controls.kernel);
            *rate = density_rate(&row, &columns);
            if diffusivity > 0.0 {
                let fluid_row = leading_part(&row, mobile);
                *rate += diffusivity * corrected_diffusion(&fluid_row, &columns, density_gradients);
            }
        });
    }

    /// Pressures of fluid and copies from densities, of walls from the fluid near them; velocities that friction sees.
    fn update_states(&mut self, fields: &FluidFields<'_, D>, densities: &[f64], fluid: usize) {
        let mobile = fluid + fields.copies.len();
        let Self { controls, volumes, pressures, seen, .. } = self;
        for i in 0..mobile {
            pressures[i] = controls.state.pressure(densities[i]);
            seen[i] = fields.velocities[i];
        }
        let (mobile_pressures, wall_pressures) = pressures.split_at_mut(mobile);
        let columns = Fields {
            masses: fields.masses,
            densities,
            volumes,
            pressures: mobile_pressures,
            velocities: fields.velocities,
        };
        let walls = wall_pressures.par_iter_mut().zip(seen[mobile..].par_iter_mut()).enumerate();
        walls.for_each_init(RowBuffer::default, |buffer, (k, (pressure, velocity))| {
            let i = mobile + k;
            let row = buffer.fill(i, fields.neighbors(i), fields.positions, &controls.kernel);
            let state = wall_state(&leading_part(&row, mobile), &columns, &controls.body_acceleration);
            let own = fields.velocities[i];
            (*pressure, *velocity) = match state {
                Some(state) => (state.pressure, wall_velocity(&own, &state.fluid_velocity)),
                // Out of the fluid's reach: no fluid particle reads it.
                None => (0.0, own),
            };
        });
    }

    /// Second pass: forces, and the density gradients of the next diffusion.
    fn sum_forces(
        &mut self,
        fields: &FluidFields<'_, D>,
        densities: &[f64],
        accelerations: &mut [SVector<f64, D>],
    ) {
        let Self { controls, volumes, pressures, seen, density_gradients, .. } = self;
        let columns =
            Fields { masses: fields.masses, densities, volumes, pressures, velocities: fields.velocities };
        let mobile = accelerations.len() + fields.copies.len();
        let sound_speed = controls.state.reference_sound_speed();
        let written = accelerations.par_iter_mut().zip(density_gradients.par_iter_mut()).enumerate();
        written.for_each_init(RowBuffer::default, |buffer, (i, (sum, density_gradient))| {
            let row = buffer.fill(i, fields.neighbors(i), fields.positions, &controls.kernel);
            *sum = controls.body_acceleration + volume_pressure_acceleration(&row, &columns);
            *sum += viscous_acceleration(&row, &columns, seen, controls.dynamic_viscosity);
            if controls.artificial_viscosity > 0.0 {
                let coefficient = controls.artificial_viscosity;
                *sum += artificial_acceleration(&row, &columns, &controls.kernel, sound_speed, coefficient);
            }
            if controls.density_diffusion > 0.0 {
                let fluid_row = leading_part(&row, mobile);
                let inverse = regularised_inverse(&moment(&fluid_row, volumes));
                *density_gradient = gradient(&fluid_row, volumes, densities, &inverse);
            }
        });
    }
}

/// Gives each copy, stored behind the fluid, the value of the particle that it shows.
fn copy_images<T: Copy>(column: &mut [T], fluid: usize, copies: &[u32]) {
    for (k, &source) in copies.iter().enumerate() {
        column[fluid + k] = column[source as usize];
    }
}

#[cfg(test)]
mod tests;
