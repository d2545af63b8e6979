//! What happens to heat at a free face.

mod evaporation;
mod losses;
mod surface;

pub use evaporation::Evaporation;
pub use losses::{STEFAN_BOLTZMANN, SurfaceLoss, surface_temperature};
pub use surface::surface_potential;
