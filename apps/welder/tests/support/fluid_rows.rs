//! Wrong scenes of fluid.

use super::Row;

/// Faults of a scene of fluid.
pub const FLUIDS: &[Row] = &[
    ("Fluid(", "Fluids(", "Fluids(", &["unknown kind of scene `Fluids`", "did you mean `Fluid`", "Weld"]),
    ("viscosity_pa_s: 0.1", "viscosity_pa_s: -0.1", "-0.1,", &["fluid.viscosity_pa_s", "negative"]),
    (
        "viscosity_pa_s: 0.1",
        "viscosity: 0.1",
        "viscosity: 0",
        &["fluid.viscosity", "did you mean `viscosity_pa_s`"],
    ),
    ("1000.0", "0.0", "0.0, visc", &["fluid.density_kg_m3", "must not be zero"]),
    (
        "sound_speed_m_s: 40.0",
        "sound_speed_m_s: 10.0",
        "10.0)",
        &["fluid.sound_speed_m_s", "lets expect", "accepted: at least", "ten times"],
    ),
    (
        "size_m: (1.0, 0.6)",
        "size_m: (1.0, 0.6, 0.4)",
        "(0.0, -0.1),\n        size",
        &["domain.low_m", "3 dimensions"],
    ),
    ("size_m: (1.0, 0.6)", "size_m: (1.0)", "(1.0)", &["domain.size_m", "two numbers"]),
    ("(0.3, 0.2)", "(0.3, 0.2), spin_rad_s: 1e9", "1e9", &["bodies.0.spin_rad_s", "rad/s"]),
    ("size_m: (1.0, 0.6)", "size_m: (1.01, 0.6)", "1.01", &["domain.size_m.0", "50.5 spacings", "1 or 1.02"]),
    (
        "high_m: (0.3, 0.2)",
        "high_m: (1.2, 0.2)",
        "1.2",
        &["bodies.0.high_m.0", "outside the domain", "0 to 1 m"],
    ),
    (
        "high_m: (0.3, 0.2)",
        "high_m: (0.3, -0.04)",
        "-0.04",
        &["bodies.0.high_m.1", "3 spacings deep", "spacing_m at most 0.015"],
    ),
    ("high_m: (0.3, 0.2)", "high_m: (0.3, -0.2)", "-0.2)", &["bodies.0.high_m.1", "outside the domain"]),
    (
        "centre_m: (0.7, 0.25)",
        "centre_m: (0.95, 0.25)",
        "0.95",
        &["bodies.1.centre_m.0", "outside the domain"],
    ),
    ("centre_m: (0.7, 0.25)", "centre_m: (0.38, 0.1)", "Ball", &["bodies.1", "overlaps with bodies.0"]),
    ("radius_m: 0.1", "radius_m: 0.05", "0.05", &["bodies.1.radius_m", "2.5 spacings", "at least 0.08"]),
    ("(0.0, -1.0)", "(0.0, -1.0, 0.0)", "(0.0, -1.0, 0.0)", &["bodies.1.velocity_m_s", "3 numbers"]),
    (
        "velocity_m_s: (0.0, 0.5)",
        "velocity_m_s: (0.1, 0.5)",
        "0.1, 0.5",
        &["domain.sides.x_max.velocity_m_s.0", "along itself"],
    ),
    ("x_min: Wall()", "x_min: Periodic", "Periodic", &["domain.sides.x_min", "both of x_min and x_max"]),
    (
        "y_min: Wall()",
        "z_min: Wall(velocity_m_s: (1.0, 0.0))",
        "Wall(velocity_m_s: (1.0",
        &["domain.sides.z_min", "no side along z"],
    ),
    ("y_min: Wall()", "y_min: Wal()", "Wal()", &["domain.sides.y_min", "`Wal`", "`Wall`"]),
    ("spacing_m: 0.02", "spacing_m: 20.0", "20.0", &["spacing_m", "mm (then write 0.02)"]),
    (
        "viscosity_pa_s: 0.1",
        "viscosity_pa_s: 0.1, surface_tension_slope_n_m_k: -1e-4",
        "-1e-4",
        &["tension changes with temperature, and the scene has none", "add temperature"],
    ),
    (
        "viscosity_pa_s: 0.1",
        "viscosity_pa_s: 0.1, volume_expansion_1_k: 7e-4",
        "7e-4",
        &[
            "fluid.volume_expansion_1_k",
            "density changes with temperature, and the scene has none",
            "add temperature",
        ],
    ),
    (
        "viscosity_pa_s: 0.1",
        "viscosity_pa_s: 0.1, volume_expansion_1_k: 700.0",
        "700.0",
        &["fluid.volume_expansion_1_k", "1e-6/K (then write 7e-4)"],
    ),
    (
        "viscosity_pa_s: 0.1",
        "viscosity_pa_s: 0.1, volume_expansion_1_k: -1e-4",
        "-1e-4",
        &["fluid.volume_expansion_1_k", "negative", "0, or 1e-6 to 1 1/K"],
    ),
    (
        "viscosity_pa_s: 0.1",
        "viscosity_pa_s: 0.1, expansion_1_k: 7e-4",
        "expansion_1_k",
        &["fluid.expansion_1_k", "did you mean `volume_expansion_1_k`"],
    ),
    (
        "viscosity_pa_s: 0.1, sound_speed_m_s: 40.0),",
        "viscosity_pa_s: 0.1, volume_expansion_1_k: 1e-3, sound_speed_m_s: 40.0), temperature: Uniform(temperature_k: 1500.0),",
        "1e-3",
        &["fluid.volume_expansion_1_k", "at 1500 K", "reference_k, 293 K", "at most 0.5"],
    ),
    (
        "sides: (x_min: Wall(), x_max: Wall(velocity_m_s: (0.0, 0.5)), y_min: Wall()),\n    ),\n    fluid: (",
        "sides: (x_min: Periodic, x_max: Periodic, y_min: Wall())),\n    temperature: Linear(origin_k: 293.0, slope_k_m: (9.0, 0.0)),\n    fluid: (volume_expansion_1_k: 1e-3, ",
        "9.0, 0.0",
        &["temperature.slope_k_m.0", "would jump", "accepted: 0 along an axis that is Periodic"],
    ),
    (
        "spacing_m: 0.02",
        "temperature: Linear(origin_k: 300.0, slope_k_m: (-400.0, 0.0)), spacing_m: 0.02",
        "300.0",
        &["temperature.origin_k", "at -100 K"],
    ),
    (
        "time: (end_s: 0.5)",
        "time: (end_s: 0.5), output: (fields: [\"phase\"])",
        "\"phase\"",
        &["output.fields.0", "no such field", "velocity_m_s"],
    ),
    (
        "time: (end_s: 0.5)",
        "time: (end_s: 0.5), budget: (max_particles: 100)",
        "0.02",
        &["spacing_m", "max_particles = 100"],
    ),
    (
        "time: (end_s: 0.5)",
        "scheme: (artificial_viscosity: 5), time: (end_s: 0.5)",
        "5), time",
        &["scheme.artificial_viscosity", "0, or"],
    ),
    (
        "Block(low_m: (0.0, -0.1), high_m: (0.3, 0.2)),",
        "Block(low_m: (0.0, -0.1)),",
        "bodies: [",
        &["bodies.0.high_m", "found nothing"],
    ),
];
