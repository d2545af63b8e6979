//! The thermal side of a material card.

use super::Table;
use crate::error::{Error, positive};

/// What conduction and phase change need to know of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct ThermalMaterial {
    /// Density \[kg/m³\]; one value, because a particle's mass and volume do not change in this crate.
    pub density: f64,
    /// Solidus temperature \[K\]: below it, all solid.
    pub solidus: f64,
    /// Liquidus temperature \[K\]: above it, all liquid.
    pub liquidus: f64,
    /// Latent heat of fusion \[J/kg\].
    pub latent_heat: f64,
    /// Specific heat capacity of the solid \[J/(kg K)\].
    pub heat_capacity_solid: Table,
    /// Specific heat capacity of the liquid \[J/(kg K)\].
    pub heat_capacity_liquid: Table,
    /// Conductivity of the solid \[W/(m K)\].
    pub conductivity_solid: Table,
    /// Conductivity of the liquid \[W/(m K)\].
    pub conductivity_liquid: Table,
}

impl ThermalMaterial {
    /// Checks the scalars against each other.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] that names the first value that no melting material has.
    pub fn validate(&self) -> Result<(), Error> {
        positive("density", self.density)?;
        positive("solidus", self.solidus)?;
        if !(self.latent_heat.is_finite() && self.latent_heat >= 0.0) {
            let accepted = "a finite number, 0 or above";
            return Err(Error::OutOfRange { field: "latent_heat", found: self.latent_heat, accepted });
        }
        if !(self.liquidus.is_finite() && self.liquidus > self.solidus) {
            let accepted = "a temperature above the solidus";
            return Err(Error::OutOfRange { field: "liquidus", found: self.liquidus, accepted });
        }
        Ok(())
    }

    /// Conductivity \[W/(m K)\] at a temperature \[K\]; linear in temperature through the mushy range.
    pub fn conductivity(&self, temperature: f64) -> f64 {
        if temperature <= self.solidus {
            return self.conductivity_solid.at(temperature);
        }
        if temperature >= self.liquidus {
            return self.conductivity_liquid.at(temperature);
        }
        let share = (temperature - self.solidus) / (self.liquidus - self.solidus);
        let solid = self.conductivity_solid.at(self.solidus);
        solid + share * (self.conductivity_liquid.at(self.liquidus) - solid)
    }

    /// Temperatures at which the conductivity bends, rising.
    pub(crate) fn conductivity_nodes(&self) -> Vec<f64> {
        let mut nodes: Vec<f64> = self.conductivity_solid.node_temperatures(0.0, self.solidus).collect();
        nodes.extend([self.solidus, self.liquidus]);
        nodes.extend(self.conductivity_liquid.node_temperatures(self.liquidus, f64::INFINITY));
        nodes
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// The aluminium of the reference solutions of this project.
    pub(crate) fn aluminium() -> ThermalMaterial {
        ThermalMaterial {
            density: 2500.0,
            solidus: 847.0,
            liquidus: 905.0,
            latent_heat: 3.97e5,
            heat_capacity_solid: Table::constant(1050.0).unwrap(),
            heat_capacity_liquid: Table::constant(1180.0).unwrap(),
            conductivity_solid: Table::constant(200.0).unwrap(),
            conductivity_liquid: Table::constant(95.0).unwrap(),
        }
    }

    #[test]
    fn conductivity_is_linear_through_the_mush() {
        let material = aluminium();
        assert_eq!(material.conductivity(300.0), 200.0);
        assert_eq!(material.conductivity(876.0), 147.5);
        assert_eq!(material.conductivity(2000.0), 95.0);
    }

    #[test]
    fn refuses_solidus_above_liquidus_and_negative_latent_heat() {
        let swapped = ThermalMaterial { solidus: 950.0, ..aluminium() };
        assert!(swapped.validate().unwrap_err().to_string().contains("liquidus"));
        let negative = ThermalMaterial { latent_heat: -1.0, ..aluminium() };
        assert!(negative.validate().unwrap_err().to_string().contains("latent_heat"));
        assert!(aluminium().validate().is_ok());
    }
}
