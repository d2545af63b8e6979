//! A body of particles that is stepped by kick-drift-kick: what the tests and examples share.

use nalgebra::{SMatrix, SVector};
use sph_integrate::leapfrog_step;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{PairReach, SearchMethod};
use sph_solid::{Controls, Inelastic, Material, Motion, ReferenceColumns, SymmetricTensor, TotalLagrangian};

/// Lattice positions \[m\], spacing `spacing`, at the centres of the cells of a box from `low`, `counts` cells along the axes.
pub fn lattice<const D: usize>(low: [f64; D], counts: [usize; D], spacing: f64) -> Vec<SVector<f64, D>> {
    let at = |k: usize, axis: usize| k / counts[..axis].iter().product::<usize>() % counts[axis];
    (0..counts.iter().product())
        .map(|k| SVector::from_fn(|axis, _| low[axis] + spacing * (at(k, axis) as f64 + 0.5)))
        .collect()
}

/// Lattice positions inside a disc or ball of `cells` spacings over its radius, about the origin.
pub fn ball<const D: usize>(cells: usize, spacing: f64) -> Vec<SVector<f64, D>> {
    let radius = cells as f64 * spacing;
    let cube = lattice([-radius; D], [2 * cells; D], spacing);
    cube.into_iter().filter(|position| position.norm() < radius).collect()
}

/// A body with all its columns.
pub struct Scene<const D: usize> {
    pub positions: Vec<SVector<f64, D>>,
    pub temperatures: Vec<f64>,
    pub displacements: Vec<SVector<f64, D>>,
    pub velocities: Vec<SVector<f64, D>>,
    pub strains: Vec<SymmetricTensor<D>>,
    pub equivalents: Vec<f64>,
    /// 1 where a component moves freely, 0 where it is held.
    pub free: Vec<SVector<f64, D>>,
    pub body: TotalLagrangian<D>,
    accelerations: Vec<f64>,
}

impl<const D: usize> Scene<D> {
    /// At rest at 293 K; Gaussian kernel with h = `ratio` dx.
    pub fn new(
        positions: Vec<SVector<f64, D>>,
        spacing: f64,
        ratio: f64,
        material: Material,
        controls: Controls,
    ) -> Self {
        let (particles, length) = (positions.len(), ratio * spacing);
        let kernel = KernelKind::Gaussian;
        let reach = Kernel::<D>::support_radius(kernel, length) * (1.0 + 1e-9);
        let list = SearchMethod::default().find(&positions, PairReach::Uniform(reach)).unwrap();
        let columns = ReferenceColumns {
            positions: &positions,
            volumes: &vec![spacing.powi(D as i32); particles],
            masses: &vec![material.expansion.reference_density(293.0) * spacing.powi(D as i32); particles],
            temperatures: &vec![293.0; particles],
            smoothing_lengths: &vec![length; particles],
            list_starts: list.starts(),
            list_neighbors: list.indices(),
        };
        let body = TotalLagrangian::new(&columns, kernel, material, controls).unwrap();
        Self {
            temperatures: vec![293.0; particles],
            displacements: vec![SVector::zeros(); particles],
            velocities: vec![SVector::zeros(); particles],
            strains: vec![SymmetricTensor::zero(); particles],
            equivalents: vec![0.0; particles],
            free: vec![SVector::repeat(1.0); particles],
            accelerations: vec![0.0; D * particles],
            body,
            positions,
        }
    }

    /// Steps `steps` times by `dt`, velocities fading by exp(-`damping` dt) a step.
    pub fn run(&mut self, steps: usize, dt: f64, damping: f64) {
        self.refresh();
        let (mut position, mut velocity) = (flat(&self.displacements), flat(&self.velocities));
        let mut acceleration = std::mem::take(&mut self.accelerations);
        for _ in 0..steps {
            leapfrog_step(&mut position, &mut velocity, &mut acceleration, dt, |position, acceleration| {
                self.accelerate(position, acceleration);
            });
            velocity.iter_mut().for_each(|component| *component *= (-damping * dt).exp());
        }
        self.accelerations = acceleration;
        self.velocities = vectors(&velocity);
    }

    /// Accelerations of the present displacements; needed after these or temperatures were set.
    pub fn refresh(&mut self) {
        let position = flat(&self.displacements);
        let mut acceleration = std::mem::take(&mut self.accelerations);
        self.accelerate(&position, &mut acceleration);
        self.accelerations = acceleration;
    }

