//! The command line: commands, options, exit codes. The commands themselves live in modules of their names.

use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::case::CaseError;
use crate::version;

/// Simulates conduction-mode laser welding with smoothed particle hydrodynamics.
#[derive(Debug, Clone, Parser)]
#[command(version = version::PROGRAM, about, after_help = EXIT_CODES)]
pub struct CommandLine {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 done; 2 the input is wrong; 3 the run went wrong; 4 an audit failed; \
                          130 interrupted after a checkpoint was written.";

/// The commands.
#[derive(Debug, Clone, Subcommand)]
pub enum Command {
    /// Run a case.
    Run(RunArguments),
    /// Read and check a case: particles, memory, step limits, dimensionless numbers, power, cost.
    Check(CheckArguments),
    /// Run benchmarks against exact solutions: error, observed order, cost.
    Verify(VerifyArguments),
    /// Show the cases, materials and benchmarks that come with the program.
    List,
    /// Run a case at several resolutions and settings: error against cost, observed order, estimated error.
    Precision(PrecisionArguments),
}

/// Arguments of `run`.
#[derive(Debug, Clone, Args)]
pub struct RunArguments {
    /// A folder with a scene.ron, or a .ron file.
    pub case: PathBuf,
    /// Where the results go [default: out/NAME].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Threads to use [default: all].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub threads: Option<u32>,
    /// Change a value of the scene, as in resolution.spacing_m=25e-6; can be given several times.
    #[arg(long = "set", value_name = "path=value")]
    pub overrides: Vec<String>,
    /// Stop, with a checkpoint, at this physical time.
    #[arg(long = "until", value_name = "SECONDS", value_parser = positive_seconds)]
    pub until_s: Option<f64>,
    /// Go on from the newest checkpoint in DIR.
    #[arg(long)]
    pub resume: bool,
    /// No progress bar, warnings only.
    #[arg(long, short)]
    pub quiet: bool,
}

/// Arguments of `check`.
#[derive(Debug, Clone, Args)]
pub struct CheckArguments {
    /// A folder with a scene.ron, or a .ron file.
    pub case: PathBuf,
    /// Change a value of the scene, as in resolution.spacing_m=25e-6; can be given several times.
    #[arg(long = "set", value_name = "path=value")]
    pub overrides: Vec<String>,
    /// Run a coarse copy of the case with and without each effect that the advice names, and hold the advice against it.
    #[arg(long)]
    pub prove: bool,
    /// Write what `--prove` found to this file as well.
    #[arg(long, value_name = "FILE", requires = "prove")]
    pub json: Option<PathBuf>,
}

/// Arguments of `verify`.
#[derive(Debug, Clone, Args)]
pub struct VerifyArguments {
    /// Benchmarks to run, by name or beginning of a name [default: all].
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// How much to run.
    #[arg(long, value_enum, default_value_t = Level::Quick)]
    pub level: Level,
    /// Write the results to this file as well.
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// Write a page with table and plots for each group of benchmarks into this folder as well.
    #[arg(long, value_name = "DIR")]
    pub book: Option<PathBuf>,
}

/// How much `verify` runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Level {
    /// The resolutions that take seconds.
    Quick,
    /// All resolutions.
    Full,
}

/// Arguments of `precision`.
#[derive(Debug, Clone, Args)]
pub struct PrecisionArguments {
    /// A folder with a scene.ron, or a .ron file.
    pub case: PathBuf,
    /// Write the results to this file as well.
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// Where the plots go [default: out/NAME].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Change a value of the scene, as in resolution.spacing_m=25e-6; can be given several times.
    #[arg(long = "set", value_name = "path=value")]
    pub overrides: Vec<String>,
    /// Run a ladder over one field of physics or of the particles' disorder instead of the program's own settings, as in
    /// physics.0.smoothing_ratio=0.7,0.85,1.0.
    #[arg(long, value_name = "path=value,value,...")]
    pub vary: Option<String>,
    /// Name the cheapest run whose error is at most this share, as in 0.01.
    #[arg(long, value_name = "SHARE", value_parser = share)]
    pub wanted_error: Option<f64>,
}

