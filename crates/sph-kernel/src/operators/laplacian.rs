//! The Laplacian by pair differences.

use crate::Row;

/// lap u_i = 2 sum_j V_j f_ij (u_i - u_j) \[unit of u per m^2\].
///
/// Sign: f <= 0, so a particle below its neighbours gets a positive value, and du_i/dt = k lap u_i is diffusion.
/// Unnormalised, so that V_i lap u_i exchanges equal and opposite amounts between i and j; divide by
/// [`laplacian_moment`](super::laplacian_moment) for a row that is exact for quadratic fields on a lattice. `volumes`
/// \[m^D\] and `field` u belong to all particles. Source: Brookshaw 1985; Cleary and Monaghan 1999.
#[inline]
pub fn laplacian<const D: usize>(row: &Row<'_, D>, volumes: &[f64], field: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let j = neighbor as usize;
        sum += volumes[j] * row.gradient_factors[k] * (field[row.index] - field[j]);
    }
    2.0 * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operators::laplacian_moment;
    use crate::test_points::{middle, perturbed_lattice, with_row};
    use nalgebra::SVector;

    fn normalised<const D: usize>(smoothing_length: f64, field_at: impl Fn(&SVector<f64, D>) -> f64) -> f64 {
        let positions = perturbed_lattice::<D>(7, 0.0);
        let volumes = vec![1.0; positions.len()];
        let field: Vec<f64> = positions.iter().map(field_at).collect();
        with_row(&positions, middle::<D>(7), smoothing_length, |row| {
            laplacian(row, &volumes, &field) / laplacian_moment(row, &volumes)
        })
    }

    #[test]
    fn is_exact_for_quadratic_fields_on_a_lattice() {
        for smoothing_length in [0.7, 1.0, 1.4] {
            let flat = normalised::<2>(smoothing_length, |r| {
                3.0 * r.x * r.x - r.y * r.y + 5.0 * r.x * r.y + 4.0 * r.x + 1.0
            });
            assert!((flat - 4.0).abs() < 1e-11, "{flat}");
            let solid =
                normalised::<3>(smoothing_length, |r| 3.0 * r.x * r.x - r.z * r.z + r.x * r.z + r.y * r.y);
            assert!((solid - 6.0).abs() < 1e-11, "{solid}");
        }
    }

    #[test]
    fn a_linear_field_has_none_and_a_hollow_gets_filled() {
        assert!(normalised::<3>(1.2, |r| r.x - 2.0 * r.z).abs() < 1e-12);
        assert!(normalised::<2>(1.2, |r| (r - SVector::from([3.0, 3.0])).norm()) > 0.5);
    }

    #[test]
    fn the_exchange_is_antisymmetric() {
        let positions = perturbed_lattice::<2>(2, 0.2);
        let field = [1.0, 4.0, -2.0, 0.5];
        let volumes = [1.0, 2.0, 0.5, 1.5];
        let gain =
            |index| volumes[index] * with_row(&positions, index, 1.3, |row| laplacian(row, &volumes, &field));
        let exchanged: f64 = (0..4).map(gain).sum();
        assert!(gain(2) > 0.1 && exchanged.abs() < 1e-15);
    }
}
