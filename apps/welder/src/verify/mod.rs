//! `welder verify`: the program against exact solutions, an independent solver, and its own promises.
//!
//! A [`Benchmark`] is a scene whose answer is known. It runs at three resolutions; each of its quantities becomes an
//! entry of the report with its errors, the order of convergence that they show, and whether they hold their marks.
//! Scenes use the program's defaults, as a user's case would.

mod benchmark;
mod book;
mod catalogue;
mod command;
mod coupled;
pub mod exact;
mod heat;
mod known;
mod melt;
mod neighbors;
mod order;
mod report;
mod round_off;
mod scene;
mod select;
mod solid;
mod table;
mod weld;

pub use benchmark::{Benchmark, BenchmarkError, LevelResult, Mark, Outcome, Quantity};
pub use catalogue::benchmarks;
pub use command::command;
pub use heat::gaussian_spot::error_with_weights;
pub use order::observed_order;
pub use report::{Entry, Report};
pub use scene::{block, never_melting, reference_aluminium, spot};
pub use select::{UnknownName, select};
