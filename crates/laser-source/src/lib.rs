#![doc = include_str!("../README.md")]

mod absorption;
mod audit;
mod beam;
mod error;
mod patches;
mod path;
mod quadrature;
mod rectangle;
mod source;

pub use absorption::{Absorption, absorption_coefficient_per_m};
pub use audit::PowerAudit;
pub use beam::{Beam, Gaussian, GaussianHuEberhard, TopHat};
pub use error::Error;
pub use patches::SurfacePatches;
pub use path::{Path, PowerPoint, Pulse, Track, TrackPoint};
pub use rectangle::Rectangle;
pub use source::LaserSource;
