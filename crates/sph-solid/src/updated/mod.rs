//! The updated-Lagrangian form: gradients are taken at the present positions.

mod rows;
mod sweep;
#[cfg(test)]
mod tests;

pub use rows::{
    DampingColumns, artificial_stress_acceleration, hourglass_viscosity, stress_acceleration,
    velocity_gradient, viscous_acceleration,
};
pub use sweep::{UpdatedControls, UpdatedFields, UpdatedForm, UpdatedLagrangian, UpdatedState};
