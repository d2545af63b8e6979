//! What a scene is computed with, apart from what its fluid is.

use crate::{Error, FluidControls, Renewal, SurfaceModel, Tait};
use sph_kernel::{KernelKind, Shape};

/// The choices that a scene leaves open; each scene names its own beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// Shape of the kernel.
    pub kernel: KernelKind,
    /// Smoothing length over the spacing \[-\].
    pub smoothing: f64,
    /// Artificial speed of sound.
    pub sound_speed: f64,
    /// Density diffusion delta \[-\].
    pub density_diffusion: f64,
    /// Exchange of the rows of a surface, and shifting.
    pub renewal: Option<Renewal>,
    /// Whether continuity and pressure are exact at a free surface.
    pub corrected_gradients: bool,
    /// How tension acts.
    pub surface_model: SurfaceModel,
}

impl Scheme {
    /// Wendland C2 over 1.5 spacings, diffusion 0.1, nothing else.
    #[must_use]
    pub const fn new(sound_speed: f64) -> Self {
        Self {
            kernel: KernelKind::WendlandC2,
            smoothing: 1.5,
            sound_speed,
            density_diffusion: 0.1,
            renewal: None,
            corrected_gradients: false,
            surface_model: SurfaceModel::Force,
        }
    }

    /// Controls of a fluid of density one, without viscosity and tension.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a speed of sound that is not positive.
    pub fn controls<const D: usize>(&self, spacing: f64) -> Result<FluidControls<D>, Error> {
        let kernel = self.kernel.with_smoothing_length(self.smoothing * spacing);
        Ok(FluidControls {
            density_diffusion: self.density_diffusion,
            renewal: self.renewal,
            corrected_gradients: self.corrected_gradients,
            surface_model: self.surface_model,
            ..FluidControls::new(kernel, Tait::new(1.0, self.sound_speed, 7.0)?)
        })
    }

    /// Time in which sound crosses a share of the smoothing length.
    #[must_use]
    pub fn acoustic_step(&self, share: f64, spacing: f64) -> f64 {
        share * self.smoothing * spacing / self.sound_speed
    }

    /// Rows of particles of a wall: a support and one more.
    pub(super) fn wall_rows(&self) -> i32 {
        (self.kernel.support() * self.smoothing).ceil() as i32 + 1
    }
}
