//! Solid and melt together, and the welds themselves.

pub(super) mod cycles;
mod fluid;
pub(super) mod gallium;
pub(super) mod gate;
pub(super) mod grid;
pub(super) mod nist_tracks;
pub(super) mod rest;
