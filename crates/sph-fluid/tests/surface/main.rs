//! Free surfaces that the stand-alone sweep must reproduce.

mod cavity;
mod drop;
mod layer;
mod patch;
mod pool;
mod shapes;
