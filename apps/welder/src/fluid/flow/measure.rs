//! What is read off a fluid.

use super::FluidFlow;
use crate::fluid::FluidLedger;
use crate::particles::bounding_box;
use crate::physics::Column;
use nalgebra::SVector;

impl<const D: usize> FluidFlow<D> {
    /// Largest change of a density over the one without pressure at its temperature \[-\].
    pub fn density_change(&self) -> f64 {
        let density = self.model.density();
        let stretched = |i: usize| self.densities[i] * self.model.stretch_at(&self.columns.positions[i]);
        (0..self.fluid).map(|i| (stretched(i) / density - 1.0).abs()).fold(0.0, f64::max)
    }

    /// Energies of motion, of height over the lowest corner of the domain, and of compression \[J; J/m in the plane\].
    pub fn energies(&self) -> [f64; 3] {
        let (gravity, low, size) = (self.model.controls.body_acceleration, self.model.low, self.model.size);
        let lowest: f64 = (0..D).map(|a| (gravity[a] * low[a]).max(gravity[a] * (low[a] + size[a]))).sum();
        let mut sums = [0.0; 3];
        for i in 0..self.fluid {
            let mass = self.columns.masses[i];
            sums[0] += 0.5 * mass * self.columns.velocities[i].norm_squared();
            sums[1] += mass * (lowest - gravity.dot(&self.columns.positions[i]));
            sums[2] += mass * self.compression(i, self.columns.temperatures.get(i));
        }
        sums
    }

    /// Energy of compression of a particle \[J/kg\] at a temperature \[K\], where the scene has one.
    pub(super) fn compression(&self, i: usize, temperature: Option<&f64>) -> f64 {
        let controls = &self.model.controls;
        let cold = || controls.state.energy(self.densities[i]);
        temperature.map_or_else(cold, |&temperature| controls.compression(self.densities[i], temperature))
    }

    /// The energy ledger now.
    pub fn ledger(&self) -> FluidLedger {
        FluidLedger::new(self, self.start_energy, &self.work)
    }

    /// Mean pressure over the volume of the fluid \[Pa\].
    pub fn mean_pressure(&self) -> f64 {
        let (mut sum, mut volume) = (0.0, 0.0);
        for (i, pressure) in self.sweep.pressures()[..self.fluid].iter().enumerate() {
            let own = self.columns.masses[i] / self.densities[i];
            sum += own * pressure;
            volume += own;
        }
        sum / volume
    }

    /// Low and high corner of the box around the fluid's cells \[m\].
    pub fn bounds(&self) -> [SVector<f64, D>; 2] {
        let half = SVector::<f64, D>::repeat(0.5 * self.model.spacing());
        let [low, high] = bounding_box(self.positions());
        [low - half, high + half]
    }

    /// Total mass \[kg; kg/m in the plane\].
    pub fn mass(&self) -> f64 {
        self.columns.masses[..self.fluid].iter().sum()
    }

    /// Columns to be shown, by name with unit.
    pub fn columns(&self) -> Vec<(&'static str, Column<D>)> {
        let mut columns = vec![
            ("velocity_m_s", Column::Vector(self.velocities().to_vec())),
            ("pressure_pa", Column::Scalar(self.pressures().to_vec())),
            ("density_kg_m3", Column::Scalar(self.densities[..self.fluid].to_vec())),
            ("body", Column::Byte(self.placed.bodies.clone())),
        ];
        if self.model.temperature.is_some() {
            columns.push(("temperature_k", Column::Scalar(self.columns.temperatures[..self.fluid].to_vec())));
        }
        columns
    }
}
