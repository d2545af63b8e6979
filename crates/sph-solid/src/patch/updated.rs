//! A patch in the updated-Lagrangian form, its list made anew as it moves.

use super::drive::{Drive, HalfKick};
use super::{FindNeighbors, START_TEMPERATURE, kick, kinetic_energy, pieces};
use crate::{
    Error, Material, SymmetricTensor, UpdatedControls, UpdatedFields, UpdatedLagrangian, UpdatedState,
    pressure_wave_speed, stable_step,
};
use nalgebra::SVector;

/// Share of the spacing that a pair may close in before the list is made again.
const SKIN: f64 = 0.5;

/// A body with the sweep that drives it. For tests, examples and benchmarks of the crate's own laws.
///
/// Columns have one entry per particle and are the caller's to set between steps.
#[derive(Debug)]
pub struct UpdatedPatch<const D: usize> {
    /// Positions \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Velocities \[m/s\].
    pub velocities: Vec<SVector<f64, D>>,
    /// Temperatures \[K\].
    pub temperatures: Vec<f64>,
    /// Densities \[kg/m^3\].
    pub densities: Vec<f64>,
    /// Deviatoric stresses \[Pa\].
    pub deviators: Vec<SymmetricTensor<D>>,
    /// Accumulated equivalent plastic strain \[-\].
    pub equivalents: Vec<f64>,
    /// 1 where a component moves freely, 0 where it is held.
    pub free: Vec<SVector<f64, D>>,
    /// Time since the start \[s\], which a drive is told.
    pub time: f64,
    drive: Drive<D>,
    masses: Vec<f64>,
    body: UpdatedLagrangian<D>,
    controls: UpdatedControls<D>,
    material: Material,
    find: FindNeighbors<D>,
    accelerations: Vec<SVector<f64, D>>,
    list: (Vec<usize>, Vec<u32>),
    /// Positions when the list was made.
    listed: Vec<SVector<f64, D>>,
    pair_visits: u64,
}

impl<const D: usize> UpdatedPatch<D> {
    /// At rest at 293 K, without stress, free everywhere; each particle has the volume of a cell of the controls' spacing.
    ///
    /// # Errors
    /// What [`UpdatedLagrangian::new`] refuses.
    pub fn new(
        positions: Vec<SVector<f64, D>>,
        material: Material,
        controls: UpdatedControls<D>,
        find: FindNeighbors<D>,
    ) -> Result<Self, Error> {
        let particles = positions.len();
        let density = material.expansion.reference_density(START_TEMPERATURE);
        Ok(Self {
            body: UpdatedLagrangian::new(particles, material.clone(), controls)?,
            velocities: vec![SVector::zeros(); particles],
            temperatures: vec![START_TEMPERATURE; particles],
            densities: vec![density; particles],
            deviators: vec![SymmetricTensor::zero(); particles],
            equivalents: vec![0.0; particles],
            free: vec![SVector::repeat(1.0); particles],
            time: 0.0,
            drive: Drive::none(),
            masses: vec![density * controls.spacing.powi(D as i32); particles],
            accelerations: vec![SVector::zeros(); particles],
            list: (Vec::new(), Vec::new()),
            listed: Vec::new(),
            pair_visits: 0,
            positions,
            material,
            controls,
            find,
        })
    }

    /// Masses \[kg; kg/m in plane strain\].
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// Directed pairs of the lists that the passes of velocity gradients and of forces have visited.
    #[must_use]
    pub fn pair_visits(&self) -> u64 {
        self.pair_visits
    }

    /// `factor` h/c_P \[s\]; see [`stable_step`].
    #[must_use]
    pub fn stable_step(&self, factor: f64) -> f64 {
        let density = self.material.expansion.reference_density(START_TEMPERATURE);
        let speed = pressure_wave_speed(self.material.solver_moduli(), density);
        stable_step(self.controls.kernel.smoothing_length(), speed, factor)
    }

    /// Moves all particles to new places in a straight drift by `dt` \[s\], whatever the forces say.
    pub fn move_to(&mut self, place: impl Fn(usize) -> SVector<f64, D>, dt: f64) {
        for i in 0..self.positions.len() {
            let position = place(i);
            self.velocities[i] = (position - self.positions[i]) / dt;
            self.positions[i] = position;
        }
        self.evaluate(dt);
    }

