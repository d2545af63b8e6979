#![doc = include_str!("../README.md")]

mod blocked;
mod cell_blocks;
mod cell_frame;
mod cell_grid;
mod drift;
mod error;
mod id_set;
mod kd_tree;
mod levels;
mod list;
mod parts;
mod point_index;
mod reach;
mod rows;
mod search;
mod skin;
mod sort;
#[cfg(test)]
mod test_sets;

pub use blocked::{BlockRows, BlockedPairs};
pub use error::Error;
pub use list::NeighborList;
pub use parts::Parts;
pub use reach::PairReach;
pub use search::SearchMethod;
pub use skin::SkinnedList;
pub use sort::{Permutation, spatial_order};
