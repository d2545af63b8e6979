//! Phase change: what a specific enthalpy says about temperature, liquid fraction and conduction potential.

mod curve;
mod material;
mod table;

pub use curve::{EnthalpyCurve, TemperatureJump};
pub use material::ThermalMaterial;
pub use table::Table;
