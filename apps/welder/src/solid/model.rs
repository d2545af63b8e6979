//! From the case of elastic bodies to particles and controls.

use crate::build::{centre_of, sites};
use crate::case::SolidCase;
use crate::case::axes::Axes;
use crate::case::solid::{Form, Solid};
use crate::model::ModelError;
use nalgebra::SVector;
use sph_kernel::KernelKind;
use sph_solid::{IsotropicModuli, Material, UpdatedControls, pressure_wave_speed};

/// Everything that the engine needs to know of a scene of elastic bodies.
#[derive(Debug, Clone)]
pub struct SolidModel<const D: usize> {
    /// The case.
    pub case: SolidCase,
    /// What the bodies are made of.
    pub material: Material,
    /// How they are computed.
    pub controls: UpdatedControls<D>,
    /// Acceleration of gravity \[m/s²\].
    pub gravity: SVector<f64, D>,
    /// Speed of waves of pressure \[m/s\].
    pub wave_speed: f64,
    /// Positions at the start \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Velocities at the start \[m/s\].
    pub velocities: Vec<SVector<f64, D>>,
    /// Which body each particle belongs to.
    pub bodies: Vec<u8>,
    /// Whether a particle is held.
    pub held: Vec<bool>,
}

impl<const D: usize> SolidModel<D> {
    /// The model of a case of `D` dimensions.
    ///
    /// # Errors
    /// [`ModelError`] when the solid crate refuses a constant.
    pub fn from_case(case: &SolidCase) -> Result<Self, ModelError> {
        let scene = &case.scene;
        let moduli =
            IsotropicModuli::from_young_and_poisson(scene.material.young_pa, scene.material.poisson)?;
        let kernel =
            KernelKind::Gaussian.with_smoothing_length(scene.scheme.smoothing_ratio * scene.spacing_m);
        let chosen = match scene.scheme.form {
            Form::Paper => UpdatedControls::paper(kernel, scene.spacing_m),
            Form::Corrected => UpdatedControls::corrected(kernel, scene.spacing_m),
        };
        let artificial_stress = scene.scheme.artificial_stress.unwrap_or(chosen.artificial_stress);
        let mut model = Self {
            material: Material::elastic(moduli, scene.material.density_kg_m3)?,
            controls: UpdatedControls { artificial_stress, ..chosen },
            gravity: scene.gravity_m_s2.as_ref().map_or_else(SVector::zeros, Axes::vector),
            wave_speed: pressure_wave_speed(&moduli, scene.material.density_kg_m3),
            positions: Vec::new(),
            velocities: Vec::new(),
            bodies: Vec::new(),
            held: Vec::new(),
            case: case.clone(),
        };
        for (index, body) in scene.bodies.iter().enumerate() {
            model.positions.extend(places::<D>(body, scene.spacing_m));
            let velocity = body.velocity_m_s().map_or_else(SVector::zeros, Axes::vector);
            model.velocities.resize(model.positions.len(), velocity);
            model.bodies.resize(model.positions.len(), index as u8);
        }
        let boxes: Vec<[SVector<f64, D>; 2]> =
            scene.held.iter().map(|hold| [hold.low_m.vector(), hold.high_m.vector()]).collect();
        let inside = |x: &SVector<f64, D>| {
            boxes.iter().any(|[low, high]| (0..D).all(|axis| low[axis] <= x[axis] && x[axis] <= high[axis]))
        };
        model.held = model.positions.iter().map(inside).collect();
        Ok(model)
    }
}

/// Particles of a body: centres of the cells of a block, or those of a lattice about the centre that lie between the radii.
fn places<const D: usize>(body: &Solid, spacing: f64) -> Vec<SVector<f64, D>> {
    let centres = |counts: [i64; D], low: SVector<f64, D>| {
        sites([0; D], counts).map(move |site| low + centre_of(site) * spacing)
    };
    match body {
        Solid::Block { low_m, high_m, .. } => {
            let (low, high) = (low_m.vector::<D>(), high_m.vector::<D>());
            centres((high - low).map(|length| (length / spacing).round() as i64).into(), low).collect()
        }
        Solid::Ring { centre_m, inner_radius_m, outer_radius_m, .. } => {
            let (centre, across) = (centre_m.vector::<D>(), (outer_radius_m / spacing).ceil());
            let low = centre - SVector::repeat(across * spacing);
            let inside =
                |x: &SVector<f64, D>| (*inner_radius_m..*outer_radius_m).contains(&(x - centre).norm());
            centres([2 * across as i64; D], low).filter(inside).collect()
        }
    }
}
