//! The terms of four pairs at a time.

use super::PackedParticle;
use crate::FluidControls;
use nalgebra::SVector;
use sph_kernel::Shape;
use wide::f64x4;

/// Pairs that are computed together.
pub(super) const LANES: usize = 4;

/// Constants of all pairs. The kernel's shape is known to the compiler, and whether there are terms of `DENSITY` and of
/// `FORCE`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms<S, const D: usize, const DENSITY: bool, const FORCE: bool> {
    shape: S,
    inverse_length: f64,
    factor_scale: f64,
    /// Twice the dynamic viscosity \[Pa s\].
    friction: f64,
    /// 2 delta h c \[m^2/s\].
    diffusivity: f64,
    /// Density gradient of the fluid at rest \[kg/m^4\].
    rest_gradient: SVector<f64, D>,
    /// alpha c h \[m^2/s\].
    artificial: f64,
    /// 0.01 h^2 \[m^2\].
    softening: f64,
}

/// Four neighbours j, one to a lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Neighbors<const D: usize> {
    pub positions: [f64x4; D],
    pub volumes: f64x4,
    pub velocities: [f64x4; D],
    pub densities: f64x4,
    pub pressures: f64x4,
}

/// What the particles i and j of four pairs give each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exchange<const D: usize> {
    /// Force on i over V_i V_j \[N/m^(2 D)\]; that on j is opposite.
    pub forces: [f64x4; D],
    /// Density rate of i over V_j.
    pub own_rates: f64x4,
    /// Density rate of j over V_i.
    pub other_rates: f64x4,
}

impl<const D: usize> Neighbors<D> {
    /// Reads four particles, each as two vectors, and turns them about.
    #[inline(always)]
    pub fn read(particles: &[PackedParticle<D>], indices: [u32; LANES]) -> Self {
        let there: [&PackedParticle<D>; LANES] = indices.map(|index| &particles[index as usize]);
        let places = f64x4::transpose(there.map(|particle| joined(&particle.position, particle.volume)));
        let motions = f64x4::transpose(there.map(|particle| joined(&particle.velocity, particle.density)));
        Self {
            positions: std::array::from_fn(|axis| places[axis]),
            volumes: places[D],
            velocities: std::array::from_fn(|axis| motions[axis]),
            densities: motions[D],
            pressures: f64x4::new(there.map(|particle| particle.pressure)),
        }
    }
}

/// A vector and a scalar behind it.
#[inline(always)]
pub(super) fn joined<const D: usize>(vector: &SVector<f64, D>, scalar: f64) -> f64x4 {
    f64x4::new(std::array::from_fn(|lane| match lane {
        _ if lane < D => vector[lane],
        _ if lane == D => scalar,
        _ => 0.0,
    }))
}

impl<S: Shape, const D: usize, const DENSITY: bool, const FORCE: bool> Terms<S, D, DENSITY, FORCE> {
    /// The terms of a fluid; `shape` must be that of the controls' kernel.
    pub fn new(shape: S, controls: &FluidControls<D>) -> Self {
        let kernel = &controls.kernel;
        let (length, sound_speed) = (kernel.smoothing_length(), controls.state.reference_sound_speed());
        Self {
            shape,
            inverse_length: 1.0 / length,
            factor_scale: kernel.gradient_factor(0.0) / shape.evaluate(0.0).1,
            friction: 2.0 * controls.dynamic_viscosity,
            diffusivity: 2.0 * controls.density_diffusion * length * sound_speed,
            rest_gradient: controls.body_acceleration
                * (controls.state.reference_density() / (sound_speed * sound_speed)),
            artificial: controls.artificial_viscosity * sound_speed * length,
            softening: 0.01 * length * length,
        }
    }

    /// All terms of four pairs. `WALL`: neighbours are walls, of which friction sees the velocities `seen`, and nothing
    /// diffuses into them.
    #[inline(always)]
    pub fn exchange<const WALL: bool>(
        &self,
        here: &PackedParticle<D>,
        there: &Neighbors<D>,
        seen: &[f64x4; D],
    ) -> Exchange<D> {
        let separations: [f64x4; D] = std::array::from_fn(|axis| here.position[axis] - there.positions[axis]);
        let differences: [f64x4; D] =
            std::array::from_fn(|axis| here.velocity[axis] - there.velocities[axis]);
        let (mut square, mut closing) = (f64x4::ZERO, f64x4::ZERO);
        for axis in 0..D {
            square = separations[axis].mul_add(separations[axis], square);
            closing = differences[axis].mul_add(separations[axis], closing);
        }
        let q = square.sqrt() * self.inverse_length;
        let factor = f64x4::new(q.to_array().map(|q| self.shape.evaluate(q).1)) * self.factor_scale;

        let mut found =
            Exchange { forces: [f64x4::ZERO; D], own_rates: f64x4::ZERO, other_rates: f64x4::ZERO };
        if FORCE {
            let central = factor * self.central(here, there, square, closing);
            let friction = factor * self.friction;
            for axis in 0..D {
                let difference = if WALL { here.velocity[axis] - seen[axis] } else { differences[axis] };
                found.forces[axis] = separations[axis].mul_add(central, difference * friction);
            }
        }
        if DENSITY {
            let compression = factor * closing;
            let diffusion =
                if WALL { f64x4::ZERO } else { factor * self.diffusion(here, there, &separations) };
            found.own_rates = compression.mul_add(f64x4::splat(here.density), diffusion);
            found.other_rates = compression.mul_sub(there.densities, diffusion);
        }
        found
    }

    /// Pressure and artificial viscosity: force along r_i - r_j over f V_i V_j.
    #[inline(always)]
    fn central(
        &self,
        here: &PackedParticle<D>,
        there: &Neighbors<D>,
        square: f64x4,
        closing: f64x4,
    ) -> f64x4 {
        let pressure = -(there.pressures + here.pressure);
        if self.artificial == 0.0 {
            return pressure;
        }
        let mean = 0.5 * (there.densities + here.density);
        let strength = there.densities * (self.artificial * here.density) * closing.min(f64x4::ZERO);
        pressure + strength / ((square + self.softening) * mean)
    }

    /// What diffuses to i over f V_j; the same leaves j.
    #[inline(always)]
    fn diffusion(&self, here: &PackedParticle<D>, there: &Neighbors<D>, separations: &[f64x4; D]) -> f64x4 {
        let mut unexpected = here.density - there.densities;
        for axis in 0..D {
            unexpected = separations[axis].mul_add(f64x4::splat(-self.rest_gradient[axis]), unexpected);
        }
        unexpected * self.diffusivity
    }
}
