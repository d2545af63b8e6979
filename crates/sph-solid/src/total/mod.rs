//! The total-Lagrangian form: everything is measured from one reference configuration.

mod body;
pub(crate) mod lanes;
pub(crate) mod links;
mod material;
mod point;
mod reference;
mod rows;
#[cfg(test)]
mod tests;

pub use body::{Inelastic, Motion, TotalLagrangian};
pub use material::{Controls, Material};
pub use reference::ReferenceColumns;
pub use rows::{deformation_gradient, hourglass_force, total_force};
