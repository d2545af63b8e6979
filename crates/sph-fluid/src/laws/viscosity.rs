//! Friction of a Newtonian fluid.

use super::Fields;
use nalgebra::SVector;
use sph_kernel::Row;

/// sum_b m_b 2 eta/(rho_a rho_b) (W'/r) (v_a - v_b) \[m/s^2\] (Morris, Fox and Zhu 1997, eq. 22, for one viscosity).
///
/// `dynamic_viscosity` eta \[Pa s\]. `velocities` \[m/s\] are those that friction sees: a particle's own for fluid, and the
/// extrapolated [`wall_velocity`](crate::wall_velocity) for walls, so that the fluid is at rest at the face and not at
/// the first row of the wall. Morris adds 0.01 h^2 to r^2, which is left out: W'/r is finite at r = 0.
#[inline]
#[must_use]
pub fn viscous_acceleration<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    velocities: &[SVector<f64, D>],
    dynamic_viscosity: f64,
) -> SVector<f64, D> {
    let a = row.index;
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        sum += (velocities[a] - velocities[b]) * (fields.volumes[b] * row.gradient_factors[k]);
    }
    sum * (2.0 * dynamic_viscosity / fields.densities[a])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use nalgebra::{Vector2, Vector3};
    use sph_kernel::operators::moment;

    fn accelerations<const D: usize>(block: &Block<D>) -> Vec<SVector<f64, D>> {
        block.map_rows(|row| viscous_acceleration(row, &block.fields(), &block.velocities, 0.6))
    }

    #[test]
    fn a_parabolic_profile_gives_its_second_derivative_in_a_lattice() {
        let block = Block::<2>::lattice(9, |r| Vector2::new(5.0 * r.y + 0.7 * r.y * r.y, 0.0));
        block.with_row(Block::<2>::middle(9), |row| {
            let found = viscous_acceleration(row, &block.fields(), &block.velocities, 0.6);
            // nu 2 * 0.7 times the number m of the moment matrix m 1, which is one to the error of the lattice.
            let expected = 0.6 / 2.0 * 1.4 * moment(row, &block.volumes)[(1, 1)];
            assert!((found - Vector2::new(expected, 0.0)).norm() < 1e-13);
            assert!((found.x / 0.42 - 1.0).abs() < 5e-3);
        });
    }

    #[test]
    fn linear_shear_has_no_friction_inside_a_lattice() {
        let block = Block::<3>::lattice(7, |r| Vector3::new(4.0 * r.z - r.y, 2.0 * r.x, 0.0));
        block.with_row(Block::<3>::middle(7), |row| {
            assert!(viscous_acceleration(row, &block.fields(), &block.velocities, 0.6).norm() < 1e-13);
        });
    }

    #[test]
    fn keeps_momentum_and_never_adds_energy() {
        let block = Block::<3>::new(5, 0.3);
        let found = accelerations(&block);
        assert!(block.relative_momentum(&found) < 1e-15);
        let power: f64 = (0..found.len()).map(|i| block.masses[i] * block.velocities[i].dot(&found[i])).sum();
        assert!(power < -1.0, "{power}");
    }

    #[test]
    fn is_the_same_for_a_moving_observer() {
        let at_rest = accelerations(&Block::<2>::new(6, 0.3));
        let moving = accelerations(&Block::<2>::new(6, 0.3).moved_by(Vector2::new(3.0, -8.0)));
        for (a, b) in at_rest.iter().zip(&moving) {
            assert!((a - b).norm() < 1e-13 && a.norm() > 1e-3);
        }
    }
}
