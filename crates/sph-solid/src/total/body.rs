//! The stand-alone sweep of the total-Lagrangian form.

use super::lanes::{Columns, Lanes, columns, matrix};
use super::links::BLOCK;
use super::material::{Controls, Material};
use super::point::{PointLaw, viscous_force};
use super::reference::{Reference, ReferenceColumns};
use crate::error::Error;
use crate::laws::small::{determinant, inverse};
use crate::{
    ArtificialViscosity, SymmetricTensor, cauchy_stress, elastic_energy, elastic_strain, pressure_wave_speed,
    second_stress, stable_step,
};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use sph_kernel::KernelKind;

/// What the forces depend on, one entry per particle.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'a, const D: usize> {
    /// Displacements u = x - X \[m\].
    pub displacements: &'a [SVector<f64, D>],
    /// Velocities \[m/s\]; read only by the artificial viscosity, and may be empty without it.
    pub velocities: &'a [SVector<f64, D>],
    /// Temperatures \[K\].
    pub temperatures: &'a [f64],
}

/// Strain that gives no stress, one entry per particle; saved and restored with the run.
#[derive(Debug)]
pub struct Inelastic<'a, const D: usize> {
    /// Plastic strain and strain of stress brought in ([`strain_of_stress`](crate::strain_of_stress)) \[-\], in the axes
    /// of the reference.
    pub strains: &'a mut [SymmetricTensor<D>],
    /// Accumulated equivalent plastic strain \[-\].
    pub equivalents: &'a mut [f64],
}

/// A body in the total-Lagrangian form: fixed pairs, F from displacements, energy-conjugate forces.
///
/// The caller owns displacements, velocities, temperatures and inelastic strain, and steps them; the body owns what follows
/// from them. Particles in the order of a spatial sort are fastest.
#[derive(Clone, Debug)]
pub struct TotalLagrangian<const D: usize> {
    reference: Reference<D>,
    material: Material,
    controls: Controls,
    masses: Vec<f64>,
    /// ln of the free stretch at the reference temperature.
    reference_stretches: Vec<f64>,
    moved: Vec<Lanes>,
    speeds: Vec<Lanes>,
    deformations: Vec<SMatrix<f64, D, D>>,
    /// Sums for F, then P B - c/2 (F - 1) \[Pa\], c the hourglass modulus.
    tensors: Vec<Columns<D>>,
    forces: Vec<Lanes>,
    /// Work of yield in the last evaluation \[J; J/m in plane strain\].
    plastic_works: Vec<f64>,
    heat: RateBuffer<D>,
}

/// What [`TotalLagrangian::gough_joule_heats`] works in.
#[derive(Clone, Debug, Default)]
struct RateBuffer<const D: usize> {
    velocities: Vec<Lanes>,
    sums: Vec<Columns<D>>,
}

impl<const D: usize> TotalLagrangian<D> {
    /// Prepares pairs and corrections.
    ///
    /// # Errors
    /// Columns of unequal length, values out of range, or a neighbour list that is not a full one.
    pub fn new(
        columns: &ReferenceColumns<'_, D>,
        kernel: KernelKind,
        material: Material,
        controls: Controls,
    ) -> Result<Self, Error> {
        const { assert!(D == 2 || D == 3, "bodies have 2 or 3 dimensions") };
        controls.check()?;
        let reference = Reference::new(columns, kernel)?;
        let particles = columns.positions.len();
        let stretch = |&temperature: &f64| material.expansion.logarithmic_stretch(temperature);
        let viscous = if controls.viscosity > 0.0 { particles } else { 0 };
        Ok(Self {
            reference,
            masses: columns.masses.to_vec(),
            reference_stretches: columns.temperatures.iter().map(stretch).collect(),
            moved: vec![Lanes::default(); particles],
            speeds: vec![Lanes::default(); viscous],
            deformations: vec![SMatrix::identity(); particles],
            tensors: vec![[Lanes::default(); D]; particles],
            forces: vec![Lanes::default(); particles],
            plastic_works: vec![0.0; particles],
            heat: RateBuffer::default(),
            material,
            controls,
        })
    }

    /// Masses \[kg; kg/m in plane strain\].
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// Deformation gradients F \[-\] of the last call of [`TotalLagrangian::accelerations`].
    #[must_use]
    pub fn deformations(&self) -> &[SMatrix<f64, D, D>] {
        &self.deformations
    }

