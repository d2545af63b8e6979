//! What can be wrong with a material value, a table or the columns of a body.

use thiserror::Error;

/// Why a value was refused: which, what it held, and what it may hold.
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
    /// A table has no node, or its temperatures do not rise.
    #[error("{table}: {found}, but at least one node with rising temperatures is needed")]
    Table {
        /// Name of the table.
        table: &'static str,
        /// What is wrong with it.
        found: String,
    },
    /// A column has not one entry per particle.
    #[error("{column} has {found} entries, but {expected} are needed")]
    Length {
        /// Name of the column.
        column: &'static str,
        /// Its length.
        found: usize,
        /// The length that is needed.
        expected: usize,
    },
    /// A neighbour list names a particle that does not exist, or lists a pair at one of its two ends only.
    #[error("the neighbour list of particle {particle} {reason}")]
    List {
        /// The particle whose row is wrong.
        particle: usize,
        /// What is wrong with it.
        reason: &'static str,
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

/// Returns `Ok` if a column has the length that is needed, else the [`Error::Length`] that names it.
pub(crate) fn require_length(column: &'static str, found: usize, expected: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::Length { column, found, expected }) }
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

    #[test]
    fn message_names_the_column() {
        let message = require_length("volumes", 3, 4).unwrap_err().to_string();
        assert_eq!(message, "volumes has 3 entries, but 4 are needed");
    }
}
