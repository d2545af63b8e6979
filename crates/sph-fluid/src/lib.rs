#![doc = include_str!("../README.md")]

pub mod benchmarks;
mod error;
mod laws;
mod packed;
mod patch;
mod surface;
mod sweep;
mod tait;
#[cfg(test)]
mod test_block;

pub use error::Error;
pub use laws::*;
pub use packed::{PackedFields, PackedParticle, PackedRates, PackedRows, PackedSweep};
pub use patch::{Conduction, FindNeighbors, FluidPatch, PatchStart};
pub use surface::*;
pub use sweep::{FluidControls, FluidFields, FluidSweep, Powers};
pub use tait::{Tait, tait_density, tait_pressure, tait_sound_speed};
