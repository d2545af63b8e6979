//! Pressure of a solid from its density and temperature.

/// p = K ln(rho/rho_ref) \[Pa\], with rho_ref the density of the unstressed material at the same temperature
/// ([`ThermalExpansion::reference_density`](crate::ThermalExpansion::reference_density)).
///
/// Conjugate to the logarithmic volume strain (Poirier and Tarantola 1998): a free body expands exactly as rho_ref says,
/// at any temperature. In every mechanical term K is the modulus that the solver uses, reduced or not.
#[inline]
#[must_use]
pub fn pressure(bulk_pa: f64, density: f64, reference_density: f64) -> f64 {
    bulk_pa * (density / reference_density).ln()
}

/// p + 3 K alpha (T - T_0) = c_0^2 (rho - rho_0) + 3 K alpha (T - T_0) \[Pa\], c_0^2 = K/rho_0: the spherical stress as
/// the paper has it (Hu and Eberhard 2015, eqs. 5, 6).
///
/// Equal to [`pressure`] to first order. A free body then has rho_0 (1 - 3 alpha dT): its strain is 2.7 % too large when
/// alpha dT is 0.013, as in aluminium at the solidus.
#[inline]
#[must_use]
pub fn paper_pressure(bulk_pa: f64, density: f64, density_zero: f64, alpha: f64, warming_k: f64) -> f64 {
    bulk_pa * (density / density_zero - 1.0) + 3.0 * bulk_pa * alpha * warming_k
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ThermalExpansion;

    const BULK: f64 = 68.627e9;

    #[test]
    fn a_free_body_has_no_pressure_at_any_temperature() {
        let material = ThermalExpansion::constant(2700.0, 293.0, 23.1e-6).unwrap();
        for temperature in [293.0, 600.0, 850.0] {
            let length = material.stretch(293.0, temperature);
            let density = 2700.0 / length.powi(3);
            assert!(pressure(BULK, density, material.reference_density(temperature)).abs() < 1e-4);
        }
    }

    #[test]
    fn a_body_held_in_all_directions_is_pressed_by_three_k_alpha_dt() {
        let material = ThermalExpansion::constant(2700.0, 293.0, 23.1e-6).unwrap();
        let held = pressure(BULK, 2700.0, material.reference_density(393.0));
        assert!((held - 475.58e6).abs() < 0.02e6, "{held}");
        assert!((paper_pressure(BULK, 2700.0, 2700.0, 23.1e-6, 100.0) / held - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_slope_is_the_bulk_modulus_and_the_paper_agrees_to_first_order() {
        for strain in [1e-3, 1e-4] {
            let exact = pressure(BULK, 2700.0 * (1.0 + strain), 2700.0);
            assert!((exact / (BULK * strain) - 1.0).abs() < 0.51 * strain);
            let paper = paper_pressure(BULK, 2700.0 * (1.0 + strain), 2700.0, 1e-5, 0.0);
            assert!((paper / (BULK * strain) - 1.0).abs() < 1e-11);
        }
    }

    #[test]
    fn the_papers_form_over_expands_a_hot_free_body() {
        // Free: rho = rho_0 (1 - 3 alpha dT), so the strain is (1 - 3 e)^(-1/3) - 1 with e = alpha dT.
        let e: f64 = 0.0129;
        let strain = (1.0 - 3.0 * e).powf(-1.0 / 3.0) - 1.0;
        assert!(paper_pressure(BULK, 2700.0 * (1.0 - 3.0 * e), 2700.0, e, 1.0).abs() < 1e-3);
        assert!((strain / e - 1.027).abs() < 1e-3);
    }
}
