//! Settings of the flow of the melt.

use serde::{Deserialize, Serialize};

/// Settings of the flow of the melt in a solid that does not move.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Flow {
    /// Artificial speed of sound in the melt in m/s; ten times the largest speed of the flow is right. Default: ten times what
    /// the scene lets expect.
    pub sound_speed_m_s: Option<f64>,
    /// The melt is this many times as viscous as the material card says: more than 1 gives a calmer, slower pool than the real
    /// one. Default: 1.
    pub viscosity_factor: f64,
    /// Artificial viscosity alpha of the melt. Default: 0.1.
    pub artificial_viscosity: f64,
    /// Who takes whose steps. Default: Split.
    pub schedule: FlowSchedule,
}

/// How heat and melt share their steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum FlowSchedule {
    /// Each at its own: the melt takes many short steps within one of heat, and only what has moved is looked at anew.
    #[default]
    Split,
    /// Heat takes the short steps of the melt too, and every neighbour is found anew after each: the slow reference.
    Together,
}

impl Default for Flow {
    fn default() -> Self {
        Flow {
            sound_speed_m_s: None,
            viscosity_factor: 1.0,
            artificial_viscosity: 0.1,
            schedule: FlowSchedule::Split,
        }
    }
}
