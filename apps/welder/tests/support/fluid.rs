//! A good scene of fluid.

/// A scene without fault.
pub const GOOD: &str = r#"Fluid(
    title: "a test",
    domain: (
        low_m: (0.0, -0.1),
        size_m: (1.0, 0.6),
        sides: (x_min: Wall(), x_max: Wall(velocity_m_s: (0.0, 0.5)), y_min: Wall()),
    ),
    fluid: (density_kg_m3: 1000.0, viscosity_pa_s: 0.1, sound_speed_m_s: 40.0),
    bodies: [
        Block(low_m: (0.0, -0.1), high_m: (0.3, 0.2)),
        Ball(centre_m: (0.7, 0.25), radius_m: 0.1, velocity_m_s: (0.0, -1.0)),
    ],
    gravity_m_s2: (0.0, -9.81),
    spacing_m: 0.02,
    time: (end_s: 0.5),
)
"#;
