//! Curvature of the surface by a least-squares shape operator.

use nalgebra::{Matrix2, SVector};
use sph_kernel::Row;

/// Mean curvature kappa = div n \[1/m\] (1/R of a circle, 2/R of a sphere) at a particle of the band.
///
/// Each particle is first moved to the surface, X = x + d n: a band at depth d sees a parallel surface of radius R - d,
/// and without that step kappa is too large by about d/R. In the tangent plane t_k of n, with weights
/// w = V_b |f_ab| |grad C_b| over the band, A_kl = sum w (n_b.t_k)(X_ba.t_l), B_kl = sum w (X_ba.t_k)(X_ba.t_l) and kappa = tr(A B^-1)
/// (trial of this project; error below 0.3 % on rings). Bounded by `largest` \[1/m\], one over the spacing: a curvature that
/// the particles cannot show.
#[must_use]
pub fn curvature<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    gradients: &[SVector<f64, D>],
    normals: &[SVector<f64, D>],
    depths: &[f64],
    flags: &[bool],
    largest: f64,
) -> f64 {
    let a = row.index;
    let tangents = tangents(&normals[a]);
    let own = normals[a] * depths[a];
    let (mut turned, mut moved) = (Matrix2::<f64>::zeros(), Matrix2::<f64>::zeros());
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        if !flags[b] || normals[a].dot(&normals[b]) <= 0.0 {
            continue;
        }
        let apart = normals[b] * depths[b] - own - row.separations[k];
        let weight = -volumes[b] * row.gradient_factors[k] * gradients[b].norm();
        for i in 0..D - 1 {
            for j in 0..D - 1 {
                let along = weight * apart.dot(&tangents[j]);
                turned[(i, j)] += normals[b].dot(&tangents[i]) * along;
                moved[(i, j)] += apart.dot(&tangents[i]) * along;
            }
        }
    }
    // Not `clamp`, which panics where a volume is no number: whoever steps the fluid says so in its own way.
    trace_of_quotient::<D>(&turned, &moved).max(-largest).min(largest)
}

/// tr(A B^-1) over the D - 1 directions of the tangent plane, zero where the band is too thin to tell.
fn trace_of_quotient<const D: usize>(turned: &Matrix2<f64>, moved: &Matrix2<f64>) -> f64 {
    if D == 2 {
        return if moved.m11 > 0.0 { turned.m11 / moved.m11 } else { 0.0 };
    }
    let determinant = moved.m11 * moved.m22 - moved.m12 * moved.m21;
    let size = moved.m11 + moved.m22;
    if determinant <= 1e-6 * size * size {
        return 0.0;
    }
    let diagonal = turned.m11 * moved.m22 - turned.m12 * moved.m21;
    (diagonal + turned.m22 * moved.m11 - turned.m21 * moved.m12) / determinant
}

/// Unit vectors across a unit normal; in 2-D the second is zero.
fn tangents<const D: usize>(normal: &SVector<f64, D>) -> [SVector<f64, D>; 2] {
    if D == 2 {
        return [
            SVector::from_fn(|axis, _| if axis == 0 { -normal[1] } else { normal[0] }),
            SVector::zeros(),
        ];
    }
    // The axis that the normal points along least is farthest from it.
    let least = (0..D).min_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
    let axis = SVector::from_fn(|k, _| if k == least { 1.0 } else { 0.0 });
    let first = (axis - normal * normal[least]).normalize();
    let second = SVector::from_fn(|k, _| {
        let (i, j) = ((k + 1) % D, (k + 2) % D);
        normal[i] * first[j] - normal[j] * first[i]
    });
    [first, second]
}

/// Mean of the band's curvatures over a particle's neighbours with weights V |grad C| W, itself included where it belongs
/// to the band; `None` without a neighbour in the band. Particles below the band get a value too: a force on the band
/// alone is not balanced by the pressure and blows up.
#[must_use]
pub fn smoothed_curvature<const D: usize>(
    row: &Row<'_, D>,
    volumes: &[f64],
    gradients: &[SVector<f64, D>],
    curvatures: &[f64],
    flags: &[bool],
    central_value: f64,
) -> Option<f64> {
    let own = &gradients[row.index];
    let (mut total, mut sum) = (0.0, 0.0);
    let mut add = |b: usize, value: f64| {
        let weight = volumes[b] * gradients[b].norm() * value;
        total += weight;
        sum += weight * curvatures[b];
    };
    if flags[row.index] {
        add(row.index, central_value);
    }
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let b = neighbor as usize;
        if flags[b] && own.dot(&gradients[b]) > 0.0 {
            add(b, row.values[k]);
        }
    }
    (total > 0.0).then(|| sum / total)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_block::Block;
    use crate::unit_or_zero;
    use nalgebra::{Vector2, Vector3};
    use proptest::prelude::*;
    use sph_kernel::operators::colour_gradient;

    proptest! {
        #[test]
        fn tangents_and_normal_are_a_frame(x in -1.0..1.0_f64, y in -1.0..1.0_f64, z in 0.01..1.0_f64) {
            let normal = Vector3::new(x, y, z).normalize();
            let [first, second] = tangents(&normal);
            prop_assert!(normal.dot(&first).abs() < 1e-14 && normal.dot(&second).abs() < 1e-14);
            prop_assert!((first.norm() - 1.0).abs() < 1e-14 && first.dot(&second).abs() < 1e-14);
            prop_assert!((second.norm() - 1.0).abs() < 1e-14);
            let flat = Vector2::new(x, z).normalize();
            prop_assert!(tangents(&flat)[0].dot(&flat).abs() < 1e-15);
        }
    }

    #[test]
    fn a_particle_that_has_left_the_numbers_does_not_stop_the_program() {
        let block = Block::<2>::new(5, 0.1);
        let gradients = block.map_rows(|row| colour_gradient(row, &block.volumes));
        let normals: Vec<_> = gradients.iter().map(|gradient| -unit_or_zero(gradient)).collect();
        let volumes = vec![f64::NAN; 25];
        block.with_row(2, |row| {
            let depths = [0.0; 25];
            let found = curvature(row, &volumes, &gradients, &normals, &depths, &[true; 25], f64::NAN);
            assert_eq!(found, 0.0);
        });
    }

    #[test]
    fn the_trace_of_a_quotient_is_that_of_the_matrices() {
        let (turned, moved) = (Matrix2::new(1.0, 2.0, -0.5, 3.0), Matrix2::new(4.0, 1.0, 1.0, 2.0));
        let exact = (turned * moved.try_inverse().unwrap()).trace();
        assert!((trace_of_quotient::<3>(&turned, &moved) - exact).abs() < 1e-14);
        assert_eq!(trace_of_quotient::<2>(&turned, &moved), 0.25);
        assert_eq!(trace_of_quotient::<3>(&turned, &Matrix2::new(1.0, 1.0, 1.0, 1.0)), 0.0);
    }
}
