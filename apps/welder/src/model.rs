//! The case as the engine takes it: numbers and curves instead of names and cards.

use crate::case::scene::{EnthalpyCurve as CurveChoice, Face, Faces, Flow, Heat, Resolution, Stress};
use crate::case::{Case, MaterialCard, Property};
use laser_source::LaserSource;
use sph_fluid::{SurfaceTension, artificial_sound_speed};
use sph_solid::{IsotropicModuli, ThermalExpansion, YieldStress};
use sph_thermal::phase::{EnthalpyCurve, Table, ThermalMaterial};
use std::sync::Arc;

/// Material (index) and temperature \[K\] at a point \[m\] at the start.
pub type Start = Arc<dyn Fn([f64; 3]) -> (u8, f64) + Send + Sync>;

/// Everything that the engine needs to know to build and run a scene.
#[derive(Clone)]
pub struct Model {
    /// Name of the case.
    pub name: String,
    /// Low corner of the part \[m\]; its top face is z = 0.
    pub low_corner: [f64; 2],
    /// Size of the part \[m\].
    pub size: [f64; 3],
    /// What the faces are.
    pub faces: Faces,
    /// Spacing, levels, disorder.
    pub resolution: Resolution,
    /// Materials in use.
    pub materials: Vec<ThermalMaterial>,
    /// Their enthalpy curves.
    pub curves: Vec<EnthalpyCurve>,
    /// What fills the part at the start.
    pub start: Start,
    /// The laser, if there is one.
    pub laser: Option<LaserSource>,
    /// How heat is computed.
    pub heat: Heat,
    /// How the melt flows, if it does.
    pub flow: Option<FlowModel>,
    /// How stress is computed, if it is.
    pub stress: Option<StressModel>,
    /// End of the run \[s\].
    pub end: f64,
    /// Whether the run ends when everything has frozen after the laser's last light.
    pub stop_when_solid: bool,
}

/// Flow as the engine takes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowModel {
    /// What the scene says.
    pub settings: Flow,
    /// Dynamic viscosity of the melt, factor included \[Pa s\].
    pub viscosity: f64,
    /// Surface tension over temperature.
    pub tension: SurfaceTension,
}

/// How much hotter than its rim a pool is taken to be before the run \[K\].
const EXPECTED_EXCESS: f64 = 500.0;

impl FlowModel {
    /// Artificial speed of sound \[m/s\]: the scene's, or ten times the largest speed that it lets expect: of capillary waves
    /// on the beam's radius, and of Marangoni flow in its boundary layer or, where friction rules, as a Stokes flow.
    pub fn sound_speed(&self, model: &Model) -> f64 {
        let density = model.materials[0].density;
        let radius = model.laser.as_ref().map_or(0.5 * model.size[2], |laser| laser.beam().radius_m());
        let pull = self.tension.slope().abs() * EXPECTED_EXCESS;
        let speed = marangoni_speed(pull, density, self.viscosity, radius);
        let expected = artificial_sound_speed(speed, density, self.tension.reference(), radius, 0.0);
        self.settings.sound_speed_m_s.unwrap_or(expected)
    }
}

/// Speed \[m/s\] of a surface that a change of tension `pull` \[N/m\] over a `radius` \[m\] drives: that of its boundary layer,
/// (pull^2/(rho eta R))^(1/3) (Ostrach 1982), or, where friction rules, of a Stokes flow in a half-sphere, 0.15 pull/eta.
pub fn marangoni_speed(pull: f64, density: f64, viscosity: f64, radius: f64) -> f64 {
    (pull * pull / (density * viscosity * radius)).cbrt().min(0.15 * pull / viscosity)
}

/// Stress as the engine takes it.
#[derive(Debug, Clone, PartialEq)]
pub struct StressModel {
    /// What the scene says.
    pub settings: Stress,
    /// Elastic moduli.
    pub moduli: IsotropicModuli,
    /// Density and expansion over temperature.
    pub expansion: ThermalExpansion,
    /// Yield stress over temperature.
    pub yield_stress: YieldStress,
}