fn share(text: &str) -> Result<f64, String> {
    let refusal = || "accepted: a share above 0 and below 1, as in 0.01 for one per cent".to_string();
    text.parse().ok().filter(|share: &f64| *share > 0.0 && *share < 1.0).ok_or_else(refusal)
}

fn positive_seconds(text: &str) -> Result<f64, String> {
    let refusal = || "accepted: a time in seconds above zero, as in 5e-3".to_string();
    text.parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0).ok_or_else(refusal)
}

/// How the program ends; the one place that knows the numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExitStatus {
    /// All was done.
    Done,
    /// The input is wrong.
    WrongInput,
    /// The run went wrong.
    RunFailed,
    /// An audit failed: energy, delivered power, a benchmark's mark.
    AuditFailed,
    /// Interrupted after a checkpoint was written.
    Interrupted,
}

impl ExitStatus {
    /// The number that the shell sees.
    pub fn code(self) -> u8 {
        match self {
            ExitStatus::Done => 0,
            ExitStatus::WrongInput => 2,
            ExitStatus::RunFailed => 3,
            ExitStatus::AuditFailed => 4,
            ExitStatus::Interrupted => 130,
        }
    }
}

impl From<ExitStatus> for ExitCode {
    fn from(status: ExitStatus) -> Self {
        ExitCode::from(status.code())
    }
}

/// Prints to standard output; a reader who has gone away is no error.
pub fn say(text: &str) {
    let mut out = std::io::stdout().lock();
    let told = out.write_all(text.as_bytes()).and_then(|()| out.write_all(b"\n"));
    if let Err(error) = told {
        tracing::debug!("nobody reads the output: {error}");
    }
}

/// Tells what is wrong with a case, on standard error, and ends with the code for it.
pub fn refuse(error: &CaseError) -> ExitStatus {
    eprint!("{}", error.report(std::io::stderr().is_terminal()));
    ExitStatus::WrongInput
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;
    use clap::error::ErrorKind;

    use super::*;

    fn parse(line: &str) -> Result<Command, ErrorKind> {
        let words = std::iter::once("welder").chain(line.split_whitespace());
        CommandLine::try_parse_from(words).map(|parsed| parsed.command).map_err(|error| error.kind())
    }

    #[test]
    fn the_definition_is_consistent() {
        CommandLine::command().debug_assert();
    }

    #[test]
    fn run_takes_the_options_of_the_contract() {
        let line =
            "run cases/spot --out here --threads 2 --set a=1 --set b.c=2 --until 5e-3 --resume --quiet";
        let Ok(Command::Run(run)) = parse(line) else { panic!("not parsed") };
        assert_eq!(run.overrides, ["a=1", "b.c=2"]);
        assert_eq!((run.threads, run.until_s, run.resume, run.quiet), (Some(2), Some(5e-3), true, true));
    }

    #[test]
    fn verify_takes_names_and_a_level() {
        let Ok(Command::Verify(verify)) =
            parse("verify heat/gaussian-spot melt --level full --json x.json --book pages")
        else {
            panic!("not parsed")
        };
        assert_eq!(verify.names, ["heat/gaussian-spot", "melt"]);
        assert_eq!(verify.level, Level::Full);
    }

    #[test]
    fn wrong_options_are_refused() {
        for line in [
            "run",
            "run case --threads 0",
            "run case --until -1",
            "run case --until nan",
            "check case --json x.json",
            "verify --level fast",
            "precision case --wanted-error 0",
            "precision case --wanted-error NaN",
            "precision case --wanted-error -0.01",
            "precision case --wanted-error 1e400",
            "precision case --wanted-error 5%",
        ] {
            assert!(parse(line).is_err(), "{line}");
        }
    }

    #[test]
    fn exit_codes_are_those_of_the_contract() {
        use ExitStatus::*;
        let codes = [Done, WrongInput, RunFailed, AuditFailed, Interrupted].map(ExitStatus::code);
        assert_eq!(codes, [0, 2, 3, 4, 130]);
    }
}
