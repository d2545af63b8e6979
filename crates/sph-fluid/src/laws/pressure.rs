//! The force of pressure.

use super::Fields;
use nalgebra::SVector;
use sph_kernel::Row;

/// -sum_b m_b (p_a/rho_a^2 + p_b/rho_b^2) grad_a W \[m/s^2\], the form of the stress in Hu and Eberhard (2015, eq. 4);
/// Monaghan (1992, eq. 3.3).
///
/// Equal and opposite in every pair. Reads masses, densities and pressures. Its partner that keeps energy is
/// d rho_a/dt = sum_b m_b v_ab.grad W, not eq. 16.
#[inline]
#[must_use]
pub fn symmetric_pressure_acceleration<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
) -> SVector<f64, D> {
    let over_square = |i: usize| fields.pressures[i] / (fields.densities[i] * fields.densities[i]);
    let own = over_square(row.index);
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        sum -= row.separations[k] * (fields.masses[b] * row.gradient_factors[k] * (own + over_square(b)));
    }
    sum
}

/// -(1/rho_a) sum_b V_b (p_a + p_b) grad_a W \[m/s^2\] (Colagrossi and Landrini 2003).
///
/// Equal and opposite in every pair, and with [`density_rate`](crate::density_rate) the work of the forces is the
/// change of internal energy to round-off. Of a uniform pressure it is -2 p sum V grad W, the balance that surface
/// tension needs. Reads densities, volumes and pressures; p is not clamped at zero, or concave melt tears apart.
#[inline]
#[must_use]
pub fn volume_pressure_acceleration<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
) -> SVector<f64, D> {
    let a = row.index;
    let mut sum = SVector::zeros();
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        let pressure = fields.pressures[a] + fields.pressures[b];
        sum -= row.separations[k] * (fields.volumes[b] * row.gradient_factors[k] * pressure);
    }
    sum / fields.densities[a]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::density_rate;
    use crate::test_block::Block;
    use nalgebra::{SVector, Vector2};
    use sph_kernel::operators::moment;

    #[test]
    fn both_forms_keep_momentum_to_round_off() {
        let block = Block::<3>::new(5, 0.3);
        let symmetric = block.map_rows(|row| symmetric_pressure_acceleration(row, &block.fields()));
        let by_volume = block.map_rows(|row| volume_pressure_acceleration(row, &block.fields()));
        assert!(block.relative_momentum(&symmetric) < 1e-15);
        assert!(block.relative_momentum(&by_volume) < 1e-15);
    }

    #[test]
    fn work_of_the_volume_form_is_the_change_of_internal_energy() {
        // m v.a + m p/rho^2 d rho/dt summed over all particles.
        let block = Block::<2>::new(8, 0.3);
        let fields = block.fields();
        let power = |row: &Row<'_, 2>| {
            let a = row.index;
            let density = block.densities[a];
            let kinetic =
                block.masses[a] * block.velocities[a].dot(&volume_pressure_acceleration(row, &fields));
            let internal =
                block.masses[a] * block.pressures[a] / (density * density) * density_rate(row, &fields);
            (kinetic, internal)
        };
        let powers = block.map_rows(power);
        let sum: f64 = powers.iter().map(|(kinetic, internal)| kinetic + internal).sum();
        let kinetic: f64 = powers.iter().map(|(kinetic, _)| kinetic).sum();
        assert!(kinetic.abs() > 0.1);
        assert!(sum.abs() < 1e-12, "{sum}");
    }

    #[test]
    fn a_linear_pressure_gives_its_gradient_in_a_lattice() {
        let mut block = Block::<2>::lattice(9, |_| SVector::zeros());
        block.pressures = block.positions.iter().map(|r| 7.0 + 0.3 * r.x - 0.8 * r.y).collect();
        block.with_row(Block::<2>::middle(9), |row| {
            // On a lattice the moment matrix is a number m times the identity.
            let expected = Vector2::new(-0.3, 0.8) * moment(row, &block.volumes)[(0, 0)] / 2.0;
            assert!((volume_pressure_acceleration(row, &block.fields()) - expected).norm() < 1e-13);
            assert!((symmetric_pressure_acceleration(row, &block.fields()) - expected).norm() < 1e-13);
        });
    }

    #[test]
    fn uniform_pressure_pushes_the_face_outward_by_the_colour_gradient() {
        let mut block = Block::<2>::new(7, 0.2);
        block.pressures.fill(3.0);
        block.with_row(3, |row| {
            let colour_gradient: Vector2<f64> =
                (0..row.len()).map(|k| row.gradient(k) * block.volumes[row.neighbors[k] as usize]).sum();
            let expected = colour_gradient * (-2.0 * 3.0 / block.densities[3]);
            let found = volume_pressure_acceleration(row, &block.fields());
            assert!((found - expected).norm() < 1e-14 && found.y < -0.1, "{found}");
        });
    }
}
