//! The artificial speed of sound.

/// Ratio of the speed of sound to the fastest flow \[-\]: density then varies by about one per cent (Monaghan 1994).
pub const SOUND_SPEED_RATIO: f64 = 10.0;

/// c_0 = 10 max(v, sqrt(tau/(rho R)), sqrt(2 p/rho)) \[m/s\]: ten times the fastest of flow, capillary motion and what a
/// pressure can drive (Morris, Fox and Zhu 1997, for the argument; Morris 2000 for tension).
///
/// `largest_speed` v \[m/s\], `surface_tension` tau \[N/m\], `radius` R \[m\] of the smallest drop or pool, `largest_pressure`
/// p \[Pa\], for example rho g H; zeros for what there is not.
#[must_use]
pub fn artificial_sound_speed(
    largest_speed: f64,
    density: f64,
    surface_tension: f64,
    radius: f64,
    largest_pressure: f64,
) -> f64 {
    let capillary = if surface_tension > 0.0 { (surface_tension / (density * radius)).sqrt() } else { 0.0 };
    let driven = (2.0 * largest_pressure.max(0.0) / density).sqrt();
    SOUND_SPEED_RATIO * largest_speed.max(capillary).max(driven)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fastest_of_the_three_rules() {
        // Liquid aluminium in a pool of 0.25 mm: sqrt(0.9/(2385 * 0.25e-3)) = 1.228590 m/s.
        let with_speed = |speed| artificial_sound_speed(speed, 2385.0, 0.9, 0.25e-3, 0.0);
        assert!((with_speed(0.1) - 12.285_902).abs() < 1e-6);
        assert_eq!(with_speed(2.0), 20.0);
        // A dam of 1 m of water: c = 10 sqrt(2 g H).
        let dam = artificial_sound_speed(1.0, 1000.0, 0.0, 0.0, 9810.0);
        assert!((dam - 10.0 * 19.62_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn suction_and_missing_tension_count_as_nothing() {
        assert_eq!(artificial_sound_speed(3.0, 1000.0, 0.0, 0.0, -5.0), 30.0);
    }
}
