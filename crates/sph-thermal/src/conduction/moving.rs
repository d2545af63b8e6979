//! Conduction between particles that move: weights computed from each row as it is met.
//!
//! g_ij = w_ij (1/M_i + 1/M_j)/2 with w_ij = -2 V_i V_j f_ij and M the second moment of the row: no solve, symmetric,
//! and about 1 % in radius and peak of a spot weld with 20 % disorder, given mirrored images at plane faces and about
//! 70 neighbours (cubic spline, h/dx 1.3). Narrow kernels fail here (3 to 11 %): use the fit where nothing moves.
//!
//! Columns hold particles first and copies (images) after them; a copy carries its source's volume and moment, and the
//! potential continued across its plane.

use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::{Row, RowBuffer, ScaledKernel, operators::laplacian_moment};

/// What a row reads of all particles and copies.
#[derive(Debug, Clone, Copy)]
pub struct Fields<'a> {
    /// Volume (\[m³\], 2-D: \[m²\]).
    pub volume: &'a [f64],
    /// Second moment M of each row.
    pub moment: &'a [f64],
    /// Kirchhoff potential \[W/m\].
    pub potential: &'a [f64],
}

/// Heat \[W\] that the particle of `row` receives (Cleary and Monaghan 1999, eq. 25, with normalized weights).
#[inline]
pub fn conduction_row<const D: usize>(row: &Row<'_, D>, fields: &Fields<'_>) -> f64 {
    let i = row.index;
    let (own, own_inverse) = (fields.potential[i], 1.0 / fields.moment[i]);
    let mut sum = 0.0;
    for (k, &j) in row.neighbors.iter().enumerate() {
        let j = j as usize;
        let scale = own_inverse + 1.0 / fields.moment[j];
        sum -= fields.volume[j] * row.gradient_factors[k] * scale * (fields.potential[j] - own);
    }
    fields.volume[i] * sum
}

/// Second moments M_i of all particles: a sweep for use without an application.
///
/// `row(i)` gives the neighbours of each of the first `particles` positions.
pub fn moments<'r, const D: usize>(
    particles: usize,
    positions: &[SVector<f64, D>],
    volume: &[f64],
    row: impl Fn(usize) -> &'r [u32] + Sync,
    kernel: &ScaledKernel<D>,
) -> Vec<f64> {
    sweep(particles, positions, row, kernel, |row| laplacian_moment(row, volume))
}

/// Heat \[W\] that each particle receives: a sweep for use without an application.
pub fn heat<'r, const D: usize>(
    particles: usize,
    positions: &[SVector<f64, D>],
    fields: &Fields<'_>,
    row: impl Fn(usize) -> &'r [u32] + Sync,
    kernel: &ScaledKernel<D>,
) -> Vec<f64> {
    sweep(particles, positions, row, kernel, |row| conduction_row(row, fields))
}

fn sweep<'r, const D: usize>(
    particles: usize,
    positions: &[SVector<f64, D>],
    row: impl Fn(usize) -> &'r [u32] + Sync,
    kernel: &ScaledKernel<D>,
    term: impl Fn(&Row<'_, D>) -> f64 + Sync,
) -> Vec<f64> {
    let one = |buffer: &mut RowBuffer<D>, i: usize| term(&buffer.fill(i, row(i), positions, kernel));
    (0..particles).into_par_iter().map_init(RowBuffer::default, one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;
    use sph_kernel::KernelKind;

    const SIDE: usize = 20;

    /// A periodic square of 20 x 20 particles, moved by up to `disorder` of a spacing, with copies all around it.
    fn periodic_square(disorder: f64) -> (Vec<Vector2<f64>>, Vec<usize>, Vec<Vec<u32>>) {
        let spacing = 1.0 / SIDE as f64;
        let noise = |n: usize| ((n as f64 * 12.9898).sin() * 43758.5453).rem_euclid(2.0) - 1.0;
        let cell = |n: usize| Vector2::new((n % SIDE) as f64 + 0.5, (n / SIDE) as f64 + 0.5);
        let mut positions: Vec<Vector2<f64>> = (0..SIDE * SIDE)
            .map(|n| spacing * (cell(n) + disorder * Vector2::new(noise(2 * n), noise(2 * n + 1))))
            .collect();
        let mut source: Vec<usize> = (0..positions.len()).collect();
        for n in 0..SIDE * SIDE {
            for shift in
                (-1..=1).flat_map(|x| (-1..=1).map(move |y| Vector2::new(f64::from(x), f64::from(y))))
            {
                let copy = positions[n] + shift;
                if shift.norm() > 0.0 && copy.iter().all(|x| (-0.2..1.2).contains(x)) {
                    positions.push(copy);
                    source.push(n);
                }
            }
        }
        let near = |i: usize, j: usize| i != j && (positions[i] - positions[j]).norm() < 2.6 * spacing;
        let rows = (0..SIDE * SIDE)
            .map(|i| (0..positions.len()).filter(|&j| near(i, j)).map(|j| j as u32).collect())
            .collect();
        (positions, source, rows)
    }

    /// Rate of decay of a cosine wave over its exact value k², with unit diffusivity.
    fn cosine_rate(disorder: f64, normalized: bool) -> f64 {
        let (positions, source, rows) = periodic_square(disorder);
        let particles = SIDE * SIDE;
        let kernel = KernelKind::CubicSpline.with_smoothing_length::<2>(1.3 / SIDE as f64);
        let volume = vec![1.0 / particles as f64; positions.len()];
        let own = moments(particles, &positions, &volume, |i| &rows[i], &kernel);
        let moment: Vec<f64> = source.iter().map(|&s| if normalized { own[s] } else { 1.0 }).collect();
        let wave = |p: &Vector2<f64>| (std::f64::consts::TAU * p.x).cos();
        let potential: Vec<f64> = positions.iter().map(wave).collect();
        let fields = Fields { volume: &volume, moment: &moment, potential: &potential };
        let heat = heat(particles, &positions, &fields, |i| &rows[i], &kernel);
        assert!(heat.iter().sum::<f64>().abs() < 1e-12, "exchange makes no heat");
        let (along, square) = heat
            .iter()
            .zip(&potential)
            .fold((0.0, 0.0), |(along, square), (q, wave)| (along - q * wave, square + wave * wave / 400.0));
        along / square / std::f64::consts::TAU.powi(2)
    }

    #[test]
    fn a_cosine_decays_at_its_rate_on_a_lattice_and_under_disorder() {
        let (lattice, disordered) = (cosine_rate(0.0, true), cosine_rate(0.2, true));
        assert!((lattice - 1.0).abs() < 0.015, "lattice {lattice}");
        assert!((disordered - 1.0).abs() < 0.025, "disordered {disordered}");
        assert!((cosine_rate(0.2, false) - disordered).abs() > 1e-3, "the moments change nothing");
    }
}
