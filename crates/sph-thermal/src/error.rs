//! What the constructors of this crate refuse.

/// A value, table or set of columns that a constructor of this crate does not accept.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A scalar is outside the range in which the law holds.
    #[error("{field}: found {found}, accepted: {accepted}")]
    OutOfRange {
        /// Name of the value.
        field: &'static str,
        /// What was given.
        found: f64,
        /// What is accepted, in words.
        accepted: &'static str,
    },
    /// A table over temperature is empty, unordered, or holds a value that is not positive and finite.
    #[error("table over temperature: {0}")]
    Table(String),
    /// Two columns that belong together differ in length.
    #[error("{what}: {found} entries where {expected} are needed")]
    Length {
        /// Which column.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length of the others.
        expected: usize,
    },
    /// The fit of the pair weights did not reach its tolerance.
    #[error(
        "the fitted pair weights stopped at a residual of {residual:.2e} after {iterations} iterations \
         (wanted {tolerance:.1e}); widen the kernel (smoothing ratio 0.85 to 1.0) or lower the disorder"
    )]
    FitDidNotConverge {
        /// Relative residual that was reached.
        residual: f64,
        /// Relative residual that was wanted.
        tolerance: f64,
        /// Iterations spent.
        iterations: usize,
    },
}

/// Refuses `found` unless it is finite and above zero.
pub(crate) fn positive(field: &'static str, found: f64) -> Result<f64, Error> {
    if found.is_finite() && found > 0.0 {
        Ok(found)
    } else {
        Err(Error::OutOfRange { field, found, accepted: "a finite number above 0" })
    }
}
