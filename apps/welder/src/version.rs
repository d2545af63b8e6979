//! Which program this is: two commits of one version can compute other bits.

/// Version of the program.
pub const NUMBER: &str = env!("CARGO_PKG_VERSION");

/// The commit that it was built from, in twelve digits: with `+` and a digest of the changes where the sources are not those of
/// the commit; `unknown` where they were not built in the project's repository.
pub const COMMIT: &str = env!("WELDER_COMMIT");

/// Both, as `welder --version` says them and checkpoints hold them.
pub const PROGRAM: &str = concat!(env!("CARGO_PKG_VERSION"), " (commit ", env!("WELDER_COMMIT"), ")");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_commit_is_twelve_digits_or_unknown() {
        let (commit, changes) = COMMIT.split_once('+').unwrap_or((COMMIT, "0"));
        let digits = |text: &str| text.chars().all(|letter| letter.is_ascii_hexdigit());
        assert!(COMMIT == "unknown" || commit.len() == 12 && digits(commit) && digits(changes), "{COMMIT}");
        assert_eq!(PROGRAM, format!("{NUMBER} (commit {COMMIT})"));
    }
}
