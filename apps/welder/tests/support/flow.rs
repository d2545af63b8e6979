//! A scene whose melt flows, and its material.

use super::good::{MATERIAL, SCENE};

/// A scene with flow.
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
