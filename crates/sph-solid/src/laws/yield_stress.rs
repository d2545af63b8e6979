//! Yield stress over temperature.

use super::table::Table;
use crate::error::Error;

/// sigma_y(T) \[Pa\]: linear between its nodes, constant below the first and above the last.
///
/// Let it end at zero at the solidus: pure elasticity would store the whole thermal strain up to melting and throw the
/// melt out with alpha dT times the sound speed.
#[derive(Debug, Clone, PartialEq)]
pub struct YieldStress {
    table: Table,
}

impl YieldStress {
    /// From nodes (temperature \[K\], sigma_y \[Pa\]).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a stress that is negative; [`Error::Table`] without nodes or where temperatures do
    /// not rise.
    pub fn new(nodes: &[(f64, f64)]) -> Result<Self, Error> {
        let table =
            Table::new("yield_pa", nodes, |value| value >= 0.0, "a stress in pascals, zero or above")?;
        Ok(Self { table })
    }

    /// Falls in a straight line from `cold_pa` at `cold_k` to zero at the solidus `solidus_k`.
    ///
    /// # Errors
    /// As [`YieldStress::new`]; [`Error::Table`] also if the solidus is not above `cold_k`.
    pub fn falling_to_zero(cold_pa: f64, cold_k: f64, solidus_k: f64) -> Result<Self, Error> {
        Self::new(&[(cold_k, cold_pa), (solidus_k, 0.0)])
    }

    /// sigma_y at `temperature_k` \[Pa\].
    #[must_use]
    pub fn at(&self, temperature_k: f64) -> f64 {
        self.table.at(temperature_k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_at_the_solidus_and_above() {
        let strength = YieldStress::falling_to_zero(90e6, 293.0, 853.0).unwrap();
        assert_eq!(strength.at(200.0), 90e6);
        assert!((strength.at(573.0) - 45e6).abs() < 1e-6);
        assert_eq!((strength.at(853.0), strength.at(2000.0)), (0.0, 0.0));
    }

    #[test]
    fn bad_tables_are_refused() {
        assert!(YieldStress::falling_to_zero(90e6, 853.0, 853.0).is_err());
        let message = YieldStress::new(&[(293.0, -1.0)]).unwrap_err().to_string();
        assert_eq!(message, "yield_pa is -1, but must be a stress in pascals, zero or above");
    }
}
