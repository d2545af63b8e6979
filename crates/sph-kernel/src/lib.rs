#![doc = include_str!("../README.md")]

pub mod kernels;
pub mod operators;
mod row;
#[cfg(test)]
mod test_points;

pub use kernels::{
    CubicSpline, Gaussian, Kernel, KernelKind, QuinticSpline, ScaledKernel, Shape, WendlandC2,
};
pub use row::{Row, RowBuffer};
