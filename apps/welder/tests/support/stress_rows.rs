//! Wrong cases: thermal stress, in the scene and in the material.

use super::Row;

/// Faults of the scene.
pub const SCENES: &[Row] = &[
    ("Stress(", "Stess(", "Stess", &["physics.1", "did you mean `Stress`"]),
    (
        "[Heat(), Stress",
        "[Stress",
        "Stress(",
        &["physics.0", "follows the temperatures of Heat", "[Heat(), Stress()]"],
    ),
    ("x_max: true", "x_min: true", "true", &["physics.1.clamped.x_min", "mirror plane"]),
    ("x_max: true", "top: true", "top", &["physics.1.clamped.top", "unknown field"]),
    ("clamped: (x_max: true)", "crossings: 0", "0)],\n    time", &["physics.1.crossings", "zero"]),
    (
        "disorder: 0.1",
        "levels: FineBox(low_m: (0, 0, -1e-3), high_m: (1e-3, 1e-3, 0))",
        "FineBox",
        &["resolution.levels", "one spacing", "Uniform"],
    ),
    ("start_k: 400.0", "material: \"in625\"", "\"in625\"", &["part.regions.0.material", "one material"]),
    (
        "\"temperature_k\"",
        "\"von_mises\"",
        "\"von_mises\"",
        &["output.fields.0", "did you mean `von_mises_pa`"],
    ),
];

/// Faults of the material.
pub const MATERIALS: &[Row] = &[
    ("7.0e10", "70.0", "70.0", &["young_pa.value", "GPa (then write 7e10)"]),
    ("0.33", "0.5", "0.5", &["poisson.value", "0 to 0.495"]),
    ("2.31e-5", "23.1", "23.1", &["expansion_1_k.value", "1e-6/K (then write 2.31e-5)"]),
    ("9.0e7", "90", "90)", &["yield_pa.table.0.1", "MPa (then write 9e7)"]),
    (
        ", (847.0, 0.0)",
        ", (947.0, 0.0)",
        "(table: [(293",
        &["yield_pa", "left at the solidus of 847 K", "(solidus_k, 0.0)"],
    ),
    (
        "    poisson: (value: 0.33, source: \"test\"),\n",
        "",
        "(",
        &["poisson", "Stress needs poisson", "leave out Stress"],
    ),
];
