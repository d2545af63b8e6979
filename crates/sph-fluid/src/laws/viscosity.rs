//! Friction of a Newtonian fluid.

use super::Fields;
use nalgebra::SVector;
use sph_kernel::Row;

/// How the friction of a pair acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Friction {
    /// Against the difference of velocities ([`viscous_acceleration`]): accurate along walls and in layers.
    #[default]
    Shear,
    /// Against the closing of a pair ([`strain_acceleration`]): right where a free surface bends as it flows.
    Strain,
}

/// Dynamic viscosity eta \[Pa s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viscosity<'a> {
    /// The same everywhere.
    Even(f64),
    /// One of each particle: of a melt whose temperature changes it.
    Each(&'a [f64]),
}

impl Viscosity<'_> {
    /// Mean of two particles \[Pa s\]: with it the sum over pairs is div(eta grad v) to second order where eta is smooth.
    #[inline]
    #[must_use]
    pub fn between(&self, a: usize, b: usize) -> f64 {
        match self {
            Self::Even(viscosity) => *viscosity,
            Self::Each(viscosities) => 0.5 * (viscosities[a] + viscosities[b]),
        }
    }
}

/// sum_b m_b (eta_a + eta_b)/(rho_a rho_b) (W'/r) (v_a - v_b) \[m/s^2\] (Morris, Fox and Zhu 1997, eq. 22).
///
/// `velocities` \[m/s\] are those that friction sees: a particle's own for fluid, and the
/// extrapolated [`wall_velocity`](crate::wall_velocity) for walls, so that the fluid is at rest at the face and not at
/// the first row of the wall. Morris adds 0.01 h^2 to r^2, which is left out: W'/r is finite at r = 0.
#[inline]
#[must_use]
pub fn viscous_acceleration<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    velocities: &[SVector<f64, D>],
    viscosity: Viscosity<'_>,
) -> SVector<f64, D> {
    let sum: SVector<f64, D> =
        (0..row.len()).map(|k| shear_term(row, fields, velocities, viscosity, k)).sum();
    sum * shear_scale(fields, row.index)
}

/// What neighbour k adds to the sum of [`viscous_acceleration`].
// A call of its own for each pair costs more than the term.
#[inline(always)]
pub(super) fn shear_term<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    velocities: &[SVector<f64, D>],
    viscosity: Viscosity<'_>,
    k: usize,
) -> SVector<f64, D> {
    let (a, b) = (row.index, row.neighbors[k] as usize);
    let weight = viscosity.between(a, b) * fields.volumes[b] * row.gradient_factors[k];
    (velocities[a] - velocities[b]) * weight
}

pub(super) fn shear_scale<const D: usize>(fields: &Fields<'_, D>, a: usize) -> f64 {
    2.0 / fields.densities[a]
}

/// sum_b V_b 2 (D + 2) (eta/rho_a) (v_ab.r_ab/r^2) grad_a W \[m/s^2\], along the line of each pair (Monaghan and Gingold 1983,
/// with the factor that makes it nu laplace v where div v = 0).
///
/// Arguments as in [`viscous_acceleration`]. It takes the energy of strain, 2 eta e:e, and none from a rotation; the form of
/// Morris takes eta grad v:grad v. Both are nu laplace v inside, but at a free surface only this one means a surface
/// without traction (Colagrossi, Antuono, Souto-Iglesias and Le Touze 2011): in potential flow, whose e is grad v, Morris'
/// takes half, and a wave decays too slowly. It feels the directions of a lattice, by 7 % of the decay of a wave where
/// h = 1.5 spacings (trial of this project), so that layers along walls keep Morris'.
#[inline]
#[must_use]
pub fn strain_acceleration<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    velocities: &[SVector<f64, D>],
    viscosity: Viscosity<'_>,
) -> SVector<f64, D> {
    let sum: SVector<f64, D> =
        (0..row.len()).map(|k| strain_term(row, fields, velocities, viscosity, k)).sum();
    sum * strain_scale(fields, row.index)
}

/// What neighbour k adds to the sum of [`strain_acceleration`].
// A call of its own for each pair costs more than the term.
#[inline(always)]
pub(super) fn strain_term<const D: usize>(
    row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    velocities: &[SVector<f64, D>],
    viscosity: Viscosity<'_>,
    k: usize,
) -> SVector<f64, D> {
    let (b, separation) = (row.neighbors[k] as usize, &row.separations[k]);
    let distance_squared = row.distances[k] * row.distances[k];
    // Two particles in one place have no line to act along.
    if distance_squared == 0.0 {
        return SVector::zeros();
    }
    let closing = (velocities[row.index] - velocities[b]).dot(separation) / distance_squared;
    separation * (viscosity.between(row.index, b) * fields.volumes[b] * row.gradient_factors[k] * closing)
}

