//! A block of fluid that the tests of the laws share.

use crate::Fields;
use nalgebra::SVector;
use sph_kernel::{KernelKind, Row, RowBuffer, ScaledKernel};

/// Smoothing length \[m\]; the spacing is 1 m.
const LENGTH: f64 = 1.5;

/// Particles on a lattice, each moved by up to an amplitude, with columns that differ from particle to particle.
pub struct Block<const D: usize> {
    pub positions: Vec<SVector<f64, D>>,
    pub masses: Vec<f64>,
    pub densities: Vec<f64>,
    pub volumes: Vec<f64>,
    pub pressures: Vec<f64>,
    pub velocities: Vec<SVector<f64, D>>,
}

impl<const D: usize> Block<D> {
    /// `count` particles a side; pressures of both signs, speeds of order one, volumes about one.
    pub fn new(count: usize, amplitude: f64) -> Self {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
        };
        let particles = count.pow(D as u32);
        let site = |k: usize, axis: usize| (k / count.pow(axis as u32) % count) as f64;
        let positions = (0..particles)
            .map(|k| SVector::from_fn(|axis, _| site(k, axis) + amplitude * random()))
            .collect();
        let densities: Vec<f64> = (0..particles).map(|_| 2.0 + 0.1 * random()).collect();
        let masses: Vec<f64> = (0..particles).map(|_| 2.0 + 0.1 * random()).collect();
        Self {
            positions,
            volumes: masses.iter().zip(&densities).map(|(mass, density)| mass / density).collect(),
            pressures: (0..particles).map(|_| random()).collect(),
            velocities: (0..particles).map(|_| SVector::from_fn(|_, _| random())).collect(),
            masses,
            densities,
        }
    }

    /// A lattice of equal particles of mass 2 kg and density 2 kg/m^3, with a field of velocities.
    pub fn lattice(count: usize, velocity: impl Fn(&SVector<f64, D>) -> SVector<f64, D>) -> Self {
        let mut block = Self::new(count, 0.0);
        block.masses.fill(2.0);
        block.densities.fill(2.0);
        block.volumes.fill(1.0);
        block.velocities = block.positions.iter().map(velocity).collect();
        block
    }

    pub fn kernel() -> ScaledKernel<D> {
        KernelKind::WendlandC2.with_smoothing_length::<D>(LENGTH)
    }

    pub fn fields(&self) -> Fields<'_, D> {
        Fields {
            masses: &self.masses,
            densities: &self.densities,
            volumes: &self.volumes,
            pressures: &self.pressures,
            velocities: &self.velocities,
        }
    }

    /// Calls `visit` with the row of one particle among all others.
    pub fn with_row<T>(&self, index: usize, visit: impl FnOnce(&Row<'_, D>) -> T) -> T {
        let others: Vec<u32> = (0..self.positions.len() as u32).filter(|&j| j as usize != index).collect();
        visit(&RowBuffer::default().fill(index, &others, &self.positions, &Self::kernel()))
    }

    pub fn for_each_row(&self, mut visit: impl FnMut(&Row<'_, D>)) {
        (0..self.positions.len()).for_each(|index| self.with_row(index, &mut visit));
    }

    /// What `law` gives for each particle.
    pub fn map_rows<T>(&self, mut law: impl FnMut(&Row<'_, D>) -> T) -> Vec<T> {
        (0..self.positions.len()).map(|index| self.with_row(index, &mut law)).collect()
    }

    /// |sum of m a| over sum of |m a|: how far the forces are from being equal and opposite.
    pub fn relative_momentum(&self, accelerations: &[SVector<f64, D>]) -> f64 {
        let force = |i: usize| accelerations[i] * self.masses[i];
        let sum: SVector<f64, D> = (0..accelerations.len()).map(force).sum();
        sum.norm() / (0..accelerations.len()).map(|i| force(i).norm()).sum::<f64>()
    }

    /// Adds one velocity to all particles.
    pub fn moved_by(mut self, velocity: SVector<f64, D>) -> Self {
        self.velocities.iter_mut().for_each(|own| *own += velocity);
        self
    }

    /// The particle in the middle of a lattice with an odd `count` a side.
    pub fn middle(count: usize) -> usize {
        count.pow(D as u32) / 2
    }
}
