//! The report as a table on the terminal.

use super::Entry;
use super::known::{Verdict, verdict};
use comfy_table::{CellAlignment, Table, presets};

/// The entries as a table, one row an entry.
pub(super) fn table(entries: &[Entry]) -> Table {
    let mut table = Table::new();
    table.load_style(presets::UTF8_HORIZONTAL_ONLY);
    table.set_header(["benchmark", "resolution: error", "order", "mark", "pair visits", "wall s", ""]);
    for entry in entries {
        table.add_row(row(entry));
    }
    for column in 2..6 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

fn row(entry: &Entry) -> [String; 7] {
    let error = |level: &super::LevelResult| format!("{}: {:.2e}", level.resolution, level.error);
    let errors: Vec<_> = entry.levels.iter().map(error).collect();
    let visits: u64 = entry.levels.iter().map(|level| level.pair_visits).sum();
    let wall: f64 = entry.levels.iter().map(|level| level.wall_s).sum();
    [
        entry.name.clone(),
        errors.join("  "),
        entry.observed_order.map_or_else(|| "-".into(), |order| format!("{order:.2}")),
        format!("{:.1e} at {}", entry.pass_mark, entry.at_resolution),
        format!("{:.1e}", visits as f64),
        format!("{wall:.2}"),
        match verdict(entry) {
            Verdict::Holds => "pass".into(),
            Verdict::Known => "MISS, known".into(),
            Verdict::Missed => "MISS".into(),
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::super::LevelResult;
    use super::*;

    #[test]
    fn a_miss_stands_out() {
        let level = LevelResult {
            resolution: 5.0,
            particles: 8,
            error: 0.034,
            pair_visits: 7,
            cpu_s: None,
            wall_s: 0.5,
        };
        let entry = Entry {
            name: "heat/x".into(),
            tested_crate: "sph-thermal".into(),
            reference: String::new(),
            quantity: String::new(),
            levels: vec![level],
            observed_order: Some(1.96),
            pass_mark: 0.01,
            at_resolution: 5.0,
            passed: false,
        };
        let text = table(&[entry]).to_string();
        for part in ["heat/x", "5: 3.40e-2", "1.96", "1.0e-2 at 5", "MISS"] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }
}
