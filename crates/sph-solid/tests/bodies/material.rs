//! Aluminium as the tests take it.

use sph_solid::{IsotropicModuli, Material, ThermalExpansion};

/// Young's modulus \[Pa\].
pub const YOUNG: f64 = 70e9;

/// Poisson's ratio.
pub const POISSON: f64 = 0.33;

/// Density \[kg/m^3\] at 293 K.
pub const DENSITY: f64 = 2700.0;

/// Linear expansion \[1/K\].
pub const ALPHA: f64 = 23.1e-6;

/// Aluminium that expands by `alpha` \[1/K\].
pub fn aluminium(alpha: f64) -> Material {
    let moduli = IsotropicModuli::from_young_and_poisson(YOUNG, POISSON).unwrap();
    let mut material = Material::elastic(moduli, DENSITY).unwrap();
    material.expansion = ThermalExpansion::constant(DENSITY, 293.0, alpha).unwrap();
    material
}
