#![doc = include_str!("../README.md")]

pub mod boundary;
pub mod conduction;
mod error;
pub mod phase;

pub use error::Error;
