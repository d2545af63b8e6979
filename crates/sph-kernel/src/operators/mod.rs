//! SPH operators that know no physics: each takes a row and columns of all particles, and returns what particle i gets.
//!
//! Symbols: V_j volume \[m^D\], r_ij = r_i - r_j, grad_i W = f_ij r_ij with f <= 0.

mod colour_gradient;
mod gradient;
mod laplacian;
mod laplacian_moment;
mod moment;
mod summation;
mod symmetric_eigen;

pub use colour_gradient::colour_gradient;
pub use gradient::gradient;
pub use laplacian::laplacian;
pub use laplacian_moment::laplacian_moment;
pub use moment::{moment, regularised_inverse};
pub use summation::summation;
pub use symmetric_eigen::symmetric_eigen;
