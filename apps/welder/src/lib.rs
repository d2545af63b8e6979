//! Simulates conduction-mode laser welding with smoothed particle hydrodynamics.

pub mod build;
pub mod case;
pub mod check;
pub mod cli;
pub mod fluid;
pub mod list;
pub mod measure;
pub mod model;
pub mod observe;
pub mod particles;
pub mod physics;
pub mod precision;
pub mod run;
pub mod solid;
pub mod verify;
pub mod version;
