//! Phase change: what a specific enthalpy says about temperature, liquid fraction and conduction potential.

mod curve;
mod material;
mod table;

pub use curve::{EnthalpyCurve, TemperatureJump};
pub use material::ThermalMaterial;
pub use table::Table;

#[cfg(test)]
pub(crate) use material::tests::aluminium as tests_material;
