//! Heat that the fluid of a patch carries and conducts.

use crate::leading_part;
use crate::sweep::copy_images;
use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::operators::{laplacian, laplacian_moment};
use sph_kernel::{Row, RowBuffer, ScaledKernel};

/// How heat spreads: one diffusivity, walls that are held at a temperature, and walls and surfaces that let no heat through.
#[derive(Clone, Copy, Debug)]
pub struct Conduction<const D: usize> {
    /// Thermal diffusivity a = k/(rho c) \[m^2/s\].
    pub diffusivity: f64,
    /// Specific heat c \[J/(kg K)\], by which the heat of friction warms the fluid.
    pub heat_capacity: f64,
    /// Temperature \[K\] at which the face before a particle of a wall is held; `None` where no heat passes.
    pub held: fn(&SVector<f64, D>) -> Option<f64>,
}

/// Who sees whom: fluid, copies, walls.
pub(super) struct Rows<'a, const D: usize> {
    pub kernel: &'a ScaledKernel<D>,
    pub positions: &'a [SVector<f64, D>],
    pub copies: &'a [u32],
    pub list: &'a (Vec<usize>, Vec<u32>),
    pub fluid: usize,
}

impl<const D: usize> Rows<'_, D> {
    fn fill<'b>(&'b self, buffer: &'b mut RowBuffer<D>, i: usize) -> Row<'b, D> {
        let (starts, neighbors) = self.list;
        buffer.fill(i, &neighbors[starts[i]..starts[i + 1]], self.positions, self.kernel)
    }

    /// Fluid and copies.
    fn mobile(&self) -> usize {
        self.fluid + self.copies.len()
    }
}

/// Columns of conduction. Each pair exchanges 2 a V_a V_b f_ab (T_a - T_b) (1/M_a + 1/M_b)/2, M the second moment of a row, equal and
/// opposite, so that a closed fluid keeps its heat to round-off, and rows at a free surface or a wall without heat are scaled
/// for what they lack.
#[derive(Clone, Debug)]
pub(super) struct ConductionSweep<const D: usize> {
    law: Conduction<D>,
    /// Volumes \[m^D\] of all that exchanges heat; zero of walls that do not.
    volumes: Vec<f64>,
    /// Volumes over M.
    scaled: Vec<f64>,
    moments: Vec<f64>,
    rates: Vec<f64>,
}

impl<const D: usize> ConductionSweep<D> {
    pub fn new(law: Conduction<D>) -> Self {
        Self { law, volumes: Vec::new(), scaled: Vec::new(), moments: Vec::new(), rates: Vec::new() }
    }

    /// Warms the fluid for `dt` at the rates of the last measurement, and by the `heating` of friction \[W/kg\], which may be
    /// empty.
    pub fn advance(&self, heating: &[f64], temperatures: &mut [f64], dt: f64) {
        for (temperature, rate) in temperatures.iter_mut().zip(&self.rates) {
            *temperature += rate * dt;
        }
        for (temperature, heat) in temperatures.iter_mut().zip(heating) {
            *temperature += heat / self.law.heat_capacity * dt;
        }
    }

    /// Writes the temperatures of copies and walls, then finds the rates of the fluid. `volumes` \[m^D\] of all particles.
    pub fn measure(
        &mut self,
        rows: &Rows<'_, D>,
        volumes: impl Iterator<Item = f64>,
        temperatures: &mut [f64],
    ) {
        self.volumes.clear();
        self.volumes.extend(volumes);
        copy_images(temperatures, rows.fluid, rows.copies);
        self.continue_into_walls(rows, temperatures);
        let Self { law, volumes, scaled, moments, rates } = self;
        // A wall that is held stands for a body that goes on: its moment is one.
        moments.clear();
        moments.resize(volumes.len(), 1.0);
        let written = moments[..rows.fluid].par_iter_mut().enumerate();
        written.for_each_init(RowBuffer::default, |buffer, (i, moment)| {
            *moment = laplacian_moment(&rows.fill(buffer, i), volumes);
        });
        copy_images(moments, rows.fluid, rows.copies);
        scaled.clear();
        scaled.extend(volumes.iter().zip(moments.iter()).map(|(volume, moment)| volume / moment));
        rates.resize(rows.fluid, 0.0);
        let temperatures: &[f64] = temperatures;
        rates.par_iter_mut().enumerate().for_each_init(RowBuffer::default, |buffer, (i, rate)| {
            let row = rows.fill(buffer, i);
            let own = laplacian(&row, volumes, temperatures) / moments[i];
            *rate = 0.5 * law.diffusivity * (own + laplacian(&row, scaled, temperatures));
        });
    }

    /// Heat over rho c \[K m^D/s\] that the fluid takes from the walls that `chosen` picks, at the last measurement.
    pub fn taken_from(
        &self,
        rows: &Rows<'_, D>,
        temperatures: &[f64],
        chosen: impl Fn(&SVector<f64, D>) -> bool,
    ) -> f64 {
        let (mut buffer, mut taken) = (RowBuffer::default(), 0.0);
        for i in 0..rows.fluid {
            let row = rows.fill(&mut buffer, i);
            for (k, &neighbor) in row.neighbors.iter().enumerate() {
                let b = neighbor as usize;
                if b >= rows.mobile() && chosen(&rows.positions[b]) {
                    let scale = 1.0 / self.moments[i] + 1.0 / self.moments[b];
                    let weight = self.volumes[i] * self.volumes[b] * row.gradient_factors[k] * scale;
                    taken += self.law.diffusivity * weight * (temperatures[i] - temperatures[b]);
                }
            }
        }
        taken
    }

    /// Temperatures of walls from the fluid near them: mirrored about that of a held face, the fluid's own elsewhere.
    fn continue_into_walls(&mut self, rows: &Rows<'_, D>, temperatures: &mut [f64]) {
        let (law, mobile) = (&self.law, rows.mobile());
        let (known, walls) = temperatures.split_at_mut(mobile);
        let written = walls.par_iter_mut().zip(self.volumes[mobile..].par_iter_mut()).enumerate();
        written.for_each_init(RowBuffer::default, |buffer, (k, (temperature, volume))| {
            let row = rows.fill(buffer, mobile + k);
            let mean = mean(&leading_part(&row, mobile), known);
            match (law.held)(&rows.positions[mobile + k]) {
                Some(held) => *temperature = mean.map_or(held, |mean| 2.0 * held - mean),
                // Out of the fluid's reach nobody reads it.
                None => (*temperature, *volume) = (mean.unwrap_or(0.0), 0.0),
            }
        });
    }
}

/// Kernel mean of a field over a row; `None` where the row is empty.
fn mean<const D: usize>(row: &Row<'_, D>, field: &[f64]) -> Option<f64> {
    let (mut total, mut sum) = (0.0, 0.0);
    for (&neighbor, &value) in row.neighbors.iter().zip(row.values) {
        total += value;
        sum += value * field[neighbor as usize];
    }
    (total > 0.0).then(|| sum / total)
}
