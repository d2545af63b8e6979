//! The stand-alone sweep of the updated-Lagrangian form.

use super::force_pass::{ForcePass, Point};
use super::gradient_pass::{GradientPass, Place, RowSums};
use super::near::NearPairs;
use super::quads::{QuadKernel, joined};
use super::{UpdatedControls, UpdatedForm};
use crate::error::Error;
use crate::total::links::BLOCK;
use crate::{
    Material, SymmetricTensor, advanced_deviator, artificial_stress, density_ratio, midpoint_gradient,
    pressure, pressure_wave_speed, radial_return,
};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use sph_kernel::operators::regularised_inverse;
use sph_kernel::{CubicSpline, Gaussian, KernelKind, QuinticSpline, Shape, WendlandC2};
use wide::f64x4;

/// What the caller owns and the sweep reads, one entry per particle.
#[derive(Clone, Copy, Debug)]
pub struct UpdatedFields<'a, const D: usize> {
    /// Positions at the end of the step \[m\].
    pub positions: &'a [SVector<f64, D>],
    /// Velocities of the drift that led there \[m/s\].
    pub velocities: &'a [SVector<f64, D>],
    /// Masses \[kg; kg/m in plane strain\].
    pub masses: &'a [f64],
    /// Temperatures \[K\].
    pub temperatures: &'a [f64],
    /// Where each particle's row starts in `list_neighbors`; one entry more than particles.
    pub list_starts: &'a [usize],
    /// A full list, all rows one after the other; entries outside the support do no harm.
    pub list_neighbors: &'a [u32],
}

/// What the sweep advances, one entry per particle.
#[derive(Debug)]
pub struct UpdatedState<'a, const D: usize> {
    /// Densities \[kg/m^3\].
    pub densities: &'a mut [f64],
    /// Deviatoric stresses \[Pa\] of the solver, out-of-plane component of plane strain beside.
    pub deviators: &'a mut [SymmetricTensor<D>],
    /// Accumulated equivalent plastic strain \[-\].
    pub equivalents: &'a mut [f64],
}

/// A body in the updated-Lagrangian form: stress by the Jaumann rate, pressure from density.
///
/// For the classic tests, for what breaks and for the mush; the total-Lagrangian form is faster and more accurate. The
/// sweep gives what the row functions of this module give, four pairs at a time; particles in the order of a spatial sort
/// are fastest.
#[derive(Clone, Debug)]
pub struct UpdatedLagrangian<const D: usize> {
    controls: UpdatedControls<D>,
    material: Material,
    places: Vec<Place>,
    gradients: Vec<SMatrix<f64, D, D>>,
    points: Vec<Point<D>>,
    accelerations: Vec<f64x4>,
    blocks: Vec<NearPairs>,
}

impl<const D: usize> UpdatedLagrangian<D> {
    /// A body of `particles` particles.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a spacing that is not positive or a coefficient that is negative.
    pub fn new(particles: usize, material: Material, controls: UpdatedControls<D>) -> Result<Self, Error> {
        const { assert!(D == 2 || D == 3, "bodies have 2 or 3 dimensions") };
        controls.check()?;
        let block = |first: usize| NearPairs::new(first..(first + BLOCK).min(particles));
        Ok(Self {
            controls,
            material,
            places: vec![Place::default(); particles],
            gradients: vec![SMatrix::zeros(); particles],
            points: vec![Point::nothing(); particles],
            accelerations: vec![f64x4::ZERO; particles],
            blocks: (0..particles).step_by(BLOCK).map(block).collect(),
        })
    }

    /// Velocity gradient of a particle \[1/s\] at the end of the last step.
    #[must_use]
    pub fn gradient(&self, particle: usize) -> SMatrix<f64, D, D> {
        self.gradients[particle]
    }

