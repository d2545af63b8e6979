//! Wrong cases: flow of the melt, in the scene and in the material.

use super::{MATERIAL, Row, SCENE};

/// A scene with flow whose only faults are its mirror planes.
pub fn scene() -> String {
    SCENE.replace("[Heat()]", "[Heat(), Flow(viscosity_factor: 20.0)]").replace("50.0e-6", "200.0e-6")
}

/// A material that flows.
pub fn material() -> String {
    let melt = "    viscosity_pa_s: (value: 1.3e-3, source: \"test\"),\n    \
         surface_tension_n_m: (value: 0.9, source: \"test\"),\n    \
         surface_tension_slope_n_m_k: (value: -3.5e-4, source: \"test\"),\n)\n";
    MATERIAL.trim_end().trim_end_matches(')').to_string() + melt
}

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
