//! The total-Lagrangian form for one particle: the plain statement that the fast sweep is held against.

use nalgebra::{SMatrix, SVector};
use sph_kernel::Row;

/// F_i = 1 + sum_j V_j (u_j - u_i) (x) grad0_i W B_i \[-\]: exact for linear displacements.
///
/// `row` is that of the reference positions, `volumes` V_0 \[m^D\], `displacements` u \[m\] of all particles, `correction`
/// B_i from [`regularised_inverse`](sph_kernel::operators::regularised_inverse). In displacement form a particle without
/// neighbours has F = 1 (Bonet and Lok 1999; displacement form: trials of this project).
#[inline]
#[must_use]
pub fn deformation_gradient<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    displacements: &[SVector<f64, D>],
    correction: &SMatrix<f64, D, D>,
) -> SMatrix<f64, D, D> {
    let mut sum = SMatrix::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        let change = displacements[j] - displacements[row.index];
        sum += change * row.gradient(k).transpose() * volumes[j];
    }
    SMatrix::identity() + sum * correction
}

/// Force on i \[N; N/m in plane strain\]: sum_j V_i V_j (P_i B_i + P_j B_j) grad0_i W, the exact derivative of the elastic
/// energy of [`deformation_gradient`], so that energy and momentum stay (Bonet and Lok 1999).
///
/// `corrected_stress` P B \[Pa\] of all particles, P the first Piola-Kirchhoff stress
/// ([`first_stress`](crate::first_stress)).
#[inline]
#[must_use]
pub fn total_force<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    corrected_stress: &[SMatrix<f64, D, D>],
) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        sum += (corrected_stress[row.index] + corrected_stress[j]) * row.gradient(k) * volumes[j];
    }
    sum * volumes[row.index]
}

/// Force on i \[N; N/m in plane strain\] against zero-energy modes: -sum_j c V_i V_j |f| e_ij, with
/// e_ij = x_i - x_j - (F_i + F_j)/2 (X_i - X_j) what the deformation gradients do not see of a pair, and f = W'/r.
///
/// Zero for every linear displacement. It is the exact derivative of
/// sum_i c/4 sum_j V_i V_j |f| |x_i - x_j - F_i (X_i - X_j)|^2: F_i with the correction B_i is the least-squares fit to its
/// own row under just these weights, so that the energy does not change with F_i. Energy and both momenta therefore stay,
/// if B is the true inverse. After Ganzenmueller (2015), who projects e on the pair; `modulus` c \[Pa\] is a share of
/// K + 4 mu/3.
#[inline]
#[must_use]
pub fn hourglass_force<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    displacements: &[SVector<f64, D>],
    deformations: &[SMatrix<f64, D, D>],
    modulus: f64,
) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        let mean = (deformations[row.index] + deformations[j]) * 0.5;
        let relative = displacements[row.index] - displacements[j] + row.separations[k];
        let unseen = relative - mean * row.separations[k];
        sum += unseen * (modulus * volumes[j] * row.gradient_factors[k]);
    }
    sum * volumes[row.index]
}
