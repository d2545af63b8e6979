//! The force of pressure by its slope, for a melt under a pressure far above that of its flow.
//!
//! A force of pairs is wrong by the pressure itself times the disorder of the particles. The weight that keeps the top of a
//! melt flat makes a pressure of a hundred times the flow's own and more, and that error then stirs the melt as strongly as
//! what drives it. The corrected slope knows differences of pressure only, and a linear pressure exactly. What pairs tell a
//! surface beside the slope, that nothing presses from outside, it must be told by a force of its own.

use nalgebra::SVector;

/// How pressure acts on the particles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PressureForce {
    /// Equal and opposite in every pair: keeps momentum.
    #[default]
    Pairs,
    /// By its corrected slope (Randles and Libersky 1996), with [`face_force`] near a free surface. Quiet under any pressure; momentum
    /// is kept to the error of the slope only, so that it is for a melt between walls.
    Slope,
}

/// 2 w1(s) (p + s N.grad p) N \[N/m^3; N/m^2 in 2-D\]: the pressure that the slope leaves at a free surface pushes outwards,
/// spread below it as the force of Marangoni is, until none is left.
///
/// `pressure` p \[Pa\] and its `slope` grad p \[Pa/m\] at a particle, `normal` N of the surface over it, outwards, and `depth` s
/// \[m\] below it, with the weight w1(s) \[1/m\] there, whose integral over the depth is one half.
#[inline]
#[must_use]
pub fn face_force<const D: usize>(
    pressure: f64,
    slope: &SVector<f64, D>,
    normal: &SVector<f64, D>,
    depth: f64,
    weight: f64,
) -> SVector<f64, D> {
    normal * (2.0 * weight * (pressure + depth * normal.dot(slope)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PlaneProfile;
    use nalgebra::{Vector2, Vector3};
    use sph_kernel::KernelKind;

    #[test]
    fn weight_leaves_no_pressure_at_the_face() {
        let (slope, normal) = (Vector2::new(0.0, -9.81), Vector2::y());
        assert!(face_force(9.81 * 0.3, &slope, &normal, 0.3, 0.7).norm() < 1e-15);
    }

    #[test]
    fn an_even_pressure_pushes_with_itself() {
        let spacing = 0.1;
        let profile = PlaneProfile::new(&KernelKind::WendlandC2.with_smoothing_length::<3>(1.5 * spacing));
        let depths = (0..4).map(|row| (f64::from(row) + 0.5) * spacing);
        let normal = Vector3::new(0.6, 0.0, 0.8);
        let force = |depth| face_force(5.0, &Vector3::zeros(), &normal, depth, profile.weight(depth));
        let sum: Vector3<f64> = depths.map(force).sum::<Vector3<f64>>() * spacing;
        assert!((sum - normal * 5.0).norm() < 0.05, "{sum}");
    }
}
