//! The history of a scene of elastic bodies.

use super::history_picture::{BLUE, Charted, Curve, GREEN, ORANGE, Panel, RED};
use super::progress::scaled;
use serde::{Deserialize, Serialize};

/// One row of the history of elastic bodies; its fields are the columns of the table. Energies and momentum of a scene in the plane
/// are for one metre of depth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SolidRow {
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
    /// Largest von Mises stress.
    pub max_von_mises_pa: f64,
    /// Largest principal stress, tension positive.
    pub max_principal_stress_pa: f64,
    /// Smallest principal stress.
    pub min_principal_stress_pa: f64,
    /// Largest displacement from the start.
    pub max_displacement_m: f64,
    /// Largest accumulated equivalent plastic strain.
    pub max_plastic_strain: f64,
    /// Number of pieces that hang together.
    pub pieces: usize,
    /// Lowest x that the bodies reach, half a spacing beyond the last particle; so the others.
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
    /// Energy of elastic strain.
    pub elastic_j: f64,
    /// Energy of height over the start.
    pub potential_j: f64,
    /// Energy brought since the start by prescribed temperatures.
    pub heated_j: f64,
    /// Energy brought since the start by what is held and moves.
    pub driven_j: f64,
    /// Work of yield since the start, plastic strain taken as small.
    pub plastic_j: f64,
    /// Energy taken since the start by damping.
    pub damped_j: f64,
    /// Energy taken since the start by artificial viscosity and the scheme itself.
    pub lost_j: f64,
    /// The same, relative to the largest of the energies.
    pub energy_residual_rel: f64,
}

impl SolidRow {
    /// What the progress bar says.
    pub(super) fn words(&self) -> String {
        let stress = 1e-6 * self.max_von_mises_pa;
        format!(", fastest {}, von Mises {stress:.3} MPa", scaled(self.max_speed_m_s, "m/s"))
    }
}

impl Charted for SolidRow {
    const TITLE: &'static str = "Largest stress, largest displacement and energies over time";

    fn time_s(&self) -> f64 {
        self.time_s
    }

    fn panels() -> Vec<Panel<Self>> {
        let stress =
            Curve { name: "largest von Mises stress", colour: RED, value: |row: &Self| row.max_von_mises_pa };
        let pull = Curve {
            name: "largest principal stress",
            colour: BLUE,
            value: |row: &Self| row.max_principal_stress_pa,
        };
        let displacement =
            Curve { name: "largest displacement", colour: GREEN, value: |row: &Self| row.max_displacement_m };
        let kinetic = Curve { name: "motion", colour: BLUE, value: |row: &Self| row.kinetic_j };
        let elastic = Curve { name: "elastic", colour: GREEN, value: |row: &Self| row.elastic_j };
        let lost = Curve { name: "lost", colour: ORANGE, value: |row: &Self| row.lost_j };
        vec![
            Panel { label: "stress, Pa", curves: vec![stress, pull] },
            Panel { label: "displacement, m", curves: vec![displacement] },
            Panel { label: "energy, J", curves: vec![kinetic, elastic, lost] },
        ]
    }
}
