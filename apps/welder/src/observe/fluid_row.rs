//! The history of a scene of fluid.

use super::history_picture::{BLUE, Charted, Curve, GREEN, ORANGE, Panel, RED};
use super::progress::scaled;
use serde::{Deserialize, Serialize};

/// One row of the history of a fluid; its fields are the columns of the table. Energies of a scene in the plane are for one
/// metre of depth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FluidRow {
    /// Physical time.
    pub time_s: f64,
    /// Steps taken.
    pub step: u64,
    /// Length of the last step.
    pub dt_s: f64,
    /// The limit that ruled the last step.
    pub dt_limit: String,
    /// Highest speed of any particle.
    pub max_speed_m_s: f64,
    /// Mean pressure over the volume of the fluid.
    pub mean_pressure_pa: f64,
    /// Largest change of a density, relative to the one without pressure.
    pub max_density_change_rel: f64,
    /// Lowest x that the fluid reaches, half a spacing beyond its last particle; so the others.
    pub x_min_m: f64,
    /// Highest x.
    pub x_max_m: f64,
    /// Lowest y.
    pub y_min_m: f64,
    /// Highest y.
    pub y_max_m: f64,
    /// Lowest z; empty in the plane.
    pub z_min_m: Option<f64>,
    /// Highest z; empty in the plane.
    pub z_max_m: Option<f64>,
    /// Energy of motion.
    pub kinetic_j: f64,
    /// Energy of height over the lowest corner of the domain.
    pub potential_j: f64,
    /// Energy of compression.
    pub compression_j: f64,
    /// Energy stored in the surface since the start.
    pub surface_j: f64,
    /// Energy taken by friction since the start.
    pub friction_j: f64,
    /// Energy given by the change of tension with temperature since the start.
    pub driven_j: f64,
    /// Energy given by expansion since the start.
    pub expansion_j: f64,
    /// What the ledger cannot account for, relative to the largest of the other energies.
    pub energy_residual_rel: f64,
}

impl FluidRow {
    /// What the progress bar says.
    pub(super) fn words(&self) -> String {
        let density = 100.0 * self.max_density_change_rel;
        format!(", fastest {}, density within {density:.1} %", scaled(self.max_speed_m_s, "m/s"))
    }
}

impl Charted for FluidRow {
    const TITLE: &'static str = "Largest speed and energies over time";

    fn time_s(&self) -> f64 {
        self.time_s
    }

    fn panels() -> Vec<Panel<Self>> {
        let speed = Curve { name: "largest speed", colour: RED, value: |row: &Self| row.max_speed_m_s };
        let kinetic = Curve { name: "motion", colour: BLUE, value: |row: &Self| row.kinetic_j };
        let potential = Curve { name: "height", colour: GREEN, value: |row: &Self| row.potential_j };
        let friction =
            Curve { name: "taken by friction", colour: ORANGE, value: |row: &Self| row.friction_j };
        vec![
            Panel { label: "speed, m/s", curves: vec![speed] },
            Panel { label: "energy, J", curves: vec![kinetic, potential, friction] },
        ]
    }
}
