//! The fast form of the plain weakly compressible terms: packed records, blocks, and lanes of pairs.

mod block_sweep;
mod particle;
mod sweep;
mod terms;

pub use particle::{PackedFields, PackedParticle, PackedRates, PackedRows};
pub use sweep::PackedSweep;
