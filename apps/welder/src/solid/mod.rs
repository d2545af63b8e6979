//! Scenes of elastic and yielding bodies that can meet, in the plane and in space.

mod account;
mod body;
mod model;
mod patch;
mod saved;
mod section;

pub use account::{SolidLedger, SolidRecords};
pub use body::SolidBody;
pub use model::{Numerics, SolidModel};
pub use section::body_sections;
