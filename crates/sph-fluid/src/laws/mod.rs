//! The laws of a row and of a point: no lists, no time.

mod artificial_viscosity;
mod conjugate;
mod continuity;
mod density_diffusion;
mod fields;
mod heating;
mod pressure;
mod renewal;
mod slope;
mod sound_speed;
mod step_limits;
mod tearing;
mod thermal_expansion;
mod viscosity;
mod wall;

pub use artificial_viscosity::{artificial_acceleration, equivalent_viscosity};
pub use conjugate::{conjugate_colour_gradient, conjugate_pressure_acceleration, corrected_density_rate};
pub use continuity::density_rate;
pub use density_diffusion::{corrected_diffusion, plain_diffusion};
pub use fields::{Fields, leading_part};
pub use heating::{artificial_heating, friction_heating};
pub use pressure::{symmetric_pressure_acceleration, volume_pressure_acceleration};
pub use renewal::{Renewal, shift_beside_surface};
pub use slope::{PressureForce, face_force};
pub use sound_speed::{SOUND_SPEED_RATIO, artificial_sound_speed};
pub use step_limits::{
    ACOUSTIC_FACTOR, CAPILLARY_FACTOR, FORCE_FACTOR, VISCOUS_FACTOR, acoustic_step, capillary_step,
    force_step, viscous_step,
};
pub use tearing::tearing_speed;
pub use thermal_expansion::ThermalExpansion;
pub use viscosity::{Friction, Viscosity, strain_acceleration, viscous_acceleration};
pub use wall::{WallState, wall_state, wall_velocity};
