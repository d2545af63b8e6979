//! Solid and melt together, and the welds themselves.

pub(super) mod cycles;
mod fluid;
pub(super) mod gate;
pub(super) mod nist_tracks;
