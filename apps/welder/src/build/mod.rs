//! From a case to particles at rest: levels of spacing, particles, images, neighbours, pair weights.

mod cells;
mod fine_box;
mod levels;
mod pairs;
mod workpiece;

pub use cells::{centre_of, sites};
pub use fine_box::{fine_box_around, largest_melt_radius, lit_box, margin};
pub use levels::{Cell, CellBox, LevelPlan};
pub use pairs::{Members, Neighborhood, PairReport, conduction_rows, default_ratio, mirrors, pair_table};
pub use workpiece::{Workpiece, disorder, planes, symmetry_planes};
