//! Material cards: plausible values, solidus below liquidus below boiling, tables that ascend, a source for all.

use super::super::card::CardSource;
use super::super::material::Property;
use super::super::problem::Problem;
use super::findings::Findings;
use super::plausible::{
    BOILING, CONDUCTIVITY, DENSITY, EVAPORATION_HEAT, EXPANSION, HEAT_CAPACITY, LATENT_HEAT, MELT_EXPANSION,
    MELTING, MOLAR_MASS, POISSON, Range, TABLE_TEMPERATURE, TENSION, TENSION_SLOPE, VISCOSITY, YIELD, YOUNG,
    number,
};

/// Least distance of solidus and liquidus in kelvin; below it the slope of the enthalpy curve has no use.
const LEAST_MELTING_RANGE_K: f64 = 0.1;

/// All findings in one card.
pub fn check(card: &CardSource) -> Vec<Problem> {
    let mut findings = Findings::new(&card.source, &card.prefix);
    let mut fine = true;
    for (name, quantity) in card.card.quantities() {
        fine &= findings.within(&format!("{name}.value"), quantity.value, quantity_range(name));
        check_source(&mut findings, name, &quantity.source);
    }
    if fine {
        check_order(&mut findings, card);
    }
    for (name, property) in card.card.properties() {
        check_property(&mut findings, name, property, property_range(name));
        check_source(&mut findings, name, &property.source);
    }
    check_tension(&mut findings, card);
    findings.into_problems()
}

/// A tension has one slope: its own, or that of its table.
fn check_tension(findings: &mut Findings, card: &CardSource) {
    let slope = "surface_tension_slope_n_m_k";
    let is_table = card.card.surface_tension_n_m.as_ref().map(|tension| tension.table.is_some());
    match (is_table, card.card.surface_tension_slope_n_m_k.is_some()) {
        (Some(true), true) => findings.refuse(
            slope,
            "surface_tension_n_m is a table, whose slope is that between its points",
            "leave out surface_tension_slope_n_m_k, or give surface_tension_n_m as a value",
        ),
        (Some(false), false) => findings.refuse(
            "surface_tension_n_m",
            "a value at the liquidus does not tell how tension changes with temperature",
            "add surface_tension_slope_n_m_k with its source, or give surface_tension_n_m as a table",
        ),
        (None, true) => findings.refuse(
            slope,
            "there is no surface_tension_n_m that it is the slope of",
            "add surface_tension_n_m",
        ),
        _ => {}
    }
}

fn quantity_range(name: &str) -> &'static Range {
    match name {
        "density_kg_m3" => &DENSITY,
        "latent_heat_j_kg" => &LATENT_HEAT,
        "boiling_k" => &BOILING,
        "heat_of_evaporation_j_kg" => &EVAPORATION_HEAT,
        "molar_mass_kg_mol" => &MOLAR_MASS,
        "surface_tension_slope_n_m_k" => &TENSION_SLOPE,
        "volume_expansion_liquid_1_k" => &MELT_EXPANSION,
        "young_pa" => &YOUNG,
        "poisson" => &POISSON,
        _ => &MELTING,
    }
}

fn property_range(name: &str) -> &'static Range {
    match name {
        "heat_capacity_solid_j_kg_k" | "heat_capacity_liquid_j_kg_k" => &HEAT_CAPACITY,
        "viscosity_pa_s" => &VISCOSITY,
        "surface_tension_n_m" => &TENSION,
        "expansion_1_k" => &EXPANSION,
        "yield_pa" => &YIELD,
        _ => &CONDUCTIVITY,
    }
}

fn check_source(findings: &mut Findings, name: &str, source: &str) {
    let remedy = "say where the number comes from; `approximate` or `assumed` if that is all there is";
    findings.require(
        !source.trim().is_empty(),
        &format!("{name}.source"),
        "every value needs its source",
        remedy,
    );
}

fn check_order(findings: &mut Findings, card: &CardSource) {
    let (solidus_k, liquidus_k) = (card.card.solidus_k.value, card.card.liquidus_k.value);
    let reason = format!("not below the liquidus, {} K", number(liquidus_k));
    let remedy =
        "accepted: solidus_k below liquidus_k; a pure metal gets a range of 1 K around its melting point";
    let ordered = findings.require(solidus_k < liquidus_k, "solidus_k.value", &reason, remedy);
    if ordered {
        let reason =
            format!("less than {LEAST_MELTING_RANGE_K} K below the liquidus, {} K", number(liquidus_k));
        findings.require(liquidus_k - solidus_k >= LEAST_MELTING_RANGE_K, "solidus_k.value", &reason, remedy);
    }
    if let Some(boiling) = &card.card.boiling_k {
        let reason = format!("not above the liquidus, {} K", number(liquidus_k));
        let remedy = "accepted: boiling_k above liquidus_k";
        findings.require(boiling.value > liquidus_k, "boiling_k.value", &reason, remedy);
    }
}

fn check_property(findings: &mut Findings, name: &str, property: &Property, range: &Range) {
    match (property.value, &property.table) {
        (Some(value), None) => {
            findings.within(&format!("{name}.value"), value, range);
        }
        (None, Some(table)) => check_table(findings, name, table, range),
        _ => findings.refuse(
            name,
            "value and table are either both given or both missing",
            "accepted: (value: 1050.0, source: \"..\") or (table: [(300.0, 900.0), (800.0, 1100.0)], source: \"..\")",
        ),
    }
}

fn check_table(findings: &mut Findings, name: &str, table: &[(f64, f64)], range: &Range) {
    let field = format!("{name}.table");
    let remedy =
        "accepted: [(temperature_k, value), ...] with at least two points; or value: .. for a constant";
    findings.require(table.len() >= 2, &field, "fewer than two points", remedy);
    for (index, &(temperature_k, value)) in table.iter().enumerate() {
        findings.within(&format!("{field}.{index}.0"), temperature_k, &TABLE_TEMPERATURE);
        findings.within(&format!("{field}.{index}.1"), value, range);
    }
    for (index, pair) in table.windows(2).enumerate() {
        let reason = format!("not above the temperature before it, {} K", number(pair[0].0));
        let remedy = "accepted: temperatures that ascend from point to point";
        let ascends = pair[0].0 < pair[1].0 || pair[0].0.is_nan() || pair[1].0.is_nan();
        findings.require(ascends, &format!("{field}.{}.0", index + 1), &reason, remedy);
    }
}
