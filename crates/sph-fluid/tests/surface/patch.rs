//! Fluid with a free surface: columns, periodic copies along x, walls, and kick-drift-kick.

use nalgebra::SVector;
use sph_fluid::{FluidControls, FluidFields, FluidSweep};
use sph_neighbors::{NeighborList, PairReach, SearchMethod};

/// Share of the spacing that particles may close in before the list is made anew.
const SKIN: f64 = 0.4;

pub struct Patch<const D: usize> {
    pub spacing: f64,
    /// Period along x; infinite without copies.
    pub period: f64,
    pub fluid: usize,
    /// Fluid, copies, walls.
    pub positions: Vec<SVector<f64, D>>,
    pub velocities: Vec<SVector<f64, D>>,
    pub densities: Vec<f64>,
    pub masses: Vec<f64>,
    pub temperatures: Vec<f64>,
    walls: Vec<SVector<f64, D>>,
    wall_mass: f64,
    copies: Vec<u32>,
    shifts: Vec<f64>,
    pub accelerations: Vec<SVector<f64, D>>,
    list: NeighborList,
    built: Vec<SVector<f64, D>>,
    reach: f64,
    pub sweep: FluidSweep<D>,
    pub time: f64,
    /// Temperature of a place \[K\].
    pub temperature: fn(&SVector<f64, D>) -> f64,
}

impl<const D: usize> Patch<D> {
    pub fn new(
        positions: Vec<SVector<f64, D>>,
        masses: Vec<f64>,
        walls: Vec<SVector<f64, D>>,
        spacing: f64,
        period: f64,
        controls: FluidControls<D>,
    ) -> Self {
        let fluid = positions.len();
        let density = controls.state.reference_density();
        let mut patch = Self {
            spacing,
            period,
            fluid,
            velocities: vec![SVector::zeros(); fluid],
            densities: vec![density; fluid],
            masses,
            temperatures: Vec::new(),
            wall_mass: density * spacing.powi(D as i32),
            walls,
            copies: Vec::new(),
            shifts: Vec::new(),
            accelerations: vec![SVector::zeros(); fluid],
            list: SearchMethod::default().find(&positions, PairReach::Uniform(spacing)).unwrap(),
            built: Vec::new(),
            reach: controls.kernel.support_radius() + SKIN * spacing,
            positions,
            sweep: FluidSweep::new(controls).unwrap(),
            time: 0.0,
            temperature: |_| 0.0,
        };
        patch.rebuild();
        patch
    }

    /// Copies, walls and the list anew; densities of walls stay those of rest.
    fn rebuild(&mut self) {
        for column in [&mut self.positions, &mut self.velocities] {
            column.truncate(self.fluid);
        }
        let density = self.wall_mass / self.spacing.powi(D as i32);
        self.densities.truncate(self.fluid);
        self.masses.truncate(self.fluid);
        (self.copies, self.shifts) = (Vec::new(), Vec::new());
        if self.period.is_finite() {
            for i in 0..self.fluid {
                self.positions[i][0] = self.positions[i][0].rem_euclid(self.period);
                let margin = self.reach + SKIN * self.spacing;
                for (near, shift) in [
                    (self.positions[i][0] < margin, self.period),
                    (self.positions[i][0] > self.period - margin, -self.period),
                ] {
                    if near {
                        self.copies.push(i as u32);
                        self.shifts.push(shift);
                    }
                }
            }
        }
        let extra = self.copies.len() + self.walls.len();
        self.positions.resize(self.fluid + self.copies.len(), SVector::zeros());
        self.positions.extend_from_slice(&self.walls);
        self.velocities.resize(self.fluid + extra, SVector::zeros());
        self.densities.resize(self.fluid + extra, density);
        let of_copies: Vec<f64> = self.copies.iter().map(|&source| self.masses[source as usize]).collect();
        self.masses.extend(of_copies);
        self.masses.resize(self.fluid + extra, self.wall_mass);
        self.move_copies();
        self.list = SearchMethod::default().find(&self.positions, PairReach::Uniform(self.reach)).unwrap();
        self.built = self.positions[..self.fluid].to_vec();
    }

    fn move_copies(&mut self) {
        for (k, &source) in self.copies.iter().enumerate() {
            self.positions[self.fluid + k] = self.positions[source as usize];
            self.positions[self.fluid + k][0] += self.shifts[k];
            self.velocities[self.fluid + k] = self.velocities[source as usize];
        }
    }

    pub fn evaluate(&mut self, dt: f64) {
        let far = 0.5 * SKIN * self.spacing;
        if self.positions[..self.fluid].iter().zip(&self.built).any(|(now, then)| (now - then).norm() > far) {
            self.rebuild();
        }
        self.move_copies();
        self.temperatures.clear();
        self.temperatures.extend(self.positions.iter().map(self.temperature));
        let fields = FluidFields {
            positions: &self.positions,
            velocities: &self.velocities,
            masses: &self.masses,
            temperatures: &self.temperatures,
            copies: &self.copies,
            list_starts: self.list.starts(),
            list_neighbors: self.list.indices(),
        };
        self.sweep.accelerations(&fields, &mut self.densities, dt, &mut self.accelerations);
    }

    pub fn kick(&mut self, dt: f64) {
        for (velocity, acceleration) in self.velocities.iter_mut().zip(&self.accelerations) {
            *velocity += acceleration * dt;
        }
    }

    pub fn step(&mut self, dt: f64) {
        self.kick(0.5 * dt);
        for i in 0..self.fluid {
            self.positions[i] += self.velocities[i] * dt;
        }
        for (position, shift) in self.positions.iter_mut().zip(self.sweep.shift_velocities()) {
            *position += shift * dt;
        }
        self.evaluate(dt);
        self.kick(0.5 * dt);
        self.time += dt;
    }

    pub fn largest_speed(&self) -> f64 {
        self.velocities[..self.fluid].iter().map(SVector::norm).fold(0.0, f64::max)
    }
}
