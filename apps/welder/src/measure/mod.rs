//! Sizes of pool and weld, read off isotherms between particles.

mod gauge;
mod interpolate;
mod isotherm;
mod relief;

pub use gauge::{Gauge, Map, Measure};
pub use interpolate::Sampler;
pub use isotherm::Extent;
pub(crate) use isotherm::{crossing, lagrange};
pub use relief::Relief;
