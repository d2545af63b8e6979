//! The case as the engine takes it: numbers and curves instead of names and cards.

mod flow;

use crate::case::scene::{EnthalpyCurve as CurveChoice, Face, Faces, Heat, Resolution, Stress};
use crate::case::{Case, MaterialCard, Property};
use laser_source::LaserSource;
use sph_solid::{IsotropicModuli, ThermalExpansion, YieldStress};
use sph_thermal::boundary::{Evaporation, SurfaceLoss};
use sph_thermal::phase::{EnthalpyCurve, Table, ThermalMaterial};
use std::sync::Arc;

pub use flow::{FlowModel, GRAVITY, TensionLaw, marangoni_speed};

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
    /// How they evaporate, where their cards tell.
    pub evaporation: Vec<Option<Evaporation>>,
    /// Surface tension of the part's own material, where its card tells.
    pub tension: Option<TensionLaw>,
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
            evaporation: case
                .materials
                .iter()
                .map(|material| evaporation(&material.card))
                .collect::<Result<_, _>>()?,
            tension: TensionLaw::of_card(&case.materials[0].card)?,
            start,
            laser: scene.laser.as_ref().map(|laser| laser.source()).transpose()?,
            heat,
            flow: scene
                .flow()
                .map(|settings| FlowModel::of_card(settings, &case.materials[0].card))
                .transpose()?,
            stress: scene.stress().map(|settings| stress(settings, case)).transpose()?,
            end: scene.time.end_s,
            stop_when_solid: scene.time.stop_when_solid,
        })
    }

    /// What a face of a material loses to its surroundings; `None` of faces that are no [`Face::Losses`].
    ///
    /// # Errors
    /// [`ModelError`] when the thermal crate refuses a constant, or the material does not tell how it evaporates.
    pub fn surface_loss(&self, face: Face, material: usize) -> Result<Option<SurfaceLoss>, ModelError> {
        let Face::Losses { convection_w_m2_k, emissivity, ambient_k, evaporation } = face else {
            return Ok(None);
        };
        let dry = SurfaceLoss::new(convection_w_m2_k, emissivity, ambient_k)?;
        match (evaporation, self.evaporation[material]) {
            (false, _) => Ok(Some(dry)),
            (true, Some(vapour)) => Ok(Some(dry.with_evaporation(vapour))),
            (true, None) => Err(ModelError::Unsupported(
                "evaporation needs boiling_k, heat_of_evaporation_j_kg and molar_mass_kg_mol of the material"
                    .into(),
            )),
        }
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

    /// Radius of the beam, or half the thickness without one \[m\]: the size of the pool that is to be expected.
    pub fn heated_radius(&self) -> f64 {
        self.laser.as_ref().map_or(0.5 * self.size[2], |laser| laser.beam().radius_m())
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

/// How a material evaporates, where its card tells all of it.
fn evaporation(card: &MaterialCard) -> Result<Option<Evaporation>, sph_thermal::Error> {
    match (&card.boiling_k, &card.heat_of_evaporation_j_kg, &card.molar_mass_kg_mol) {
        (Some(boiling), Some(heat), Some(mass)) => {
            Evaporation::new(boiling.value, heat.value, mass.value).map(Some)
        }
        _ => Ok(None),
    }
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
