//! Material cards: each value with its source, tables over temperature where the model takes them.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// A card as it stands in a file of cases/materials or in the scene's `materials`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MaterialCard {
    /// What the material is, in words.
    #[serde(default)]
    pub title: String,
    /// Density in kg/m3, constant in the model: the particles keep their mass and their volume.
    pub density_kg_m3: Quantity,
    /// Temperature in kelvin at which melting begins.
    pub solidus_k: Quantity,
    /// Temperature in kelvin at which all is molten; above the solidus.
    pub liquidus_k: Quantity,
    /// Latent heat of fusion in J/kg.
    pub latent_heat_j_kg: Quantity,
    /// Temperature in kelvin at which the melt boils, at one atmosphere.
    #[serde(default)]
    pub boiling_k: Option<Quantity>,
    /// Heat of evaporation in J/kg; read where a face evaporates and where a keyhole is to be told, as is the one below.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heat_of_evaporation_j_kg: Option<Quantity>,
    /// Molar mass of the vapour in kg/mol.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub molar_mass_kg_mol: Option<Quantity>,
    /// Specific heat capacity of the solid in J/(kg K).
    pub heat_capacity_solid_j_kg_k: Property,
    /// Specific heat capacity of the melt in J/(kg K).
    pub heat_capacity_liquid_j_kg_k: Property,
    /// Thermal conductivity of the solid in W/(m K).
    pub conductivity_solid_w_m_k: Property,
    /// Thermal conductivity of the melt in W/(m K).
    pub conductivity_liquid_w_m_k: Property,
    /// Dynamic viscosity of the melt in Pa s; read by Flow, as are the three below.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub viscosity_pa_s: Option<Property>,
    /// Surface tension of the melt in N/m: a value at the liquidus with the slope below, or a table over temperature without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface_tension_n_m: Option<Property>,
    /// Change of the surface tension with temperature in N/(m K), mostly negative; only with a value of the tension.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface_tension_slope_n_m_k: Option<Quantity>,
    /// Coefficient of expansion of the melt by volume in 1/K, -1/rho d rho/dT from the liquidus on; read by Flow,
    /// which makes warm melt lighter with it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume_expansion_liquid_1_k: Option<Quantity>,
    /// Young's modulus of the solid in Pa, constant in the model; read by Stress alone, as are those below.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub young_pa: Option<Quantity>,
    /// Poisson's ratio of the solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson: Option<Quantity>,
    /// Coefficient of linear thermal expansion of the solid in 1/K, the slope d ln(length)/dT.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expansion_1_k: Option<Property>,
    /// Yield stress in Pa, zero from the solidus on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_pa: Option<Property>,
}

impl MaterialCard {
    /// The constant values with the names of their fields; those that may be left out only when they are given.
    pub fn quantities(&self) -> Vec<(&'static str, &Quantity)> {
        let mut all = vec![
            ("density_kg_m3", &self.density_kg_m3),
            ("solidus_k", &self.solidus_k),
            ("liquidus_k", &self.liquidus_k),
            ("latent_heat_j_kg", &self.latent_heat_j_kg),
        ];
        let vapour = [
            ("boiling_k", &self.boiling_k),
            ("heat_of_evaporation_j_kg", &self.heat_of_evaporation_j_kg),
            ("molar_mass_kg_mol", &self.molar_mass_kg_mol),
        ];
        all.extend(vapour.into_iter().filter_map(|(name, value)| Some((name, value.as_ref()?))));
        all.extend(
            self.surface_tension_slope_n_m_k.as_ref().map(|slope| ("surface_tension_slope_n_m_k", slope)),
        );
        let expansion = self.volume_expansion_liquid_1_k.as_ref();
        all.extend(expansion.map(|expansion| ("volume_expansion_liquid_1_k", expansion)));
        all.extend(self.young_pa.as_ref().map(|young| ("young_pa", young)));
        all.extend(self.poisson.as_ref().map(|poisson| ("poisson", poisson)));
        all
    }

    /// The values that may depend on temperature, with the names of their fields; those that may be left out only when they are given.
    pub fn properties(&self) -> Vec<(&'static str, &Property)> {
        let mut all = vec![
            ("heat_capacity_solid_j_kg_k", &self.heat_capacity_solid_j_kg_k),
            ("heat_capacity_liquid_j_kg_k", &self.heat_capacity_liquid_j_kg_k),
            ("conductivity_solid_w_m_k", &self.conductivity_solid_w_m_k),
            ("conductivity_liquid_w_m_k", &self.conductivity_liquid_w_m_k),
        ];
        let optional = [
            ("viscosity_pa_s", &self.viscosity_pa_s),
            ("surface_tension_n_m", &self.surface_tension_n_m),
            ("expansion_1_k", &self.expansion_1_k),
            ("yield_pa", &self.yield_pa),
        ];
        all.extend(optional.into_iter().filter_map(|(name, property)| Some((name, property.as_ref()?))));
        all
    }
}

/// A number and where it comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quantity {
    /// The number, in the unit of the field's name.
    pub value: f64,
    /// Where the number comes from.
    pub source: String,
}

/// A number or a table over temperature, and where it comes from. A checked card has exactly one of the two.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Property {
    /// The number, in the unit of the field's name, when it does not depend on temperature.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Pairs (temperature_k, value), temperatures ascending; linear between, constant beyond the ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<(f64, f64)>>,
    /// Where the numbers come from.
    pub source: String,
}

impl Property {
    /// The value at a temperature in kelvin: linear between the points of a table, constant beyond its ends.
    pub fn at(&self, temperature_k: f64) -> f64 {
        let points = self.points();
        let above = points.partition_point(|&(point_k, _)| point_k <= temperature_k);
        if above == 0 {
            return points[0].1;
        }
        let Some(&(high_k, high)) = points.get(above) else { return points[above - 1].1 };
        let (low_k, low) = points[above - 1];
        low + (high - low) * (temperature_k - low_k) / (high_k - low_k)
    }

    /// The points (temperature_k, value) of the table; a constant is one point at 0 K.
    pub fn points(&self) -> Vec<(f64, f64)> {
        self.table.clone().unwrap_or_else(|| vec![(0.0, self.value.unwrap_or(f64::NAN))])
    }

    /// The number, when the property does not depend on temperature.
    pub fn constant(&self) -> Option<f64> {
        self.value
    }
}

/// A material of a loaded case: a checked card, the name it goes by, and where it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name: the file's without its ending, or the key in the scene.
    pub name: String,
    /// The file that the card was read from: the card's own or the scene.
    pub path: PathBuf,
    /// The values.
    pub card: MaterialCard,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Property {
        Property {
            value: None,
            table: Some(vec![(300.0, 10.0), (400.0, 20.0), (800.0, 0.0)]),
            source: String::new(),
        }
    }

    #[test]
    fn tables_are_linear_between_their_points() {
        assert_eq!(table().at(350.0), 15.0);
        assert_eq!(table().at(400.0), 20.0);
        assert_eq!(table().at(600.0), 10.0);
    }

    #[test]
    fn tables_are_constant_beyond_their_ends() {
        assert_eq!(table().at(20.0), 10.0);
        assert_eq!(table().at(3000.0), 0.0);
    }

    #[test]
    fn a_constant_holds_everywhere() {
        let constant = Property { value: Some(7.0), table: None, source: String::new() };
        assert_eq!(constant.at(1.0), 7.0);
        assert_eq!(constant.at(1.0e4), 7.0);
    }
}
