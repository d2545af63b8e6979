//! The stand-alone sweep of a weakly compressible fluid.

mod buffers;
mod controls;
mod fields;
mod near;
mod powers;
mod surface;
mod warmth;

use crate::error::Error;
use crate::{
    Fields, Friction, PressureForce, SurfaceBand, SurfaceModel, Viscosity, artificial_acceleration,
    artificial_heating, conjugate_pressure_acceleration, corrected_density_rate, corrected_diffusion,
    density_rate, face_force, friction_heating, leading_part, shift_beside_surface, strain_acceleration,
    tearing_speed, viscous_acceleration, volume_pressure_acceleration, wall_state, wall_velocity,
};
use nalgebra::{SMatrix, SVector};
use near::NearRows;
use rayon::prelude::*;
use sph_kernel::operators::{colour_gradient, gradient, moment, regularised_inverse, summation};
use sph_kernel::{Row, ScaledKernel};

pub(crate) use buffers::Buffers;
pub use controls::FluidControls;
pub use fields::FluidFields;
pub(crate) use fields::copy_images;
pub use powers::Powers;

/// Share of the speed of tearing that shifting goes by: the kernel sees less than all of the shortest wave, and more than this
/// shifts a Stokes flow under its own noise of pressure.
const TEARING_SHARE: f64 = 0.5;

/// A weakly compressible fluid between walls: density by continuity, pressure by Tait's law, Morris viscosity,
/// Antuono's density diffusion, walls that carry the fluid's pressure and mirror its speed.
///
/// Two passes over the rows a step, each with all its terms: density first, then forces, and those of the surface between them, all
/// over rows that hold nobody outside the support. The density gradients of the diffusion are those of the previous evaluation.
/// Columns are kept from step to step: once they have their size, a step allocates nothing.
#[derive(Clone, Debug)]
pub struct FluidSweep<const D: usize> {
    controls: FluidControls<D>,
    near: NearRows,
    buffers: Buffers<D>,
    rates: Vec<f64>,
    /// sum m grad W \[kg/m^(D + 1)\] of the fluid, which shifting goes by; zero without renewal.
    crowding: Vec<SVector<f64, D>>,
    volumes: Vec<f64>,
    pressures: Vec<f64>,
    /// Velocities that friction sees.
    seen: Vec<SVector<f64, D>>,
    density_gradients: Vec<SVector<f64, D>>,
    surface: Option<SurfaceBand<D>>,
    shifts: Vec<SVector<f64, D>>,
    /// What friction and tension add to the accelerations of the fluid \[m/s^2\], and the Marangoni force \[N/m^3; N/m^2 in 2-D\];
    /// the last two are empty without tension.
    friction: Vec<SVector<f64, D>>,
    tension: Vec<SVector<f64, D>>,
    marangoni: Vec<SVector<f64, D>>,
    /// Surface tension \[N/m\] of all particles; empty where it is the same everywhere.
    tensions: Vec<f64>,
    /// Stresses of the surface \[N/m^2; N/m in 2-D\] of fluid and copies; empty where tension acts as a force.
    surface_stresses: Vec<SMatrix<f64, D, D>>,
    /// rho_0/rho_ref(T) of all particles, one of walls, which fill their cells at any temperature, and with it the densities and masses that have the same pressure and room at T_0; empty
    /// without thermal expansion.
    stretches: Vec<f64>,
    even_densities: Vec<f64>,
    even_masses: Vec<f64>,
    /// Heat of friction; zero where it is not asked for.
    heating: Vec<f64>,
    /// Inverse moments B; empty without corrected gradients.
    corrections: Vec<SMatrix<f64, D, D>>,
}

impl<const D: usize> FluidSweep<D> {
    /// A fluid that has seen no particles.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a coefficient that is negative or a number that is not finite.
    pub fn new(controls: FluidControls<D>) -> Result<Self, Error> {
        controls.check()?;
        Ok(Self {
            surface: controls.has_surface().then(|| SurfaceBand::new(controls.kernel)),
            controls,
            near: NearRows::default(),
            buffers: Buffers::default(),
            rates: Vec::new(),
            crowding: Vec::new(),
            volumes: Vec::new(),
            pressures: Vec::new(),
            seen: Vec::new(),
            density_gradients: Vec::new(),
            shifts: Vec::new(),
            friction: Vec::new(),
            tension: Vec::new(),
            marangoni: Vec::new(),
            tensions: Vec::new(),
            surface_stresses: Vec::new(),
            stretches: Vec::new(),
            even_densities: Vec::new(),
            even_masses: Vec::new(),
            heating: Vec::new(),
            corrections: Vec::new(),
        })
    }

