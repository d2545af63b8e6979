//! The pair force between solid and melt of Hu and Eberhard (2015, section 2.3): each side brings its own stress.

use nalgebra::{SMatrix, SVector};
use sph_kernel::Row;

/// V_a sum_b V_b sigma_b grad_a W \[N; N/m in 2-D\], what the stress of solid neighbours does to a particle of melt (their eq. 4,
/// of the pair's two terms that of the solid, with volumes for m/rho). The solid gets the opposite, pair by pair, in `loads`.
///
/// `solid_row` holds the solid neighbours, the first of which in all columns is `first`; `stresses` \[Pa\] and `loads` count from there.
pub(super) fn own_stress_force<const D: usize>(
    solid_row: &Row<'_, D>,
    volumes: &[f64],
    first: usize,
    stresses: &[SMatrix<f64, D, D>],
    loads: &mut [SVector<f64, D>],
) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    for (k, &neighbor) in solid_row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        let Some(stress) = stresses.get(b - first) else { continue };
        let gradient = solid_row.separations[k] * solid_row.gradient_factors[k];
        let force = stress * gradient * (volumes[solid_row.index] * volumes[b]);
        sum += force;
        loads[b - first] -= force;
    }
    sum
}
