//! Flows that the stand-alone sweep must reproduce.

mod channel;
mod series;
mod start_up;
