//! Constant flux through a disc of a half space's surface (Carslaw and Jaeger, 10.5).

use libm::erfc;
use std::f64::consts::PI;

/// Rise of the disc's centre, 2 q sqrt(a t)/k (1/sqrt(pi) - ierfc(b/(2 sqrt(a t)))), for the radius b of the disc.
pub fn top_hat_rise(flux: f64, radius: f64, conductivity: f64, diffusivity: f64, time: f64) -> f64 {
    let length = (diffusivity * time).sqrt();
    2.0 * flux * length / conductivity * (1.0 / PI.sqrt() - integrated_erfc(radius / (2.0 * length)))
}

/// Integral of erfc from `x` to infinity.
fn integrated_erfc(x: f64) -> f64 {
    (-x * x).exp() / PI.sqrt() - x * erfc(x)
}

#[cfg(test)]
mod tests {
    use super::super::{numeric::integral, plane_flux_rise};
    use super::*;

    #[test]
    fn the_printed_value() {
        assert!((top_hat_rise(1.0 / PI, 1.0, 1.0, 1.0, 1.0) - 0.23207869).abs() < 5e-9);
    }

    #[test]
    fn a_wide_disc_is_a_plane_and_the_integral_is_right() {
        let wide = top_hat_rise(1e9, 1.0, 200.0, 7.6e-5, 1e-3);
        assert!((wide / plane_flux_rise(1e9, 200.0, 7.6e-5, 1e-3) - 1.0).abs() < 1e-14);
        assert!((integrated_erfc(0.7) - integral(erfc, 0.7, 8.0)).abs() < 1e-14);
    }
}
