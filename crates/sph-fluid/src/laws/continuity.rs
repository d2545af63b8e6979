//! Conservation of mass.

use super::Fields;
use sph_kernel::Row;

/// d rho_a/dt = rho_a sum_b V_b (v_a - v_b).grad_a W \[kg/(m^3 s)\] (Hu and Eberhard 2015, eq. 16).
///
/// Reads densities, volumes and velocities. A wall enters with its own velocity. The density must be advanced with
/// the velocity that moved the particles, before forces are formed: one step of lag exploded every trial.
#[inline]
#[must_use]
pub fn density_rate<const D: usize>(row: &Row<'_, D>, fields: &Fields<'_, D>) -> f64 {
    let a = row.index;
    let mut sum = 0.0;
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        let closing = (fields.velocities[a] - fields.velocities[b]).dot(&row.separations[k]);
        sum += fields.volumes[b] * row.gradient_factors[k] * closing;
    }
    fields.densities[a] * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use nalgebra::{Matrix2, Matrix3, SMatrix, Vector2, Vector3};
    use sph_kernel::operators::moment;

    /// Rate and the scale of the moment matrix, m of M = m 1, in the middle of a lattice.
    fn rate_in_a_linear_flow<const D: usize>(count: usize, gradient: SMatrix<f64, D, D>) -> (f64, f64) {
        let block = Block::lattice(count, |position| gradient * position);
        block.with_row(Block::<D>::middle(count), |row| {
            (density_rate(row, &block.fields()), moment(row, &block.volumes)[(0, 0)])
        })
    }

    #[test]
    fn a_linear_flow_gives_its_divergence_in_a_lattice() {
        // On a lattice M = m 1, so that the sum is m div v to round-off, and m is one to the error of the lattice.
        let (rate, scale) = rate_in_a_linear_flow(9, Matrix2::new(0.3, 5.0, -2.0, 0.4));
        assert!((rate + 2.0 * 0.7 * scale).abs() < 1e-13);
        assert!((scale - 1.0).abs() < 5e-3, "{scale}");
        let stretch = Matrix3::new(0.3, 5.0, 1.0, -2.0, 0.4, 3.0, 2.0, 2.0, 0.5);
        let (rate, scale) = rate_in_a_linear_flow(7, stretch);
        assert!((rate + 2.0 * 1.2 * scale).abs() < 1e-13);
        assert!((scale - 1.0).abs() < 5e-3, "{scale}");
    }

    #[test]
    fn rotation_changes_no_density_anywhere() {
        // v_ab is normal to r_ab for every pair, so that this holds without any lattice.
        let mut block = Block::<2>::new(6, 0.3);
        block.velocities = block.positions.iter().map(|r| Vector2::new(-r.y, r.x)).collect();
        block.for_each_row(|row| assert!(density_rate(row, &block.fields()).abs() < 1e-13));
    }

    #[test]
    fn is_the_same_for_a_moving_observer() {
        let rates = |block: &Block<3>| block.map_rows(|row| density_rate(row, &block.fields()));
        let at_rest = rates(&Block::new(4, 0.2));
        let moving = rates(&Block::new(4, 0.2).moved_by(Vector3::new(3.0, -2.0, 1.0)));
        assert!(at_rest.iter().all(|rate| rate.abs() > 1e-6));
        for (a, b) in at_rest.iter().zip(&moving) {
            assert!((a - b).abs() < 1e-13);
        }
    }

    #[test]
    fn is_the_derivative_of_summed_volume() {
        // d/dt of the sum of W over the neighbours along the motion, for volumes held fixed.
        let block = Block::<2>::new(5, 0.2);
        let index = Block::<2>::middle(5);
        let colour = |dt: f64| {
            let mut later = Block::<2>::new(5, 0.2);
            for (position, velocity) in later.positions.iter_mut().zip(&block.velocities) {
                *position += velocity * dt;
            }
            later.with_row(index, |row| {
                row.neighbors.iter().zip(row.values).map(|(&b, w)| block.volumes[b as usize] * w).sum::<f64>()
            })
        };
        let slope = (colour(1e-5) - colour(-1e-5)) / 2e-5;
        let rate = block.with_row(index, |row| density_rate(row, &block.fields()));
        assert!((rate / block.densities[index] - slope).abs() < 1e-9);
    }
}
