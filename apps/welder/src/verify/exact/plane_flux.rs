//! Constant flux into a half space (Carslaw and Jaeger, 2.9).

use std::f64::consts::PI;

/// Rise of the surface, 2 q sqrt(a t/pi)/k, for the flux q, diffusivity a and conductivity k.
pub fn plane_flux_rise(flux: f64, conductivity: f64, diffusivity: f64, time: f64) -> f64 {
    2.0 * flux * (diffusivity * time / PI).sqrt() / conductivity
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_value() {
        let rise = plane_flux_rise(1e9, 200.0, 200.0 / 2.625e6, 1e-3);
        assert!((rise - 1557.311).abs() < 5e-4, "{rise}");
    }
}