    /// Kernel of all particles.
    #[must_use]
    pub fn kernel(&self) -> &ScaledKernel<D> {
        &self.controls.kernel
    }

    /// The free surface at the last evaluation, where the controls have one.
    #[must_use]
    pub fn surface(&self) -> Option<&SurfaceBand<D>> {
        self.surface.as_ref()
    }

    /// What the caller adds to the velocities of the fluid for the next drift, and for nothing else \[m/s\]; empty without
    /// renewal.
    #[must_use]
    pub fn shift_velocities(&self) -> &[SVector<f64, D>] {
        &self.shifts
    }

    /// Heat \[W/kg\] that true and artificial viscosity make in each particle of the fluid at the last evaluation; zero without
    /// `viscous_heating`. With the velocities that were given, its sum is what both take from the motion, to round-off.
    #[must_use]
    pub fn heating(&self) -> &[f64] {
        &self.heating
    }

    /// Pressures \[Pa\] of all particles at the last evaluation; of walls that of the fluid carried to them.
    #[must_use]
    pub fn pressures(&self) -> &[f64] {
        &self.pressures
    }

    /// Volumes \[m^D\] of all particles at the last evaluation; of walls those that their cells have under the pressure that they
    /// carry.
    #[must_use]
    pub fn volumes(&self) -> &[f64] {
        &self.volumes
    }

    /// Marangoni force \[N/m^3; N/m^2 in 2-D\] on each particle of fluid at the last evaluation; empty without tension, zero with
    /// [`SurfaceModel::Stress`], which has no force of its own for it.
    #[must_use]
    pub fn marangoni_forces(&self) -> &[SVector<f64, D>] {
        &self.marangoni
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
        assert!(fields.mirrors.is_empty() || fields.mirrors.len() == fields.copies.len(), "mirrors");
        let viscosities = fields.viscosities.len();
        assert!(viscosities == 0 || viscosities == particles, "viscosities");
        let walls = particles - fluid - fields.copies.len();
        assert!(fields.wall_pressures.is_empty() || fields.wall_pressures.len() == walls, "wall_pressures");
        self.fit(particles, fluid);
        let mut near = std::mem::take(&mut self.near);
        near.find(fields, fluid, self.controls.kernel.support_radius());
        self.evaluate(&near.of(fields), densities, dt_s, accelerations);
        self.near = near;
    }

    /// The same for fields whose list has no skin.
    fn evaluate(
        &mut self,
        fields: &FluidFields<'_, D>,
        densities: &mut [f64],
        dt_s: f64,
        accelerations: &mut [SVector<f64, D>],
    ) {
        let fluid = accelerations.len();
        self.measure_tensions(fields);
        self.measure_stretches(fields, fluid);
        copy_images(densities, fluid, fields.copies);
        // Those of the evaluation before, whose copies may have been others.
        fields.copy_vectors(&mut self.density_gradients, fluid);
        self.measure_volumes(fields, densities);
        self.measure_corrections(fields, fluid);
        self.measure_rates(fields, densities, fluid);
        for i in 0..fluid {
            densities[i] += self.rates[i] * dt_s;
        }
        copy_images(densities, fluid, fields.copies);
        self.measure_volumes(fields, densities);
        self.update_states(fields, densities, fluid);
        if let Some(surface) = &mut self.surface {
            let bends = self.controls.surface_model == SurfaceModel::Force
                && self.controls.surface_tension.is_some_and(|tension| tension.pulls());
            surface.measure(fields, &self.volumes, fluid, bends);
        }
        self.sum_forces(fields, densities, accelerations);
        self.add_surface_forces(fields, densities, accelerations);
        self.measure_shifts(fields, fluid);
    }

    fn fit(&mut self, particles: usize, fluid: usize) {
        self.rates.resize(fluid, 0.0);
        self.crowding.resize(fluid, SVector::zeros());
        self.friction.resize(fluid, SVector::zeros());
        self.heating.resize(fluid, 0.0);
        self.volumes.resize(particles, 0.0);
        self.pressures.resize(particles, 0.0);
        self.seen.resize(particles, SVector::zeros());
        self.density_gradients.resize(particles, SVector::zeros());
        if self.controls.corrected_gradients {
            self.corrections.resize(particles, SMatrix::identity());
        }
    }