    /// From now on holds and moves particles as [`SolidPatch::drive`](crate::SolidPatch::drive) does.
    pub fn drive(
        &mut self,
        members: Vec<usize>,
        velocity: impl Fn(usize, f64) -> SVector<f64, D> + Send + Sync + 'static,
    ) {
        members.iter().for_each(|&i| self.free[i] = SVector::zeros());
        self.drive.set(members, velocity);
    }

    /// Work of what moves particles since it was set \[J; J/m in plane strain\].
    #[must_use]
    pub fn driven_work(&self) -> f64 {
        self.drive.work()
    }

    /// One kick-drift-kick step \[s\].
    pub fn step(&mut self, dt: f64) {
        let middle = self.time + 0.5 * dt;
        self.half_kick(&HalfKick { to: middle, middle, dt: 0.5 * dt });
        for (position, velocity) in self.positions.iter_mut().zip(&self.velocities) {
            *position += velocity * dt;
        }
        self.evaluate(dt);
        self.time += dt;
        self.half_kick(&HalfKick { to: self.time, middle, dt: 0.5 * dt });
    }

    fn half_kick(&mut self, half: &HalfKick) {
        let Self { masses, velocities, accelerations, free, drive, .. } = self;
        kick(velocities, accelerations, free, half.dt);
        drive.kick(masses, velocities, accelerations, free, half);
    }

    /// Evaluates and steps `steps` times by `dt` \[s\].
    pub fn run(&mut self, steps: usize, dt: f64) {
        self.evaluate(0.0);
        (0..steps).for_each(|_| self.step(dt));
    }

    /// Advances stress over a drift by `dt` \[s\] that has just been made, and takes the new accelerations; 0 only evaluates,
    /// as is needed before the first [`UpdatedPatch::step`].
    pub fn evaluate(&mut self, dt: f64) {
        self.renew_list();
        let fields = UpdatedFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.temperatures,
            list_starts: &self.list.0,
            list_neighbors: &self.list.1,
        };
        let mut state = UpdatedState {
            densities: &mut self.densities,
            deviators: &mut self.deviators,
            equivalents: &mut self.equivalents,
        };
        self.body.accelerations(&fields, &mut state, dt, &mut self.accelerations);
        self.pair_visits += 2 * self.list.1.len() as u64;
    }

    fn renew_list(&mut self) {
        let limit = 0.5 * SKIN * self.controls.spacing;
        let near = |(a, b): (&SVector<f64, D>, &SVector<f64, D>)| (a - b).norm() < limit;
        if self.listed.len() == self.positions.len() && self.positions.iter().zip(&self.listed).all(near) {
            return;
        }
        let reach = self.controls.kernel.support_radius() + SKIN * self.controls.spacing;
        self.list = (self.find)(&self.positions, reach);
        self.listed.clone_from(&self.positions);
    }

    /// Kinetic energy \[J; J/m in plane strain\].
    #[must_use]
    pub fn kinetic_energy(&self) -> f64 {
        kinetic_energy(&self.masses, &self.velocities)
    }

    /// Elastic energy \[J; J/m in plane strain\] of small strain: p^2/(2 K) + S : S/(4 mu) over the volume.
    #[must_use]
    pub fn elastic_energy(&self) -> f64 {
        let moduli = self.material.solver_moduli();
        let energy = |i: usize| {
            let stress = self.stress(i);
            let mean = stress.trace() / 3.0;
            let volume = self.masses[i] / self.densities[i];
            volume
                * (0.5 * mean * mean / moduli.bulk_pa()
                    + 0.25 * self.deviators[i].norm_squared() / moduli.shear_pa())
        };
        (0..self.masses.len()).map(energy).sum()
    }

    fn stress(&self, i: usize) -> SymmetricTensor<D> {
        self.body.stress(self.densities[i], self.temperatures[i], &self.deviators[i])
    }

    /// Stress of the solver \[Pa\].
    #[must_use]
    pub fn stresses(&self) -> Vec<SymmetricTensor<D>> {
        (0..self.masses.len()).map(|i| self.stress(i)).collect()
    }

    /// Number of pieces: particles nearer than `link` \[m\] hang together.
    #[must_use]
    pub fn pieces(&self, link: f64) -> usize {
        pieces(&self.positions, link, self.find)
    }
}
