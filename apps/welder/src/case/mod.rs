//! Cases: reading, overriding, checking and writing scene files and material cards.

pub mod axes;
mod card;
mod flow;
pub mod fluid;
mod heat;
mod laser;
mod lex;
pub mod library;
mod load;
mod locate;
mod material;
mod nearest;
pub mod over_rise;
mod part;
mod problem;
mod read;
mod resolution;
mod scan;
pub mod scene;
mod set;
pub mod solid;
pub mod source;
mod stress;
mod validate;

pub use card::{CardSource, read_card};
pub use load::{
    Case, FluidCase, Loaded, SolidCase, load, load_any, resolved_fluid_ron, resolved_ron, resolved_solid_ron,
};
pub use material::{Material, MaterialCard, Property, Quantity};
pub(crate) use nearest::suggestion;
pub use problem::{CaseError, Problem};
pub(crate) use validate::memory;
