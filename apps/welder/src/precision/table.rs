//! The tables of a ladder, on the terminal and as CSV.

use super::convergence::{CAREFUL_SAFETY_FACTOR, SAFETY_FACTOR};
use super::estimate::Estimate;
use super::{Point, PrecisionError, settings};
use crate::observe::{ObserveError, whole_file};
use std::path::Path;

/// What is said of values whose order cannot be trusted.
pub(super) const NOT_ASYMPTOTIC: &str = "not in the asymptotic range";

/// Titles of the columns.
pub(super) fn head() -> String {
    format!(
        "{:<22} {:>8} {:>9} {:>6} {:>7} {:>11} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}",
        "setting",
        "um",
        "particles",
        "pairs",
        "sweeps",
        "pair visits",
        "cpu s",
        "set-up s",
        "width %",
        "depth %",
        "length %",
        "peak %",
        "weld %"
    )
}

/// A run as a row of the table.
pub(super) fn row(point: &Point) -> String {
    format!(
        "{:<22} {:>8.2} {:>9} {:>6.1} {:>7} {:>11.3e} {:>8.3} {:>8.3} {:>+8.2} {:>+8.2} {:>+8.2} {:>+8.2} {:>+8.2}",
        point.setting,
        1e6 * point.spacing_m,
        point.particles,
        point.pairs_per_particle,
        point.sweeps,
        point.pair_visits as f64,
        point.cpu_s,
        point.setup_cpu_s,
        100.0 * point.errors.width_error,
        100.0 * point.errors.depth_error,
        100.0 * point.errors.length_error,
        100.0 * point.errors.peak_error,
        100.0 * point.errors.weld_error
    )
}

/// Writes all runs as CSV.
pub(super) fn write_csv(path: &Path, points: &[Point]) -> Result<(), PrecisionError> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record([
        "setting",
        "spacing_m",
        "particles",
        "pairs_per_particle",
        "steps",
        "sweeps",
        "pair_visits",
        "cpu_s",
        "setup_cpu_s",
        "width_error",
        "depth_error",
        "length_error",
        "peak_error",
        "weld_error",
        "width_m",
        "depth_m",
        "length_m",
        "peak_temperature_k",
        "weld_volume_m3",
        "solidified_at_s",
    ])?;
    for p in points {
        let numbers = [
            p.spacing_m,
            p.particles as f64,
            p.pairs_per_particle,
            p.steps as f64,
            p.sweeps as f64,
            p.pair_visits as f64,
            p.cpu_s,
            p.setup_cpu_s,
            p.errors.width_error,
            p.errors.depth_error,
            p.errors.length_error,
            p.errors.peak_error,
            p.errors.weld_error,
            p.sizes.width_m,
            p.sizes.depth_m,
            p.sizes.length_m,
            p.sizes.peak_temperature_k,
            p.sizes.weld_volume_m3,
            p.sizes.solidified_at_s.unwrap_or(f64::NAN),
        ];
        let cells = std::iter::once(p.setting.clone()).chain(numbers.iter().map(f64::to_string));
        table.write_record(cells)?;
    }
    place(path, table)
}

/// Puts a table into its file.
pub(super) fn place(path: &Path, table: csv::Writer<Vec<u8>>) -> Result<(), PrecisionError> {
    let bytes = table.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(whole_file::replace(path, &bytes).map_err(ObserveError::file("write", path))?)
}

/// The estimates of the default setting, one line a quantity, with the index of the reference.
pub(super) fn convergence(estimates: &[Estimate], reference_indices: &[f64]) -> String {
    let own: Vec<_> = estimates.iter().filter(|e| e.setting == settings::TIGHT).collect();
    if own.is_empty() {
        return "fewer than three spacings: no observed order".into();
    }
    let mut lines = vec![
        format!(
            "{}, spacings alone (index: safety factor {SAFETY_FACTOR}, {CAREFUL_SAFETY_FACTOR} where {NOT_ASYMPTOTIC}):",
            settings::TIGHT
        ),
        format!(
            "{:<14} {:>11} {:>7} {:>12} {:>8} {:>8} {:>11}",
            "quantity", "finest", "order", "extrapolated", "error %", "index %", "reference %"
        ),
    ];
    lines.extend(own.iter().zip(reference_indices).map(|(estimate, index)| {
        let found = estimate.convergence;
        format!(
            "{:<14} {:>11.4} {:>7} {:>12} {:>8} {:>8} {:>11.2}{}",
            format!("{}, {}", estimate.quantity, estimate.unit),
            estimate.value,
            cell(found.order, 2),
            cell(found.extrapolated, 4),
            cell(found.error.map(|error| 100.0 * error), 2),
            cell(found.index.map(|index| 100.0 * index), 2),
            100.0 * index,
            if found.asymptotic { String::new() } else { format!("  {NOT_ASYMPTOTIC}") }
        )
    }));
    lines.join("\n")
}

fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".into(), |value| format!("{value:.digits$}"))
}

/// Writes the estimates of all settings as CSV; cells without a value are empty.
pub(super) fn write_convergence(path: &Path, estimates: &[Estimate]) -> Result<(), PrecisionError> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record([
        "setting",
        "quantity",
        "unit",
        "spacing_m",
        "value",
        "observed_order",
        "extrapolated",
        "relative_error",
        "grid_convergence_index",
        "verdict",
    ])?;
    for e in estimates {
        let found = e.convergence;
        let optional = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
        table.write_record([
            e.setting.clone(),
            e.quantity.to_string(),
            e.unit.to_string(),
            e.spacing_m.to_string(),
            e.value.to_string(),
            optional(found.order),
            optional(found.extrapolated),
            optional(found.error),
            optional(found.index),
            if found.asymptotic { "asymptotic" } else { NOT_ASYMPTOTIC }.to_string(),
        ])?;
    }
    place(path, table)
}
