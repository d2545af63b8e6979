//! Values of a fluid at a place, by least squares over the particles near it.

use crate::FluidPatch;
use nalgebra::{SMatrix, SVector, Vector2};

/// Radius of what a fit sees \[spacings\].
const RADIUS: f64 = 3.0;

/// Velocity at a place, of a parabola in both directions through the particles within three spacings, weighted with
/// (1 - (r/R)^2)^2; not a number where they are too few.
pub(super) fn velocity_at(patch: &FluidPatch<2>, place: Vector2<f64>) -> Vector2<f64> {
    let radius = RADIUS * patch.spacing();
    let (mut matrix, mut right) = (SMatrix::<f64, 6, 6>::zeros(), SMatrix::<f64, 6, 2>::zeros());
    for (position, velocity) in patch.positions().iter().zip(patch.velocities()) {
        let r = (position - place) / radius;
        if r.norm_squared() < 1.0 {
            let basis = SVector::from([1.0, r.x, r.y, r.x * r.x, r.x * r.y, r.y * r.y]);
            let weight = (1.0 - r.norm_squared()).powi(2);
            matrix += basis * basis.transpose() * weight;
            right += basis * velocity.transpose() * weight;
        }
    }
    let fitted = matrix.cholesky().map(|cholesky| cholesky.solve(&right).row(0).transpose());
    fitted.unwrap_or(Vector2::repeat(f64::NAN))
}
