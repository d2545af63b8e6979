//! Surface tension of a melt.

use crate::error::{Error, require};

/// tau(T) = tau_0 + tau_T (T - T_0). Where it falls below zero the surface is not pulled any more, and still driven by its change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceTension {
    tension: f64,
    slope: f64,
    reference_temperature: f64,
}

impl SurfaceTension {
    /// tau_0 \[N/m\] at a temperature T_0 \[K\], and its slope tau_T \[N/(m K)\]; a slope of zero makes no Marangoni force.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a tension below zero, a temperature below zero, or a value that is not finite.
    pub fn new(tension: f64, slope: f64, reference_temperature: f64) -> Result<Self, Error> {
        require(tension >= 0.0, "tension", tension, "zero or above, in newtons per metre")?;
        require(true, "slope", slope, "finite, in newtons per metre and kelvin")?;
        let accepted = "zero or above, in kelvin";
        require(reference_temperature >= 0.0, "reference_temperature", reference_temperature, accepted)?;
        Ok(Self { tension, slope, reference_temperature })
    }

    /// tau_T \[N/(m K)\].
    #[inline]
    #[must_use]
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// tau_0 \[N/m\].
    #[inline]
    #[must_use]
    pub fn reference(&self) -> f64 {
        self.tension
    }

    /// tau \[N/m\] at a temperature \[K\].
    #[inline]
    #[must_use]
    pub fn at(&self, temperature: f64) -> f64 {
        self.tension + self.slope * (temperature - self.reference_temperature)
    }

    /// Whether there is tension at the reference temperature.
    #[inline]
    #[must_use]
    pub fn pulls(&self) -> bool {
        self.tension > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tension_falls_with_temperature() {
        let aluminium = SurfaceTension::new(0.9, -3.5e-4, 933.0).unwrap();
        assert!((aluminium.at(1433.0) - 0.725).abs() < 1e-15 && aluminium.pulls());
        assert!(SurfaceTension::new(-1.0, 0.0, 0.0).unwrap_err().to_string().starts_with("tension is -1"));
        assert!(SurfaceTension::new(1.0, f64::NAN, 0.0).is_err());
    }
}
