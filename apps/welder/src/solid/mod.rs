//! Scenes of elastic and yielding bodies that can meet, in the plane and in space.

mod body;
mod model;
mod patch;
mod saved;
mod section;

pub use body::{SolidBody, SolidLedger, SolidRecords};
pub use model::{Numerics, SolidModel};
pub use section::body_sections;
