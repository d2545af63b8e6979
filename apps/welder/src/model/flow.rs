//! The melt as the engine takes it.

use super::{Model, ModelError};
use crate::case::MaterialCard;
use crate::case::scene::Flow;
use sph_fluid::{SurfaceTension, ThermalExpansion, artificial_sound_speed};
use sph_thermal::phase::Table;

/// How much hotter than its rim a pool is taken to be before the run \[K\].
const EXPECTED_EXCESS: f64 = 500.0;

/// Gravity on the melt of a weld, downwards \[m/s²\].
pub const GRAVITY: f64 = 9.81;

/// Flow of the part's own material.
#[derive(Debug, Clone, PartialEq)]
pub struct FlowModel {
    /// What the scene says.
    pub settings: Flow,
    /// Dynamic viscosity of the melt over temperature, factor included \[Pa s\].
    pub viscosity: Table,
    /// Surface tension over temperature \[N/m\].
    pub tension: TensionLaw,
    /// How warmth expands the melt beyond the liquidus, where the card tells.
    pub expansion: Option<ThermalExpansion>,
    /// Temperature that the numbers of a flow are taken at \[K\].
    pub liquidus: f64,
}

/// Surface tension over temperature.
#[derive(Debug, Clone, PartialEq)]
pub enum TensionLaw {
    /// A value and a slope.
    Linear(SurfaceTension),
    /// A table; its slope is that between its points.
    Table(Table),
}

impl TensionLaw {
    /// The tension of a card, where it tells.
    ///
    /// # Errors
    /// [`ModelError::Unsupported`] of a value without slope or a table with one, and what the crates refuse.
    pub fn of_card(card: &MaterialCard) -> Result<Option<Self>, ModelError> {
        let Some(tension) = &card.surface_tension_n_m else { return Ok(None) };
        match (tension.constant(), &card.surface_tension_slope_n_m_k) {
            (Some(tension), Some(slope)) => {
                Ok(Some(Self::Linear(SurfaceTension::new(tension, slope.value, card.liquidus_k.value)?)))
            }
            (None, None) => Ok(Some(Self::Table(Table::new(tension.points())?))),
            _ => {
                let what =
                    "surface_tension_n_m is a value with surface_tension_slope_n_m_k, or a table without";
                Err(ModelError::Unsupported(what.into()))
            }
        }
    }

    /// Tension \[N/m\] at a temperature \[K\].
    pub fn at(&self, temperature: f64) -> f64 {
        match self {
            Self::Linear(tension) => tension.at(temperature),
            Self::Table(table) => table.at(temperature),
        }
    }

    /// The slope of largest magnitude between two temperatures \[N/(m K)\].
    pub fn steepest_slope(&self, low: f64, high: f64) -> f64 {
        match self {
            Self::Linear(tension) => tension.slope(),
            Self::Table(table) => {
                table.slopes(low, high).max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
            }
        }
    }

    /// What the sweep needs of it: the largest tension, which rules the steps, and the slope.
    ///
    /// # Errors
    /// What the fluid crate refuses.
    pub fn for_steps(&self) -> Result<SurfaceTension, sph_fluid::Error> {
        match self {
            Self::Linear(tension) => Ok(*tension),
            Self::Table(table) => SurfaceTension::new(table.largest(), 0.0, 0.0),
        }
    }
}

impl FlowModel {
    /// The melt of a card.
    ///
    /// # Errors
    /// [`ModelError::Unsupported`] where the card lacks what flow needs, and what the crates refuse.
    pub fn of_card(settings: &Flow, card: &MaterialCard) -> Result<Self, ModelError> {
        let (Some(viscosity), Some(tension)) = (&card.viscosity_pa_s, TensionLaw::of_card(card)?) else {
            let what = "Flow needs viscosity_pa_s and surface_tension_n_m of the material";
            return Err(ModelError::Unsupported(what.into()));
        };
        let liquidus = card.liquidus_k.value;
        let thickened = viscosity.points().into_iter().map(|(t, eta)| (t, settings.viscosity_factor * eta));
        let viscosity = Table::new(thickened.collect())?;
        let expansion = card.volume_expansion_liquid_1_k.as_ref().filter(|given| given.value != 0.0);
        let expansion = expansion.map(|given| ThermalExpansion::new(given.value, liquidus)).transpose()?;
        Ok(Self { settings: *settings, viscosity, tension, expansion, liquidus })
    }

