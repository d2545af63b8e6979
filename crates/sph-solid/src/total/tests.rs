//! The sweep against the plain row functions, and what both must conserve.

use super::*;
use crate::{
    IsotropicModuli, SymmetricTensor, ThermalExpansion, elastic_strain, first_stress, second_stress,
};
use nalgebra::{SMatrix, SVector};
use sph_kernel::operators::{moment, regularised_inverse};
use sph_kernel::{KernelKind, RowBuffer};
use sph_neighbors::{NeighborList, PairReach, SearchMethod};

const KERNEL: KernelKind = KernelKind::Gaussian;

/// A slightly disordered block of `count`^D particles, spacing 1, with a body in it.
struct Block<const D: usize> {
    positions: Vec<SVector<f64, D>>,
    volumes: Vec<f64>,
    temperatures: Vec<f64>,
    list: NeighborList,
    lengths: Vec<f64>,
    material: Material,
    controls: Controls,
}

/// A number in -1..1 that looks random.
fn noise(seed: usize) -> f64 {
    2.0 * ((seed as f64 * 12.9898).sin() * 43_758.547).rem_euclid(1.0) - 1.0
}

impl<const D: usize> Block<D> {
    fn new(count: usize, controls: Controls) -> Self {
        let at = |k: usize, axis: usize| (k / count.pow(axis as u32)) % count;
        let positions: Vec<_> = (0..count.pow(D as u32))
            .map(|k| SVector::from_fn(|axis, _| at(k, axis) as f64 + 0.1 * noise(7 * k + axis)))
            .collect();
        let volumes = (0..positions.len()).map(|k| 1.0 + 0.1 * noise(k + 31)).collect();
        let temperatures = (0..positions.len()).map(|k| 293.0 + 30.0 * noise(k)).collect();
        let lengths = vec![0.9; positions.len()];
        let list = SearchMethod::default().find(&positions, PairReach::Uniform(2.8)).unwrap();
        let moduli = IsotropicModuli::from_young_and_poisson(1.0, 0.33).unwrap();
        let mut material = Material::elastic(moduli, 1.0).unwrap();
        material.expansion = ThermalExpansion::constant(1.0, 293.0, 1e-4).unwrap();
        Self { positions, volumes, temperatures, list, lengths, material, controls }
    }

    fn body(&self) -> TotalLagrangian<D> {
        let columns = ReferenceColumns {
            positions: &self.positions,
            volumes: &self.volumes,
            masses: &self.volumes,
            temperatures: &vec![293.0; self.positions.len()],
            smoothing_lengths: &self.lengths,
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
        };
        TotalLagrangian::new(&columns, KERNEL, self.material.clone(), self.controls).unwrap()
    }

    /// Accelerations, and elastic plus hourglass energy.
    fn run(
        &self,
        body: &mut TotalLagrangian<D>,
        displacements: &[SVector<f64, D>],
        velocities: &[SVector<f64, D>],
    ) -> (Vec<SVector<f64, D>>, f64) {
        let particles = self.positions.len();
        let motion = Motion { displacements, velocities, temperatures: &self.temperatures };
        let mut strains = vec![SymmetricTensor::zero(); particles];
        let mut equivalents = vec![0.0; particles];
        let mut inelastic = Inelastic { strains: &mut strains, equivalents: &mut equivalents };
        let mut accelerations = vec![SVector::zeros(); particles];
        body.accelerations(&motion, &mut inelastic, &mut accelerations);
        let (elastic, hourglass) = body.energies(&self.temperatures, &strains);
        (accelerations, elastic + hourglass)
    }

    fn wild(&self) -> Vec<SVector<f64, D>> {
        let displacement = |k: usize| SVector::from_fn(|axis, _| 0.05 * noise(3 * k + 100 * axis));
        (0..self.positions.len()).map(displacement).collect()
    }
}

const WITHOUT: Controls = Controls { hourglass: 0.0, viscosity: 0.0 };
const FULL: Controls = Controls { hourglass: 0.3, viscosity: 0.0 };

fn sweep_against_rows<const D: usize>(count: usize) {
    let block = Block::<D>::new(count, FULL);
    let (mut body, displacements) = (block.body(), block.wild());
    let (accelerations, _) = block.run(&mut body, &displacements, &[]);
    let mut buffer = RowBuffer::default();
    let moduli = *block.material.solver_moduli();
    let (mut deformations, mut stresses) = (Vec::new(), Vec::new());
    for i in 0..block.positions.len() {
        let row =
            buffer.fill_with_mean_lengths(i, block.list.row(i), &block.positions, &block.lengths, KERNEL);
        let correction = regularised_inverse(&moment(&row, &block.volumes));
        let f = deformation_gradient(&row, &block.volumes, &displacements, &correction);
        let stretch = block.material.expansion.stretch(293.0, block.temperatures[i]);
        let stress = first_stress(&f, stretch, &second_stress(&elastic_strain(&f, stretch), &moduli));
        deformations.push(f);
        stresses.push(stress * correction);
    }
    let modulus = 0.3 * (moduli.bulk_pa() + 4.0 / 3.0 * moduli.shear_pa());
    let scale = accelerations.iter().map(SVector::norm).fold(0.0, f64::max);
    for i in 0..block.positions.len() {
        let row =
            buffer.fill_with_mean_lengths(i, block.list.row(i), &block.positions, &block.lengths, KERNEL);
        let force = total_force(&row, &block.volumes, &stresses)
            + hourglass_force(&row, &block.volumes, &displacements, &deformations, modulus);
        assert!((body.deformations()[i] - deformations[i]).norm() < 1e-14);
        assert!((force / body.masses()[i] - accelerations[i]).norm() < 1e-13 * scale, "particle {i}");
    }
}