    /// Pass of the corrected gradients: B of the fluid and its copies; walls keep plain ones.
    fn measure_corrections(&mut self, fields: &FluidFields<'_, D>, fluid: usize) {
        let Self { controls, buffers, volumes, corrections, .. } = self;
        if corrections.is_empty() {
            return;
        }
        let (own, others) = corrections.split_at_mut(fluid);
        own.par_iter_mut().enumerate().for_each_init(
            || buffers.take(),
            |buffer, (i, correction)| {
                let row = buffer.fill(i, fields.neighbors(i), fields.positions, &controls.kernel);
                *correction = regularised_inverse(&moment(&row, volumes));
            },
        );
        others.fill(SMatrix::identity());
        copy_images(corrections, fluid, fields.copies);
        for (correction, mirror) in corrections[fluid..].iter_mut().zip(fields.mirrors) {
            let mirror = SVector::from(*mirror);
            correction.component_mul_assign(&(mirror * mirror.transpose()));
        }
    }

    /// Tension of each particle, where it changes.
    fn measure_tensions(&mut self, fields: &FluidFields<'_, D>) {
        let Some(tension) = self.controls.surface_tension else { return };
        self.tensions.clear();
        if !fields.tensions.is_empty() {
            assert_eq!(fields.tensions.len(), fields.positions.len(), "tensions");
            self.tensions.extend_from_slice(fields.tensions);
        } else if tension.slope() != 0.0 {
            assert_eq!(fields.temperatures.len(), fields.positions.len(), "temperatures");
            self.tensions.extend(fields.temperatures.iter().map(|&temperature| tension.at(temperature)));
        }
    }

    /// Where warmth expands the fluid, by how much.
    fn measure_stretches(&mut self, fields: &FluidFields<'_, D>, fluid: usize) {
        let Some(expansion) = self.controls.thermal_expansion else { return };
        assert_eq!(fields.temperatures.len(), fields.positions.len(), "temperatures");
        self.stretches.clear();
        self.stretches.extend(fields.temperatures.iter().map(|&temperature| expansion.stretch(temperature)));
        self.stretches[fluid + fields.copies.len()..].fill(1.0);
        self.even_masses.clear();
        self.even_masses
            .extend(fields.masses.iter().zip(&self.stretches).map(|(mass, stretch)| mass * stretch));
    }

    fn measure_volumes(&mut self, fields: &FluidFields<'_, D>, densities: &[f64]) {
        for (i, volume) in self.volumes.iter_mut().enumerate() {
            *volume = fields.masses[i] / densities[i];
        }
        self.even_densities.clear();
        let stretched = densities.iter().zip(&self.stretches);
        self.even_densities.extend(stretched.map(|(density, stretch)| density * stretch));
    }

    /// First pass: continuity over all neighbours, diffusion over fluid ones, and how they crowd.
    fn measure_rates(&mut self, fields: &FluidFields<'_, D>, densities: &[f64], fluid: usize) {
        let Self { controls, buffers, volumes, pressures, density_gradients, surface, corrections, .. } =
            self;
        let columns =
            Fields { masses: fields.masses, densities, volumes, pressures, velocities: fields.velocities };
        let even = Fields { densities: even_or(&self.even_densities, densities), ..columns };
        let masses = even_or(&self.even_masses, fields.masses);
        let (central, sound_speed) = (controls.kernel.value(0.0), controls.state.reference_sound_speed());
        let renewal = controls.renewal.zip(surface.as_ref());
        let diffusivity = controls.density_diffusion
            * controls.kernel.smoothing_length()
            * controls.state.reference_sound_speed();
        let mobile = fluid + fields.copies.len();
        let written = (&mut self.rates, &mut self.crowding).into_par_iter().enumerate();
        written.for_each_init(
            || buffers.take(),
            |buffer, (i, (rate, crowding))| {
                let row = buffer.fill(i, fields.neighbors(i), fields.positions, &controls.kernel);
                *rate = match corrections.get(i) {
                    Some(correction) => corrected_density_rate(&row, &columns, correction),
                    None => density_rate(&row, &columns),
                };
                if diffusivity > 0.0 {
                    let fluid_row = leading_part(&row, mobile);
                    let spread = corrected_diffusion(&fluid_row, &even, density_gradients);
                    *rate += diffusivity * spread * densities[i] / even.densities[i];
                }
                if let Some((renewal, surface)) = &renewal {
                    // Depths are those of the previous evaluation; before the first there are none.
                    let depth = surface.planes().get(i).map_or(f64::INFINITY, |plane| plane.1);
                    let (colour, length) =
                        (surface.profile().colour(depth), controls.kernel.smoothing_length());
                    let (summed, density) = (summation(&row, masses, central), even.densities[i]);
                    let pull = renewal.density_rate(summed, colour, density, sound_speed, length);
                    *rate += pull * densities[i] / density;
                    *crowding = colour_gradient(&row, masses);
                }
            },
        );
    }

