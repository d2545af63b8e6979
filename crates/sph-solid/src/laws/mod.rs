//! The laws of a point: no particles, no neighbours.

mod artificial_stress;
mod artificial_viscosity;
mod contact;
mod equation_of_state;
mod finite_strain;
mod gough_joule;
mod jaumann;
mod radial_return;
mod reduced_sound;
mod rotation;
pub(crate) mod small;
mod step;
mod table;
mod thermal_expansion;
mod yield_stress;

pub use artificial_stress::{
    ARTIFICIAL_STRESS_EXPONENT, ARTIFICIAL_STRESS_FACTOR, artificial_stress, artificial_stress_weight,
};
pub use artificial_viscosity::ArtificialViscosity;
pub use contact::Contact;
pub use equation_of_state::{paper_pressure, pressure};
pub use finite_strain::{
    cauchy_stress, elastic_energy, elastic_strain, first_stress, second_stress, second_stress_of_cauchy,
    strain_of_stress,
};
pub use gough_joule::{gough_joule_rate, heat_capacity_at_constant_strain};
pub use jaumann::{advanced_deviator, deviator_rate, strain_rate};
pub use radial_return::{PlasticStep, radial_return};
pub use reduced_sound::ReducedSound;
pub use rotation::{density_ratio, incremental_rotation, midpoint_gradient};
pub use step::{DEFAULT_STEP_FACTOR, stable_step};
pub use thermal_expansion::ThermalExpansion;
pub use yield_stress::YieldStress;
