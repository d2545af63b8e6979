//! Hands the flags of the build and the commit of the sources to the program, which writes them beside what it measures.

use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What the program is built from, beside the crates.
const SOURCES: [&str; 6] =
    ["build.rs", "src", "Cargo.toml", "../../Cargo.toml", "../../Cargo.lock", "../../.cargo/config.toml"];

fn main() {
    println!("cargo:rustc-env=WELDER_BUILD={}", flags());
    // Built anew where a source changes or another commit is checked out, and else not: `git status` and a new test change nothing.
    let sources = sources();
    let watched = sources.iter().cloned().chain(["HEAD", "logs/HEAD"].into_iter().filter_map(git_path));
    // A path that is not there would count as changed each time.
    watched
        .filter(|path| path.exists())
        .for_each(|path| println!("cargo:rerun-if-changed={}", path.display()));
    println!("cargo:rustc-env=WELDER_COMMIT={}", commit(&sources).unwrap_or_else(|| "unknown".into()));
}

fn flags() -> String {
    let of = |name: &str| std::env::var(name).unwrap_or_default();
    let answer = Command::new(of("RUSTC")).arg("--version").output();
    let answer =
        answer.map_or_else(|_| String::new(), |told| String::from_utf8_lossy(&told.stdout).into_owned());
    // "rustc 1.89.0": what follows holds the date of the compiler.
    let compiler: Vec<&str> = answer.split_whitespace().take(2).collect();
    format!(
        "{}, profile {}, opt-level {}, rustflags \"{}\"",
        compiler.join(" "),
        of("PROFILE"),
        of("OPT_LEVEL"),
        of("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ")
    )
}

fn sources() -> Vec<PathBuf> {
    let crates = std::fs::read_dir("../../crates").into_iter().flatten().filter_map(Result::ok);
    let of_crates = crates.flat_map(|folder| ["src", "Cargo.toml"].map(|name| folder.path().join(name)));
    let mut sources: Vec<_> =
        SOURCES.iter().map(PathBuf::from).chain(of_crates).filter(|path| path.exists()).collect();
    // The digest of changes is of their text in this order.
    sources.sort();
    sources
}

/// The commit, with a digest of what has been changed since; none where these sources are in no repository, or there is no git.
fn commit(sources: &[PathBuf]) -> Option<String> {
    // Sources that lie in a repository by chance, as those of an unpacked package, are not of its commit.
    git(&["ls-files", "--error-unmatch", "build.rs"], &[])?;
    let commit = String::from_utf8(git(&["rev-parse", "--short=12", "HEAD"], &[])?).ok()?;
    let changes = git(&["diff", "--no-ext-diff", "HEAD"], sources)?;
    if changes.is_empty() {
        return Some(commit.trim().into());
    }
    let mut digest = DefaultHasher::new();
    digest.write(&changes);
    Some(format!("{}+{:08x}", commit.trim(), digest.finish() >> 32))
}

/// A file of the repository.
fn git_path(name: &str) -> Option<PathBuf> {
    let path = String::from_utf8(git(&["rev-parse", "--git-path", name], &[])?).ok()?;
    Some(Path::new(path.trim_end()).to_path_buf())
}

/// What git answers, if it does.
fn git(arguments: &[&str], paths: &[PathBuf]) -> Option<Vec<u8>> {
    let mut command = Command::new("git");
    // Only looks: takes no lock and writes no index.
    command.arg("--no-optional-locks").args(arguments);
    if !paths.is_empty() {
        command.arg("--").args(paths);
    }
    let answer = command.output().ok()?;
    answer.status.success().then_some(answer.stdout)
}
