//! Free surfaces that the stand-alone sweep must reproduce.

mod bulge;
mod cavity;
mod drop;
mod layer;
mod measure;
mod momentum;
mod patch;
mod pool;
mod shapes;
mod tearing;
