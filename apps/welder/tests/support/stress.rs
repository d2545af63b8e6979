//! A good scene with stress, and its material.

use super::good::{MATERIAL, SCENE};

/// A scene with stress and without fault.
pub fn scene() -> String {
    SCENE.replace("[Heat()]", "[Heat(), Stress(clamped: (x_max: true))]").replace("50.0e-6", "200.0e-6")
}

/// Its material.
pub fn material() -> String {
    let mechanics = "    young_pa: (value: 7.0e10, source: \"test\"),\n    poisson: (value: 0.33, source: \"test\"),\n    \
         expansion_1_k: (value: 2.31e-5, source: \"test\"),\n    \
         yield_pa: (table: [(293.0, 9.0e7), (847.0, 0.0)], source: \"test\"),\n)\n";
    MATERIAL.trim_end().trim_end_matches(')').to_string() + mechanics
}
