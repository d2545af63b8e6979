//! The updated-Lagrangian form: gradients are taken at the present positions.

mod controls;
mod force_pass;
mod gradient_pass;
mod near;
mod quads;
mod rows;
mod sweep;
#[cfg(test)]
mod tests;

pub use controls::{UpdatedControls, UpdatedForm};
pub use rows::{
    DampingColumns, artificial_stress_acceleration, hourglass_viscosity, stress_acceleration,
    velocity_gradient, viscous_acceleration,
};
pub use sweep::{UpdatedFields, UpdatedLagrangian, UpdatedState};
