//! Solid and melt together, and the welds themselves.

pub(super) mod cup;
pub(super) mod cycles;
mod fluid;
pub(super) mod gallium;
pub(super) mod gate;
pub(super) mod grid;
pub(super) mod nist_tracks;
mod own_stress;
pub(super) mod rest;
