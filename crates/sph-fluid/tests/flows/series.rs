//! Start-up of flow between plates at rest and of flow dragged by one of them (Morris, Fox and Zhu 1997).

use crate::channel::{Channel, HEIGHT, VISCOSITY};
use std::f64::consts::PI;

/// Acceleration along the plates \[m/s^2\].
pub const FORCE: f64 = 1e-4;
/// Speed of the upper plate, and the largest of steady Poiseuille flow \[m/s\].
pub const SPEED: f64 = 1.25e-5;
/// When flows are compared \[s\].
pub const TIMES: [f64; 5] = [0.0225, 0.045, 0.1125, 0.225, 1.0];

/// Speed \[m/s\] at the height y \[m\] of flow under [`FORCE`].
pub fn poiseuille(y: f64, time: f64) -> f64 {
    let steady = FORCE / (2.0 * VISCOSITY) * y * (HEIGHT - y);
    let term = |n: i32| {
        let odd = f64::from(2 * n + 1) * PI;
        let amplitude = 4.0 * FORCE * HEIGHT * HEIGHT / (VISCOSITY * odd.powi(3));
        amplitude * (odd * y / HEIGHT).sin() * (-(odd / HEIGHT).powi(2) * VISCOSITY * time).exp()
    };
    steady - (0..40).map(term).sum::<f64>()
}

/// Speed \[m/s\] at the height y \[m\] of flow under an upper plate of [`SPEED`].
pub fn couette(y: f64, time: f64) -> f64 {
    let term = |n: i32| {
        let wave = f64::from(n) * PI;
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        let decay = (-(wave / HEIGHT).powi(2) * VISCOSITY * time).exp();
        2.0 * SPEED / wave * sign * (wave * y / HEIGHT).sin() * decay
    };
    SPEED * y / HEIGHT + (1..80).map(term).sum::<f64>()
}

/// Largest error over all particles and both directions at each of [`TIMES`], over [`SPEED`].
pub fn errors(mut channel: Channel, profile: impl Fn(f64, f64) -> f64) -> [f64; 5] {
    TIMES.map(|time| {
        channel.run_to(time);
        channel.largest_error(&profile) / SPEED
    })
}

/// [`errors`] of Poiseuille flow with this many particles across.
pub fn poiseuille_errors(across: usize) -> [f64; 5] {
    errors(Channel::new(across, [FORCE, 0.0], 0.0, SPEED), poiseuille)
}

/// [`errors`] of Couette flow with this many particles across.
pub fn couette_errors(across: usize) -> [f64; 5] {
    errors(Channel::new(across, [0.0, 0.0], SPEED, SPEED), couette)
}
