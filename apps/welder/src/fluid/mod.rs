//! Scenes of pure fluid, in the plane and in space: blocks and balls of a weakly compressible fluid between walls, open and
//! periodic sides.

mod expect;
mod flow;
mod ledger;
mod model;
mod place;
mod section;

pub use expect::{Expected, expected};
pub use flow::{FluidFlow, FluidRecords};
pub use ledger::FluidLedger;
pub use model::{Edge, FluidModel};
pub use place::{Placed, wall_rows};
pub use section::{Cloud, section, sections};

/// What a list reaches beyond the kernel, over the spacing.
const SKIN: f64 = 1.0;

/// Spacings that a periodic scene must repeat after at least, so that no particle meets itself: what fluid sees of a wall, what
/// that wall sees again, and the skins.
pub fn least_period(smoothing_ratio: f64) -> f64 {
    2.0 * (2.0 * smoothing_ratio + SKIN) + SKIN
}
