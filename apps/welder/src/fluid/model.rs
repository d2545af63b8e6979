//! A scene of fluid as the engine takes it: vectors and controls instead of what the case file says.

use super::expect::{Expected, expected};
use crate::case::FluidCase;
use crate::case::axes::Axes;
use crate::case::fluid::{Friction as FrictionChoice, Scheme, Side, Temperature};
use crate::model::ModelError;
use nalgebra::SVector;
use sph_fluid::{
    FluidControls, Friction, Renewal, SOUND_SPEED_RATIO, SurfaceTension, Tait, ThermalExpansion,
};
use sph_kernel::KernelKind;

/// Exponent of Tait's equation.
const TAIT_EXPONENT: f64 = 7.0;

/// Pull of densities towards the particles where there is no tension.
const DENSITY_PULL: f64 = 0.005;

/// What stands at one side of the domain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Edge<const D: usize> {
    /// Nothing.
    Open,
    /// A wall with this velocity \[m/s\].
    Wall(SVector<f64, D>),
    /// The other side of the domain.
    Periodic,
}

/// Everything that the engine needs to know of a scene of fluid.
#[derive(Debug, Clone)]
pub struct FluidModel<const D: usize> {
    /// The case.
    pub case: FluidCase,
    /// Low corner of the domain \[m\].
    pub low: SVector<f64, D>,
    /// Size of the domain \[m\].
    pub size: SVector<f64, D>,
    /// Its sides, low and high along each axis.
    pub edges: [[Edge<D>; 2]; D],
    /// Constants of fluid and scheme.
    pub controls: FluidControls<D>,
    /// Temperature at the origin \[K\] and its slope \[K/m\].
    pub temperature: Option<(f64, SVector<f64, D>)>,
    /// What the scene lets expect.
    pub expected: Expected,
}

/// The numbers of a tuple, or zeros.
pub(super) fn vector_or_zero<const D: usize>(axes: Option<&Axes>) -> SVector<f64, D> {
    axes.map_or_else(SVector::zeros, Axes::vector)
}

impl<const D: usize> FluidModel<D> {
    /// The model of a case of `D` dimensions.
    ///
    /// # Errors
    /// [`ModelError`] when the fluid crate refuses a constant.
    pub fn from_case(case: &FluidCase) -> Result<Self, ModelError> {
        let (scene, expected) = (&case.scene, expected(&case.scene));
        let sides = scene.domain.sides.named();
        let edge = |side: &Side| match side {
            Side::Open => Edge::Open,
            Side::Wall { velocity_m_s } => Edge::Wall(vector_or_zero(velocity_m_s.as_ref())),
            Side::Periodic => Edge::Periodic,
        };
        let temperature = scene.temperature.as_ref().map(|temperature| match temperature {
            Temperature::Uniform { temperature_k } => (*temperature_k, SVector::zeros()),
            Temperature::Linear { origin_k, slope_k_m } => (*origin_k, slope_k_m.vector()),
        });
        Ok(Self {
            low: vector_or_zero(scene.domain.low_m.as_ref()),
            size: scene.domain.size_m.vector(),
            edges: std::array::from_fn(|axis| sides[axis].map(|(_, side)| edge(side))),
            controls: controls(case, &expected)?,
            temperature,
            expected,
            case: case.clone(),
        })
    }

    /// Distance of neighbouring particles \[m\].
    pub fn spacing(&self) -> f64 {
        self.case.scene.spacing_m
    }

    /// Artificial speed of sound \[m/s\].
    pub fn sound_speed(&self) -> f64 {
        self.controls.state.reference_sound_speed()
    }

    /// Density without pressure \[kg/m³\].
    pub fn density(&self) -> f64 {
        self.controls.state.reference_density()
    }

    /// Temperature at a place \[K\], where the scene has one.
    pub fn temperature_at(&self, place: &SVector<f64, D>) -> Option<f64> {
        self.temperature.map(|(origin, slope)| origin + slope.dot(place))
    }

    /// rho_0 over the density without pressure at a place \[-\].
    pub fn stretch_at(&self, place: &SVector<f64, D>) -> f64 {
        self.temperature_at(place).map_or(1.0, |temperature| self.controls.stretch(temperature))
    }

    /// Period along an axis \[m\], where the scene repeats.
    pub fn period(&self, axis: usize) -> Option<f64> {
        (self.edges[axis][0] == Edge::Periodic).then(|| self.size[axis])
    }

    /// The side that a particle has passed, by half a spacing where a wall stands there, and whether one does.
    pub fn passed(&self, position: &SVector<f64, D>) -> Option<(&'static str, bool)> {
        let names = self.case.scene.domain.sides.named();
        (0..D).find_map(|axis| {
            let beyond = [self.low[axis] - position[axis], position[axis] - self.low[axis] - self.size[axis]];
            (0..2).find_map(|end| {
                let (allowed, wall) = match self.edges[axis][end] {
                    Edge::Open => (0.0, false),
                    Edge::Wall(_) => (0.5 * self.spacing(), true),
                    Edge::Periodic => (f64::INFINITY, false),
                };
                (beyond[end] > allowed).then_some((names[axis][end].0, wall))
            })
        })
    }
}

fn controls<const D: usize>(case: &FluidCase, expected: &Expected) -> Result<FluidControls<D>, ModelError> {
    let (scene, fluid, scheme) = (&case.scene, &case.scene.fluid, &case.scene.scheme);
    let kernel = KernelKind::WendlandC2.with_smoothing_length(scheme.smoothing_ratio * scene.spacing_m);
    let sound_speed = fluid.sound_speed_m_s.unwrap_or(SOUND_SPEED_RATIO * expected.sound_needs);
    let (tension, slope) = (fluid.surface_tension_n_m, fluid.surface_tension_slope_n_m_k);
    let surface_tension = match (tension, slope) {
        (0.0, 0.0) => None,
        _ => Some(SurfaceTension::new(tension, slope, fluid.reference_k)?),
    };
    let thermal_expansion = match fluid.volume_expansion_1_k {
        0.0 => None,
        coefficient => Some(ThermalExpansion::new(coefficient, fluid.reference_k)?),
    };
    Ok(FluidControls {
        dynamic_viscosity: fluid.viscosity_pa_s,
        friction: match scheme.friction {
            FrictionChoice::Shear => Friction::Shear,
            FrictionChoice::Strain => Friction::Strain,
        },
        artificial_viscosity: scheme.artificial_viscosity,
        density_diffusion: scheme.density_diffusion,
        body_acceleration: vector_or_zero(scene.gravity_m_s2.as_ref()),
        surface_tension,
        thermal_expansion,
        renewal: renewal(scheme, tension > 0.0),
        corrected_gradients: scheme.corrected_gradients.unwrap_or(tension > 0.0),
        ..FluidControls::new(kernel, Tait::new(fluid.density_kg_m3, sound_speed, TAIT_EXPONENT)?)
    })
}

fn renewal(scheme: &Scheme, tense: bool) -> Option<Renewal> {
    let density_pull = scheme.density_pull.unwrap_or(if tense { 0.0 } else { DENSITY_PULL });
    let wanted = scheme.shifting > 0.0 || density_pull > 0.0;
    wanted.then_some(Renewal { shifting: scheme.shifting, density_pull })
}
