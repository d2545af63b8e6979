//! Gough-Joule effect: a solid cools when it is stretched and warms when it is pressed.

/// dT/dt = -3 K alpha T tr(eps_dot)/(rho c_v) \[K/s\] (Kelvin 1855; Hu and Eberhard 2015, eq. 11 without conduction).
///
/// `bulk_pa` is the true K also where the solver uses a reduced one: the strain is right there, the stress is not.
/// `heat_capacity` \[J/(kg K)\] is that at constant strain, [`heat_capacity_at_constant_strain`]; a handbook's c_p already
/// holds the work of free expansion and belongs to runs without this term.
#[inline]
#[must_use]
pub fn gough_joule_rate(
    bulk_pa: f64,
    alpha: f64,
    temperature_k: f64,
    volume_strain_rate: f64,
    density: f64,
    heat_capacity: f64,
) -> f64 {
    -3.0 * bulk_pa * alpha * temperature_k * volume_strain_rate / (density * heat_capacity)
}

/// c_v = c_p - 9 K alpha^2 T/rho \[J/(kg K)\] (Landau and Lifshitz, Theory of Elasticity (1986), section 6).
#[inline]
#[must_use]
pub fn heat_capacity_at_constant_strain(
    heat_capacity_at_constant_pressure: f64,
    bulk_pa: f64,
    alpha: f64,
    temperature_k: f64,
    density: f64,
) -> f64 {
    heat_capacity_at_constant_pressure - 9.0 * bulk_pa * alpha * alpha * temperature_k / density
}

#[cfg(test)]
mod tests {
    use super::*;

    const BULK: f64 = 70e9 / (3.0 * 0.34);

    #[test]
    fn aluminium_stretched_by_a_thousandth_cools_by_half_a_kelvin() {
        let cooling = gough_joule_rate(BULK, 23.1e-6, 293.0, 1e-3, 2700.0, 897.0);
        assert!((cooling + 0.5754).abs() < 5e-5, "{cooling}");
    }

    #[test]
    fn capacities_of_aluminium_differ_by_four_to_twelve_percent() {
        for (temperature, difference) in [(293.0, 36.0), (600.0, 73.0), (853.0, 104.0)] {
            let constant_strain = heat_capacity_at_constant_strain(900.0, BULK, 23.1e-6, temperature, 2700.0);
            assert!((900.0 - constant_strain - difference).abs() < 1.0, "{constant_strain}");
        }
    }

    #[test]
    fn a_freely_expanding_body_takes_in_its_capacity_at_constant_pressure() {
        // Free: volume strain 3 alpha dT. Heat = c_v dT - c_v * (Gough-Joule change) must be c_p dT.
        let (alpha, temperature, density, warming) = (23.1e-6, 600.0, 2700.0, 1e-3);
        let constant_strain = heat_capacity_at_constant_strain(900.0, BULK, alpha, temperature, density);
        let effect =
            gough_joule_rate(BULK, alpha, temperature, 3.0 * alpha * warming, density, constant_strain);
        let heat = constant_strain * (warming - effect);
        assert!((heat / (900.0 * warming) - 1.0).abs() < 1e-12);
    }
}
