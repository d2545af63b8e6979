//! Wrong cases: faces, sizes and places.

use super::Row;

/// Faults of the faces.
pub const FACES: &[Row] = &[
    ("y_min: Symmetry", "bottom: Symmetry", "Symmetry)", &["part.faces.bottom", "mirror", "Adiabatic"]),
    (
        "y_min: Symmetry",
        "bottom: FixedTemperature(temperature_k: 1e5)",
        "1e5",
        &["part.faces.bottom.temperature_k"],
    ),
    ("y_min: Symmetry", "top: FixedTemperature(temperature_k: 300)", "FixedT", &["part.faces.top", "laser"]),
    ("y_min: Symmetry", "top: Losses(emissivity: 2)", "2)", &["part.faces.top.emissivity", "0 to 1"]),
    ("y_min: Symmetry", "top: Losses(evaporation: 1)", "1)", &["part.faces.top.evaporation", "true"]),
    ("y_min: Symmetry", "top: Losses(ambient_k: 20)", "20)", &["part.faces.top.ambient_k", "Celsius"]),
    ("y_min: Symmetry", "top: Flux(flux_w_m2: NaN)", "NaN", &["part.faces.top.flux_w_m2", "finite"]),
];

/// Faults of sizes and places against each other.
pub const GEOMETRY: &[Row] = &[
    (
        "50.0e-6",
        "70.0e-6",
        "6.0e-3, 4",
        &["part.size_m.0", "85.7143 spacings", "5.95e-3 or 6.02e-3", "resolution.spacing_m: "],
    ),
    ("3.0e-3)", "50.0e-6)", "50.0e-6)", &["part.size_m.2", "two spacings", "at least 1e-4 m"]),
    ("3.0e-3)", "20.0e-6)", "20.0e-6)", &["part.size_m.2", "two spacings"]),
    (
        "0.6e-3",
        "0.12e-3",
        "0.12e-3",
        &["laser.beam.radius_1e2_m", "two spacings", "spacing_m at most 4.24264e-5"],
    ),
    (
        "Gaussian(radius_1e2_m: 0.6e-3)",
        "TopHat(radius_m: 90e-6)",
        "90e-6",
        &["laser.beam.radius_m", "at most 4.5e-5"],
    ),
    (
        "(position_m: (0.0, 0.0)",
        "(position_m: (9.0e-3, 0.0)",
        "(9.0e-3",
        &["laser.path.position_m", "off the part", "x from 0 to 6e-3 m"],
    ),
    (
        "(position_m: (0.0, 0.0)",
        "(position_m: (1.0e-3, 0.0)",
        "(1.0e-3, 0.0), pulse",
        &["laser.path.position_m", "second laser", "x = 0"],
    ),
    (
        "Surface(absorptivity: 0.4)",
        "BeerLambert(absorptivity: 0.4, absorption_coefficient_per_m: 1e5)",
        "1e5",
        &["laser.absorption.absorption_coefficient_per_m", "two spacings", "Surface(", "at most 5e-6"],
    ),
    (
        "high_m: (1.0e-3, 1.0e-3, 0.0)",
        "high_m: (1.0e-3, 1.0e-3, 1.0e-3)",
        "1.0e-3), start",
        &["part.regions.0.high_m.2", "outside the part"],
    ),
    (
        "high_m: (1.0e-3, 1.0e-3, 0.0)",
        "high_m: (1.02e-3, 1.0e-3, 0.0)",
        "1.02e-3",
        &["part.regions.0.high_m.0", "cuts through particles", "1e-3 or 1.05e-3"],
    ),
    (
        "high_m: (1.0e-3, 1.0e-3, 0.0)",
        "high_m: (1.0e-3, 1.0e-3, -2.0e-3)",
        "-2.0e-3",
        &["part.regions.0.high_m.2", "low_m"],
    ),
    (", start_k: 400.0", "", "(low_m", &["part.regions.0", "changes nothing"]),
    (
        "disorder: 0.1",
        "levels: FineBox(low_m: (0, 0, 0), high_m: (1e-3, 1e-3, 1e-3))",
        "FineBox",
        &["resolution.levels", "outside the part"],
    ),
];

/// Scenes that are too large.
pub const SIZES: &[Row] = &[
    ("50.0e-6", "1.0e-6", "1.0e-6", &["resolution.spacing_m", "particles", "max_particles"]),
    (
        "50.0e-6, disorder: 0.1",
        "4.0e-6, levels: Uniform",
        "4.0e-6",
        &["resolution.spacing_m", "1.13e9 particles", "max_particles"],
    ),
    (
        "max_particles: 20000000",
        "max_memory_bytes: 1000",
        "50.0e-6",
        &["resolution.spacing_m", "budget.max_memory_bytes", "smaller part"],
    ),
];
