#![doc = include_str!("../README.md")]

mod error;
mod moduli;
mod waves;

pub use error::Error;
pub use moduli::IsotropicModuli;
pub use waves::{bar_speed, pressure_wave_speed, shear_wave_speed};
