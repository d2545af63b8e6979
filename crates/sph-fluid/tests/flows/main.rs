//! Flows that the stand-alone sweep must reproduce.

mod closed;
mod fast;
#[path = "../surface/patch.rs"]
mod patch;
mod start_up;
mod still;
mod warm;
