//! Scenes of elastic bodies, in the plane and in space, in the updated-Lagrangian form, in which they can meet.

mod body;
mod model;
mod section;

pub use body::{SolidBody, SolidLedger, SolidRecords};
pub use model::SolidModel;
pub use section::stress_section;
