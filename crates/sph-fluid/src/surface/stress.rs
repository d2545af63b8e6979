//! Surface tension as a stress in the rows of the surface, the alternative to a force along its curvature.

use nalgebra::{SMatrix, SVector};
use sph_kernel::Row;

/// How tension acts on the particles of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SurfaceModel {
    /// A force tau kappa along the doubled colour gradient, with a curvature of its own, and Marangoni's force beside it: a uniform
    /// pressure balances it particle by particle, momentum is kept to the error of the curvature.
    #[default]
    Force,
    /// The divergence of a stress tau (I - n n) in the surface's rows, which holds Marangoni's force too: equal and opposite
    /// between particles of fluid, without a curvature, and balanced over the whole surface only.
    Stress,
}

/// What plain sums make of a stress beside a free surface is C of it, the colour, for lack of neighbours: a stress of 2 w1 pulls across
/// a cut with int 2 w1 C ds = \[C^2\] from 1/2 to 1 = 3/4 of its tension, whatever the kernel and the dimension. One over that.
pub const PLAIN_SHARE: f64 = 4.0 / 3.0;

/// tau 2 w1(s) (I - N N) \[N/m^2\] (Lafaurie et al. 1994; for particles Hu and Adams 2006), spread over the depth as Marangoni's force
/// is ([`marangoni_force`](crate::marangoni_force)): its integral over the depth is tau.
#[inline]
#[must_use]
pub fn surface_stress<const D: usize>(
    tension: f64,
    plane_weight: f64,
    normal: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    (SMatrix::identity() - normal * normal.transpose()) * (2.0 * tension * plane_weight)
}

/// sum_b V_b (S_a + S_b) grad_a W \[N/m^3; N/m^2 in 2-D\]: times V_a equal and opposite in every pair.
///
/// S is the stress times [`PLAIN_SHARE`], or times the inverse moment B of its particle, with which the whole of it pulls across a
/// cut (as in [`conjugate_pressure_acceleration`](crate::conjugate_pressure_acceleration)). `fluid_row` holds fluid only: the surface ends
/// at a wall.
#[inline]
#[must_use]
pub fn surface_stress_force<const D: usize>(
    fluid_row: &Row<'_, D>,
    volumes: &[f64],
    stresses: &[SMatrix<f64, D, D>],
) -> SVector<f64, D> {
    let own = &stresses[fluid_row.index];
    let mut sum = SVector::zeros();
    for (k, &neighbor) in fluid_row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        let shared = own + stresses[b];
        sum += shared * (fluid_row.separations[k] * (volumes[b] * fluid_row.gradient_factors[k]));
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use crate::{PlaneProfile, unit_or_zero};
    use nalgebra::{Vector2, Vector3};

    #[test]
    fn a_stress_lies_in_the_surface() {
        let normal = Vector3::new(2.0, -1.0, 2.0) / 3.0;
        let stress = surface_stress(0.5, 3.0, &normal);
        let along = Vector3::new(1.0, 2.0, 0.0);
        assert!((stress * normal).norm() < 1e-15);
        assert!((stress * along - along * 3.0).norm() < 1e-14);
        assert!((stress.trace() - 2.0 * 3.0).abs() < 1e-14);
    }

    #[test]
    fn momentum_stays() {
        let block = Block::<3>::new(5, 0.3);
        let stresses: Vec<_> =
            block.velocities.iter().map(|v| surface_stress(1.0, 2.0, &unit_or_zero(v))).collect();
        let accelerations = block.map_rows(|row| {
            surface_stress_force(row, &block.volumes, &stresses) / block.densities[row.index]
        });
        assert!(block.relative_momentum(&accelerations) < 1e-14);
    }

    #[test]
    fn plain_sums_pull_across_a_cut_of_a_flat_layer_with_the_whole_tension() {
        // Particles left of a cut through a lattice whose upper face is the surface. Sums over a lattice are 5 % off their integrals.
        let block = Block::<2>::lattice(13, |_| Vector2::zeros());
        let profile = PlaneProfile::new(&Block::<2>::kernel());
        let stresses: Vec<_> = block
            .positions
            .iter()
            .map(|place| {
                let depth = 12.5 - place.y;
                surface_stress(0.7, profile.weight(depth), &Vector2::y()) * PLAIN_SHARE
            })
            .collect();
        let across_the_cut: f64 = (0..13)
            .flat_map(|row| (0..6).map(move |column| 13 * row + column))
            .map(|left| {
                let force = block.with_row(left, |row| surface_stress_force(row, &block.volumes, &stresses));
                block.volumes[left] * force.x
            })
            .sum();
        assert!((across_the_cut / 0.7 - 1.0).abs() < 0.06, "{across_the_cut}");
    }
}
