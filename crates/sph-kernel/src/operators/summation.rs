//! The colour sum.

use crate::Row;

/// C_i = V_i W(0) + sum_j V_j W_ij \[-\], the smoothed colour or Shepard sum: about one inside, one half on a flat face.
///
/// `volumes` \[m^D\] of all particles; `central_value` is W(0) \[m^-D\], which the row does not hold. Source: Shepard
/// 1968; Monaghan 1992, the interpolant of a constant.
#[inline]
pub fn summation<const D: usize>(row: &Row<'_, D>, volumes: &[f64], central_value: f64) -> f64 {
    let of_neighbors: f64 = row
        .neighbors
        .iter()
        .zip(row.values)
        .map(|(&neighbor, value)| volumes[neighbor as usize] * value)
        .sum();
    volumes[row.index] * central_value + of_neighbors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        KernelKind,
        test_points::{middle, perturbed_lattice, with_row},
    };

    fn sum_in_the_middle<const D: usize>(volume: f64) -> f64 {
        let positions = perturbed_lattice::<D>(9, 0.0);
        let central = KernelKind::WendlandC2.with_smoothing_length::<D>(2.0).value(0.0);
        let volumes = vec![volume; positions.len()];
        with_row(&positions, middle::<D>(9), 2.0, |row| summation(row, &volumes, central))
    }

    #[test]
    fn is_one_inside_a_lattice_and_linear_in_the_volume() {
        // What is left is the quadrature error of the lattice, which falls with h/dx.
        assert!((sum_in_the_middle::<2>(1.0) - 1.0).abs() < 2e-3);
        assert!((sum_in_the_middle::<3>(1.0) - 1.0).abs() < 2e-3);
        assert!((sum_in_the_middle::<2>(3.0) - 3.0 * sum_in_the_middle::<2>(1.0)).abs() < 1e-14);
    }

    #[test]
    fn a_lonely_particle_counts_itself() {
        let positions = perturbed_lattice::<2>(1, 0.0);
        assert_eq!(with_row(&positions, 0, 1.0, |row| summation(row, &[0.5], 0.6)), 0.3);
    }
}
