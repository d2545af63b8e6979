//! The second moment that normalises conduction rows.

use crate::Row;

/// M_i = -(1/D) sum_j V_j r_ij^2 f_ij \[-\], the mean of the diagonal of [`moment`](super::moment): about one inside,
/// one half on a flat face.
///
/// Dividing [`laplacian`](super::laplacian) by it makes the row exact for quadratic fields on a lattice, whatever h/dx.
/// `volumes` \[m^D\] of all particles.
#[inline]
pub fn laplacian_moment<const D: usize>(row: &Row<'_, D>, volumes: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        sum += volumes[neighbor as usize] * row.distances[k] * row.distances[k] * row.gradient_factors[k];
    }
    -sum / D as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operators::moment;
    use crate::test_points::{middle, perturbed_lattice, with_row};

    #[test]
    fn is_about_one_inside_and_one_half_on_a_face() {
        let positions = perturbed_lattice::<2>(11, 0.0);
        let volumes = vec![1.0; positions.len()];
        let inside = with_row(&positions, middle::<2>(11), 2.0, |row| laplacian_moment(row, &volumes));
        let face = with_row(&positions, 5, 2.0, |row| laplacian_moment(row, &volumes));
        assert!((inside - 1.0).abs() < 4e-3, "{inside}");
        // The lattice row on the face itself belongs to neither half, hence more than one half.
        assert!(face > 0.5 && face < 0.65, "{face}");
    }

    #[test]
    fn is_the_mean_diagonal_of_the_moment_matrix() {
        let positions = perturbed_lattice::<3>(5, 0.2);
        let volumes: Vec<f64> = (0..positions.len()).map(|k| 1.0 + 0.01 * k as f64).collect();
        with_row(&positions, 31, 1.5, |row| {
            let expected = moment(row, &volumes).trace() / 3.0;
            assert!((laplacian_moment(row, &volumes) - expected).abs() < 1e-14);
        });
    }
}
