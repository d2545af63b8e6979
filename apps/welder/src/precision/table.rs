//! The table of a ladder, on the terminal and as CSV.

use super::{Point, PrecisionError};
use std::path::Path;

/// Titles of the columns.
pub(super) fn head() -> String {
    format!(
        "{:<22} {:>8} {:>9} {:>6} {:>7} {:>11} {:>8} {:>8} {:>8} {:>8} {:>8}",
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
        "peak %"
    )
}

/// A run as a row of the table.
pub(super) fn row(point: &Point) -> String {
    format!(
        "{:<22} {:>8.2} {:>9} {:>6.1} {:>7} {:>11.3e} {:>8.3} {:>8.3} {:>+8.2} {:>+8.2} {:>+8.2}",
        point.setting,
        1e6 * point.spacing_m,
        point.particles,
        point.pairs_per_particle,
        point.sweeps,
        point.pair_visits as f64,
        point.cpu_s,
        point.setup_cpu_s,
        100.0 * point.width_error,
        100.0 * point.depth_error,
        100.0 * point.peak_error
    )
}

/// Writes all runs as CSV.
pub(super) fn write_csv(path: &Path, points: &[Point]) -> Result<(), PrecisionError> {
    let mut table = csv::Writer::from_path(path)?;
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
        "peak_error",
        "width_m",
        "depth_m",
        "peak_temperature_k",
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
            p.width_error,
            p.depth_error,
            p.peak_error,
            p.sizes.width_m,
            p.sizes.depth_m,
            p.sizes.peak_temperature_k,
            p.sizes.solidified_at_s.unwrap_or(f64::NAN),
        ];
        let cells = std::iter::once(p.setting.clone()).chain(numbers.iter().map(f64::to_string));
        table.write_record(cells)?;
    }
    table.flush().map_err(csv::Error::from)?;
    Ok(())
}
