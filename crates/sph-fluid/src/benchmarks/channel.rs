//! Water in a channel of 1 mm between two plates, periodic along x: start-up of flow under a force, and of flow dragged by the
//! upper plate (Morris, Fox and Zhu 1997), at Re 0.0125.

use super::largest;
use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{
    Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Tait, acoustic_step, artificial_sound_speed,
    viscous_step,
};
use nalgebra::Vector2;
use sph_kernel::KernelKind;
use std::f64::consts::PI;

/// Density of water \[kg/m^3\].
pub const DENSITY: f64 = 1000.0;
/// Kinematic viscosity of water \[m^2/s\].
const VISCOSITY: f64 = 1e-6;
/// Height of the channel \[m\].
pub const HEIGHT: f64 = 1e-3;
/// Acceleration along the plates \[m/s^2\].
const FORCE: f64 = 1e-4;
/// Speed of the upper plate, and the largest of steady Poiseuille flow \[m/s\].
pub const SPEED: f64 = 1.25e-5;
/// When flows are compared \[s\].
pub const TIMES: [f64; 5] = [0.0225, 0.045, 0.1125, 0.225, 1.0];
/// Particles in one period along x.
const COLUMNS: i32 = 8;

/// A channel and its step.
#[derive(Debug)]
pub struct Channel {
    /// The fluid.
    pub patch: FluidPatch<2>,
    dt: f64,
}

impl Channel {
    /// At rest: `across` particles over the height, driven by a body force \[m/s^2\] or by the upper plate \[m/s\];
    /// `largest_speed` \[m/s\] is what the speed of sound is made for.
    ///
    /// # Errors
    /// [`Error`] of the sweep.
    pub fn new(
        across: usize,
        body_acceleration: Vector2<f64>,
        upper_plate_speed: f64,
        largest_speed: f64,
        find: FindNeighbors<2>,
    ) -> Result<Self, Error> {
        let (spacing, rows) = (HEIGHT / across as f64, across as i32);
        let length = 1.5 * spacing;
        let sound_speed = artificial_sound_speed(largest_speed, DENSITY, 0.0, 0.0, 0.0);
        let kernel = KernelKind::WendlandC2.with_smoothing_length(length);
        let controls = FluidControls {
            dynamic_viscosity: DENSITY * VISCOSITY,
            density_diffusion: 0.1,
            body_acceleration,
            ..FluidControls::new(kernel, Tait::new(DENSITY, sound_speed, 7.0)?)
        };
        let (columns, rows_of_all) = (-WALL_ROWS..COLUMNS + WALL_ROWS, -WALL_ROWS..rows + WALL_ROWS);
        let mut start = lattice(spacing, columns, rows_of_all, |column, row| {
            match ((0..COLUMNS).contains(&column), (0..rows).contains(&row)) {
                (true, true) => Site::Fluid,
                (false, true) => Site::Empty,
                (_, false) => Site::Wall,
            }
        });
        for (position, velocity) in start.walls.iter().zip(&mut start.wall_velocities) {
            velocity.x = if position.y > 0.5 * HEIGHT { upper_plate_speed } else { 0.0 };
        }
        let periods = [Some(f64::from(COLUMNS) * spacing), None];
        let patch = FluidPatch::new(PatchStart { periods, ..start }, controls, find)?;
        let dt = acoustic_step(length, sound_speed, largest_speed).min(viscous_step(length, VISCOSITY));
        Ok(Self { patch, dt })
    }

    /// Steps until exactly `time` \[s\].
    pub fn run_to(&mut self, time: f64) {
        self.patch.run_to(time, self.dt);
    }

    /// Largest difference of a particle's velocity, both components, from a profile u(y, t) along x \[m/s\].
    #[must_use]
    pub fn largest_error(&self, profile: impl Fn(f64, f64) -> f64) -> f64 {
        let pairs = self.patch.positions().iter().zip(self.patch.velocities());
        let error = |(position, velocity): (&Vector2<f64>, &Vector2<f64>)| {
            (velocity - Vector2::new(profile(position.y, self.patch.time()), 0.0)).norm()
        };
        largest(pairs.map(error))
    }

    /// Largest error at each of [`TIMES`], over [`SPEED`].
    fn errors(&mut self, profile: fn(f64, f64) -> f64) -> [f64; 5] {
        TIMES.map(|time| {
            self.run_to(time);
            self.largest_error(profile) / SPEED
        })
    }
}

/// Speed \[m/s\] at the height y \[m\] of flow that a force started from rest.
#[must_use]
pub fn poiseuille(y: f64, time: f64) -> f64 {
    let steady = FORCE / (2.0 * VISCOSITY) * y * (HEIGHT - y);
    let term = |n: i32| {
        let odd = f64::from(2 * n + 1) * PI;
        let amplitude = 4.0 * FORCE * HEIGHT * HEIGHT / (VISCOSITY * odd.powi(3));
        amplitude * (odd * y / HEIGHT).sin() * (-(odd / HEIGHT).powi(2) * VISCOSITY * time).exp()
    };
    steady - (0..40).map(term).sum::<f64>()
}

/// Speed \[m/s\] at the height y \[m\] of flow that an upper plate of [`SPEED`] started from rest.
#[must_use]
pub fn couette(y: f64, time: f64) -> f64 {
    let term = |n: i32| {
        let wave = f64::from(n) * PI;
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        let decay = (-(wave / HEIGHT).powi(2) * VISCOSITY * time).exp();
        2.0 * SPEED / wave * sign * (wave * y / HEIGHT).sin() * decay
    };
    SPEED * y / HEIGHT + (1..80).map(term).sum::<f64>()
}

/// Largest error of any particle of Poiseuille flow at each of [`TIMES`], over [`SPEED`], with the channel.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn poiseuille_errors(across: usize, find: FindNeighbors<2>) -> Result<([f64; 5], Channel), Error> {
    let mut channel = Channel::new(across, Vector2::new(FORCE, 0.0), 0.0, SPEED, find)?;
    Ok((channel.errors(poiseuille), channel))
}

/// The same of Couette flow.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn couette_errors(across: usize, find: FindNeighbors<2>) -> Result<([f64; 5], Channel), Error> {
    let mut channel = Channel::new(across, Vector2::zeros(), SPEED, SPEED, find)?;
    Ok((channel.errors(couette), channel))
}
