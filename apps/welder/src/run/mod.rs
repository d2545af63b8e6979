//! Running a model: the time loop, the ledger, the records, and what stands around them.

mod ledger;
mod pilot;
mod simulation;

pub use ledger::Ledger;
pub use pilot::level_plan;
pub use simulation::{Records, Simulation, StepReport};
