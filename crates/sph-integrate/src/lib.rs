#![doc = include_str!("../README.md")]

mod controller;
mod error;
mod error_estimate;
mod explicit;
mod leapfrog;
mod limits;
mod rkl2;
mod spectral;
#[cfg(test)]
mod test_problems;

pub use controller::{ControllerState, Decision, StepController};
pub use error::Error;
pub use error_estimate::{ErrorWeight, local_error, weighted_rms_error};
pub use explicit::{ExplicitScratch, euler_step, rk2_step, rk4_step};
pub use leapfrog::leapfrog_step;
pub use limits::{LimitCounter, StepLimit, smallest};
pub use rkl2::{Rkl2Coefficients, Rkl2Scratch, Stage, max_step, rkl2_step, stages_for};
pub use spectral::{SPECTRAL_SAFETY, largest_eigenvalue};
