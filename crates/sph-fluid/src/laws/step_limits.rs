//! The longest steps that sound, friction, surface tension and forces allow.

/// Share of h/(c + v) that a step takes \[-\]; 0.5 was stable and as accurate in trials.
pub const ACOUSTIC_FACTOR: f64 = 0.25;
/// Share of h^2/nu that a step takes \[-\] (Morris, Fox and Zhu 1997).
pub const VISCOUS_FACTOR: f64 = 0.125;
/// Share of sqrt(rho h^3/(2 pi tau)) that a step takes \[-\] (Morris 2000).
pub const CAPILLARY_FACTOR: f64 = 0.25;
/// Share of sqrt(h/a) that a step takes \[-\] (Morris, Fox and Zhu 1997).
pub const FORCE_FACTOR: f64 = 0.25;

/// 0.25 h/(c + v) \[s\] for the smoothing length h \[m\], the speed of sound c and the fastest particle v \[m/s\] (Morris,
/// Fox and Zhu 1997, with the flow's own speed added).
#[inline]
#[must_use]
pub fn acoustic_step(smoothing_length: f64, sound_speed: f64, largest_speed: f64) -> f64 {
    ACOUSTIC_FACTOR * smoothing_length / (sound_speed + largest_speed)
}

/// 0.125 h^2/nu \[s\] for the kinematic viscosity nu \[m^2/s\]; infinite without viscosity.
#[inline]
#[must_use]
pub fn viscous_step(smoothing_length: f64, kinematic_viscosity: f64) -> f64 {
    VISCOUS_FACTOR * smoothing_length * smoothing_length / kinematic_viscosity
}

/// 0.25 sqrt(rho h^3/(2 pi tau)) \[s\] for the surface tension tau \[N/m\]; infinite without tension.
///
/// The shortest capillary wave that h resolves must not cross h in a step (Brackbill, Kothe and Zemach 1992).
#[inline]
#[must_use]
pub fn capillary_step(smoothing_length: f64, density: f64, surface_tension: f64) -> f64 {
    let cube = smoothing_length.powi(3);
    CAPILLARY_FACTOR * (density * cube / (2.0 * std::f64::consts::PI * surface_tension)).sqrt()
}

/// 0.25 sqrt(h/a) \[s\] for the largest acceleration a \[m/s^2\]; infinite without forces.
#[inline]
#[must_use]
pub fn force_step(smoothing_length: f64, largest_acceleration: f64) -> f64 {
    FORCE_FACTOR * (smoothing_length / largest_acceleration).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn liquid_aluminium_at_fifty_and_twenty_five_micrometres() {
        // h = 1.5 dx, c = 20 m/s, v = 2 m/s; the acoustic limit rules.
        assert!((acoustic_step(75e-6, 20.0, 2.0) - 8.522_727_272_7e-7).abs() < 1e-17);
        assert!((acoustic_step(37.5e-6, 20.0, 2.0) - 4.261_363_636_4e-7).abs() < 1e-17);
        // nu = 1.1e-3/2385.
        assert!((viscous_step(75e-6, 1.1e-3 / 2385.0) - 1.524_502_840_909e-3).abs() < 1e-14);
        assert!((capillary_step(75e-6, 2385.0, 0.9) - 3.334762480e-06).abs() < 1e-14);
        assert!((force_step(75e-6, 9.81) - 6.912515795e-04).abs() < 1e-12);
    }

    #[test]
    fn what_is_absent_does_not_limit() {
        assert_eq!(viscous_step(1e-3, 0.0), f64::INFINITY);
        assert_eq!(capillary_step(1e-3, 1000.0, 0.0), f64::INFINITY);
        assert_eq!(force_step(1e-3, 0.0), f64::INFINITY);
    }

    #[test]
    fn limits_scale_with_their_power_of_the_length() {
        assert!((acoustic_step(2e-3, 5.0, 1.0) / acoustic_step(1e-3, 5.0, 1.0) - 2.0).abs() < 1e-14);
        assert!((viscous_step(2e-3, 1e-6) / viscous_step(1e-3, 1e-6) - 4.0).abs() < 1e-14);
        let ratio = capillary_step(2e-3, 1.0, 1.0) / capillary_step(1e-3, 1.0, 1.0);
        assert!((ratio - 8.0_f64.sqrt()).abs() < 1e-13);
        assert!((force_step(2e-3, 9.81) / force_step(1e-3, 9.81) - 2.0_f64.sqrt()).abs() < 1e-14);
    }
}
