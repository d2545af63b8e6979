//! A scene of pure fluid: what its case file, `Fluid( ... )`, may say.

use super::axes::Axes;
use super::scene::{Budget, Output, ResolvedOutput};
use serde::{Deserialize, Serialize};

/// The whole of a case file that begins with `Fluid(`. Tuples have two numbers in the plane and three in space, as
/// `domain.size_m` has; the last axis points up. What a scene in the plane says in kilograms or joules is for one metre of depth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Fluid", deny_unknown_fields)]
pub struct FluidScene {
    /// What the case is, in words; for reports and pictures.
    #[serde(default)]
    pub title: String,
    /// The room in which the fluid may be, and what stands at its sides.
    pub domain: Domain,
    /// What the fluid is.
    pub fluid: Substance,
    /// Where there is fluid at the start.
    pub bodies: Vec<Body>,
    /// Acceleration of gravity in m/s2. Default: none.
    #[serde(default)]
    pub gravity_m_s2: Option<Axes>,
    /// Temperature of the places that the fluid moves through; needed where tension or density change with it.
    /// Default: none.
    #[serde(default)]
    pub temperature: Option<Temperature>,
    /// Distance of neighbouring particles in metres.
    pub spacing_m: f64,
    /// How the fluid is computed.
    #[serde(default)]
    pub scheme: Scheme,
    /// How long the run lasts.
    pub time: Span,
    /// What the run writes.
    #[serde(default)]
    pub output: Output,
    /// What the run may cost.
    #[serde(default)]
    pub budget: Budget,
}

/// The room in which the fluid may be: fluid that leaves it ends the run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Domain {
    /// Its low corner in metres. Default: the origin.
    #[serde(default)]
    pub low_m: Option<Axes>,
    /// Its length along each axis in metres, a whole number of spacings; two numbers make a scene in the plane.
    pub size_m: Axes,
    /// What stands at its sides. Default: all open.
    #[serde(default)]
    pub sides: Sides,
}

/// The sides of the domain; those of z are for scenes in space.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Sides {
    /// The side at low x.
    pub x_min: Side,
    /// The side at high x.
    pub x_max: Side,
    /// The side at low y.
    pub y_min: Side,
    /// The side at high y.
    pub y_max: Side,
    /// The side at low z.
    pub z_min: Side,
    /// The side at high z.
    pub z_max: Side,
}

/// What stands at one side of the domain.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Side {
    /// Nothing: a free surface may lie there, and fluid that passes it ends the run.
    #[default]
    Open,
    /// A wall to which the fluid sticks.
    Wall {
        /// Velocity of the wall along itself in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
    },
    /// The scene repeats beyond it; so it does at the opposite side.
    Periodic,
}

/// What the fluid is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Substance {
    /// Density without pressure in kg/m3.
    pub density_kg_m3: f64,
    /// Dynamic viscosity in Pa s; zero is none.
    pub viscosity_pa_s: f64,
    /// Surface tension in N/m. Default: 0.
    #[serde(default)]
    pub surface_tension_n_m: f64,
    /// Change of surface tension with temperature in N/(m K). Default: 0.
    #[serde(default)]
    pub surface_tension_slope_n_m_k: f64,
    /// Coefficient of expansion by volume in 1/K, -1/rho d rho/dT: warm fluid is lighter, and rises under gravity.
    /// Default: 0.
    #[serde(default)]
    pub volume_expansion_1_k: f64,
    /// Temperature in kelvin at which density and surface tension are those given. Default: 293.
    #[serde(default = "room_temperature_k")]
    pub reference_k: f64,
    /// Artificial speed of sound in m/s, at least five times the speed that the scene lets expect. Default: ten times that.
    #[serde(default)]
    pub sound_speed_m_s: Option<f64>,
}

fn room_temperature_k() -> f64 {
    293.0
}

