//! Flows whose answer is known, for tests, examples and `welder verify`: a scene and what is measured of it, no verdicts.

pub mod drop;
pub mod layer;
pub mod shapes;
