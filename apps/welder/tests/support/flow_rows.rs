//! Wrong cases: flow of the melt, in the scene and in the material.

use super::Row;

/// Faults of a scene whose melt flows.
pub const FLOWS: &[Row] = &[
    (
        "Symmetry, y_min",
        "Adiabatic, y_min",
        "Symmetry)",
        &["part.faces.y_min", "no mirror planes", "whole part"],
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
        "[Heat(weights: Fitted), ",
        "[Heat(w",
        &["physics", "fitted to particles at rest", "Normalized"],
    ),
    ("20.0)]", "20.0), Stress()]", "Flow(", &["physics.1", "list Flow or Stress"]),
];
