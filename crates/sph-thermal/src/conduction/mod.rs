//! Heat conduction between particles.
//!
//! The pair law is `rho V_i dh_i/dt = sum_j g_ij (theta_j - theta_i)` with symmetric g (energy is exchanged, never
//! made) and the Kirchhoff potential theta. What differs is how g is found:
//!
//! - particles at rest: [`PairTable`] collects pairs and mirrored images once, gives [`ConductionRows`] by one of three
//!   weights (fitted, normalized, plain), and [`ConductionMatrix`] stores them for speed;
//! - particles that move: [`moving`] computes normalized weights from each row as it is met.

mod fit;
mod images;
mod joint;
mod matrix;
pub mod moving;
mod pairs;
mod rows;

pub use fit::{FitReport, fitted_weights};
pub use images::{Images, Parity, Planes};
pub use joint::{JointPair, joint_conductance};
pub use matrix::{ConductionMatrix, LANES};
pub use pairs::PairTable;
pub use rows::{ConductionRows, WallCoupling};