    /// Present density of a particle \[kg/m^3\]: m/(V_0 det F), F of the last call of [`TotalLagrangian::accelerations`].
    #[must_use]
    pub fn density(&self, particle: usize) -> f64 {
        let start = self.masses[particle] * self.reference.inverse_volumes[particle];
        start / determinant(&self.deformations[particle])
    }

    /// Number of stored pairs: each is visited twice a step.
    #[must_use]
    pub fn stored_pairs(&self) -> usize {
        self.reference.links.len()
    }

    /// The longest stable step \[s\], `factor` h/c_P for the smallest h; see [`stable_step`].
    #[must_use]
    pub fn stable_step(&self, factor: f64) -> f64 {
        let smallest = self.reference.smoothing_lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let density = (0..self.masses.len())
            .map(|i| self.masses[i] * self.reference.inverse_volumes[i])
            .fold(f64::INFINITY, f64::min);
        stable_step(smallest, pressure_wave_speed(self.material.solver_moduli(), density), factor)
    }

    /// Writes the accelerations \[m/s^2\] of internal forces. Call it once a step: where stress exceeds the yield stress,
    /// it moves strain into `inelastic`.
    ///
    /// # Panics
    /// If a column has not one entry per particle.
    pub fn accelerations(
        &mut self,
        motion: &Motion<'_, D>,
        inelastic: &mut Inelastic<'_, D>,
        accelerations: &mut [SVector<f64, D>],
    ) {
        let particles = self.masses.len();
        assert_eq!(motion.displacements.len(), particles, "displacements");
        assert_eq!(motion.temperatures.len(), particles, "temperatures");
        assert_eq!(inelastic.strains.len(), particles, "inelastic strains");
        assert_eq!(inelastic.equivalents.len(), particles, "equivalent plastic strains");
        assert_eq!(accelerations.len(), particles, "accelerations");
        assert!(self.speeds.is_empty() || motion.velocities.len() == particles, "velocities");
        self.gather(motion);
        self.update_stresses(motion.temperatures, inelastic);
        self.sum_forces();
        let (forces, masses) = (&self.forces, &self.masses);
        accelerations.par_iter_mut().with_min_len(BLOCK).enumerate().for_each(|(i, acceleration)| {
            *acceleration = forces[i].vector::<D>() / masses[i];
        });
    }

    /// Copies what pairs read into padded columns, densities and smoothing lengths beside.
    fn gather(&mut self, motion: &Motion<'_, D>) {
        let (reference, masses) = (&self.reference, &self.masses);
        self.moved.par_iter_mut().with_min_len(BLOCK).enumerate().for_each(|(i, moved)| {
            *moved = Lanes::new(&motion.displacements[i], masses[i] * reference.inverse_volumes[i]);
        });
        for (i, speed) in self.speeds.iter_mut().enumerate() {
            *speed = Lanes::new(&motion.velocities[i], reference.smoothing_lengths[i]);
        }
    }

    /// First pass: F and, from it, the tensors that the forces are made of.
    fn update_stresses(&mut self, temperatures: &[f64], inelastic: &mut Inelastic<'_, D>) {
        let (reference, moved) = (&self.reference, &self.moved);
        let point = PointLaw::new(&self.material, &self.controls);
        let reference_stretches = &self.reference_stretches;
        self.tensors
            .par_chunks_mut(BLOCK)
            .zip(self.deformations.par_chunks_mut(BLOCK))
            .zip(inelastic.strains.par_chunks_mut(BLOCK))
            .zip(inelastic.equivalents.par_chunks_mut(BLOCK))
            .zip(self.plastic_works.par_chunks_mut(BLOCK))
            .enumerate()
            .for_each(|(block, ((((tensors, deformations), strains), equivalents), works))| {
                let first = block * BLOCK;
                reference.links.gradient_sums(first, moved, tensors);
                for k in 0..tensors.len() {
                    let i = first + k;
                    let correction = &reference.corrections[i];
                    let gradient = matrix(&tensors[k]) * correction * reference.inverse_volumes[i];
                    deformations[k] = SMatrix::identity() + gradient;
                    let temperature = temperatures[i];
                    let stretch = point.stretch(temperature, reference_stretches[i]);
                    let stress = point.update(
                        &deformations[k],
                        stretch,
                        temperature,
                        &mut strains[k],
                        &mut equivalents[k],
                        &mut works[k],
                    );
                    works[k] /= reference.inverse_volumes[i];
                    let hourglass = gradient * (0.5 * point.hourglass_modulus);
                    tensors[k] = columns(&(stress * correction - hourglass));
                }
            });
    }

