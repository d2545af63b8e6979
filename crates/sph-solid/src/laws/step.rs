//! The longest stable step of elastic motion.

/// Share of h/c_P that a step takes by default \[-\].
///
/// Kick-drift-kick is stable to 1.29 (total Lagrangian, 2-D, h/dx 1.2), 1.34 (3-D, h/dx 0.8) and 1.16 with hourglass
/// stiffness 1; other schemes in use only to 0.3-0.5 (measured in trials of this project).
pub const DEFAULT_STEP_FACTOR: f64 = 0.6;

/// dt = `factor` h/c_P \[s\] for the smoothing length h \[m\] and the pressure-wave speed c_P \[m/s\]
/// ([`pressure_wave_speed`](crate::pressure_wave_speed)): the fastest wave rules, 23 % faster than sqrt(K/rho) in aluminium.
#[inline]
#[must_use]
pub fn stable_step(smoothing_length: f64, pressure_wave_speed: f64, factor: f64) -> f64 {
    factor * smoothing_length / pressure_wave_speed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aluminium_at_thirty_micrometres() {
        let dt = stable_step(1.3 * 30e-6, 6197.8, DEFAULT_STEP_FACTOR);
        assert!((dt - 3.7756e-9).abs() < 1e-13, "{dt}");
    }
}
