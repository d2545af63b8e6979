//! The list of physics in a scene, and the settings of heat conduction.

use super::flow::Flow;
use super::stress::Stress;
use serde::{Deserialize, Serialize};

/// One physics of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Physics {
    /// Heat conduction with melting and freezing.
    Heat(Heat),
    /// Flow of the melt in a solid that does not move; needs Heat.
    Flow(Flow),
    /// Thermal stress in a body that heat warms; needs Heat.
    Stress(Stress),
}

impl Physics {
    /// The name that the scene uses.
    pub fn name(&self) -> &'static str {
        match self {
            Physics::Heat(_) => "Heat",
            Physics::Flow(_) => "Flow",
            Physics::Stress(_) => "Stress",
        }
    }
}

/// Settings of heat conduction; the defaults are the program's choice by measured error per cost.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Heat {
    /// How the pair weights are made. Default: Auto.
    pub weights: Weights,
    /// Shape of the smoothing kernel. Default: WendlandC2.
    pub kernel: KernelShape,
    /// Smoothing length over spacing. Default: the program's choice for the weights and the disorder.
    pub smoothing_ratio: Option<f64>,
    /// What stands for the conductivity between two particles. Default: Kirchhoff.
    pub conductivity_mean: ConductivityMean,
    /// Temperature from enthalpy. Default: Continuous.
    pub enthalpy: EnthalpyCurve,
    /// How time advances. Default: super steps.
    pub stepping: Stepping,
}

/// How the pair weights of conduction are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Weights {
    /// The program's choice.
    #[default]
    Auto,
    /// Fitted so that linear temperature fields are exact; for particles at rest.
    Fitted,
    /// Divided by the second moment of the kernel sum.
    Normalized,
    /// The plain sum of Cleary and Monaghan (1999).
    Plain,
    /// As Normalized, but computed anew at every stage instead of stored: the form for particles that move, and the slow
    /// reference of the stored rows.
    Moving,
}

/// Shape of the smoothing kernel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum KernelShape {
    /// Wendland C2.
    #[default]
    WendlandC2,
    /// Gaussian, cut at three smoothing lengths.
    Gaussian,
    /// Cubic spline.
    CubicSpline,
    /// Quintic spline.
    QuinticSpline,
}

/// What stands for the conductivity between two particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum ConductivityMean {
    /// Difference of the integral of k over temperature.
    #[default]
    Kirchhoff,
    /// Harmonic mean of the two conductivities, as Cleary and Monaghan (1999).
    Harmonic,
}

/// Temperature as a function of enthalpy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum EnthalpyCurve {
    /// Continuous and monotone through solidus and liquidus.
    #[default]
    Continuous,
    /// The form of Hu and Eberhard (2015), eqs. 20-21; it can jump at the solidus.
    HuEberhard2015,
}

/// How time advances.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Stepping {
    /// Stabilised explicit steps of many stages.
    SuperSteps {
        /// Estimated error that one step may make, over the heat taken up so far (both root mean squares). Default: the
        /// program's choice, 0.05 under a laser, 0.02 after it, 0.001 without one.
        #[serde(default)]
        tolerance: Option<f64>,
        /// Most stages of one step, at least 3. Default: 60.
        #[serde(default = "default_max_stages")]
        max_stages: u32,
    },
    /// Forward Euler.
    Euler {
        /// Step over the largest stable step, 0 to 1. Default: 0.9.
        #[serde(default = "default_euler_factor")]
        factor: f64,
    },
}

fn default_max_stages() -> u32 {
    60
}

fn default_euler_factor() -> f64 {
    0.9
}

impl Default for Stepping {
    fn default() -> Self {
        Stepping::SuperSteps { tolerance: None, max_stages: default_max_stages() }
    }
}
