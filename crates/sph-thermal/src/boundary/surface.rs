//! The potential at a face, from the two layers of particles below it.
//!
//! Below a face that takes up a flux q the potential falls as theta(z) = theta_0 - q z + C z² (C from conduction along
//! the face and from heating up). Two layers and the known flux give theta_0 to third order. The layer's own value
//! is 15 % of the rise too low at five spacings to a beam radius, and theta_1 + q z_1 is 1.3 % too high.

/// Potential at the face \[W/m\] from the layers at depths z_1 < z_2 \[m\] and the flux q into the body \[W/m²\].
#[inline]
pub fn surface_potential(first: (f64, f64), second: (f64, f64), flux: f64) -> f64 {
    let ((z1, theta1), (z2, theta2)) = (first, second);
    let curvature = ((theta1 + flux * z1) - (theta2 + flux * z2)) / (z1 * z1 - z2 * z2);
    theta1 + flux * z1 - curvature * z1 * z1
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn exact_for_every_parabola(
            theta0 in -1e5..1e5f64, flux in 0.0..1e9f64, curvature in -1e12..1e12f64, dx in 1e-6..1e-3f64,
        ) {
            let at = |z: f64| theta0 - flux * z + curvature * z * z;
            let (z1, z2) = (0.5 * dx, 1.5 * dx);
            let found = surface_potential((z1, at(z1)), (z2, at(z2)), flux);
            prop_assert!((found - theta0).abs() <= 1e-9 * (theta0.abs() + flux * dx + curvature.abs() * dx * dx) + 1e-9);
        }
    }
}
