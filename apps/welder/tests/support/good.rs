//! A good scene with its material, and how the program is heard.

use std::process::Output;

/// A scene without fault.
pub const SCENE: &str = r#"(
    title: "a test",
    part: (
        size_m: (6.0e-3, 4.0e-3, 3.0e-3),
        material: "metal",
        start_k: 293.0,
        faces: (x_min: Symmetry, y_min: Symmetry),
        regions: [(low_m: (0.0, 0.0, -1.0e-3), high_m: (1.0e-3, 1.0e-3, 0.0), start_k: 400.0)],
    ),
    resolution: (spacing_m: 50.0e-6, disorder: 0.1),
    laser: (
        beam: Gaussian(radius_1e2_m: 0.6e-3),
        absorption: Surface(absorptivity: 0.4),
        path: Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0)),
    ),
    physics: [Heat()],
    time: (end_s: 0.03),
    output: (frame_interval_s: 1.0e-3, fields: ["temperature_k"]),
    budget: (max_particles: 20000000),
)
"#;

/// Its material, as `materials/metal.ron` beside it.
pub const MATERIAL: &str = r#"(
    density_kg_m3: (value: 2500.0, source: "test"),
    solidus_k: (value: 847.0, source: "test"),
    liquidus_k: (value: 905.0, source: "test"),
    latent_heat_j_kg: (value: 3.97e5, source: "test"),
    boiling_k: (value: 2790.0, source: "test"),
    heat_capacity_solid_j_kg_k: (table: [(300.0, 900.0), (847.0, 1050.0)], source: "test"),
    heat_capacity_liquid_j_kg_k: (value: 1180.0, source: "test"),
    conductivity_solid_w_m_k: (value: 200.0, source: "test"),
    conductivity_liquid_w_m_k: (value: 95.0, source: "test"),
)
"#;

/// Exit code and both channels of a finished program.
pub fn spoken(output: &Output) -> (Option<i32>, String) {
    let text =
        [&output.stdout[..], &output.stderr[..]].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    (output.status.code(), text.concat())
}
