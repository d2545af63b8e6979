//! Running a model: the time loop, the ledger, the records, and what stands around them.

mod command;
mod course;
mod fluid;
mod ledger;
mod pilot;
mod regime;
mod report;
mod saved;
mod scenario;
mod simulation;
mod solid;
mod watch;
mod weld;

pub use command::command;
pub(crate) use fluid::fluid_numbers;
pub use ledger::Ledger;
pub(crate) use pilot::coarse_conduction;
pub use pilot::{level_plan, level_plan_on};
pub use report::numbers;
pub(crate) use report::solid_scales;
pub use scenario::Scenario;
pub use simulation::{Records, Simulation, StepReport};
pub(crate) use solid::solid_numbers;
pub(crate) use weld::WeldRun;