    /// Second pass: V_i V_j (P_i B_i + P_j B_j) grad0 W, the hourglass force and the viscosity.
    ///
    /// The hourglass force -c k e with e = u_i - u_j + d - (F_i + F_j)/2 d and k d = -V_i V_j grad0 W splits into
    /// -c k (u_i - u_j) and terms of one particle each, which the tensors already hold.
    fn sum_forces(&mut self) {
        let (links, moved, tensors, speeds) =
            (&self.reference.links, &self.moved, &self.tensors, &self.speeds);
        let modulus = PointLaw::new(&self.material, &self.controls).hourglass_modulus;
        let pull = |i: usize| {
            let (here, place) = (tensors[i], moved[i]);
            move |j: usize, weight: Lanes| {
                let there = &tensors[j];
                let mut force = (moved[j] - place) * (modulus * weight.scalar());
                for axis in 0..D {
                    force = (here[axis] + there[axis]).times_plus(weight.0[axis], force);
                }
                force
            }
        };
        let law = ArtificialViscosity { alpha: self.controls.viscosity, beta: 0.0 };
        let sound = self.wave_speed();
        let damped = |i: usize| {
            let pull = pull(i);
            move |j: usize, weight: Lanes| {
                let (moved, speeds) = ([moved[i], moved[j]], [speeds[i], speeds[j]]);
                pull(j, weight) + viscous_force::<D>(&law, sound, moved, speeds, weight)
            }
        };
        let viscous = !speeds.is_empty();
        self.forces.par_chunks_mut(BLOCK).enumerate().for_each(|(block, forces)| {
            forces.fill(Lanes::default());
            if viscous {
                links.add_forces(block * BLOCK, forces, damped);
            } else {
                links.add_forces(block * BLOCK, forces, pull);
            }
        });
    }

    fn wave_speed(&self) -> f64 {
        let density = self.masses.first().map_or(1.0, |mass| mass * self.reference.inverse_volumes[0]);
        pressure_wave_speed(self.material.solver_moduli(), density)
    }

    /// Writes the Cauchy stress in true units \[Pa\], out-of-plane component of plane strain beside, for the deformation of
    /// the last call of [`TotalLagrangian::accelerations`] and the same temperatures and inelastic strains.
    ///
    /// # Panics
    /// If a column has not one entry per particle.
    pub fn stresses(
        &self,
        temperatures: &[f64],
        inelastic_strains: &[SymmetricTensor<D>],
        in_plane: &mut [SMatrix<f64, D, D>],
        out_of_plane: &mut [f64],
    ) {
        assert!(in_plane.len() == self.masses.len() && out_of_plane.len() == self.masses.len());
        let point = PointLaw::new(&self.material, &self.controls);
        for i in 0..self.masses.len() {
            let stretch = point.stretch(temperatures[i], self.reference_stretches[i]);
            let strain = elastic_strain(&self.deformations[i], stretch) - inelastic_strains[i];
            let second = second_stress(&strain, self.material.solver_moduli());
            let stress =
                self.material.sound.reported(&cauchy_stress(&self.deformations[i], stretch, &second));
            in_plane[i] = stress.in_plane;
            out_of_plane[i] = stress.out_of_plane;
        }
    }

    /// Elastic energy and energy of the hourglass control \[J; J/m in plane strain\], in the units of the solver (true ones
    /// times K_eff/K), for the state of the last call of [`TotalLagrangian::accelerations`].
    #[must_use]
    pub fn energies(&self, temperatures: &[f64], inelastic_strains: &[SymmetricTensor<D>]) -> (f64, f64) {
        let point = PointLaw::new(&self.material, &self.controls);
        let mut hourglass = 0.0;
        self.reference.links.for_each(|i, j, weight, both| {
            let unseen = |k: usize| self.unseen(i, j, k, weight).norm_squared() * weight.scalar();
            hourglass += 0.25 * point.hourglass_modulus * (unseen(i) + if both { unseen(j) } else { 0.0 });
        });
        (self.elastic_energy(self.masses.len(), temperatures, inelastic_strains), hourglass)
    }

