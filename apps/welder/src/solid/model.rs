//! From the case of elastic bodies to particles and controls.

use crate::build::{centre_of, disorder, sites};
use crate::case::SolidCase;
use crate::case::axes::Axes;
use crate::case::over_rise::OverRise;
use crate::case::solid::{Elastic, Form, Hold, Solid};
use crate::model::ModelError;
use nalgebra::SVector;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use sph_kernel::{KernelKind, ScaledKernel};
use sph_solid::{
    IsotropicModuli, Material, START_TEMPERATURE, ThermalExpansion, UpdatedControls, YieldStress,
    pressure_wave_speed,
};

/// Smoothing length over spacing of the total-Lagrangian and of the updated-Lagrangian form, where the case names none.
const SMOOTHING_RATIOS: [f64; 2] = [0.8, 1.2];

/// How the bodies are computed.
#[derive(Debug, Clone, Copy)]
pub enum Numerics<const D: usize> {
    /// In the total-Lagrangian form with its default controls.
    Total,
    /// In the updated-Lagrangian form.
    Updated(UpdatedControls<D>),
}

/// Everything that the engine needs to know of a scene of elastic bodies.
#[derive(Debug, Clone)]
pub struct SolidModel<const D: usize> {
    /// The case.
    pub case: SolidCase,
    /// What the bodies are made of.
    pub material: Material,
    /// How they are computed.
    pub numerics: Numerics<D>,
    /// The kernel of all particles.
    pub kernel: ScaledKernel<D>,
    /// Acceleration of gravity \[m/s²\].
    pub gravity: SVector<f64, D>,
    /// Speed of waves of pressure \[m/s\].
    pub wave_speed: f64,
    /// Positions at the start \[m\].
    pub positions: Vec<SVector<f64, D>>,
    /// Velocities at the start \[m/s\], of those that are held at all times.
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
        let (material, scheme) = (material(&scene.material)?, &scene.scheme);
        let [total, updated] = SMOOTHING_RATIOS;
        let usual = if scheme.form == Form::Total { total } else { updated };
        let ratio = scheme.smoothing_ratio.unwrap_or(usual);
        let kernel = KernelKind::Gaussian.with_smoothing_length(ratio * scene.spacing_m);
        let with_stress = |chosen: UpdatedControls<D>| {
            let artificial_stress = scheme.artificial_stress.unwrap_or(chosen.artificial_stress);
            Numerics::Updated(UpdatedControls { artificial_stress, ..chosen })
        };
        let numerics = match scheme.form {
            Form::Total => Numerics::Total,
            Form::Paper => with_stress(UpdatedControls::paper(kernel, scene.spacing_m)),
            Form::Corrected => with_stress(UpdatedControls::corrected(kernel, scene.spacing_m)),
        };
        let wave_speed = pressure_wave_speed(material.solver_moduli(), scene.material.density_kg_m3);
        let mut model = Self {
            material,
            numerics,
            kernel,
            wave_speed,
            gravity: scene.gravity_m_s2.as_ref().map_or_else(SVector::zeros, Axes::vector),
            positions: Vec::new(),
            velocities: Vec::new(),
            bodies: Vec::new(),
            held: Vec::new(),
            case: case.clone(),
        };
        let mut random = Pcg64Mcg::seed_from_u64(scene.seed);
        let mut shifted =
            |x: SVector<f64, D>| x + disorder::<D>(&mut random, scene.disorder, scene.spacing_m);
        for (index, body) in scene.bodies.iter().enumerate() {
            model.positions.extend(places::<D>(body, scene.spacing_m).into_iter().map(&mut shifted));
            let velocity = body.velocity_m_s().map_or_else(SVector::zeros, Axes::vector);
            model.velocities.resize(model.positions.len(), velocity);
            model.bodies.resize(model.positions.len(), index as u8);
        }
        for (position, velocity) in model.positions.iter().zip(&mut model.velocities) {
            let holding = scene.held.iter().find(|hold| is_inside(hold, position));
            if let Some(hold) = holding {
                *velocity = hold.velocity_m_s.as_ref().map_or_else(SVector::zeros, Axes::vector);
            }
            model.held.push(holding.is_some());
        }
        Ok(model)
    }

    /// Temperature \[K\] that the case prescribes at a time \[s\] where the material was at `start` \[m\].
    pub fn temperature(&self, start: &SVector<f64, D>, time: f64) -> f64 {
        let heating = self.case.scene.heating.as_ref();
        heating.map_or(START_TEMPERATURE, |heating| {
            let share = heating.spot.as_ref().map_or(1.0, |spot| {
                let from = start - spot.centre_m.vector::<D>();
                (-from.norm_squared() / spot.radius_m.powi(2)).exp()
            });
            START_TEMPERATURE + share * heating.rise_k(time)
        })
    }

    /// Whether temperatures change between two times \[s\].
    pub fn warms(&self, from: f64, to: f64) -> bool {
        let heating = self.case.scene.heating.as_ref();
        heating.is_some_and(|heating| heating.rise_k(from) != heating.rise_k(to))
    }
}

fn is_inside<const D: usize>(hold: &Hold, x: &SVector<f64, D>) -> bool {
    let (low, high) = (hold.low_m.vector::<D>(), hold.high_m.vector::<D>());
    (0..D).all(|axis| low[axis] <= x[axis] && x[axis] <= high[axis])
}

fn material(elastic: &Elastic) -> Result<Material, sph_solid::Error> {
    let moduli = IsotropicModuli::from_young_and_poisson(elastic.young_pa, elastic.poisson)?;
    let mut material = Material::elastic(moduli, elastic.density_kg_m3)?;
    let nodes = |value: &OverRise| -> Vec<(f64, f64)> {
        value.points().into_iter().map(|(rise, value)| (START_TEMPERATURE + rise, value)).collect()
    };
    material.expansion =
        ThermalExpansion::new(elastic.density_kg_m3, START_TEMPERATURE, &nodes(&elastic.expansion_1_k))?;
    let law = elastic.yield_pa.as_ref().map(|yield_pa| YieldStress::new(&nodes(yield_pa)));
    material.yield_stress = law.transpose()?;
    Ok(material)
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