    /// Viscosity at the liquidus \[Pa s\].
    pub fn viscosity_at_liquidus(&self) -> f64 {
        self.viscosity.at(self.liquidus)
    }

    /// Tension at the liquidus \[N/m\].
    pub fn tension_at_liquidus(&self) -> f64 {
        self.tension.at(self.liquidus)
    }

    /// Change of tension \[N/m\] over a pool that is hotter than its rim by `excess` \[K\], at the steepest slope there.
    pub fn pull(&self, excess: f64) -> f64 {
        self.tension.steepest_slope(self.liquidus, self.liquidus + excess).abs() * excess
    }

    /// Artificial speed of sound \[m/s\] to begin with: the scene's, or ten times the speed of capillary waves on the
    /// beam's radius or, in pools so large that weight rules, of a fall from it. Where the melt turns out faster than
    /// a tenth of it, the run raises it.
    pub fn first_sound_speed(&self, model: &Model) -> f64 {
        let density = model.materials[0].density;
        let (tension, radius) = (self.tension_at_liquidus(), model.heated_radius());
        let needed = artificial_sound_speed(0.0, density, tension, radius, density * GRAVITY * radius);
        self.settings.sound_speed_m_s.unwrap_or(needed)
    }

    /// Speed \[m/s\] that the scene lets expect of its Marangoni flow.
    pub fn expected_speed(&self, model: &Model) -> f64 {
        let density = model.materials[0].density;
        marangoni_speed(
            self.pull(EXPECTED_EXCESS),
            density,
            self.viscosity_at_liquidus(),
            model.heated_radius(),
        )
    }
}

/// Speed \[m/s\] of a surface that a change of tension `pull` \[N/m\] over a `radius` \[m\] drives: that of its boundary layer,
/// (pull^2/(rho eta R))^(1/3) (Ostrach 1982), or, where friction rules, of a Stokes flow in a half-sphere, 0.15 pull/eta.
pub fn marangoni_speed(pull: f64, density: f64, viscosity: f64, radius: f64) -> f64 {
    (pull * pull / (density * viscosity * radius)).cbrt().min(0.15 * pull / viscosity)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Iron with sulphur: tension rises to 2000 K and falls from there.
    fn turning() -> TensionLaw {
        TensionLaw::Table(Table::new(vec![(1800.0, 1.5), (2000.0, 1.6), (2500.0, 1.4)]).unwrap())
    }

    #[test]
    fn a_table_has_the_slopes_of_its_pieces() {
        let law = turning();
        assert!((law.at(1900.0) - 1.55).abs() < 1e-12);
        assert!((law.steepest_slope(1800.0, 2500.0) - 5e-4).abs() < 1e-12);
        assert!((law.steepest_slope(2000.0, 2500.0) + 4e-4).abs() < 1e-12);
        assert_eq!(law.steepest_slope(2600.0, 2700.0), 0.0);
        assert_eq!(law.for_steps().unwrap().reference(), 1.6);
    }

    #[test]
    fn a_line_is_the_same_as_its_table_where_that_reaches() {
        let line = TensionLaw::Linear(SurfaceTension::new(0.9, -3.5e-4, 905.0).unwrap());
        let table = TensionLaw::Table(Table::new(vec![(905.0, 0.9), (1905.0, 0.55)]).unwrap());
        assert!((line.at(1405.0) - table.at(1405.0)).abs() < 1e-15);
        let slopes = [&line, &table].map(|law| law.steepest_slope(905.0, 1405.0));
        assert!((slopes[0] - slopes[1]).abs() < 1e-15, "{slopes:?}");
    }
}