#[test]
fn the_sweep_equals_the_rows_within_and_across_blocks() {
    sweep_against_rows::<2>(50);
    sweep_against_rows::<3>(14);
}

fn moments<const D: usize>(
    block: &Block<D>,
    masses: &[f64],
    displacements: &[SVector<f64, D>],
    accelerations: &[SVector<f64, D>],
) -> (f64, f64) {
    let (mut linear, mut angular, mut scale) =
        (SVector::<f64, D>::zeros(), SMatrix::<f64, D, D>::zeros(), 0.0);
    for i in 0..masses.len() {
        let (force, arm) = (accelerations[i] * masses[i], block.positions[i] + displacements[i]);
        linear += force;
        angular += arm * force.transpose() - force * arm.transpose();
        scale += force.norm();
    }
    (linear.norm() / scale, angular.norm() / scale)
}

#[test]
fn forces_carry_no_momentum_of_either_kind() {
    for controls in [WITHOUT, FULL, Controls { hourglass: 1.0, viscosity: 0.7 }] {
        let block = Block::<3>::new(6, controls);
        let (mut body, displacements) = (block.body(), block.wild());
        let (accelerations, _) = block.run(&mut body, &displacements, &block.wild());
        let (linear, angular) = moments(&block, body.masses(), &displacements, &accelerations);
        assert!(linear < 1e-14 && angular < 1e-13, "{linear} {angular}");
    }
}

fn forces_are_the_slope_of_the_energy<const D: usize>(count: usize, controls: Controls) {
    let block = Block::<D>::new(count, controls);
    let (mut body, displacements) = (block.body(), block.wild());
    let (accelerations, _) = block.run(&mut body, &displacements, &[]);
    let step = 1e-5;
    for k in [0, 5, block.positions.len() / 2] {
        for axis in 0..D {
            let mut moved = displacements.clone();
            moved[k][axis] += step;
            let above = block.run(&mut body, &moved, &[]).1;
            moved[k][axis] -= 2.0 * step;
            let below = block.run(&mut body, &moved, &[]).1;
            let force = -(above - below) / (2.0 * step);
            let expected = accelerations[k][axis] * body.masses()[k];
            assert!((force - expected).abs() < 1e-8, "{force} against {expected}");
        }
    }
}

#[test]
fn forces_derive_from_the_energies() {
    forces_are_the_slope_of_the_energy::<2>(7, WITHOUT);
    forces_are_the_slope_of_the_energy::<2>(7, FULL);
    forces_are_the_slope_of_the_energy::<3>(5, WITHOUT);
    forces_are_the_slope_of_the_energy::<3>(5, FULL);
}

#[test]
fn linear_displacements_are_seen_exactly_and_wake_no_hourglass() {
    let mut block = Block::<3>::new(6, FULL);
    block.material.expansion = ThermalExpansion::constant(1.0, 293.0, 0.0).unwrap();
    let gradient = SMatrix::<f64, 3, 3>::from_fn(|r, c| 0.02 * noise(3 * r + c));
    let displacements: Vec<_> = block.positions.iter().map(|x| gradient * x).collect();
    let mut body = block.body();
    block.run(&mut body, &displacements, &[]);
    for f in body.deformations() {
        assert!((f - SMatrix::identity() - gradient).norm() < 1e-13);
    }
    let (elastic, hourglass) =
        body.energies(&block.temperatures, &vec![SymmetricTensor::zero(); block.positions.len()]);
    assert!(hourglass < 1e-20 * elastic && elastic > 0.0, "{hourglass} beside {elastic}");
}

#[test]
fn viscosity_takes_kinetic_energy() {
    let still = Block::<2>::new(8, WITHOUT);
    let damped = Block::<2>::new(8, Controls { hourglass: 0.0, viscosity: 0.5 });
    let (displacements, velocities) = (still.wild(), still.wild());
    let elastic = still.run(&mut still.body(), &displacements, &velocities).0;
    let mut body = damped.body();
    let total = damped.run(&mut body, &displacements, &velocities).0;
    let power: f64 = (0..64).map(|i| body.masses()[i] * (total[i] - elastic[i]).dot(&velocities[i])).sum();
    assert!(power < -1e-4, "{power}");
}

#[test]
fn same_bits_on_one_and_two_threads() {
    let block = Block::<3>::new(17, Controls { hourglass: 0.3, viscosity: 0.3 });
    let (velocities, displacements) = (block.wild(), block.wild());
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| block.run(&mut block.body(), &displacements, &velocities).0)
    };
    assert_eq!(on(1), on(2));
}

#[test]
fn a_particle_alone_feels_nothing() {
    let mut block = Block::<3>::new(1, FULL);
    block.temperatures = vec![293.0];
    let (accelerations, energy) = block.run(&mut block.body(), &[SVector::repeat(7.0)], &[]);
    assert_eq!((accelerations[0], energy), (SVector::zeros(), 0.0));
}
