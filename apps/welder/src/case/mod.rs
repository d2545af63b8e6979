//! Cases: reading, overriding, checking and writing scene files and material cards.

mod card;
mod flow;
mod heat;
mod laser;
mod lex;
pub mod library;
mod load;
mod locate;
mod material;
mod nearest;
mod part;
mod problem;
mod read;
mod resolution;
mod scan;
pub mod scene;
mod set;
pub mod source;
mod stress;
mod validate;

pub use card::{CardSource, read_card};
pub use load::{Case, load, resolved_ron};
pub use material::{Material, MaterialCard, Property, Quantity};
pub(crate) use nearest::suggestion;
pub use problem::{CaseError, Problem};
pub(crate) use validate::memory;