    /// Elastic energy of the first `particles` particles, as [`TotalLagrangian::energies`] has it.
    #[must_use]
    pub fn elastic_energy(
        &self,
        particles: usize,
        temperatures: &[f64],
        inelastic_strains: &[SymmetricTensor<D>],
    ) -> f64 {
        let point = PointLaw::new(&self.material, &self.controls);
        let elastic = |i: usize| {
            let stretch = point.stretch(temperatures[i], self.reference_stretches[i]);
            let strain = elastic_strain(&self.deformations[i], stretch) - inelastic_strains[i];
            elastic_energy(&strain, stretch, self.material.solver_moduli())
                / self.reference.inverse_volumes[i]
        };
        (0..particles).map(elastic).sum()
    }

    /// Work of yield in the last call of [`TotalLagrangian::accelerations`], one entry per particle \[J; J/m in plane
    /// strain\], in the units of the solver: stress times what it added to the plastic strain.
    #[must_use]
    pub fn plastic_works(&self) -> &[f64] {
        &self.plastic_works
    }

    /// Power that the artificial viscosity of the last call of [`TotalLagrangian::accelerations`] takes from particles
    /// with these `velocities` \[W; W/m in plane strain\].
    ///
    /// The velocities at the end of a kick-drift-kick step are the mean over all that its forces do: power times step is
    /// then the work without an error of the step.
    #[must_use]
    pub fn viscous_power(&self, velocities: &[SVector<f64, D>]) -> f64 {
        let law = ArtificialViscosity { alpha: self.controls.viscosity, beta: 0.0 };
        let (moved, speeds, sound, mut power) = (&self.moved, &self.speeds, self.wave_speed(), 0.0);
        if !speeds.is_empty() {
            self.reference.links.for_each(|i, j, weight, both| {
                let force =
                    viscous_force::<D>(&law, sound, [moved[i], moved[j]], [speeds[i], speeds[j]], weight);
                let taken = -force.vector::<D>().dot(&(velocities[i] - velocities[j]));
                power += if both { taken } else { 0.5 * taken };
            });
        }
        power
    }

    /// Writes the heat -3 K alpha T V tr(dF/dt F^-1) \[W; W/m in plane strain\] that each particle gets from the change of
    /// its volume ([`gough_joule_rate`](crate::gough_joule_rate) times rho c V), for a solver of heat that works with the
    /// capacity at constant strain.
    ///
    /// For the deformation of the last call of [`TotalLagrangian::accelerations`]. K and alpha are true ones, and the rate
    /// is that of the whole strain, free expansion included. Memory is kept from one call to the next.
    ///
    /// # Panics
    /// If a column has not one entry per particle.
    pub fn gough_joule_heats(
        &mut self,
        velocities: &[SVector<f64, D>],
        temperatures: &[f64],
        heats: &mut [f64],
    ) {
        let particles = self.masses.len();
        assert_eq!(velocities.len(), particles, "velocities");
        assert_eq!(temperatures.len(), particles, "temperatures");
        assert_eq!(heats.len(), particles, "heats");
        let Self { reference, deformations, material, heat, .. } = self;
        let RateBuffer { velocities: lanes, sums } = heat;
        lanes.clear();
        lanes.extend(velocities.iter().map(|velocity| Lanes::new(velocity, 0.0)));
        sums.resize(particles, [Lanes::default(); D]);
        let bulk_pa = material.sound.real().bulk_pa();
        let blocks = heats.par_chunks_mut(BLOCK).zip(sums.par_chunks_mut(BLOCK)).enumerate();
        blocks.for_each(|(block, (heats, sums))| {
            let first = block * BLOCK;
            reference.links.gradient_sums(first, lanes, sums);
            for k in 0..heats.len() {
                let i = first + k;
                // V_0 dF/dt.
                let rate = matrix(&sums[k]) * reference.corrections[i];
                let deformation = &deformations[i];
                let growth = determinant(deformation) * (rate * inverse(deformation)).trace();
                let alpha = material.expansion.coefficient(temperatures[i]);
                heats[k] = -3.0 * bulk_pa * alpha * temperatures[i] * growth;
            }
        });
    }

    /// x_i - x_j - F_k (X_i - X_j) \[m\].
    fn unseen(&self, i: usize, j: usize, k: usize, weight: Lanes) -> SVector<f64, D> {
        let apart = weight.vector::<D>() / -weight.scalar();
        (self.moved[i] - self.moved[j]).vector::<D>() + apart - self.deformations[k] * apart
    }
}
