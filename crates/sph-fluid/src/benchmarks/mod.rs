//! Flows whose answer is known, for tests, examples and `welder verify`: a scene and what is measured of it, no verdicts.

pub mod cavity;
pub mod channel;
pub mod convection;
pub mod dam;
pub mod drop;
mod fit;
mod lattice;
pub mod layer;
pub mod measure;
pub mod momentum;
pub mod pool;
mod scheme;
pub mod shapes;
pub mod square;
pub mod tank;
pub mod voids;
pub mod vortices;
pub mod warm_shear;
pub mod wave;

pub use scheme::Scheme;

/// The largest of numbers that are not negative; no number where one of them is none.
pub(crate) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, value| if largest.is_nan() || value <= largest { largest } else { value })
}