    /// Stress of the solver -p 1 + S \[Pa\] for a particle's density, temperature \[K\] and deviator; in true units by
    /// [`ReducedSound::reported`](crate::ReducedSound::reported).
    #[must_use]
    pub fn stress(
        &self,
        density: f64,
        temperature_k: f64,
        deviator: &SymmetricTensor<D>,
    ) -> SymmetricTensor<D> {
        stress(&self.material, density, temperature_k, deviator)
    }

    /// Second half of a kick-drift-kick step's work: after the drift by `dt_s`, advances density and stress by the gradient
    /// of the velocities at mid-step and writes the accelerations \[m/s^2\]. `dt_s` = 0 only evaluates.
    ///
    /// # Panics
    /// If a column has not one entry per particle.
    pub fn accelerations(
        &mut self,
        fields: &UpdatedFields<'_, D>,
        state: &mut UpdatedState<'_, D>,
        dt_s: f64,
        accelerations: &mut [SVector<f64, D>],
    ) {
        let particles = self.places.len();
        assert_eq!(fields.positions.len(), particles, "positions");
        assert_eq!(fields.velocities.len(), particles, "velocities");
        assert_eq!(fields.masses.len(), particles, "masses");
        assert_eq!(fields.temperatures.len(), particles, "temperatures");
        assert_eq!(state.densities.len(), particles, "densities");
        assert_eq!(state.deviators.len(), particles, "deviators");
        assert_eq!(state.equivalents.len(), particles, "equivalent plastic strains");
        assert_eq!(accelerations.len(), particles, "accelerations");
        self.gather(fields, state.densities);
        match self.controls.kernel.kind() {
            KernelKind::WendlandC2 => self.run(WendlandC2, fields, state, dt_s),
            KernelKind::Gaussian => self.run(Gaussian, fields, state, dt_s),
            KernelKind::CubicSpline => self.run(CubicSpline, fields, state, dt_s),
            KernelKind::QuinticSpline => self.run(QuinticSpline, fields, state, dt_s),
        }
        let found = accelerations.par_iter_mut().zip(&self.accelerations).with_min_len(BLOCK);
        found.for_each(|(acceleration, found)| {
            *acceleration = SVector::from_fn(|axis, _| found.to_array()[axis]);
        });
    }

    /// Copies what the first pass reads into one place a particle.
    fn gather(&mut self, fields: &UpdatedFields<'_, D>, densities: &[f64]) {
        self.places.par_iter_mut().with_min_len(BLOCK).enumerate().for_each(|(i, place)| {
            place.position = joined(&fields.positions[i], fields.masses[i] / densities[i]);
            place.velocity = joined(&fields.velocities[i], 0.0);
        });
    }

    fn run<S: Shape>(
        &mut self,
        shape: S,
        fields: &UpdatedFields<'_, D>,
        state: &mut UpdatedState<'_, D>,
        dt_s: f64,
    ) {
        match self.controls.form {
            UpdatedForm::Paper => self.advance::<S, false>(shape, fields, state, dt_s),
            UpdatedForm::Corrected => self.advance::<S, true>(shape, fields, state, dt_s),
        }
        if self.controls.artificial_stress > 0.0 {
            self.sum_forces::<S, true>(shape);
        } else {
            self.sum_forces::<S, false>(shape);
        }
    }

