//! Bodies of particles in the total-Lagrangian form against exact solutions.

mod motion;
mod scene;
mod thermal;
mod updated;
mod updated_scene;
mod waves;

use sph_solid::{IsotropicModuli, Material, ThermalExpansion};

/// Young's modulus of aluminium \[Pa\].
const YOUNG: f64 = 70e9;

/// Poisson's ratio of aluminium.
const POISSON: f64 = 0.33;

/// Density of aluminium \[kg/m^3\].
const DENSITY: f64 = 2700.0;

/// Aluminium that expands by `alpha` \[1/K\].
fn aluminium(alpha: f64) -> Material {
    let moduli = IsotropicModuli::from_young_and_poisson(YOUNG, POISSON).unwrap();
    let mut material = Material::elastic(moduli, DENSITY).unwrap();
    material.expansion = ThermalExpansion::constant(DENSITY, 293.0, alpha).unwrap();
    material
}
