//! The measures of one moment, of any kind of scene.

use super::history_picture::draw_history;
use super::progress::scaled;
use super::{FluidRow, HistoryRow, ObserveError, SolidRow, read_history};
use serde::Serialize;
use std::path::Path;

/// A row of the history of one kind of scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Measures {
    /// Of a weld.
    Weld(HistoryRow),
    /// Of a fluid.
    Fluid(FluidRow),
    /// Of elastic bodies.
    Solid(SolidRow),
}

impl Measures {
    /// What the progress bar says of them, with a comma before it.
    pub(super) fn words(&self) -> String {
        match self {
            Measures::Weld(row) => weld_words(row),
            Measures::Fluid(row) => row.words(),
            Measures::Solid(row) => row.words(),
        }
    }

    /// Draws the history at `table`, whose rows are of this kind, into a PNG file.
    pub(super) fn draw_history(&self, picture: &Path, table: &Path) -> Result<(), ObserveError> {
        match self {
            Measures::Weld(_) => draw_history::<HistoryRow>(picture, &read_history(table)?),
            Measures::Fluid(_) => draw_history::<FluidRow>(picture, &read_history(table)?),
            Measures::Solid(_) => draw_history::<SolidRow>(picture, &read_history(table)?),
        }
    }
}

fn weld_words(row: &HistoryRow) -> String {
    let pool = if row.pool_depth_m > 0.0 || row.pool_width_m > 0.0 {
        format!(", pool {} wide, {} deep", scaled(row.pool_width_m, "m"), scaled(row.pool_depth_m, "m"))
    } else {
        String::new()
    };
    format!("{pool}, peak {:.0} K", row.peak_temperature_k)
}
