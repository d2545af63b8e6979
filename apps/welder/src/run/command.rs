//! `welder run`: reads a case, runs it as its kind asks, and says how it ended.

use super::course::{RunError, interrupt_flag};
use super::{fluid, solid, weld};
use crate::case::{self, Loaded};
use crate::cli::{ExitStatus, RunArguments, refuse};
use crate::observe::CheckpointError;

/// Runs the case of `arguments`.
pub fn command(arguments: &RunArguments) -> ExitStatus {
    let case = match case::load_any(&arguments.case, &arguments.overrides) {
        Ok(case) => case,
        Err(error) => return refuse(&error),
    };
    let mut pool = rayon::ThreadPoolBuilder::new();
    if let Some(threads) = arguments.threads {
        pool = pool.num_threads(threads as usize);
    }
    match pool.build() {
        Ok(pool) => pool.install(|| run(&case, arguments)),
        Err(error) => {
            tracing::error!("the threads cannot be started: {error}");
            ExitStatus::RunFailed
        }
    }
}

fn run(case: &Loaded, arguments: &RunArguments) -> ExitStatus {
    interrupt_flag();
    let ended = match case {
        Loaded::Weld(case) => weld::run(case, arguments),
        Loaded::Fluid(case) => fluid::run(case, arguments),
        Loaded::Solid(case) => solid::run(case, arguments),
    };
    match ended {
        Ok(status) => status,
        Err(RunError::Case(report)) => {
            eprint!("{report}");
            ExitStatus::WrongInput
        }
        Err(RunError::Checkpoint(
            error @ (CheckpointError::OtherCase { .. } | CheckpointError::OtherVersion { .. }),
        )) => {
            tracing::error!("{error}");
            ExitStatus::WrongInput
        }
        Err(RunError::Model(error)) => {
            tracing::error!("the case cannot be built: {error}");
            ExitStatus::WrongInput
        }
        Err(error) => {
            tracing::error!("{error}");
            ExitStatus::RunFailed
        }
    }
}
