//! The updated-Lagrangian form for one particle.

use crate::ArtificialViscosity;
use nalgebra::{SMatrix, SVector};
use sph_kernel::{Row, ScaledKernel};

/// L_i = sum_j V_j (v_j - v_i) (x) grad_i W B_i \[1/s\]; exact for linear velocities where `correction` B_i is the inverse of
/// the row's [`moment`](sph_kernel::operators::moment), the paper's form with B_i = 1.
///
/// `volumes` m/rho \[m^D\] and `velocities` \[m/s\] belong to all particles of the body: never let neighbours of melt in, or a
/// sheared melt loads the solid without end. Source: Randles and Libersky (1996).
#[inline]
#[must_use]
pub fn velocity_gradient<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    velocities: &[SVector<f64, D>],
    correction: &SMatrix<f64, D, D>,
) -> SMatrix<f64, D, D> {
    let mut sum = SMatrix::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        sum += (velocities[j] - velocities[row.index]) * row.gradient(k).transpose() * volumes[j];
    }
    sum * correction
}

/// sum_j m_j (A_i + A_j) grad_i W \[m/s^2\], the divergence of stress (Hu and Eberhard 2015, eq. 4).
///
/// `tensors` A \[Pa m^6/kg^2\] of all particles: sigma/rho^2 as in the paper, or sigma B/rho^2, which is the derivative of the
/// work of [`velocity_gradient`] with the same B and so keeps energy (to the variation of rho between neighbours).
#[inline]
#[must_use]
pub fn stress_acceleration<const D: usize>(
    row: &Row<'_, D>,
    masses: &[f64],
    tensors: &[SMatrix<f64, D, D>],
) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        sum += (tensors[row.index] + tensors[j]) * row.gradient(k) * masses[j];
    }
    sum
}

/// sum_j m_j (R_i + R_j) Phi^n grad_i W \[m/s^2\] with R from [`artificial_stress`](crate::artificial_stress).
///
/// `value_at_spacing` is W of the initial spacing \[m^-D\] (Gray, Monaghan and Swift 2001).
#[inline]
#[must_use]
pub fn artificial_stress_acceleration<const D: usize>(
    row: &Row<'_, D>,
    masses: &[f64],
    tensors: &[SMatrix<f64, D, D>],
    value_at_spacing: f64,
    exponent: i32,
) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        let weight = crate::artificial_stress_weight(row.values[k], value_at_spacing, exponent);
        sum += (tensors[row.index] + tensors[j]) * row.gradient(k) * (masses[j] * weight);
    }
    sum
}

/// Columns that resistances to motion read, one entry per particle.
#[derive(Clone, Copy, Debug)]
pub struct DampingColumns<'a, const D: usize> {
    /// Masses \[kg; kg/m in plane strain\].
    pub masses: &'a [f64],
    /// Densities \[kg/m^3\].
    pub densities: &'a [f64],
    /// Velocities \[m/s\].
    pub velocities: &'a [SVector<f64, D>],
    /// Velocity gradients L \[1/s\] from [`velocity_gradient`].
    pub gradients: &'a [SMatrix<f64, D, D>],
    /// Speed of the pressure wave \[m/s\].
    pub wave_speed: f64,
    /// Density rho_0 that the wave speed belongs to \[kg/m^3\].
    pub reference_density: f64,
}

/// -sum_j m_j Pi_ij grad_i W \[m/s^2\], Monaghan's viscosity ([`ArtificialViscosity::pair`]).
#[inline]
#[must_use]
pub fn viscous_acceleration<const D: usize>(
    row: &Row<'_, D>,
    columns: &DampingColumns<'_, D>,
    kernel: &ScaledKernel<D>,
    law: &ArtificialViscosity,
) -> SVector<f64, D> {
    let (i, mut sum) = (row.index, SVector::zeros());
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        let relative = columns.velocities[i] - columns.velocities[j];
        let density = 0.5 * (columns.densities[i] + columns.densities[j]);
        let length = kernel.smoothing_length();
        let pi = law.pair(&row.separations[k], &relative, length, columns.wave_speed, density);
        sum -= row.gradient(k) * (columns.masses[j] * pi);
    }
    sum
}

/// -sum_j m_j b c_P h/rho_0 |f| (v_ij - (L_i + L_j)/2 r_ij) \[m/s^2\], viscosity on what the velocity gradients do not see.
///
/// Zero for linear velocities. The corrected form needs it with `coefficient` b = 0.4 at h/dx 1.2: under stress the moving
/// kernel gives zero-energy modes a negative stiffness, which burns 27 % of a plate's energy in half a period with 20
/// particles over the thickness (trials of this project, after Ganzenmueller 2015).
#[inline]
#[must_use]
pub fn hourglass_viscosity<const D: usize>(
    row: &Row<'_, D>,
    columns: &DampingColumns<'_, D>,
    kernel: &ScaledKernel<D>,
    coefficient: f64,
) -> SVector<f64, D> {
    let (i, mut sum) = (row.index, SVector::zeros());
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        let mean = (columns.gradients[i] + columns.gradients[j]) * 0.5;
        let unseen = columns.velocities[i] - columns.velocities[j] - mean * row.separations[k];
        sum += unseen * (columns.masses[j] * row.gradient_factors[k]);
    }
    sum * (coefficient * columns.wave_speed * kernel.smoothing_length() / columns.reference_density)
}