/// What the engine refuses although the case could be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// Two settings that do not go together.
    #[error("{0}")]
    Unsupported(String),
    /// The neighbour search refused the particles.
    #[error("neighbour search: {0}")]
    Neighbors(#[from] sph_neighbors::Error),
    /// The thermal crate refused a material or the pair weights.
    #[error("heat: {0}")]
    Thermal(#[from] sph_thermal::Error),
    /// The fluid crate refused its constants.
    #[error("flow: {0}")]
    Fluid(#[from] sph_fluid::Error),
    /// The solid crate refused a material or the body.
    #[error("stress: {0}")]
    Solid(#[from] sph_solid::Error),
    /// The laser crate refused the source.
    #[error("laser: {0}")]
    Laser(#[from] laser_source::Error),
    /// The integrator refused its settings.
    #[error("time steps: {0}")]
    Integrate(#[from] sph_integrate::Error),
}

impl Model {
    /// The model of a checked case.
    ///
    /// # Errors
    /// [`ModelError`] when a material is refused by the thermal crate.
    pub fn from_case(case: &Case) -> Result<Self, ModelError> {
        let scene = &case.scene;
        let heat = scene.heat().copied().unwrap_or_default();
        let materials: Vec<_> =
            case.materials.iter().map(|material| thermal(&material.card)).collect::<Result<_, _>>()?;
        let curves =
            materials.iter().map(|material| curve(material, heat.enthalpy)).collect::<Result<_, _>>()?;
        let filled = case.clone();
        let start = Arc::new(move |point| {
            let (material, temperature) = filled.fill_at(point);
            (material as u8, temperature)
        });
        Ok(Self {
            name: case.name.clone(),
            low_corner: scene.part.low_corner_m,
            size: scene.part.size_m,
            faces: scene.part.faces,
            resolution: scene.resolution,
            materials,
            curves,
            start,
            laser: scene.laser.as_ref().map(|laser| laser.source()).transpose()?,
            heat,
            flow: scene.flow().map(|settings| flow(settings, case)).transpose()?,
            stress: scene.stress().map(|settings| stress(settings, case)).transpose()?,
            end: scene.time.end_s,
            stop_when_solid: scene.time.stop_when_solid,
        })
    }

    /// Finest spacing \[m\].
    pub fn spacing(&self) -> f64 {
        self.resolution.spacing_m
    }

    /// Low and high corner of the part \[m\].
    pub fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let [x, y] = self.low_corner;
        ([x, y, -self.size[2]], [x + self.size[0], y + self.size[1], 0.0])
    }

    /// Which of the low and high faces of x and y are symmetry planes.
    pub fn mirrored(&self) -> [[bool; 2]; 2] {
        let faces = &self.faces;
        [[faces.x_min, faces.x_max], [faces.y_min, faces.y_max]]
            .map(|axis| axis.map(|face| face == Face::Symmetry))
    }

    /// Number of finest cells along each axis.
    pub fn counts(&self) -> [i64; 3] {
        self.size.map(|size| (size / self.spacing()).round() as i64)
    }
}

/// The melt of the part's own material.
///
/// # Errors
/// [`ModelError::Unsupported`] where the card lacks what flow needs, and what the fluid crate refuses.
fn flow(settings: &Flow, case: &Case) -> Result<FlowModel, ModelError> {
    let card = &case.materials[0].card;
    let (Some(viscosity), Some(tension), Some(slope)) =
        (&card.viscosity_pa_s, &card.surface_tension_n_m, &card.surface_tension_slope_n_m_k)
    else {
        let what =
            "Flow needs viscosity_pa_s, surface_tension_n_m and surface_tension_slope_n_m_k of the material";
        return Err(ModelError::Unsupported(what.into()));
    };
    Ok(FlowModel {
        settings: *settings,
        viscosity: settings.viscosity_factor * viscosity.value,
        tension: SurfaceTension::new(tension.value, slope.value, card.liquidus_k.value)?,
    })
}

/// The mechanical side of the part's own material.
///
/// # Errors
/// [`ModelError::Unsupported`] where the card lacks what stress needs, and what the solid crate refuses.
fn stress(settings: &Stress, case: &Case) -> Result<StressModel, ModelError> {
    let card = &case.materials[0].card;
    let (Some(young), Some(poisson), Some(expansion), Some(strength)) =
        (&card.young_pa, &card.poisson, &card.expansion_1_k, &card.yield_pa)
    else {
        let what = "Stress needs young_pa, poisson, expansion_1_k and yield_pa of the material";
        return Err(ModelError::Unsupported(what.into()));
    };
    let (density, start) = (card.density_kg_m3.value, case.scene.part.start_k);
    Ok(StressModel {
        settings: *settings,
        moduli: IsotropicModuli::from_young_and_poisson(young.value, poisson.value)?,
        expansion: ThermalExpansion::new(density, start, &expansion.points())?,
        yield_stress: YieldStress::new(&strength.points())?,
    })
}

/// The thermal side of a material card.
fn thermal(card: &MaterialCard) -> Result<ThermalMaterial, sph_thermal::Error> {
    let table = |property: &Property| Table::new(property.points());
    Ok(ThermalMaterial {
        density: card.density_kg_m3.value,
        solidus: card.solidus_k.value,
        liquidus: card.liquidus_k.value,
        latent_heat: card.latent_heat_j_kg.value,
        heat_capacity_solid: table(&card.heat_capacity_solid_j_kg_k)?,
        heat_capacity_liquid: table(&card.heat_capacity_liquid_j_kg_k)?,
        conductivity_solid: table(&card.conductivity_solid_w_m_k)?,
        conductivity_liquid: table(&card.conductivity_liquid_w_m_k)?,
    })
}

/// The enthalpy curve that a scene asks for.
///
/// # Errors
/// What the curve refuses.
pub fn curve(material: &ThermalMaterial, choice: CurveChoice) -> Result<EnthalpyCurve, sph_thermal::Error> {
    match choice {
        CurveChoice::Continuous => EnthalpyCurve::continuous(material),
        CurveChoice::HuEberhard2015 => EnthalpyCurve::hu_eberhard_2015(material),
    }
}
