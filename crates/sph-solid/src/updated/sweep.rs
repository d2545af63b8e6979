//! The stand-alone sweep of the updated-Lagrangian form.

use crate::error::{Error, require};
use crate::total::lanes::{Columns, Lanes, columns, matrix};
use crate::total::links::{BLOCK, Links, ListBuffer};
use crate::{
    ARTIFICIAL_STRESS_EXPONENT, ARTIFICIAL_STRESS_FACTOR, ArtificialViscosity, Material, SymmetricTensor,
    advanced_deviator, artificial_stress, artificial_stress_weight, density_ratio, midpoint_gradient,
    pressure, pressure_wave_speed, radial_return,
};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use sph_kernel::ScaledKernel;
use sph_kernel::operators::regularised_inverse;

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
/// For the classic tests, for what breaks and for the mush; the total-Lagrangian form is faster and more accurate. The
/// sweep gives what the row functions of this module give; particles in the order of a spatial sort are fastest.
#[derive(Clone, Debug)]
pub struct UpdatedLagrangian<const D: usize> {
    controls: UpdatedControls<D>,
    material: Material,
    /// Positions \[m\], volumes \[m^D\] beside.
    places: Vec<Lanes>,
    /// Velocities \[m/s\].
    speeds: Vec<Lanes>,
    points: Vec<Point<D>>,
    repulsions: Vec<Columns<D>>,
    forces: Vec<Lanes>,
    blocks: Vec<Block<D>>,
}

/// What the forces read of one particle, together in memory.
#[derive(Clone, Copy, Debug)]
struct Point<const D: usize> {
    /// Velocity \[m/s\] and, beside it, the density at the end of the step \[kg/m^3\].
    speed: Lanes,
    /// Velocity gradient L \[1/s\].
    gradient: Columns<D>,
    /// sigma B/rho^2 \[Pa m^6/kg^2\] and, beside its first column, the density \[kg/m^3\] of the volumes in the weights.
    tensor: Columns<D>,
}

/// Pairs of a block of particles at their present positions, and the sums that they give.
#[derive(Clone, Debug)]
struct Block<const D: usize> {
    links: Links,
    buffer: ListBuffer,
    moments: Vec<Columns<D>>,
    gradients: Vec<Columns<D>>,
}

impl<const D: usize> UpdatedLagrangian<D> {
    /// A body of `particles` particles.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a spacing that is not positive or a coefficient that is negative.
    pub fn new(particles: usize, material: Material, controls: UpdatedControls<D>) -> Result<Self, Error> {
        controls.check()?;
        let zero = [Lanes::default(); D];
        let block = |first: usize| {
            let sums = vec![zero; BLOCK.min(particles - first)];
            let (links, buffer) = (Links::new(first, sums.len()), ListBuffer::default());
            Block { links, buffer, moments: sums.clone(), gradients: sums }
        };
        Ok(Self {
            controls,
            material,
            places: vec![Lanes::default(); particles],
            speeds: vec![Lanes::default(); particles],
            points: vec![Point { speed: Lanes::default(), gradient: zero, tensor: zero }; particles],
            repulsions: vec![zero; particles],
            forces: vec![Lanes::default(); particles],
            blocks: (0..particles).step_by(BLOCK).map(block).collect(),
        })
    }

    /// Velocity gradient of a particle \[1/s\] at the end of the last step.
    #[must_use]
    pub fn gradient(&self, particle: usize) -> SMatrix<f64, D, D> {
        matrix(&self.points[particle].gradient)
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
        self.advance(fields, state, dt_s);
        self.sum_forces(state.densities.first().copied().unwrap_or(1.0));
        let forces = accelerations.par_iter_mut().zip(&self.forces).zip(fields.masses);
        forces.with_min_len(BLOCK).for_each(|((acceleration, force), mass)| {
            *acceleration = force.vector::<D>() / *mass;
        });
    }

    /// Copies what pairs read into padded columns.
    fn gather(&mut self, fields: &UpdatedFields<'_, D>, densities: &[f64]) {
        let both = self.places.par_iter_mut().zip(&mut self.speeds).with_min_len(BLOCK);
        both.enumerate().for_each(|(i, (place, speed))| {
            *place = Lanes::new(&fields.positions[i], fields.masses[i] / densities[i]);
            *speed = Lanes::new(&fields.velocities[i], 0.0);
        });
    }

