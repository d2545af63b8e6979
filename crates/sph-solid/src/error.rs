//! What can be wrong with a material value.

use thiserror::Error;

/// Why a material value was refused: which, what it held, and what it may hold.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A number lies outside its range or is not finite.
    #[error("{field} is {found}, but must be {accepted}")]
    OutOfRange {
        /// Name of the value.
        field: &'static str,
        /// The value that was given.
        found: f64,
        /// The values that are accepted, in words.
        accepted: &'static str,
    },
}

/// Returns `Ok` if `holds` and the value is finite, else the [`Error::OutOfRange`] that names it.
pub(crate) fn require(
    holds: bool,
    field: &'static str,
    found: f64,
    accepted: &'static str,
) -> Result<(), Error> {
    if holds && found.is_finite() { Ok(()) } else { Err(Error::OutOfRange { field, found, accepted }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn message_names_field_value_and_what_is_accepted() {
        let message = require(false, "density", -1.0, "a positive number").unwrap_err().to_string();
        assert_eq!(message, "density is -1, but must be a positive number");
        assert!(require(true, "density", f64::INFINITY, "a positive number").is_err());
        assert!(require(true, "density", 1.0, "a positive number").is_ok());
    }
}
