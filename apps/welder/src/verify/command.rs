//! The command itself: select, run, print, write, judge.

use super::known::{Verdict, verdict};
use super::table::table;
use super::{Benchmark, Entry, Report, book, select};
use crate::cli::{ExitStatus, Level, VerifyArguments};
use crate::observe::{Machine, ObserveError, summary::write_json};
use crate::version;

/// Runs `welder verify`.
pub fn command(arguments: &VerifyArguments) -> ExitStatus {
    let chosen = match select(&arguments.names) {
        Ok(chosen) => chosen,
        Err(unknown) => {
            tracing::error!("{unknown}");
            return ExitStatus::WrongInput;
        }
    };
    let mut entries = Vec::new();
    let mut unanswered = 0;
    for benchmark in chosen {
        match run(benchmark, arguments) {
            Some(found) => entries.extend(found),
            None => unanswered += 1,
        }
    }
    println!("{}", table(&entries));
    let of = |wanted: Verdict| entries.iter().filter(move |entry| verdict(entry) == wanted);
    let (held, missed) = (of(Verdict::Holds).count(), of(Verdict::Missed).count());
    println!("{held} of {} entries hold their marks", entries.len());
    for entry in of(Verdict::Known) {
        println!("known to miss, and no worse than it was: {}", entry.name);
    }
    let (version, commit) = (version::NUMBER.into(), version::COMMIT.into());
    let report = Report { version, commit, machine: Machine::here(), entries };
    if let Err(error) = write(&report, arguments) {
        tracing::error!("{error}");
        return ExitStatus::WrongInput;
    }
    match (unanswered, missed) {
        (0, 0) => ExitStatus::Done,
        (0, _) => ExitStatus::AuditFailed,
        _ => ExitStatus::RunFailed,
    }
}

/// Writes the files that were asked for.
fn write(report: &Report, arguments: &VerifyArguments) -> Result<(), ObserveError> {
    if let Some(path) = &arguments.json {
        write_json(path, report)?;
    }
    arguments.book.as_ref().map_or(Ok(()), |folder| book::write(folder, report, &line(arguments)))
}

/// The command line that gives the same numbers.
fn line(arguments: &VerifyArguments) -> String {
    let level = match arguments.level {
        Level::Quick => "quick",
        Level::Full => "full",
    };
    let names = arguments.names.iter().map(|name| format!(" {name}")).collect::<String>();
    format!("welder verify{names} --level {level}")
}

/// The entries of one benchmark; none where it has no answer, which is told.
fn run(benchmark: &Benchmark, arguments: &VerifyArguments) -> Option<Vec<Entry>> {
    tracing::info!("{}: {}", benchmark.name, benchmark.reference);
    match benchmark.entries(arguments.level) {
        Ok(entries) => Some(entries),
        Err(error) => {
            tracing::error!("{}: {error}", benchmark.name);
            None
        }
    }
}
