//! Running a model: the time loop, the ledger, the records, and what stands around them.

mod command;
mod ledger;
mod pilot;
mod report;
mod saved;
mod simulation;
mod watch;

pub use command::command;
pub use ledger::Ledger;
pub use pilot::{level_plan, level_plan_on};
pub(crate) use report::solid_scales;
pub use report::{numbers, summary};
pub use simulation::{Records, Simulation, StepReport};
