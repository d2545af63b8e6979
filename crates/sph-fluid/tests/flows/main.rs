//! Flows that the stand-alone sweep must reproduce.

mod channel;
mod closed;
mod series;
mod start_up;
