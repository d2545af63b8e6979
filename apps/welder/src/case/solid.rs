//! A scene of elastic bodies: what its case file, `Solid( ... )`, may say.

use super::axes::Axes;
use super::fluid::Span;
use super::scene::{Budget, Output, ResolvedOutput};
use serde::{Deserialize, Serialize};

/// The whole of a case file that begins with `Solid(`. Tuples have two numbers in the plane (plane strain) and three in space, as
/// the first corner or centre of the bodies has; the last axis points up. What a scene in the plane says in kilograms or joules is for
/// one metre of depth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Solid", deny_unknown_fields)]
pub struct SolidScene {
    /// What the case is, in words; for reports and pictures.
    #[serde(default)]
    pub title: String,
    /// What all bodies are made of.
    pub material: Elastic,
    /// The bodies at the start, without stress.
    pub bodies: Vec<Solid>,
    /// Boxes whose particles are held where they are. Default: none.
    #[serde(default)]
    pub held: Vec<Hold>,
    /// Acceleration of gravity in m/s2. Default: none.
    #[serde(default)]
    pub gravity_m_s2: Option<Axes>,
    /// Distance of neighbouring particles in metres.
    pub spacing_m: f64,
    /// How the bodies are computed.
    #[serde(default)]
    pub scheme: SolidScheme,
    /// How long the run lasts.
    pub time: Span,
    /// What the run writes.
    #[serde(default)]
    pub output: Output,
    /// What the run may cost.
    #[serde(default)]
    pub budget: Budget,
}

/// An elastic material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Elastic {
    /// Density without stress in kg/m3.
    pub density_kg_m3: f64,
    /// Young's modulus in Pa.
    pub young_pa: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// A body at the start, all of it moving alike.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Solid {
    /// A box of cells.
    Block {
        /// Low corner in metres.
        low_m: Axes,
        /// High corner in metres, a whole number of spacings from the low one.
        high_m: Axes,
        /// Velocity in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
    },
    /// A ring in the plane, a hollow ball in space, cut out of a lattice about its centre.
    Ring {
        /// Centre in metres.
        centre_m: Axes,
        /// Inner radius in metres; zero makes a disc or a ball. Default: 0.
        #[serde(default)]
        inner_radius_m: f64,
        /// Outer radius in metres.
        outer_radius_m: f64,
        /// Velocity in m/s. Default: at rest.
        #[serde(default)]
        velocity_m_s: Option<Axes>,
    },
}

impl Solid {
    /// Its velocity, when it has one.
    pub fn velocity_m_s(&self) -> Option<&Axes> {
        match self {
            Solid::Block { velocity_m_s, .. } | Solid::Ring { velocity_m_s, .. } => velocity_m_s.as_ref(),
        }
    }
}

/// A box whose particles are held: those that start in it stay.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// Low corner in metres.
    pub low_m: Axes,
    /// High corner in metres.
    pub high_m: Axes,
}

/// How bodies are computed: in the updated-Lagrangian form, in which bodies can meet.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SolidScheme {
    /// How gradients and forces are formed. Default: Corrected.
    pub form: Form,
    /// Smoothing length over spacing. Default: 1.2.
    pub smoothing_ratio: f64,
    /// Artificial stress epsilon, which keeps stretched bodies whole. Default: 0.3 in the paper's form, 0 in the corrected one.
    pub artificial_stress: Option<f64>,
}

impl Default for SolidScheme {
    fn default() -> Self {
        SolidScheme { form: Form::Corrected, smoothing_ratio: 1.2, artificial_stress: None }
    }
}

/// How gradients and forces are formed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Form {
    /// As in Hu and Eberhard (2015), with artificial stress and viscosity: holds bodies that meet at high speed.
    Paper,
    /// Corrected gradients, a force that keeps energy, and viscosity on zero-energy modes: accurate for bodies that bend.
    #[default]
    Corrected,
}

/// The columns that a frame of a solid can hold.
pub const SOLID_FIELDS: &[&str] =
    &["velocity_m_s", "displacement_m", "von_mises_pa", "density_kg_m3", "body"];

impl SolidScene {
    /// Number of dimensions, 2 or 3: that of the first body.
    pub fn dimension(&self) -> usize {
        match self.bodies.first() {
            Some(Solid::Block { low_m, .. }) => low_m.values().len(),
            Some(Solid::Ring { centre_m, .. }) => centre_m.values().len(),
            None => 2,
        }
    }

    /// What the run writes, the defaults filled in.
    pub fn output(&self) -> ResolvedOutput {
        let fields = || SOLID_FIELDS.iter().copied().map(String::from).collect();
        self.output.resolved(self.time.end_s, fields)
    }
}
