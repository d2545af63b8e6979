//! Simulates conduction-mode laser welding with smoothed particle hydrodynamics.

pub mod case;
pub mod cli;
pub mod list;
