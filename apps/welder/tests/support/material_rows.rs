//! Wrong cases: material cards.

use super::Row;

/// Faults of the material card.
pub const MATERIALS: &[Row] = &[
    ("2500.0", "-2500.0", "-2500.0", &["density_kg_m3.value", "negative"]),
    ("2500.0", "2.5", "2.5,", &["density_kg_m3.value", "g/cm3 (then write 2500)"]),
    (
        "(value: 2500.0, source: \"test\")",
        "2500.0",
        "2500.0",
        &["density_kg_m3", "found `2500.0`", "round brackets"],
    ),
    ("(value: 847.0", "(value: 950.0", "950.0", &["solidus_k.value", "not below the liquidus, 905 K"]),
    ("(value: 847.0", "(value: 905.0", "905.0", &["solidus_k.value", "1 K"]),
    ("3.97e5", "-3.97e5", "-3.97e5", &["latent_heat_j_kg.value", "negative"]),
    ("3.97e5", "397", "397", &["latent_heat_j_kg.value", "kJ/kg or J/g (then write 3.97e5)"]),
    ("2790.0", "880.0", "880.0", &["boiling_k.value", "liquidus"]),
    (
        "    heat_capacity_solid",
        "    heat_of_evaporation_j_kg: (value: 10900.0, source: \"test\"),\n    heat_capacity_solid",
        "10900.0",
        &["heat_of_evaporation_j_kg.value", "kJ/kg or J/g (then write 1.09e7)"],
    ),
    (
        "    heat_capacity_solid",
        "    molar_mass_kg_mol: (value: 26.98, source: \"test\"),\n    heat_capacity_solid",
        "26.98",
        &["molar_mass_kg_mol.value", "g/mol (then write 0.02698)"],
    ),
    (
        "    heat_capacity_solid",
        "    volume_expansion_liquid_1_k: (value: 131.0, source: \"test\"),\n    heat_capacity_solid",
        "131.0",
        &["volume_expansion_liquid_1_k.value", "1e-6/K (then write 1.31e-4)"],
    ),
    (
        "    heat_capacity_solid",
        "    volume_expansion_liquid_1_k: (value: -1.3e-4, source: \"test\"),\n    heat_capacity_solid",
        "-1.3e-4",
        &["volume_expansion_liquid_1_k.value", "negative", "accepted: 0, or 1e-6 to 1e-3 1/K"],
    ),
    (
        "    heat_capacity_solid",
        "    volume_expansion_1_k: (value: 1.3e-4, source: \"test\"),\n    heat_capacity_solid",
        "volume_expansion_1_k",
        &["unknown field `volume_expansion_1_k`", "did you mean `volume_expansion_liquid_1_k`"],
    ),
    (
        "    heat_capacity_solid",
        "    volume_expansion_liquid_1_k: 1.3e-4,\n    heat_capacity_solid",
        "1.3e-4",
        &["volume_expansion_liquid_1_k", "found `1.3e-4`", "round brackets"],
    ),
    (
        "    heat_capacity_solid",
        "    surface_tension_n_m: (value: 0.9, source: \"test\"),\n    heat_capacity_solid",
        "(value: 0.9",
        &["surface_tension_n_m", "add surface_tension_slope_n_m_k", "as a table"],
    ),
    (
        "    heat_capacity_solid",
        "    surface_tension_n_m: (table: [(905.0, 0.9), (1905.0, 0.55)], source: \"test\"),\n    \
         surface_tension_slope_n_m_k: (value: -3.5e-4, source: \"test\"),\n    heat_capacity_solid",
        "(value: -3.5e-4",
        &["surface_tension_slope_n_m_k", "is a table"],
    ),
    ("value: 200.0", "value: 0.2", "0.2", &["conductivity_solid_w_m_k.value", "W/(mm K) (then write 200)"]),
    (
        "value: 200.0",
        "value: 200.0, table: [(1, 2)]",
        "(value: 200.0",
        &["conductivity_solid_w_m_k", "both given"],
    ),
    ("(value: 200.0, ", "(", "(source", &["conductivity_solid_w_m_k", "table:"]),
    ("(847.0, 1050.0)", "(250.0, 1050.0)", "250.0", &["heat_capacity_solid_j_kg_k.table.1.0", "ascend"]),
    ("(847.0, 1050.0)", "(847.0, inf)", "inf", &["heat_capacity_solid_j_kg_k.table.1.1", "finite"]),
    (", (847.0, 1050.0)", "", "[(300", &["heat_capacity_solid_j_kg_k.table", "two points"]),
    (
        "value: 1180.0, source: \"test\"",
        "value: 1180.0, source: \" \"",
        "\" \"",
        &["heat_capacity_liquid_j_kg_k.source", "source"],
    ),
    (
        "value: 1180.0, source: \"test\"",
        "value: 1180.0",
        "heat_capacity_liquid",
        &["heat_capacity_liquid_j_kg_k.source", "add `source"],
    ),
    (
        "latent_heat_j_kg",
        "latent_heat",
        "latent_heat",
        &["unknown field `latent_heat`", "did you mean `latent_heat_j_kg`"],
    ),
];
