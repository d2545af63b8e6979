//! The command line of `welder`.

use std::io::IsTerminal;
use std::process::ExitCode;

use clap::Parser;
use tracing_subscriber::EnvFilter;
use welder::cli::{Command, CommandLine, ExitStatus};

fn main() -> ExitCode {
    let line = CommandLine::parse();
    start_log(&line.command);
    dispatch(line.command).into()
}

/// Logs go to standard error, by level; RUST_LOG overrides the level.
fn start_log(command: &Command) {
    let quiet = matches!(command, Command::Run(run) if run.quiet);
    let level = if quiet { "warn" } else { "info" };
    let filter = EnvFilter::try_from_default_env().unwrap_or_else(|_| EnvFilter::new(level));
    let colours = std::io::stderr().is_terminal();
    tracing_subscriber::fmt().with_env_filter(filter).with_writer(std::io::stderr).with_ansi(colours).init();
}

fn dispatch(command: Command) -> ExitStatus {
    match command {
        Command::List => welder::list::command(),
        Command::Check(arguments) => welder::check::command(&arguments),
        Command::Run(arguments) => welder::run::command(&arguments),
        Command::Precision(arguments) => welder::precision::command(&arguments),
        Command::Verify(arguments) => welder::verify::command(&arguments),
    }
}