    /// First pass: pairs, B and the velocity gradients at the end positions; with them density, deviator and yield; then
    /// what the forces read.
    fn advance<S: Shape, const CORRECTED: bool>(
        &mut self,
        shape: S,
        fields: &UpdatedFields<'_, D>,
        state: &mut UpdatedState<'_, D>,
        dt_s: f64,
    ) {
        let damping = self.damping();
        let Self { controls, material, places, gradients, points, blocks, .. } = self;
        let pass = GradientPass::<_, CORRECTED> {
            kernel: QuadKernel::new(shape, &controls.kernel),
            limit: controls.kernel.support_radius().powi(2),
            places,
        };
        blocks
            .par_iter_mut()
            .zip(points.par_chunks_mut(BLOCK))
            .zip(gradients.par_chunks_mut(BLOCK))
            .zip(state.densities.par_chunks_mut(BLOCK))
            .zip(state.deviators.par_chunks_mut(BLOCK))
            .zip(state.equivalents.par_chunks_mut(BLOCK))
            .for_each(|(((((near, points), gradients), densities), deviators), equivalents)| {
                near.clear();
                for (k, i) in near.particles().enumerate() {
                    let list = &fields.list_neighbors[fields.list_starts[i]..fields.list_starts[i + 1]];
                    let RowSums { moment, gradient } = pass.row(i, list, near);
                    let correction =
                        if CORRECTED { regularised_inverse(&moment) } else { SMatrix::identity() };
                    let gradient = gradient * correction;
                    let (density, deviator) = (&mut densities[k], &mut deviators[k]);
                    let strained = Strained { gradient, temperature: fields.temperatures[i], dt_s };
                    let stress = strained.advance(material, density, deviator, &mut equivalents[k]).in_plane;
                    let pull = stress * correction / (*density * *density) - gradient * (0.5 * damping);
                    let repulsion = artificial_stress(&stress, *density, controls.artificial_stress);
                    let (place, speed) = (&fields.positions[i], &fields.velocities[i]);
                    points[k] = Point::new((place, fields.masses[i]), (speed, *density), &pull, &repulsion);
                    gradients[k] = gradient;
                }
            });
    }

    /// Second pass: the divergence of stress and what is added to it.
    fn sum_forces<S: Shape, const REPULSIVE: bool>(&mut self, shape: S) {
        let wave_speed = self.wave_speed();
        let pass = ForcePass::<S, D, REPULSIVE>::new(shape, &self.controls, wave_speed, self.damping());
        let blocks = self.blocks.par_iter().zip(self.accelerations.par_chunks_mut(BLOCK));
        blocks.for_each(|(near, accelerations)| pass.block(&self.points, near, accelerations));
    }

    /// Of pressure waves in the material as it is at first \[m/s\].
    fn wave_speed(&self) -> f64 {
        pressure_wave_speed(self.material.solver_moduli(), self.material.expansion.density())
    }

    /// Viscosity on what gradients do not see, over the first density: b in [`Point`].
    fn damping(&self) -> f64 {
        let UpdatedControls { kernel, hourglass_viscosity, .. } = &self.controls;
        let density = self.material.expansion.density();
        hourglass_viscosity * self.wave_speed() * kernel.smoothing_length() / density
    }
}

/// What strains a particle over a step.
struct Strained<const D: usize> {
    /// Velocity gradient \[1/s\] at the end of the step.
    gradient: SMatrix<f64, D, D>,
    temperature: f64,
    dt_s: f64,
}

impl<const D: usize> Strained<D> {
    /// Advances density, deviator and equivalent plastic strain, and returns the stress \[Pa\].
    fn advance(
        &self,
        material: &Material,
        density: &mut f64,
        deviator: &mut SymmetricTensor<D>,
        equivalent: &mut f64,
    ) -> SymmetricTensor<D> {
        let shear_pa = material.solver_moduli().shear_pa();
        let mid = midpoint_gradient(&self.gradient, self.dt_s);
        *density *= density_ratio(&mid, self.dt_s);
        *deviator = advanced_deviator(deviator, &mid, shear_pa, self.dt_s);
        if material.yield_stress.is_some() {
            let yield_pa = material.solver_yield_pa(self.temperature);
            if let Some(step) = radial_return(deviator, shear_pa, yield_pa) {
                *deviator = *deviator * step.scale;
                *equivalent += step.equivalent;
            }
        }
        stress(material, *density, self.temperature, deviator)
    }
}

/// -p 1 + S \[Pa\].
fn stress<const D: usize>(
    material: &Material,
    density: f64,
    temperature_k: f64,
    deviator: &SymmetricTensor<D>,
) -> SymmetricTensor<D> {
    let reference = material.expansion.reference_density(temperature_k);
    let pressure = pressure(material.solver_moduli().bulk_pa(), density, reference);
    *deviator - SymmetricTensor::isotropic(pressure)
}
