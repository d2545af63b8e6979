//! Aluminium as the benchmarks take it.

use crate::{Error, IsotropicModuli, Material, ThermalExpansion};

/// Young's modulus \[Pa\].
pub const YOUNG: f64 = 70e9;

/// Poisson's ratio \[-\].
pub const POISSON: f64 = 0.33;

/// Density \[kg/m^3\] at 293 K.
pub const DENSITY: f64 = 2700.0;

/// Linear expansion \[1/K\].
pub const ALPHA: f64 = 23.1e-6;

/// Heat capacity \[J/(kg K)\].
pub const HEAT_CAPACITY: f64 = 897.0;

/// Elastic aluminium that expands by `alpha` \[1/K\].
///
/// # Errors
/// [`Error`] for an `alpha` out of range.
pub fn aluminium(alpha: f64) -> Result<Material, Error> {
    let mut material = Material::elastic(IsotropicModuli::from_young_and_poisson(YOUNG, POISSON)?, DENSITY)?;
    material.expansion = ThermalExpansion::constant(DENSITY, 293.0, alpha)?;
    Ok(material)
}
