//! What fluid sees of a wall: the state of the fluid carried into it.

use super::Fields;
use nalgebra::SVector;
use sph_kernel::Row;

/// Kernel means of the fluid at a particle of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallState<const D: usize> {
    /// Mean velocity of the fluid \[m/s\].
    pub fluid_velocity: SVector<f64, D>,
    /// Pressure of the fluid carried to the wall's particle \[Pa\].
    pub pressure: f64,
}

/// Shepard means over the fluid neighbours: velocity, and pressure with its hydrostatic change,
/// p_w = sum_b V_b W (p_b + rho_b g.(r_w - r_b)) / sum_b V_b W (Adami, Hu and Adams 2012, eqs. 22 and 27).
///
/// `fluid_row` holds the wall's fluid neighbours only ([`leading_part`](crate::leading_part)). `body_acceleration` g
/// \[m/s^2\] less the wall's own acceleration. `None` where there is no fluid.
#[inline]
#[must_use]
pub fn wall_state<const D: usize>(
    fluid_row: &Row<'_, D>,
    fields: &Fields<'_, D>,
    body_acceleration: &SVector<f64, D>,
) -> Option<WallState<D>> {
    let (mut total, mut pressure, mut velocity) = (0.0, 0.0, SVector::zeros());
    for (k, &neighbor) in fluid_row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        let weight = fields.volumes[b] * fluid_row.values[k];
        let head = fields.densities[b] * body_acceleration.dot(&fluid_row.separations[k]);
        total += weight;
        pressure += weight * (fields.pressures[b] + head);
        velocity += fields.velocities[b] * weight;
    }
    (total > 0.0).then(|| WallState { fluid_velocity: velocity / total, pressure: pressure / total })
}

/// v_w = 2 v_s - <v_fluid> \[m/s\], the velocity that friction sees (Adami, Hu and Adams 2012, eq. 23).
///
/// `velocity` v_s is the wall's own, `fluid_velocity` that of [`wall_state`]. With the wall's own velocity alone the fluid
/// comes to rest 0.6 spacings inside the wall (trial of this project).
#[inline]
#[must_use]
pub fn wall_velocity<const D: usize>(
    velocity: &SVector<f64, D>,
    fluid_velocity: &SVector<f64, D>,
) -> SVector<f64, D> {
    velocity * 2.0 - fluid_velocity
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::leading_part;
    use crate::test_block::Block;
    use nalgebra::Vector2;

    #[test]
    fn fluid_at_rest_under_gravity_gives_the_hydrostatic_pressure_in_the_wall() {
        let mut block = Block::<2>::new(7, 0.2);
        block.densities.fill(2.0);
        let gravity = Vector2::new(0.4, -9.81);
        block.pressures = block.positions.iter().map(|r| 5.0 + 2.0 * gravity.dot(r)).collect();
        let wall = 45;
        let state = block
            .with_row(wall, |row| wall_state(&leading_part(row, 42), &block.fields(), &gravity))
            .unwrap();
        assert!((state.pressure - block.pressures[wall]).abs() < 1e-12);
    }

    #[test]
    fn plug_flow_is_seen_with_its_speed_and_mirrored() {
        let mut block = Block::<2>::new(7, 0.2);
        block.velocities.fill(Vector2::new(3.0, 1.0));
        let state = block
            .with_row(45, |row| wall_state(&leading_part(row, 42), &block.fields(), &Vector2::zeros()))
            .unwrap();
        assert!((state.fluid_velocity - Vector2::new(3.0, 1.0)).norm() < 1e-14);
        let mirrored = wall_velocity(&Vector2::new(1.0, 1.0), &state.fluid_velocity);
        assert!((mirrored - Vector2::new(-1.0, 1.0)).norm() < 1e-14);
    }

    #[test]
    fn without_fluid_there_is_no_state() {
        let block = Block::<2>::new(7, 0.2);
        let state =
            block.with_row(45, |row| wall_state(&leading_part(row, 0), &block.fields(), &Vector2::zeros()));
        assert_eq!(state, None);
    }
}
