//! The sweep against the plain row functions.

use super::*;
use crate::{
    ARTIFICIAL_STRESS_EXPONENT, ArtificialViscosity, IsotropicModuli, Material, SymmetricTensor,
    advanced_deviator, artificial_stress, density_ratio, midpoint_gradient, pressure_wave_speed,
};
use nalgebra::{SMatrix, SVector};
use sph_kernel::operators::{moment, regularised_inverse};
use sph_kernel::{KernelKind, RowBuffer};
use sph_neighbors::{NeighborList, PairReach, SearchMethod};

const DT: f64 = 0.01;
const TEMPERATURE: f64 = 293.0;
const REFERENCE_DENSITY: f64 = 1.02;

/// A number in -1..1 that looks random.
fn noise(seed: usize) -> f64 {
    2.0 * ((seed as f64 * 12.9898).sin() * 43_758.547).rem_euclid(1.0) - 1.0
}

/// A disordered, moving block of `count`^D particles under stress, spacing 1, its list with a skin.
struct Block<const D: usize> {
    positions: Vec<SVector<f64, D>>,
    velocities: Vec<SVector<f64, D>>,
    masses: Vec<f64>,
    densities: Vec<f64>,
    deviators: Vec<SymmetricTensor<D>>,
    list: NeighborList,
    material: Material,
}

impl<const D: usize> Block<D> {
    fn new(count: usize) -> Self {
        let at = |k: usize, axis: usize| (k / count.pow(axis as u32)) % count;
        let particles = 0..count.pow(D as u32);
        let position = |k| SVector::from_fn(|axis, _| at(k, axis) as f64 + 0.1 * noise(7 * k + axis));
        let positions: Vec<_> = particles.clone().map(position).collect();
        let velocity = |k| SVector::from_fn(|axis, _| 0.1 * noise(3 * k + 100 * axis));
        let deviator = |k| {
            let entries = SMatrix::from_fn(|row, column| 0.01 * noise(k + 10 * (row + 1) * (column + 1)));
            SymmetricTensor { in_plane: entries, out_of_plane: 0.0 }.deviator()
        };
        let list = SearchMethod::default().find(&positions, PairReach::Uniform(2.9)).unwrap();
        let moduli = IsotropicModuli::from_young_and_poisson(1.0, 0.33).unwrap();
        Self {
            positions,
            velocities: particles.clone().map(velocity).collect(),
            masses: particles.clone().map(|k| 1.0 + 0.1 * noise(k + 31)).collect(),
            densities: particles.clone().map(|k| 1.0 + 0.05 * noise(k + 57)).collect(),
            deviators: particles.map(deviator).collect(),
            list,
            material: Material::elastic(moduli, REFERENCE_DENSITY).unwrap(),
        }
    }

    /// Accelerations, densities and deviators after a step, with the body.
    fn sweep(&self, controls: UpdatedControls<D>) -> (UpdatedLagrangian<D>, Vec<SVector<f64, D>>, Vec<f64>) {
        let particles = self.positions.len();
        let fields = UpdatedFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &vec![TEMPERATURE; particles],
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
        };
        let (mut densities, mut deviators) = (self.densities.clone(), self.deviators.clone());
        let mut state = UpdatedState {
            densities: &mut densities,
            deviators: &mut deviators,
            equivalents: &mut vec![0.0; particles],
        };
        let mut body = UpdatedLagrangian::new(particles, self.material.clone(), controls).unwrap();
        let mut accelerations = vec![SVector::zeros(); particles];
        body.accelerations(&fields, &mut state, DT, &mut accelerations);
        (body, accelerations, densities)
    }

    fn held_against_rows(&self, controls: UpdatedControls<D>) {
        let particles = self.positions.len();
        let volumes: Vec<f64> = (0..particles).map(|i| self.masses[i] / self.densities[i]).collect();
        let mut buffer = RowBuffer::default();
        let (mut gradients, mut tensors, mut repulsions) = (Vec::new(), Vec::new(), Vec::new());
        let (body, accelerations, densities) = self.sweep(controls);
        let shear = self.material.solver_moduli().shear_pa();
        for i in 0..particles {
            let row = buffer.fill(i, self.list.row(i), &self.positions, &controls.kernel);
            let correction = match controls.form {
                UpdatedForm::Corrected => regularised_inverse(&moment(&row, &volumes)),
                UpdatedForm::Paper => SMatrix::identity(),
            };
            let gradient = velocity_gradient(&row, &volumes, &self.velocities, &correction);
            assert!((gradient - body.gradient(i)).norm() < 1e-14, "particle {i}");
            let mid = midpoint_gradient(&gradient, DT);
            let density = self.densities[i] * density_ratio(&mid, DT);
            assert!((density - densities[i]).abs() < 1e-14, "particle {i}");
            let deviator = advanced_deviator(&self.deviators[i], &mid, shear, DT);
            let stress = body.stress(density, TEMPERATURE, &deviator).in_plane;
            gradients.push(gradient);
            tensors.push(stress * correction / (density * density));
            repulsions.push(artificial_stress(&stress, density, controls.artificial_stress));
        }
        let wave_speed = pressure_wave_speed(self.material.solver_moduli(), REFERENCE_DENSITY);
        let (masses, kernel) = (&self.masses, &controls.kernel);
        let columns = DampingColumns {
            masses,
            densities: &densities,
            velocities: &self.velocities,
            gradients: &gradients,
            wave_speed,
            reference_density: REFERENCE_DENSITY,
        };
        let at_spacing = kernel.value(controls.spacing);
        for i in 0..particles {
            let row = buffer.fill(i, self.list.row(i), &self.positions, kernel);
            let expected = stress_acceleration(&row, masses, &tensors)
                + artificial_stress_acceleration(
                    &row,
                    masses,
                    &repulsions,
                    at_spacing,
                    ARTIFICIAL_STRESS_EXPONENT,
                )
                + viscous_acceleration(&row, &columns, kernel, &controls.viscosity)
                + hourglass_viscosity(&row, &columns, kernel, controls.hourglass_viscosity);
            assert!((expected - accelerations[i]).norm() < 1e-13, "particle {i}");
        }
    }

    fn both_forms_held_against_rows(&self) {
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.3);
        let viscosity = ArtificialViscosity { alpha: 0.5, beta: 1.0 };
        self.held_against_rows(UpdatedControls { viscosity, ..UpdatedControls::paper(kernel, 1.0) });
        self.held_against_rows(UpdatedControls::corrected(kernel, 1.0));
    }
}

#[test]
fn the_sweep_equals_the_rows_within_and_across_blocks() {
    Block::<2>::new(50).both_forms_held_against_rows();
    Block::<3>::new(14).both_forms_held_against_rows();
}

#[test]
fn same_bits_on_one_and_two_threads() {
    let block = Block::<3>::new(17);
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.3);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| block.sweep(UpdatedControls::corrected(kernel, 1.0)).1)
    };
    assert_eq!(on(1), on(2));
}
