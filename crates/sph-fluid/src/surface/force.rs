//! The forces of surface tension and of its change with temperature.

use nalgebra::SVector;

/// tau kappa 2 grad C \[N/m^3\] (Brackbill, Kothe and Zemach 1992, for a colour that is one-sided and therefore doubled).
///
/// `colour_gradient` \[1/m\] is the plain sum, which points inwards; kappa > 0 of a drop pulls inwards.
#[inline]
#[must_use]
pub fn tension_force<const D: usize>(
    tension: f64,
    curvature: f64,
    colour_gradient: &SVector<f64, D>,
) -> SVector<f64, D> {
    colour_gradient * (2.0 * tension * curvature)
}

/// 2 w1 (I - N N) grad tau \[N/m^3\], the change of tension along the surface spread over the depth; grad tau is tau_T grad T
/// where tension is linear in temperature.
///
/// `tension_gradient` \[N/m^2\], `plane_weight` w1(s) \[1/m\] of [`PlaneProfile`](super::PlaneProfile): its integral over the
/// depth is one half, so that the force over an area is that of grad tau whatever the row's own sums are. Hu and Eberhard (2015,
/// eq. 18), with the surface delta that its second term needs.
#[inline]
#[must_use]
pub fn marangoni_force<const D: usize>(
    plane_weight: f64,
    normal: &SVector<f64, D>,
    tension_gradient: &SVector<f64, D>,
) -> SVector<f64, D> {
    let along = tension_gradient - normal * normal.dot(tension_gradient);
    along * (2.0 * plane_weight)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn tension_pulls_a_drop_together_and_marangoni_runs_along_the_surface() {
        let inwards = Vector3::new(0.0, 0.0, -3.0);
        assert_eq!(tension_force(0.5, 2.0, &inwards), Vector3::new(0.0, 0.0, -6.0));
        let force = marangoni_force(4.0, &Vector3::z(), &Vector3::new(-0.5, 0.0, 7.0));
        assert!((force - Vector3::new(-4.0, 0.0, 0.0)).norm() < 1e-15);
    }
}
