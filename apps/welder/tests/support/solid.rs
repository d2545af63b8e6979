//! A good scene of elastic bodies.

/// A scene without fault.
pub const GOOD: &str = r#"Solid(
    title: "a test",
    material: (density_kg_m3: 2700.0, young_pa: 7.0e10, poisson: 0.33, expansion_1_k: 23.1e-6, yield_pa: 1.0e8),
    bodies: [
        Block(low_m: (-0.02, -0.01), high_m: (0.02, 0.01)),
        Ring(centre_m: (0.05, 0.0), inner_radius_m: 4.0e-3, outer_radius_m: 1.2e-2, velocity_m_s: (-9.0, 0.0)),
    ],
    held: [(low_m: (-0.02, -0.01), high_m: (-0.016, 0.01))],
    heating: (
        nodes: [(time_s: 2.0e-5, rise_k: 250.0), (time_s: 4.0e-5, rise_k: -30.0)],
        spot: (centre_m: (0.0, 0.0), radius_m: 5.0e-3),
    ),
    gravity_m_s2: (0.0, -9.81),
    damping_1_s: 6.0e5,
    spacing_m: 2.0e-3,
    scheme: (smoothing_ratio: 0.9),
    time: (end_s: 7.0e-5),
)
"#;
