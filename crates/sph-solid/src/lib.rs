#![doc = include_str!("../README.md")]

pub mod benchmarks;
mod error;
mod laws;
mod moduli;
mod patch;
mod tensor;
mod total;
mod updated;
mod waves;

pub use error::Error;
pub use laws::*;
pub use moduli::IsotropicModuli;
pub use patch::{FindNeighbors, MechanicalLedger, START_TEMPERATURE, SolidPatch, SolidStart, UpdatedPatch};
pub use tensor::SymmetricTensor;
pub use total::*;
pub use updated::*;
pub use waves::{bar_speed, pressure_wave_speed, shear_wave_speed};
