//! Benchmarks of heat conduction, one a file.

pub(super) mod constant_flux;
pub(super) mod cosine_decay;
pub(super) mod evaporation;
pub(super) mod gaussian_field;
pub mod gaussian_spot;
pub(super) mod half_spaces;
pub(super) mod moving_gaussian;
pub(super) mod mushy_stefan;
pub(super) mod stefan;
pub(super) mod top_hat;

mod front;
