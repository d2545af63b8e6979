//! A body in the updated-Lagrangian form, stepped by kick-drift-kick, its list made anew as it moves.

use nalgebra::SVector;
use sph_neighbors::{NeighborList, PairReach, SearchMethod};
use sph_solid::{
    Material, SymmetricTensor, UpdatedControls, UpdatedFields, UpdatedLagrangian, UpdatedState,
    pressure_wave_speed, stable_step,
};

/// Share of the spacing that a pair may close in before the list is made again.
const SKIN: f64 = 0.5;

pub struct UpdatedScene<const D: usize> {
    pub positions: Vec<SVector<f64, D>>,
    pub velocities: Vec<SVector<f64, D>>,
    pub masses: Vec<f64>,
    pub temperatures: Vec<f64>,
    pub densities: Vec<f64>,
    pub deviators: Vec<SymmetricTensor<D>>,
    pub equivalents: Vec<f64>,
    pub free: Vec<SVector<f64, D>>,
    pub body: UpdatedLagrangian<D>,
    pub controls: UpdatedControls<D>,
    pub material: Material,
    pub accelerations: Vec<SVector<f64, D>>,
    list: NeighborList,
    listed: Vec<SVector<f64, D>>,
}

impl<const D: usize> UpdatedScene<D> {
    /// At rest at 293 K.
    pub fn new(positions: Vec<SVector<f64, D>>, material: Material, controls: UpdatedControls<D>) -> Self {
        let particles = positions.len();
        let density = material.expansion.reference_density(293.0);
        Self {
            velocities: vec![SVector::zeros(); particles],
            masses: vec![density * controls.spacing.powi(D as i32); particles],
            temperatures: vec![293.0; particles],
            densities: vec![density; particles],
            deviators: vec![SymmetricTensor::zero(); particles],
            equivalents: vec![0.0; particles],
            free: vec![SVector::repeat(1.0); particles],
            body: UpdatedLagrangian::new(particles, material.clone(), controls).unwrap(),
            accelerations: vec![SVector::zeros(); particles],
            list: NeighborList::default(),
            listed: Vec::new(),
            controls,
            material,
            positions,
        }
    }

    /// `factor` h/c_P \[s\].
    pub fn stable_step(&self, factor: f64) -> f64 {
        let speed = pressure_wave_speed(self.material.solver_moduli(), self.densities[0]);
        stable_step(self.controls.kernel.smoothing_length(), speed, factor)
    }

    /// Advances stress over a drift by `dt` that has just been made, and takes the new accelerations.
    pub fn evaluate(&mut self, dt: f64) {
        self.renew_list();
        let fields = UpdatedFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.temperatures,
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
        };
        let mut state = UpdatedState {
            densities: &mut self.densities,
            deviators: &mut self.deviators,
            equivalents: &mut self.equivalents,
        };
        self.body.accelerations(&fields, &mut state, dt, &mut self.accelerations);
    }

    pub fn run(&mut self, steps: usize, dt: f64) {
        self.evaluate(0.0);
        for _ in 0..steps {
            self.kick(0.5 * dt);
            for (position, velocity) in self.positions.iter_mut().zip(&self.velocities) {
                *position += velocity * dt;
            }
            self.evaluate(dt);
            self.kick(0.5 * dt);
        }
    }

    fn kick(&mut self, dt: f64) {
        for i in 0..self.velocities.len() {
            self.velocities[i] += self.accelerations[i].component_mul(&self.free[i]) * dt;
        }
    }

    fn renew_list(&mut self) {
        let limit = 0.5 * SKIN * self.controls.spacing;
        let near = |(a, b): (&SVector<f64, D>, &SVector<f64, D>)| (a - b).norm() < limit;
        if self.listed.len() == self.positions.len() && self.positions.iter().zip(&self.listed).all(near) {
            return;
        }
        let reach = self.controls.kernel.support_radius() + SKIN * self.controls.spacing;
        self.list = SearchMethod::default().find(&self.positions, PairReach::Uniform(reach)).unwrap();
        self.listed.clone_from(&self.positions);
    }

    pub fn kinetic_energy(&self) -> f64 {
        (0..self.masses.len()).map(|i| 0.5 * self.masses[i] * self.velocities[i].norm_squared()).sum()
    }

    /// Elastic energy \[J\] of small strain: p^2/(2 K) + S : S/(4 mu) over the volume.
    pub fn elastic_energy(&self) -> f64 {
        let moduli = self.material.solver_moduli();
        (0..self.masses.len())
            .map(|i| {
                let stress = self.body.stress(self.densities[i], self.temperatures[i], &self.deviators[i]);
                let mean = stress.trace() / 3.0;
                let energy = 0.5 * mean * mean / moduli.bulk_pa()
                    + 0.25 * self.deviators[i].norm_squared() / moduli.shear_pa();
                energy * self.masses[i] / self.densities[i]
            })
            .sum()
    }

    /// Number of pieces: particles nearer than `link` \[m\] hang together.
    pub fn pieces(&self, link: f64) -> usize {
        let list = SearchMethod::default().find(&self.positions, PairReach::Uniform(link)).unwrap();
        let mut seen = vec![false; self.positions.len()];
        let mut pieces = 0;
        for start in 0..seen.len() {
            let mut open = if seen[start] { vec![] } else { vec![start] };
            pieces += usize::from(!seen[start]);
            while let Some(i) = open.pop() {
                if !std::mem::replace(&mut seen[i], true) {
                    open.extend(list.row(i).iter().map(|&j| j as usize));
                }
            }
        }
        pieces
    }
}
