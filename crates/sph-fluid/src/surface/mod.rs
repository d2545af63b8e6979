//! The free surface: where it is, how it is curved, and what surface tension and its change with temperature do there.
//!
//! There is no gas: the colour is one in all condensed matter, melt and solid, and its gradient is one-sided. The force of
//! tension is tau kappa 2 grad C with the same plain sums that the pressure force is made of, so that a uniform pressure
//! tau kappa is a discrete equilibrium, particle by particle (trials of this project).

mod band;
mod curvature;
mod force;
mod normal;
mod plane;
mod stress;
mod tension;

pub use band::SurfaceBand;
pub use curvature::{curvature, smoothed_curvature};
pub use force::{marangoni_force, tension_force};
pub use normal::{is_surface, may_be_surface, plane_of_surface, smoothed_normal, unit_or_zero};
pub use plane::PlaneProfile;
pub use stress::{PLAIN_SHARE, SurfaceModel, surface_stress, surface_stress_force};
pub use tension::SurfaceTension;
