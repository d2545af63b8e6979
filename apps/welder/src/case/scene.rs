//! What a case file may say: the root of the scene and its sections on time, output and budget.
//!
//! Every value is in SI units and says so in its name. Unknown fields are refused; what is left out takes the
//! default that stands at the field.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use super::flow::{Flow, FlowSchedule};
pub use super::heat::{ConductivityMean, EnthalpyCurve, Heat, KernelShape, Physics, Stepping, Weights};
pub use super::laser::Laser;
pub use super::material::MaterialCard;
pub use super::part::{Face, Faces, Part, Region};
pub use super::resolution::{Levels, Resolution};
pub use super::stress::{Clamped, Stress};

/// The whole of a `scene.ron` of a weld: `( ... )` or `Weld( ... )`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Weld", deny_unknown_fields)]
pub struct Scene {
    /// What the case is, in words; for reports and pictures.
    #[serde(default)]
    pub title: String,
    /// The workpiece.
    pub part: Part,
    /// How finely the workpiece is cut into particles.
    pub resolution: Resolution,
    /// The laser. Default: none; then heat comes from the faces alone.
    #[serde(default)]
    pub laser: Option<Laser>,
    /// The physics that is computed; what is not listed is not built.
    pub physics: Vec<Physics>,
    /// How long the run lasts.
    pub time: Time,
    /// What the run writes.
    #[serde(default)]
    pub output: Output,
    /// What the run may cost.
    #[serde(default)]
    pub budget: Budget,
    /// Material cards that stand in the scene itself; they are looked up before the files.
    #[serde(default)]
    pub materials: BTreeMap<String, MaterialCard>,
}

/// When the run ends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// Physical time at which the run ends, in seconds.
    pub end_s: f64,
    /// End earlier, as soon as the laser is off and nothing is molten any more. Default: false.
    #[serde(default)]
    pub stop_when_solid: bool,
}

/// What the run writes, and how often. Intervals are in physical seconds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Whether frames (VTU) are written. Default: true.
    pub frames: bool,
    /// Time between frames. Default: a 25th of `time.end_s`.
    pub frame_interval_s: Option<f64>,
    /// Time between rows of history.csv. Default: a 500th of `time.end_s`.
    pub history_interval_s: Option<f64>,
    /// Time between checkpoints. Default: a fifth of `time.end_s`.
    pub checkpoint_interval_s: Option<f64>,
    /// Columns of the frames, out of [`OUTPUT_FIELDS`] with Flow [`FLOW_FIELDS`] and with Stress [`STRESS_FIELDS`]. Default:
    /// temperature_k, phase, was_molten, and all those of Flow and Stress where they are computed.
    pub fields: Option<Vec<String>>,
    /// Whether pictures (PNG) are drawn. Default: true.
    pub pictures: bool,
}

/// The columns that a frame can hold.
pub const OUTPUT_FIELDS: &[&str] = &[
    "temperature_k",
    "phase",
    "was_molten",
    "liquid_fraction",
    "enthalpy_j_kg",
    "peak_temperature_k",
    "spacing_m",
    "material",
];

/// The columns that a frame can hold besides where the melt flows.
pub const FLOW_FIELDS: &[&str] = &["velocity_m_s", "marangoni_force_n", "pressure_pa", "is_melt"];

/// The columns that a frame can hold besides where stress is computed.
pub const STRESS_FIELDS: &[&str] =
    &["displacement_m", "von_mises_pa", "principal_stress_pa", "plastic_strain"];

impl Default for Output {
    fn default() -> Self {
        Output {
            frames: true,
            frame_interval_s: None,
            history_interval_s: None,
            checkpoint_interval_s: None,
            fields: None,
            pictures: true,
        }
    }
}

/// What the run may cost at most; a case beyond it is refused before it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Budget {
    /// Most particles. Default: 20 million.
    pub max_particles: u64,
    /// Most steps. Default: 10 million.
    pub max_steps: u64,
    /// Most memory in bytes. Default: what the machine has free.
    pub max_memory_bytes: Option<u64>,
}

impl Default for Budget {
    fn default() -> Self {
        Budget { max_particles: 20_000_000, max_steps: 10_000_000, max_memory_bytes: None }
    }
}

/// [`Output`] with its defaults filled in.
#[derive(Debug, Clone, PartialEq)]
pub struct ResolvedOutput {
    /// Whether frames are written.
    pub frames: bool,
    /// Time between frames in seconds.
    pub frame_interval_s: f64,
    /// Time between rows of history.csv in seconds.
    pub history_interval_s: f64,
    /// Time between checkpoints in seconds.
    pub checkpoint_interval_s: f64,
    /// Columns of the frames.
    pub fields: Vec<String>,
    /// Whether pictures are drawn.
    pub pictures: bool,
}

impl Output {
    /// The defaults filled in, for a run that ends at `end_s` seconds and whose frames hold `fields` by default.
    pub fn resolved(&self, end_s: f64, fields: impl FnOnce() -> Vec<String>) -> ResolvedOutput {
        ResolvedOutput {
            frames: self.frames,
            frame_interval_s: self.frame_interval_s.unwrap_or(end_s / 25.0),
            history_interval_s: self.history_interval_s.unwrap_or(end_s / 500.0),
            checkpoint_interval_s: self.checkpoint_interval_s.unwrap_or(end_s / 5.0),
            fields: self.fields.clone().unwrap_or_else(fields),
            pictures: self.pictures,
        }
    }
}

impl From<ResolvedOutput> for Output {
    fn from(resolved: ResolvedOutput) -> Self {
        Output {
            frames: resolved.frames,
            frame_interval_s: Some(resolved.frame_interval_s),
            history_interval_s: Some(resolved.history_interval_s),
            checkpoint_interval_s: Some(resolved.checkpoint_interval_s),
            fields: Some(resolved.fields),
            pictures: resolved.pictures,
        }
    }
}

impl Scene {
    /// The settings of heat conduction, when the scene lists it.
    pub fn heat(&self) -> Option<&Heat> {
        self.physics.iter().find_map(|physics| match physics {
            Physics::Heat(heat) => Some(heat),
            _ => None,
        })
    }

    /// The settings of thermal stress, when the scene lists it.
    pub fn stress(&self) -> Option<&Stress> {
        self.physics.iter().find_map(|physics| match physics {
            Physics::Stress(stress) => Some(stress),
            _ => None,
        })
    }

    /// The settings of the flow of the melt, when the scene lists it.
    pub fn flow(&self) -> Option<&Flow> {
        self.physics.iter().find_map(|physics| match physics {
            Physics::Flow(flow) => Some(flow),
            _ => None,
        })
    }

    /// The columns of frames that the listed physics have of their own.
    pub fn own_fields(&self) -> Vec<&'static str> {
        let stress = if self.stress().is_some() { STRESS_FIELDS } else { &[] };
        let flow = if self.flow().is_some() { FLOW_FIELDS } else { &[] };
        stress.iter().chain(flow).copied().collect()
    }

    /// What the run writes, the defaults filled in.
    pub fn output(&self) -> ResolvedOutput {
        let heat = ["temperature_k", "phase", "was_molten"].as_slice();
        let default = || heat.iter().copied().chain(self.own_fields()).map(String::from).collect();
        self.output.resolved(self.time.end_s, default)
    }
}
