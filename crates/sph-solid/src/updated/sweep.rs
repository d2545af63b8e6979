//! The stand-alone sweep of the updated-Lagrangian form.

use super::rows::{
    DampingColumns, artificial_stress_acceleration, hourglass_viscosity, stress_acceleration,
    velocity_gradient, viscous_acceleration,
};
use crate::error::{Error, require};
use crate::{
    ARTIFICIAL_STRESS_EXPONENT, ARTIFICIAL_STRESS_FACTOR, ArtificialViscosity, Material, SymmetricTensor,
    advanced_deviator, artificial_stress, density_ratio, midpoint_gradient, pressure, pressure_wave_speed,
    radial_return,
};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use sph_kernel::operators::{moment, regularised_inverse};
use sph_kernel::{RowBuffer, ScaledKernel};

/// How gradients and forces are formed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpdatedForm {
    /// As in Hu and Eberhard (2015): plain kernel gradients. For comparison: a spinning block stresses itself.
    Paper,
    /// The kernel-gradient correction B in the velocity gradient and in the force, which keeps energy.
    Corrected,
}

/// Coefficients of the updated-Lagrangian form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpdatedControls<const D: usize> {
    /// Paper's or corrected gradients.
    pub form: UpdatedForm,
    /// Kernel of all particles.
    pub kernel: ScaledKernel<D>,
    /// Initial spacing \[m\], to which the artificial stress is scaled.
    pub spacing: f64,
    /// Artificial stress epsilon \[-\]; 0 is none.
    pub artificial_stress: f64,
    /// Artificial viscosity; zero coefficients are none.
    pub viscosity: ArtificialViscosity,
    /// Viscosity on zero-energy modes \[-\]; 0 is none.
    pub hourglass_viscosity: f64,
}

impl<const D: usize> UpdatedControls<D> {
    /// The paper's: artificial stress 0.3, viscosity alpha 0.5.
    #[must_use]
    pub fn paper(kernel: ScaledKernel<D>, spacing: f64) -> Self {
        let viscosity = ArtificialViscosity { alpha: 0.5, beta: 0.0 };
        let artificial_stress = ARTIFICIAL_STRESS_FACTOR;
        Self {
            form: UpdatedForm::Paper,
            kernel,
            spacing,
            artificial_stress,
            viscosity,
            hourglass_viscosity: 0.0,
        }
    }

    /// Corrected gradients, no artificial stress, viscosity on zero-energy modes 0.4.
    #[must_use]
    pub fn corrected(kernel: ScaledKernel<D>, spacing: f64) -> Self {
        let viscosity = ArtificialViscosity { alpha: 0.0, beta: 0.0 };
        let form = UpdatedForm::Corrected;
        Self { form, kernel, spacing, artificial_stress: 0.0, viscosity, hourglass_viscosity: 0.4 }
    }

    fn check(&self) -> Result<(), Error> {
        require(self.spacing > 0.0, "spacing", self.spacing, "positive, in metres")?;
        for (name, value) in [
            ("artificial_stress", self.artificial_stress),
            ("viscosity alpha", self.viscosity.alpha),
            ("viscosity beta", self.viscosity.beta),
            ("hourglass_viscosity", self.hourglass_viscosity),
        ] {
            require(value >= 0.0, name, value, "zero or above")?;
        }
        Ok(())
    }
}

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
/// For the classic tests, for what breaks and for the mush; the total-Lagrangian form is faster and more accurate.
#[derive(Clone, Debug)]
pub struct UpdatedLagrangian<const D: usize> {
    controls: UpdatedControls<D>,
    material: Material,
    volumes: Vec<f64>,
    corrections: Vec<SMatrix<f64, D, D>>,
    gradients: Vec<SMatrix<f64, D, D>>,
    tensors: Vec<SMatrix<f64, D, D>>,
    repulsions: Vec<SMatrix<f64, D, D>>,
}

impl<const D: usize> UpdatedLagrangian<D> {
    /// A body of `particles` particles.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a spacing that is not positive or a coefficient that is negative.
    pub fn new(particles: usize, material: Material, controls: UpdatedControls<D>) -> Result<Self, Error> {
        controls.check()?;
        let zeros = vec![SMatrix::zeros(); particles];
        Ok(Self {
            controls,
            material,
            volumes: vec![0.0; particles],
            corrections: vec![SMatrix::identity(); particles],
            gradients: zeros.clone(),
            tensors: zeros.clone(),
            repulsions: zeros,
        })
    }

    /// Velocity gradients \[1/s\] at the end of the last step.
    #[must_use]
    pub fn gradients(&self) -> &[SMatrix<f64, D, D>] {
        &self.gradients
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
        let reference = self.material.expansion.reference_density(temperature_k);
        let pressure = pressure(self.material.solver_moduli().bulk_pa(), density, reference);
        *deviator - SymmetricTensor::isotropic(pressure)
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
        assert_eq!(fields.positions.len(), self.volumes.len(), "positions");
        assert_eq!(accelerations.len(), self.volumes.len(), "accelerations");
        for i in 0..self.volumes.len() {
            self.volumes[i] = fields.masses[i] / state.densities[i];
        }
        self.measure_gradients(fields);
        self.advance(fields, state, dt_s);
        self.sum_forces(fields, state.densities, accelerations);
    }

