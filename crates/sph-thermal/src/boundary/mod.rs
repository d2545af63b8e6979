//! What happens to heat at a free face.

mod losses;
mod surface;

pub use losses::{STEFAN_BOLTZMANN, SurfaceLoss, surface_temperature};
pub use surface::surface_potential;