    /// Pressures of fluid and copies from densities, of walls from the fluid near them; velocities that friction sees; volumes of
    /// walls.
    ///
    /// A wall shrinks under the pressure that it carries as fluid would (Adami, Hu and Adams 2012, eq. 28). With cells of fixed
    /// size compressed fluid finds more volume in the wall than in itself, and the force of pairs drives it off, by the pressure
    /// times that surplus: shifting leads particles back, continuity counts the flow alone, and the density runs away.
    fn update_states(&mut self, fields: &FluidFields<'_, D>, densities: &[f64], fluid: usize) {
        let mobile = fluid + fields.copies.len();
        let Self { controls, buffers, volumes, pressures, seen, even_densities, .. } = self;
        let even_densities = even_or(even_densities, densities);
        for i in 0..mobile {
            pressures[i] = controls.state.pressure(even_densities[i]);
            seen[i] = fields.velocities[i];
        }
        let (mobile_pressures, wall_pressures) = pressures.split_at_mut(mobile);
        let (fluid_volumes, wall_volumes) = volumes.split_at_mut(mobile);
        let columns = Fields {
            masses: fields.masses,
            densities,
            volumes: fluid_volumes,
            pressures: mobile_pressures,
            velocities: fields.velocities,
        };
        let walls = wall_pressures.par_iter_mut().zip(seen[mobile..].par_iter_mut()).enumerate();
        walls.for_each_init(
            || buffers.take(),
            |buffer, (k, (pressure, velocity))| {
                let i = mobile + k;
                let neighbors = fields.neighbors(i);
                let fluid = &neighbors[..neighbors.partition_point(|&b| (b as usize) < mobile)];
                let fluid_row = buffer.fill(i, fluid, fields.positions, &controls.kernel);
                let state = wall_state(&fluid_row, &columns, &controls.body_acceleration);
                let own = fields.velocities[i];
                (*pressure, *velocity) = match state {
                    Some(state) => (
                        fields.wall_pressures.get(k).copied().unwrap_or(state.pressure),
                        wall_velocity(&own, &state.fluid_velocity),
                    ),
                    // Out of the fluid's reach: no fluid particle reads it.
                    None => (0.0, own),
                };
            },
        );
        let reference = controls.state.reference_density();
        for (volume, pressure) in wall_volumes.iter_mut().zip(wall_pressures) {
            *volume *= reference / controls.state.density(*pressure);
        }
    }

    /// Second pass: forces, the heat of friction, and the density gradients of the next diffusion.
    fn sum_forces(
        &mut self,
        fields: &FluidFields<'_, D>,
        densities: &[f64],
        accelerations: &mut [SVector<f64, D>],
    ) {
        let Self {
            controls,
            buffers,
            volumes,
            pressures,
            seen,
            density_gradients,
            corrections,
            friction,
            heating,
            surface,
            ..
        } = self;
        let columns =
            Fields { masses: fields.masses, densities, volumes, pressures, velocities: fields.velocities };
        let mobile = accelerations.len() + fields.copies.len();
        let even_densities = even_or(&self.even_densities, densities);
        let viscosity = fields.viscosity(controls.dynamic_viscosity);
        let written = (accelerations, density_gradients, friction, heating).into_par_iter().enumerate();
        written.for_each_init(
            || buffers.take(),
            |buffer, (i, (sum, density_gradient, friction, heat))| {
                let row = buffer.fill(i, fields.neighbors(i), fields.positions, &controls.kernel);
                let pressure = match controls.pressure {
                    PressureForce::Slope => slope_acceleration(&row, &columns, surface.as_ref()),
                    PressureForce::Pairs if corrections.is_empty() => {
                        volume_pressure_acceleration(&row, &columns)
                    }
                    PressureForce::Pairs => conjugate_pressure_acceleration(&row, &columns, corrections),
                };
                *friction = friction_acceleration(&row, &columns, seen, viscosity, controls);
                *sum = controls.body_acceleration + pressure + *friction;
                if controls.viscous_heating {
                    *heat = heat_of_friction(&row, &columns, seen, mobile, viscosity, controls);
                }
                if controls.density_diffusion > 0.0 {
                    let fluid_row = leading_part(&row, mobile);
                    let inverse = regularised_inverse(&moment(&fluid_row, volumes));
                    *density_gradient = gradient(&fluid_row, volumes, even_densities, &inverse);
                }
            },
        );
    }