/// Fluid at the start, all of it moving alike.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Body {
    /// A block on the lattice of particles, with the pressure of its depth under gravity.
    Block {
        /// Low corner in metres, a whole number of spacings from that of the domain.
        low_m: Axes,
        /// High corner in metres, the same.
        high_m: Axes,
        /// Velocity in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
        /// Angular speed about its centre in rad/s, from x to y, in the plane; its pressure is then also that of a block that
        /// nothing holds. Default: 0.
        #[serde(default)]
        spin_rad_s: f64,
    },
    /// A disc of rings of particles in the plane, a ball cut out of a lattice in space; with the pressure of its surface tension.
    Ball {
        /// Centre in metres.
        centre_m: Axes,
        /// Radius in metres, at least four spacings.
        radius_m: f64,
        /// Velocity in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
    },
}

impl Body {
    /// Its velocity, when it has one.
    pub fn velocity_m_s(&self) -> Option<&Axes> {
        match self {
            Body::Block { velocity_m_s, .. } | Body::Ball { velocity_m_s, .. } => velocity_m_s.as_ref(),
        }
    }

    /// Its angular speed in rad/s.
    pub fn spin_rad_s(&self) -> f64 {
        match self {
            Body::Block { spin_rad_s, .. } => *spin_rad_s,
            Body::Ball { .. } => 0.0,
        }
    }
}

/// Temperature over the places of a scene; it does not change.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Temperature {
    /// The same everywhere.
    Uniform {
        /// The temperature in kelvin.
        temperature_k: f64,
    },
    /// Linear in place.
    Linear {
        /// The temperature at the origin in kelvin.
        origin_k: f64,
        /// Its slope along each axis in K/m.
        slope_k_m: Axes,
    },
}

/// How the fluid is computed. What the defaults give is measured in the book.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Scheme {
    /// Smoothing length over spacing. Default: 1.5.
    pub smoothing_ratio: f64,
    /// Artificial viscosity alpha. Default: 0.05.
    pub artificial_viscosity: f64,
    /// Density diffusion delta. Default: 0.1.
    pub density_diffusion: f64,
    /// How viscosity acts between particles. Default: Shear.
    pub friction: Friction,
    /// Whether continuity and pressure take gradients that are exact at a free surface. Default: where there is surface tension.
    pub corrected_gradients: Option<bool>,
    /// Strength of the shifting of particles from crowds to voids; 3 where a surface flows in closed rounds, 10 in flow without
    /// surfaces. Default: 0.
    pub shifting: f64,
    /// Rate of the pull of densities towards the particles; it keeps thin films from leaking into walls. Default: 0.005 where
    /// there is no surface tension, 0 where there is.
    pub density_pull: Option<f64>,
}

impl Default for Scheme {
    fn default() -> Self {
        Scheme {
            smoothing_ratio: 1.5,
            artificial_viscosity: 0.05,
            density_diffusion: 0.1,
            friction: Friction::Shear,
            corrected_gradients: None,
            shifting: 0.0,
            density_pull: None,
        }
    }
}

/// How viscosity acts between two particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Friction {
    /// Against the difference of velocities (Morris): accurate along walls and in layers.
    #[default]
    Shear,
    /// Against the closing of a pair: right where a free surface bends as it flows.
    Strain,
}

/// When the run ends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Span {
    /// Physical time at which the run ends, in seconds.
    pub end_s: f64,
}

/// The columns that a frame of a fluid can hold.
pub const FLUID_FIELDS: &[&str] = &["velocity_m_s", "pressure_pa", "density_kg_m3", "body", "temperature_k"];

impl Sides {
    /// The sides with their names in the scene: low and high along x, y, z.
    pub fn named(&self) -> [[(&'static str, &Side); 2]; 3] {
        [
            [("x_min", &self.x_min), ("x_max", &self.x_max)],
            [("y_min", &self.y_min), ("y_max", &self.y_max)],
            [("z_min", &self.z_min), ("z_max", &self.z_max)],
        ]
    }
}

impl FluidScene {
    /// Number of dimensions, 2 or 3.
    pub fn dimension(&self) -> usize {
        self.domain.size_m.values().len()
    }

    /// The columns of frames that this scene has.
    pub fn fields(&self) -> Vec<&'static str> {
        let heated = self.temperature.is_some();
        FLUID_FIELDS.iter().copied().filter(|&name| heated || name != "temperature_k").collect()
    }

    /// What the run writes, the defaults filled in.
    pub fn output(&self) -> ResolvedOutput {
        self.output.resolved(self.time.end_s, || self.fields().into_iter().map(String::from).collect())
    }
}
