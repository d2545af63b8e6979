#![doc = include_str!("../README.md")]

mod error;
mod tait;

pub use error::Error;
pub use tait::{Tait, tait_density, tait_pressure, tait_sound_speed};
