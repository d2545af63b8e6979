//! Wrong cases: flow of the melt, in the scene and in the material.

use super::Row;

/// Faults of a scene whose melt flows.
pub const FLOWS: &[Row] = &[
    (
        "Symmetry, y_min",
        "FixedTemperature(temperature_k: 300.0), y_min",
        "FixedTemperature(",
        &["part.faces.x_min", "particles that move", "accepted with Flow: Adiabatic, Symmetry"],
    ),
    (
        "viscosity_factor: 20.0",
        "schedule: Together",
        "Together",
        &["physics.1.schedule", "one spacing", "levels: Uniform"],
    ),
    (
        "viscosity_factor: 20.0",
        "viscosity_factor: 0.5",
        "0.5)]",
        &["physics.1.viscosity_factor", "1 to 10000"],
    ),
    ("viscosity_factor: 20.0", "sound_speed_m_s: -3", "-3)]", &["physics.1.sound_speed_m_s", "negative"]),
    ("[Heat(), ", "[", "Flow(", &["physics.0", "list both: physics: [Heat(), Flow()]"]),
    (
        "[Heat(), ",
        "[Heat(weights: Plain), ",
        "[Heat(w",
        &["physics", "normalized weights where the melt moves", "Fitted"],
    ),
];