    /// First pass: pairs, B and the velocity gradients at the end positions; with them density, deviator and yield; then
    /// what the forces read.
    fn advance(&mut self, fields: &UpdatedFields<'_, D>, state: &mut UpdatedState<'_, D>, dt_s: f64) {
        let Self { controls, material, places, speeds, .. } = self;
        let corrected = controls.form == UpdatedForm::Corrected;
        let shear_pa = material.solver_moduli().shear_pa();
        self.blocks
            .par_iter_mut()
            .zip(self.points.par_chunks_mut(BLOCK))
            .zip(self.repulsions.par_chunks_mut(BLOCK))
            .zip(state.densities.par_chunks_mut(BLOCK))
            .zip(state.deviators.par_chunks_mut(BLOCK))
            .zip(state.equivalents.par_chunks_mut(BLOCK))
            .enumerate()
            .for_each(|(number, (((((block, points), repulsions), densities), deviators), equivalents))| {
                let first = number * BLOCK;
                block.sum(first, places, speeds, corrected, |i| neighbors(fields, i), &controls.kernel);
                for k in 0..points.len() {
                    let i = first + k;
                    let volume = places[i].scalar();
                    let correction = if corrected {
                        regularised_inverse(&(matrix(&block.moments[k]) / volume))
                    } else {
                        SMatrix::identity()
                    };
                    let gradient = matrix(&block.gradients[k]) * correction / volume;
                    let mid = midpoint_gradient(&gradient, dt_s);
                    let listed_density = densities[k];
                    let density = listed_density * density_ratio(&mid, dt_s);
                    let mut deviator = advanced_deviator(&deviators[k], &mid, shear_pa, dt_s);
                    if material.yield_stress.is_some() {
                        let yield_pa = material.solver_yield_pa(fields.temperatures[i]);
                        if let Some(step) = radial_return(&deviator, shear_pa, yield_pa) {
                            deviator = deviator * step.scale;
                            equivalents[k] += step.equivalent;
                        }
                    }
                    (densities[k], deviators[k]) = (density, deviator);
                    let stress = stress(material, density, fields.temperatures[i], &deviator).in_plane;
                    let mut tensor = columns(&(stress * correction / (density * density)));
                    tensor[0].0[3] = listed_density;
                    let speed = Lanes::new(&fields.velocities[i], density);
                    points[k] = Point { speed, gradient: columns(&gradient), tensor };
                    if controls.artificial_stress > 0.0 {
                        repulsions[k] =
                            columns(&artificial_stress(&stress, density, controls.artificial_stress));
                    }
                }
            });
    }

    /// Second pass: the divergence of stress and what is added to it, as forces \[N; N/m in plane strain\].
    fn sum_forces(&mut self, density: f64) {
        let (controls, places, points, repulsions) =
            (&self.controls, &self.places, &self.points, &self.repulsions);
        let wave_speed = pressure_wave_speed(self.material.solver_moduli(), density);
        let length = controls.kernel.smoothing_length();
        let hourglass = controls.hourglass_viscosity * wave_speed * length;
        let viscous = controls.viscosity.alpha > 0.0 || controls.viscosity.beta > 0.0;
        let repulsive = controls.artificial_stress > 0.0;
        let value_at_spacing = controls.kernel.value(controls.spacing);
        // All of them for m_i m_j = V_i V_j times the densities of these volumes, but without these densities.
        let pull = |here: &Point<D>, there: &Point<D>, weight: Lanes| {
            let damping = 2.0 * hourglass / (here.speed + there.speed).scalar();
            let mut force = (there.speed - here.speed) * (damping * weight.scalar());
            for axis in 0..D {
                let tensor = here.tensor[axis] + there.tensor[axis];
                let twice_mean = here.gradient[axis] + there.gradient[axis];
                force = twice_mean.times_plus(-0.5 * damping, tensor).times_plus(weight.0[axis], force);
            }
            force
        };
        let added = |i: usize, j: usize, weight: Lanes| {
            let separation = (places[i] - places[j]).vector::<D>();
            let (here, there) = (points[i].speed, points[j].speed);
            let relative = (here - there).vector::<D>();
            let density = 0.5 * (here + there).scalar();
            let pi = controls.viscosity.pair(&separation, &relative, length, wave_speed, density);
            let mut force = weight * -pi;
            if repulsive {
                let value = controls.kernel.value(separation.norm());
                let share = artificial_stress_weight(value, value_at_spacing, ARTIFICIAL_STRESS_EXPONENT);
                for axis in 0..D {
                    let both = repulsions[i][axis] + repulsions[j][axis];
                    force = both.times_plus(share * weight.0[axis], force);
                }
            }
            force
        };
        let densities =
            |here: &Point<D>, there: &Point<D>| here.tensor[0].scalar() * there.tensor[0].scalar();
        let conjugate = |i: usize| {
            let here = points[i];
            move |j: usize, weight: Lanes| pull(&here, &points[j], weight) * densities(&here, &points[j])
        };
        let damped = |i: usize| {
            let here = points[i];
            move |j: usize, weight: Lanes| {
                let force = pull(&here, &points[j], weight) + added(i, j, weight);
                force * densities(&here, &points[j])
            }
        };
        let blocks = self.blocks.par_iter().zip(self.forces.par_chunks_mut(BLOCK)).enumerate();
        blocks.for_each(|(number, (block, forces))| {
            forces.fill(Lanes::default());
            if viscous || repulsive {
                block.links.add_forces(number * BLOCK, forces, damped);
            } else {
                block.links.add_forces(number * BLOCK, forces, conjugate);
            }
        });
    }
}

impl<const D: usize> Block<D> {
    /// Finds the pairs and sums what they give to the moments, where these are `wanted`, and to the velocity gradients.
    fn sum<'a>(
        &mut self,
        first: usize,
        places: &[Lanes],
        speeds: &[Lanes],
        wanted: bool,
        list: impl Fn(usize) -> &'a [u32],
        kernel: &ScaledKernel<D>,
    ) {
        let Self { links, buffer, moments, gradients } = self;
        links.clear();
        moments.fill([Lanes::default(); D]);
        gradients.fill([Lanes::default(); D]);
        for i in first..first + gradients.len() {
            links.push_listed(list(i), places, kernel, buffer);
            if wanted {
                links.add_gradients(i, first, places, moments);
            }
            links.add_gradients(i, first, speeds, gradients);
        }
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