    /// First pass: B and the velocity gradients at the end positions.
    fn measure_gradients(&mut self, fields: &UpdatedFields<'_, D>) {
        let (controls, volumes) = (&self.controls, &self.volumes);
        let columns = self.gradients.par_iter_mut().zip(self.corrections.par_iter_mut()).enumerate();
        columns.for_each_init(RowBuffer::default, |buffer, (i, (gradient, correction))| {
            let row = buffer.fill(i, neighbors(fields, i), fields.positions, &controls.kernel);
            if controls.form == UpdatedForm::Corrected {
                *correction = regularised_inverse(&moment(&row, volumes));
            }
            *gradient = velocity_gradient(&row, volumes, fields.velocities, correction);
        });
    }

    /// Density, deviator and yield of every particle; then the tensors of the forces.
    fn advance(&mut self, fields: &UpdatedFields<'_, D>, state: &mut UpdatedState<'_, D>, dt_s: f64) {
        let shear_pa = self.material.solver_moduli().shear_pa();
        for i in 0..self.volumes.len() {
            let mid = midpoint_gradient(&self.gradients[i], dt_s);
            state.densities[i] *= density_ratio(&mid, dt_s);
            let deviator = &mut state.deviators[i];
            *deviator = advanced_deviator(deviator, &mid, shear_pa, dt_s);
            if self.material.yield_stress.is_some() {
                let yield_pa = self.material.solver_yield_pa(fields.temperatures[i]);
                if let Some(step) = radial_return(deviator, shear_pa, yield_pa) {
                    *deviator = *deviator * step.scale;
                    state.equivalents[i] += step.equivalent;
                }
            }
            let stress =
                self.stress(state.densities[i], fields.temperatures[i], &state.deviators[i]).in_plane;
            let density = state.densities[i];
            self.tensors[i] = stress * self.corrections[i] / (density * density);
            if self.controls.artificial_stress > 0.0 {
                self.repulsions[i] = artificial_stress(&stress, density, self.controls.artificial_stress);
            }
        }
    }

    /// Second pass: the divergence of stress and what is added to it.
    fn sum_forces(
        &self,
        fields: &UpdatedFields<'_, D>,
        densities: &[f64],
        accelerations: &mut [SVector<f64, D>],
    ) {
        let controls = &self.controls;
        let value_at_spacing = controls.kernel.value(controls.spacing);
        let density = densities.first().copied().unwrap_or(1.0);
        let damping = DampingColumns {
            masses: fields.masses,
            densities,
            velocities: fields.velocities,
            gradients: &self.gradients,
            wave_speed: pressure_wave_speed(self.material.solver_moduli(), density),
        };
        accelerations.par_iter_mut().enumerate().for_each_init(RowBuffer::default, |buffer, (i, sum)| {
            let row = buffer.fill(i, neighbors(fields, i), fields.positions, &controls.kernel);
            *sum = stress_acceleration(&row, fields.masses, &self.tensors);
            if controls.artificial_stress > 0.0 {
                let exponent = ARTIFICIAL_STRESS_EXPONENT;
                let repulsions = &self.repulsions;
                *sum += artificial_stress_acceleration(
                    &row,
                    fields.masses,
                    repulsions,
                    value_at_spacing,
                    exponent,
                );
            }
            if controls.viscosity.alpha > 0.0 || controls.viscosity.beta > 0.0 {
                *sum += viscous_acceleration(&row, &damping, &controls.kernel, &controls.viscosity);
            }
            if controls.hourglass_viscosity > 0.0 {
                *sum += hourglass_viscosity(&row, &damping, &controls.kernel, controls.hourglass_viscosity);
            }
        });
    }
}

/// The row of the list of particle `i`.
fn neighbors<'a, const D: usize>(fields: &UpdatedFields<'a, D>, i: usize) -> &'a [u32] {
    &fields.list_neighbors[fields.list_starts[i]..fields.list_starts[i + 1]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::IsotropicModuli;
    use sph_kernel::KernelKind;

    #[test]
    fn bad_controls_are_named() {
        let kernel = KernelKind::WendlandC2.with_smoothing_length::<2>(1.0);
        let moduli = IsotropicModuli::from_young_and_poisson(1.0, 0.3).unwrap();
        let material = Material::elastic(moduli, 1.0).unwrap();
        let message = |controls| {
            UpdatedLagrangian::new(1, material.clone(), controls).map(|_| ()).unwrap_err().to_string()
        };
        let controls = UpdatedControls { artificial_stress: -0.3, ..UpdatedControls::paper(kernel, 1.0) };
        assert_eq!(message(controls), "artificial_stress is -0.3, but must be zero or above");
        assert!(message(UpdatedControls::corrected(kernel, 0.0)).starts_with("spacing is 0"));
    }
}
