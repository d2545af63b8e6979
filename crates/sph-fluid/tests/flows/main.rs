//! Flows that the stand-alone sweep must reproduce.

mod closed;
#[path = "../surface/patch.rs"]
mod patch;
mod start_up;
