//! What can be wrong with the input of a laser source.

use thiserror::Error;

/// Why an input was refused: which field, what it held, and what it may hold.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A number lies outside its range or is not finite.
    #[error("{field} is {found}, but must be {accepted}")]
    OutOfRange {
        /// Name of the field as it is written in a case file, for example `points[2].power_w`.
        field: String,
        /// The value that was given.
        found: f64,
        /// The values that are accepted, in words.
        accepted: &'static str,
    },
    /// Both or neither of two fields were given that say the same thing in two ways.
    #[error("give exactly one of {first} and {second}; {found} of them were given")]
    ExactlyOne {
        /// The first of the two fields.
        first: &'static str,
        /// The second of the two fields.
        second: &'static str,
        /// How many of them were given: 0 or 2.
        found: usize,
    },
    /// A table has too few entries.
    #[error("{field} has {found} entries, but needs at least {accepted}")]
    TooFew {
        /// Name of the table.
        field: &'static str,
        /// How many entries it has.
        found: usize,
        /// How many it needs.
        accepted: usize,
    },
    /// Columns that describe the same patches differ in length.
    #[error("column {field} has {found} entries, but column x_m has {accepted}")]
    ColumnLength {
        /// Name of the column.
        field: &'static str,
        /// Its length.
        found: usize,
        /// The length of the first column.
        accepted: usize,
    },
}

/// Returns `Ok` if `holds`, else the [`Error::OutOfRange`] that names the field.
pub(crate) fn require(holds: bool, field: &str, found: f64, accepted: &'static str) -> Result<(), Error> {
    if holds { Ok(()) } else { Err(Error::OutOfRange { field: field.to_owned(), found, accepted }) }
}

/// Requires a positive finite length.
pub(crate) fn require_length(field: &str, found: f64) -> Result<(), Error> {
    require(found.is_finite() && found > 0.0, field, found, "a positive length in metres")
}

/// Requires a finite coordinate.
pub(crate) fn require_coordinate(field: &str, found: f64) -> Result<(), Error> {
    require(found.is_finite(), field, found, "a finite coordinate in metres")
}

/// Requires a finite power that is not negative.
pub(crate) fn require_power(field: &str, found: f64) -> Result<(), Error> {
    require(found.is_finite() && found >= 0.0, field, found, "a power in watts, zero or more")
}

/// Requires a finite time.
pub(crate) fn require_time(field: &str, found: f64) -> Result<(), Error> {
    require(found.is_finite(), field, found, "a finite time in seconds")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn message_names_field_value_and_what_is_accepted() {
        let message = require_length("radius_m", -1.0).unwrap_err().to_string();
        assert_eq!(message, "radius_m is -1, but must be a positive length in metres");
    }

    #[test]
    fn values_that_are_not_numbers_are_refused() {
        assert!(require_length("a", f64::NAN).is_err());
        assert!(require_length("a", f64::INFINITY).is_err());
        assert!(require_length("a", 0.0).is_err());
        assert!(require_coordinate("a", f64::NAN).is_err());
        assert!(require_power("a", f64::INFINITY).is_err());
        assert!(require_power("a", -1e-9).is_err());
        assert!(require_power("a", 0.0).is_ok());
        assert!(require_time("a", f64::NEG_INFINITY).is_err());
    }
}
