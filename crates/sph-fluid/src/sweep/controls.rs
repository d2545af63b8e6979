//! What a fluid is and how it is computed.

use crate::error::{Error, require};
use crate::{
    Friction, PressureForce, Renewal, SurfaceModel, SurfaceTension, Tait, ThermalExpansion, acoustic_step,
    capillary_step, equivalent_viscosity, force_step, viscous_step,
};
use nalgebra::SVector;
use sph_kernel::ScaledKernel;

/// Share of the acoustic step at rest below which a fluid is wild.
const WILD: f64 = 1e-3;

/// Constants of the fluid and of the scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FluidControls<const D: usize> {
    /// Kernel of all particles.
    pub kernel: ScaledKernel<D>,
    /// Equation of state.
    pub state: Tait,
    /// Dynamic viscosity eta \[Pa s\]; where [`FluidFields::viscosities`](super::FluidFields::viscosities) gives one of each particle, the largest of them, which
    /// steps are taken by.
    pub dynamic_viscosity: f64,
    /// How viscosity acts between particles.
    pub friction: Friction,
    /// Artificial viscosity alpha \[-\]; 0 is none.
    pub artificial_viscosity: f64,
    /// Density diffusion delta \[-\]; 0.02 to 0.1, 0 is none.
    pub density_diffusion: f64,
    /// Acceleration of every particle, for example gravity \[m/s^2\].
    pub body_acceleration: SVector<f64, D>,
    /// Tension of a free surface; `None` where there is none, or where it does not matter. Its reference rules the steps also where
    /// [`FluidFields::tensions`](super::FluidFields::tensions) gives the tension.
    pub surface_tension: Option<SurfaceTension>,
    /// How tension acts on the particles of a surface.
    pub surface_model: SurfaceModel,
    /// Exchange of the rows of a free surface; needed where a surface flows in a closed melt.
    pub renewal: Option<Renewal>,
    /// How warmth expands the fluid; `None` where it does not.
    pub thermal_expansion: Option<ThermalExpansion>,
    /// Whether the sweep finds the heat that friction makes.
    pub viscous_heating: bool,
    /// Whether continuity and pressure take corrected gradients, exact at the free surface, at the cost of a pass.
    pub corrected_gradients: bool,
    /// How pressure acts; by its slope where a weight far above the forces of the flow holds a melt between walls. A tension that
    /// pulls has no form that balances the slope, and is refused with it.
    pub pressure: PressureForce,
}

impl<const D: usize> FluidControls<D> {
    /// A fluid with an equation of state and nothing else: no viscosity, diffusion, force or surface.
    #[must_use]
    pub fn new(kernel: ScaledKernel<D>, state: Tait) -> Self {
        Self {
            kernel,
            state,
            dynamic_viscosity: 0.0,
            friction: Friction::default(),
            artificial_viscosity: 0.0,
            density_diffusion: 0.0,
            body_acceleration: SVector::zeros(),
            surface_tension: None,
            surface_model: SurfaceModel::default(),
            renewal: None,
            thermal_expansion: None,
            viscous_heating: false,
            corrected_gradients: false,
            pressure: PressureForce::default(),
        }
    }

    /// The longest steps \[s\] of kick-drift-kick that sound, friction, tension and force allow, by name, for the fastest particle
    /// \[m/s\] and the strongest acceleration \[m/s^2\].
    #[must_use]
    pub fn longest_steps(&self, fastest: f64, strongest: f64) -> [(&'static str, f64); 4] {
        let (length, density) = (self.kernel.smoothing_length(), self.state.reference_density());
        let tension = self.surface_tension.map_or(0.0, |tension| tension.reference());
        // Kick-drift-kick is stable to twice the acoustic limit, and as accurate there.
        let sound = 2.0 * acoustic_step(length, self.state.reference_sound_speed(), fastest);
        [
            ("sound", sound),
            ("friction", viscous_step(length, self.dynamic_viscosity / density)),
            ("tension", capillary_step(length, density, tension)),
            ("force", force_step(length, strongest)),
        ]
    }

    /// A fluid that asks for steps below this \[s\], a thousandth of what its sound allows at rest, has run wild.
    #[must_use]
    pub fn wild_step(&self) -> f64 {
        WILD * acoustic_step(self.kernel.smoothing_length(), self.state.reference_sound_speed(), 0.0)
    }

    /// Viscosity of the fluid with that of the scheme \[m^2/s\].
    pub(super) fn kinematic_viscosity(&self) -> f64 {
        let (length, sound) = (self.kernel.smoothing_length(), self.state.reference_sound_speed());
        self.dynamic_viscosity / self.state.reference_density()
            + equivalent_viscosity::<D>(length, sound, self.artificial_viscosity)
    }

    pub(crate) fn has_surface(&self) -> bool {
        self.surface_tension.is_some() || self.renewal.is_some()
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        for (name, value) in [
            ("dynamic_viscosity", self.dynamic_viscosity),
            ("artificial_viscosity", self.artificial_viscosity),
            ("density_diffusion", self.density_diffusion),
        ] {
            require(value >= 0.0, name, value, "zero or above")?;
        }
        let pulled = self.surface_tension.is_some_and(|tension| tension.pulls());
        let balanced = self.pressure == PressureForce::Pairs || !pulled;
        let found = self.surface_tension.map_or(0.0, |tension| tension.reference());
        require(balanced, "surface_tension", found, "none that pulls where pressure acts by its slope")?;
        self.body_acceleration
            .iter()
            .try_for_each(|&value| require(true, "body_acceleration", value, "finite"))
    }
}