pub(super) fn strain_scale<const D: usize>(fields: &Fields<'_, D>, a: usize) -> f64 {
    2.0 * (D as f64 + 2.0) / fields.densities[a]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use nalgebra::{Vector2, Vector3};
    use sph_kernel::operators::moment;
    use sph_kernel::{KernelKind, RowBuffer};

    const EVEN: Viscosity<'static> = Viscosity::Even(0.6);

    fn accelerations<const D: usize>(block: &Block<D>) -> Vec<SVector<f64, D>> {
        block.map_rows(|row| viscous_acceleration(row, &block.fields(), &block.velocities, EVEN))
    }

    #[test]
    fn a_parabolic_profile_gives_its_second_derivative_in_a_lattice() {
        let block = Block::<2>::lattice(9, |r| Vector2::new(5.0 * r.y + 0.7 * r.y * r.y, 0.0));
        block.with_row(Block::<2>::middle(9), |row| {
            let found = viscous_acceleration(row, &block.fields(), &block.velocities, EVEN);
            // nu 2 * 0.7 times the number m of the moment matrix m 1, which is one to the error of the lattice.
            let expected = 0.6 / 2.0 * 1.4 * moment(row, &block.volumes)[(1, 1)];
            assert!((found - Vector2::new(expected, 0.0)).norm() < 1e-13);
            assert!((found.x / 0.42 - 1.0).abs() < 5e-3);
        });
    }

    #[test]
    fn a_viscosity_that_changes_acts_as_its_divergence() {
        // v = (y^2, 0), eta = 3 + y: d/dy (eta dv/dy) = 6 + 4 y, and rho = 2.
        let block = Block::<2>::lattice(9, |r| Vector2::new(r.y * r.y, 0.0));
        let viscosities: Vec<f64> = block.positions.iter().map(|r| 3.0 + r.y).collect();
        block.with_row(Block::<2>::middle(9), |row| {
            let each = Viscosity::Each(&viscosities);
            let found = viscous_acceleration(row, &block.fields(), &block.velocities, each);
            let expected = (6.0 + 4.0 * block.positions[row.index].y) / block.densities[row.index];
            assert!((found - Vector2::new(expected, 0.0)).norm() < 5e-3 * expected, "{found} {expected}");
        });
        let all = vec![0.6; block.positions.len()];
        let even = accelerations(&block);
        let each = block.map_rows(|row| {
            viscous_acceleration(row, &block.fields(), &block.velocities, Viscosity::Each(&all))
        });
        assert!(
            even.iter().zip(&each).all(|(even, each)| (even - each).norm() < 1e-14 * even.norm().max(1.0))
        );
    }

    #[test]
    fn linear_shear_has_no_friction_inside_a_lattice() {
        let block = Block::<3>::lattice(7, |r| Vector3::new(4.0 * r.z - r.y, 2.0 * r.x, 0.0));
        block.with_row(Block::<3>::middle(7), |row| {
            assert!(viscous_acceleration(row, &block.fields(), &block.velocities, EVEN).norm() < 1e-13);
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

    fn strains<const D: usize>(block: &Block<D>) -> Vec<SVector<f64, D>> {
        block.map_rows(|row| strain_acceleration(row, &block.fields(), &block.velocities, EVEN))
    }

    #[test]
    fn strain_keeps_momentum_and_spin_and_never_adds_energy() {
        let block = Block::<2>::new(7, 0.3);
        let found = strains(&block);
        assert!(block.relative_momentum(&found) < 1e-15);
        let (mut power, mut moment, mut size) = (0.0, 0.0, 0.0);
        for i in 0..found.len() {
            let force = found[i] * block.masses[i];
            power += force.dot(&block.velocities[i]);
            moment += block.positions[i].perp(&force);
            size += block.positions[i].norm() * force.norm();
        }
        assert!(power < -1.0, "{power}");
        assert!(moment.abs() < 1e-14 * size, "{moment}");
    }

    #[test]
    fn a_rotating_body_has_no_strain_up_to_its_faces() {
        let mut block = Block::<2>::new(6, 0.3);
        block.velocities = block.positions.iter().map(|r| Vector2::new(-r.y, r.x)).collect();
        assert!(strains(&block).iter().all(|found| found.norm() < 1e-13));
        assert!(accelerations(&block).iter().any(|found| found.norm() > 0.1));
    }

    /// Acceleration over nu laplace v of a profile of shear in the middle of a lattice of spacing h/4.
    fn strain_ratio<const D: usize>(count: usize) -> f64 {
        let block = Block::<D>::lattice(count, |r| {
            SVector::from_fn(|axis, _| if axis == 0 { 0.7 * r[1] * r[1] } else { 0.0 })
        });
        let index = Block::<D>::middle(count);
        let others: Vec<u32> = (0..block.positions.len() as u32).filter(|&j| j as usize != index).collect();
        let kernel = KernelKind::WendlandC2.with_smoothing_length::<D>(4.0);
        let mut buffer = RowBuffer::default();
        let row = buffer.fill(index, &others, &block.positions, &kernel);
        let found = strain_acceleration(&row, &block.fields(), &block.velocities, EVEN);
        found[0] / (0.6 / block.densities[index] * 1.4)
    }

    #[test]
    fn strain_gives_the_second_derivative_in_a_fine_lattice() {
        let (flat, solid) = (strain_ratio::<2>(17), strain_ratio::<3>(17));
        assert!((flat - 1.0).abs() < 0.01 && (solid - 1.0).abs() < 0.01, "{flat} {solid}");
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
