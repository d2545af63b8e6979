//! Which particles make the surface, and where its plane lies.

use nalgebra::SVector;
use sph_kernel::Row;

/// |grad C| h from which a particle may belong to the surface.
const WEAK: f64 = 0.1;
/// |grad C| h from which it does.
const STRONG: f64 = 0.3;
/// Cosine between normals of a weak particle and of a strong one beside it.
const ALIGNED: f64 = 0.5;
/// Mean normals shorter than this say nothing: the surface is torn or folded there.
const SHORTEST_MEAN: f64 = 0.3;

/// The vector over its length, or zero.
#[inline]
#[must_use]
pub fn unit_or_zero<const D: usize>(vector: &SVector<f64, D>) -> SVector<f64, D> {
    let length = vector.norm();
    if length > 0.0 { vector / length } else { SVector::zeros() }
}

/// Whether a particle may belong to the band at all; what the band needs of a particle is of no use elsewhere.
#[inline]
#[must_use]
pub fn may_be_surface<const D: usize>(gradient: &SVector<f64, D>, smoothing_length: f64) -> bool {
    gradient.norm() * smoothing_length > WEAK
}

/// Whether a particle lies in the outermost row.
#[inline]
fn is_strong<const D: usize>(gradient: &SVector<f64, D>, smoothing_length: f64) -> bool {
    gradient.norm() * smoothing_length > STRONG
}

/// Whether a particle belongs to the band of the surface (rows one and two): |grad C| h > 0.1, and > 0.3 itself or
/// beside a particle of > 0.3 with a similar normal.
///
/// A cut on the colour itself would lose the second row and 13 % of the Marangoni force. `gradients` of all particles.
#[must_use]
pub fn is_surface<const D: usize>(
    row: &Row<'_, D>,
    gradients: &[SVector<f64, D>],
    smoothing_length: f64,
) -> bool {
    let own = &gradients[row.index];
    let length = own.norm();
    if !may_be_surface(own, smoothing_length) {
        return false;
    }
    is_strong(own, smoothing_length)
        || row.neighbors.iter().any(|&neighbor| {
            let other = &gradients[neighbor as usize];
            is_strong(other, smoothing_length) && own.dot(other) > ALIGNED * length * other.norm()
        })
}

/// Outward normal of a particle of the band, averaged over the band with weights |grad C| W, itself included.
///
/// `gradients` grad C and `flags` of all particles; -grad C/|grad C| is the normal of one.
#[must_use]
pub fn smoothed_normal<const D: usize>(
    row: &Row<'_, D>,
    gradients: &[SVector<f64, D>],
    flags: &[bool],
    central_value: f64,
) -> SVector<f64, D> {
    let own = &gradients[row.index];
    let mut sum = own * central_value;
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        let other = &gradients[neighbor as usize];
        if flags[neighbor as usize] && own.dot(other) > 0.0 {
            sum += other * row.values[k];
        }
    }
    -unit_or_zero(&sum)
}

/// Normal of the smoothed surface over a particle, the particle's depth below it \[m\], and how far the band's normals agree \[-\]: one
/// under a plane, less where the surface bends or folds. `None` away from the band, and where it is torn.
///
/// N = mean of n_b over the band with weights |grad C_b| W, whose length is the third, s = N . mean of (x_b + d_b n_b - x_a). `normals`,
/// depths `depths` of particles below the surface \[m\], `gradients` and `flags` belong to all particles.
#[must_use]
pub fn plane_of_surface<const D: usize>(
    row: &Row<'_, D>,
    gradients: &[SVector<f64, D>],
    normals: &[SVector<f64, D>],
    depths: &[f64],
    flags: &[bool],
    central_value: f64,
) -> Option<(SVector<f64, D>, f64, f64)> {
    let (mut total, mut normal, mut point) = (0.0, SVector::zeros(), SVector::zeros());
    let mut add = |b: usize, value: f64, towards: SVector<f64, D>| {
        let weight = gradients[b].norm() * value;
        total += weight;
        normal += normals[b] * weight;
        point += (towards + normals[b] * depths[b]) * weight;
    };
    if flags[row.index] {
        add(row.index, central_value, SVector::zeros());
    }
    for (k, &neighbor) in row.neighbors.iter().enumerate() {
        if flags[neighbor as usize] {
            add(neighbor as usize, row.values[k], -row.separations[k]);
        }
    }
    let mean = normal / total;
    let length = mean.norm();
    let found = || (mean / length, (mean / length).dot(&point) / total, length);
    (total > 0.0 && length >= SHORTEST_MEAN).then(found)
}
