//! A column of water, twice as high as it is wide, that falls into a dry channel (Martin and Moyce 1952, n^2 = 2). Width a,
//! density and gravity are one; the channel ends in a wall at 8 a.

use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{
    Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Renewal, Tait, artificial_sound_speed,
};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

/// Where the front of the experiment was: t \[sqrt(a/(2 g))\], z \[a\].
pub const FRONT: [(f64, f64); 7] = [
    (0.832, 1.217),
    (1.219, 1.474),
    (1.997, 2.292),
    (2.547, 2.995),
    (3.345, 4.134),
    (4.034, 4.944),
    (5.091, 6.980),
];
/// Length of the channel.
const LENGTH: i32 = 8;
/// Height of its end walls.
const WALL_HEIGHT: i32 = 3;

/// The water and its step.
#[derive(Debug)]
pub struct DamBreak {
    /// The water.
    pub patch: FluidPatch<2>,
    dt: f64,
}

impl DamBreak {
    /// The column, `across` particles wide, with the pressure of its depth; the dam is gone at once.
    ///
    /// # Errors
    /// [`Error`] of the sweep.
    pub fn new(across: usize, find: FindNeighbors<2>) -> Result<Self, Error> {
        let (spacing, n) = (1.0 / across as f64, across as i32);
        let length = 1.5 * spacing;
        let sound_speed = artificial_sound_speed(0.0, 1.0, 0.0, 0.0, 2.0);
        let columns = -WALL_ROWS..LENGTH * n + WALL_ROWS;
        let start = lattice(spacing, columns, -WALL_ROWS..WALL_HEIGHT * n, |column, row| {
            if row < 0 || !(0..LENGTH * n).contains(&column) {
                Site::Wall
            } else if column < n && row < 2 * n {
                Site::Fluid
            } else {
                Site::Empty
            }
        });
        let start = PatchStart { pressure: |position: &Vector2<f64>| 2.0 - position.y, ..start };
        let kernel = KernelKind::WendlandC2.with_smoothing_length(length);
        let controls = FluidControls {
            artificial_viscosity: 0.05,
            density_diffusion: 0.1,
            body_acceleration: Vector2::new(0.0, -1.0),
            // A film of one row forgets by continuity where its wall is, and leaks without the pull.
            renewal: Some(Renewal { shifting: 0.0, ..Renewal::default() }),
            ..FluidControls::new(kernel, Tait::new(1.0, sound_speed, 7.0)?)
        };
        Ok(Self { patch: FluidPatch::new(start, controls, find)?, dt: 0.5 * length / sound_speed })
    }

    /// Steps until `time` \[sqrt(a/g)\].
    pub fn run_to(&mut self, time: f64) {
        self.patch.run_to(time, self.dt);
    }

    /// Where the foremost particle ends \[a\].
    #[must_use]
    pub fn front(&self) -> f64 {
        let foremost = self.patch.positions().iter().map(|position| position.x).fold(f64::NAN, f64::max);
        foremost + 0.5 * self.patch.spacing()
    }

    /// Runs along [`FRONT`]: how far the front is ahead of the experiment's, relative, at each time.
    pub fn front_errors(&mut self) -> [f64; 7] {
        FRONT.map(|(time, place)| {
            self.run_to(time / 2.0_f64.sqrt());
            self.front() / place - 1.0
        })
    }

    /// Particles whose centre lies behind the face of a wall, by half a spacing or more.
    #[must_use]
    pub fn lost(&self) -> usize {
        let far = 0.5 * self.patch.spacing();
        let (across, up) = (-far..f64::from(LENGTH) + far, -far..f64::INFINITY);
        let held = |position: &&Vector2<f64>| across.contains(&position.x) && up.contains(&position.y);
        self.patch.positions().len() - self.patch.positions().iter().filter(held).count()
    }
}
