//! Whether a weld is still one of conduction mode: the recoil of vapour against the tension of the melt.

use sph_thermal::boundary::Evaporation;

/// p a/(2 tau): the recoil pressure of vapour at the hottest point over what a surface of the tension \[N/m\] can hold over the
/// radius a of the hot spot. Above one the surface cannot stay a shallow dent: a keyhole opens.
///
/// p_sat falls by 1/e where the temperature is lower by T^2/(L M/R). Across a pool of radius R whose temperature falls as a parabola from
/// its `peak` to its `rim` \[K\] that is at a = R T/sqrt((L M/R) (T - T_rim)), and at most at R.
pub(super) fn recoil_over_tension(
    vapour: &Evaporation,
    tension: f64,
    radius: f64,
    peak: f64,
    rim: f64,
) -> f64 {
    if peak <= rim || radius <= 0.0 {
        return 0.0;
    }
    let spot = (peak / (vapour.steepness() * (peak - rim)).sqrt()).min(1.0) * radius;
    vapour.recoil_pressure(peak) * spot / (2.0 * tension)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn aluminium() -> Evaporation {
        Evaporation::new(2790.0, 1.09e7, 0.02698).unwrap()
    }

    #[test]
    fn the_spot_of_the_vapour_is_the_radius_at_which_its_pressure_is_an_e_th() {
        let (vapour, radius, peak, rim) = (aluminium(), 0.4e-3, 2600.0, 933.0);
        let found = recoil_over_tension(&vapour, 0.5, radius, peak, rim);
        let spot = 2.0 * 0.5 * found / vapour.recoil_pressure(peak);
        let there = peak - (peak - rim) * (spot / radius).powi(2);
        let fallen = vapour.saturation_pressure(there) / vapour.saturation_pressure(peak);
        assert!((fallen * std::f64::consts::E - 1.0).abs() < 0.25, "{fallen}");
    }

    #[test]
    fn a_small_spot_is_held_longer_than_a_large_one() {
        let at = |radius, peak| recoil_over_tension(&aluminium(), 0.6, radius, peak, 933.0);
        assert!(at(30e-6, 2790.0) < 1.0 && at(400e-6, 2790.0) > 5.0);
        assert!(at(400e-6, 2000.0) < 0.1);
        assert_eq!(at(400e-6, 900.0), 0.0);
    }
}