    fn accelerate(&mut self, position: &[f64], acceleration: &mut [f64]) {
        self.displacements = vectors(position);
        let motion = Motion {
            displacements: &self.displacements,
            velocities: &self.velocities,
            temperatures: &self.temperatures,
        };
        let mut inelastic = Inelastic { strains: &mut self.strains, equivalents: &mut self.equivalents };
        let mut result = vec![SVector::zeros(); self.positions.len()];
        self.body.accelerations(&motion, &mut inelastic, &mut result);
        for (target, (a, free)) in acceleration.chunks_exact_mut(D).zip(result.iter().zip(&self.free)) {
            target.copy_from_slice(a.component_mul(free).as_slice());
        }
    }

    /// Relaxes a body of half size `radius` \[m\] to rest: damping 2 c/radius for 16 radius/c, c the wave speed.
    pub fn relax(&mut self, radius: f64, wave_speed: f64) {
        let dt = self.body.stable_step(0.6);
        let steps = (16.0 * radius / wave_speed / dt).ceil() as usize;
        self.run(steps, dt, 2.0 * wave_speed / radius);
    }

    /// Cauchy stress in true units \[Pa\].
    pub fn stresses(&self) -> Vec<SymmetricTensor<D>> {
        let mut in_plane = vec![SMatrix::zeros(); self.positions.len()];
        let mut out_of_plane = vec![0.0; self.positions.len()];
        self.body.stresses(&self.temperatures, &self.strains, &mut in_plane, &mut out_of_plane);
        in_plane
            .into_iter()
            .zip(out_of_plane)
            .map(|(in_plane, out_of_plane)| SymmetricTensor { in_plane, out_of_plane })
            .collect()
    }

    /// Kinetic, elastic and hourglass energy \[J\].
    pub fn energies(&self) -> [f64; 3] {
        let kinetic = |i: usize| 0.5 * self.body.masses()[i] * self.velocities[i].norm_squared();
        let (elastic, hourglass) = self.body.energies(&self.temperatures, &self.strains);
        [(0..self.positions.len()).map(kinetic).sum(), elastic, hourglass]
    }

    /// Mean of a value over the particles that satisfy `inside`.
    pub fn mean(&self, inside: impl Fn(&SVector<f64, D>) -> bool, value: impl Fn(usize) -> f64) -> f64 {
        let chosen: Vec<usize> = (0..self.positions.len()).filter(|&i| inside(&self.positions[i])).collect();
        chosen.iter().map(|&i| value(i)).sum::<f64>() / chosen.len() as f64
    }

    /// Gives the body the velocities `amplitude` * `mode` and returns the time \[s\] after which its displacement along the
    /// mode is back at zero: half a period.
    pub fn half_period(
        &mut self,
        mode: impl Fn(&SVector<f64, D>) -> SVector<f64, D>,
        amplitude: f64,
        dt: f64,
        longest: f64,
    ) -> f64 {
        let shape: Vec<_> =
            self.positions.iter().zip(&self.free).map(|(x, f)| mode(x).component_mul(f)).collect();
        self.velocities = shape.iter().map(|shape| shape * amplitude).collect();
        let project =
            |scene: &Self| -> f64 { scene.displacements.iter().zip(&shape).map(|(u, s)| u.dot(s)).sum() };
        let chunk = (0.01 * longest / dt).ceil() as usize;
        let (mut time, mut before) = (0.0, 0.0);
        while time < longest {
            self.run(chunk, dt, 0.0);
            time += chunk as f64 * dt;
            let now = project(self);
            if before > 0.0 && now <= 0.0 {
                // The mode is nearly straight in time here: the secant over a hundredth of the time meets the crossing.
                return time - chunk as f64 * dt * now / (now - before);
            }
            before = now;
        }
        f64::NAN
    }
}

fn flat<const D: usize>(vectors: &[SVector<f64, D>]) -> Vec<f64> {
    vectors.iter().flat_map(|vector| vector.iter().copied()).collect()
}

fn vectors<const D: usize>(flat: &[f64]) -> Vec<SVector<f64, D>> {
    flat.chunks_exact(D).map(SVector::from_column_slice).collect()
}