    /// Shift velocities of the next drift.
    fn measure_shifts(&mut self, fields: &FluidFields<'_, D>, fluid: usize) {
        let Some((renewal, surface)) = self.controls.renewal.zip(self.surface.as_ref()) else { return };
        let (kernel, profile) = (&self.controls.kernel, surface.profile());
        let squares = fields.velocities[..fluid].iter().map(SVector::norm_squared);
        let largest_speed = squares.fold(0.0, f64::max).sqrt();
        let reference_density = self.controls.state.reference_density();
        let (length, viscosity) = (kernel.smoothing_length(), self.controls.kinematic_viscosity());
        self.shifts.resize(fluid, SVector::zeros());
        for (i, shift) in self.shifts.iter_mut().enumerate() {
            let crowding = self.crowding[i] / reference_density;
            let (normal, depth) = &surface.planes()[i];
            let near = *depth < profile.support();
            let flat = if near { normal * profile.weight(*depth) } else { SVector::zeros() };
            let tearing =
                TEARING_SHARE * tearing_speed(self.pressures[i], reference_density, viscosity, length);
            let wanted = renewal.shift_velocity(&crowding, &flat, length, largest_speed.max(tearing));
            *shift = if near {
                shift_beside_surface(&wanted, normal, surface.agreements()[i])
            } else if surface.flags()[i] {
                // A torn surface has no side to shift along.
                SVector::zeros()
            } else {
                wanted
            };
        }
    }
}

/// Acceleration of a particle by the slope of pressure \[m/s^2\], below a free surface with the force of its face.
fn slope_acceleration<const D: usize>(
    row: &Row<'_, D>,
    columns: &Fields<'_, D>,
    surface: Option<&SurfaceBand<D>>,
) -> SVector<f64, D> {
    let (i, inverse) = (row.index, regularised_inverse(&moment(row, columns.volumes)));
    let slope = gradient(row, columns.volumes, columns.pressures, &inverse);
    let at_face = surface.map_or(SVector::zeros(), |surface| {
        let (normal, depth) = &surface.planes()[i];
        if *depth >= surface.profile().support() {
            return SVector::zeros();
        }
        let weight = surface.profile().weight(depth.max(0.0));
        face_force(columns.pressures[i], &slope, normal, *depth, weight)
    });
    (at_face - slope) / columns.densities[i]
}

/// Acceleration of a particle by viscosity and artificial viscosity \[m/s^2\]. `seen` are the velocities that friction sees.
fn friction_acceleration<const D: usize>(
    row: &Row<'_, D>,
    columns: &Fields<'_, D>,
    seen: &[SVector<f64, D>],
    viscosity: Viscosity<'_>,
    controls: &FluidControls<D>,
) -> SVector<f64, D> {
    let own = match controls.friction {
        Friction::Shear => viscous_acceleration(row, columns, seen, viscosity),
        Friction::Strain => strain_acceleration(row, columns, seen, viscosity),
    };
    let (sound_speed, coefficient) = (controls.state.reference_sound_speed(), controls.artificial_viscosity);
    if coefficient > 0.0 {
        own + artificial_acceleration(row, columns, &controls.kernel, sound_speed, coefficient)
    } else {
        own
    }
}

/// Heat \[W/kg\] that this friction makes in the particle.
fn heat_of_friction<const D: usize>(
    row: &Row<'_, D>,
    columns: &Fields<'_, D>,
    seen: &[SVector<f64, D>],
    mobile: usize,
    viscosity: Viscosity<'_>,
    controls: &FluidControls<D>,
) -> f64 {
    let own = friction_heating(row, columns, seen, mobile, controls.friction, viscosity);
    let (sound_speed, coefficient) = (controls.state.reference_sound_speed(), controls.artificial_viscosity);
    if coefficient > 0.0 {
        own + artificial_heating(row, columns, &controls.kernel, mobile, sound_speed, coefficient)
    } else {
        own
    }
}

/// The column at the reference temperature, where there is one.
fn even_or<'a>(even: &'a [f64], column: &'a [f64]) -> &'a [f64] {
    if even.is_empty() { column } else { even }
}

#[cfg(test)]
mod tests;
