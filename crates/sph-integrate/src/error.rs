//! What can be wrong with the settings of a scheme.

use thiserror::Error;

/// Why a setting was refused: which, what it held, and what it may hold.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A number lies outside its range or is not finite.
    #[error("{field} is {found}, but must be {accepted}")]
    OutOfRange {
        /// Name of the setting.
        field: &'static str,
        /// The value that was given.
        found: f64,
        /// The values that are accepted, in words.
        accepted: &'static str,
    },
    /// A stage count that the scheme does not have.
    #[error("an RKL2 step of {found} stages was asked for, but the count must be odd and at least 3")]
    StageCount {
        /// The count that was given.
        found: usize,
    },
}

/// Returns `Ok` if `holds`, else the [`Error::OutOfRange`] that names the setting.
pub(crate) fn require(
    holds: bool,
    field: &'static str,
    found: f64,
    accepted: &'static str,
) -> Result<(), Error> {
    if holds { Ok(()) } else { Err(Error::OutOfRange { field, found, accepted }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_what_was_found_and_what_is_accepted() {
        let message = require(false, "tolerance", -1.0, "a positive number").unwrap_err().to_string();
        assert_eq!(message, "tolerance is -1, but must be a positive number");
        assert!(Error::StageCount { found: 4 }.to_string().contains("4 stages"));
    }
}
