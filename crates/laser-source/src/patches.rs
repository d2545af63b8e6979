//! Many small squares on one surface, evaluated together.

mod edges;

use crate::error::{Error, require_coordinate, require_length};
use crate::quadrature::QuadraturePoint;
use crate::source::LaserSource;

use edges::Edges;

/// Squares of a plane surface that receive absorbed power; one for each surface particle.
///
/// Squares on a regular plane share their edges: each distinct edge costs one error function per quadrature
/// point, each square then only the product of two differences. Squares beyond the reach of the beam are not
/// visited.
#[derive(Debug, Clone)]
pub struct SurfacePatches {
    x_edges: Edges,
    y_edges: Edges,
    rows: Vec<Row>,
    cells: Vec<Cell>,
}

/// Squares with the same two y-edges, in order of x.
#[derive(Debug, Clone)]
struct Row {
    y_low: u32,
    y_high: u32,
    cells: std::ops::Range<usize>,
}

/// One square of a row: its x-edges and its place in the caller's columns.
#[derive(Debug, Clone)]
struct Cell {
    x_low: u32,
    x_high: u32,
    patch: u32,
}

impl SurfacePatches {
    /// The squares with centres `(x_m[i], y_m[i])` and sides `2 half_width_m[i]`.
    ///
    /// Edges closer than 1e-9 of the smallest half width count as one, so that neighbouring squares leave no
    /// gap.
    ///
    /// # Errors
    /// [`Error::ColumnLength`] if the columns differ in length, [`Error::OutOfRange`] if a coordinate is not
    /// finite or a half width not positive.
    pub fn new(x_m: &[f64], y_m: &[f64], half_width_m: &[f64]) -> Result<Self, Error> {
        validate(x_m, y_m, half_width_m)?;
        let tolerance_m = 1e-9 * half_width_m.iter().copied().fold(f64::INFINITY, f64::min);
        let (x_edges, x_spans) = Edges::of_intervals(x_m, half_width_m, tolerance_m);
        let (y_edges, y_spans) = Edges::of_intervals(y_m, half_width_m, tolerance_m);
        let mut order: Vec<usize> = (0..x_m.len()).collect();
        order.sort_by_key(|&patch| (y_spans[patch], x_spans[patch], patch));
        let mut rows: Vec<Row> = Vec::new();
        let mut cells = Vec::with_capacity(order.len());
        for patch in order {
            let ([y_low, y_high], [x_low, x_high]) = (y_spans[patch], x_spans[patch]);
            if rows.last().is_none_or(|row| [row.y_low, row.y_high] != [y_low, y_high]) {
                rows.push(Row { y_low, y_high, cells: cells.len()..cells.len() });
            }
            cells.push(Cell { x_low, x_high, patch: patch as u32 });
            if let Some(row) = rows.last_mut() {
                row.cells.end = cells.len();
            }
        }
        Ok(Self { x_edges, y_edges, rows, cells })
    }

    /// Number of squares.
    #[must_use]
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether there are no squares.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Adds to `out[i]` the power (W) that square i absorbs from `source`, mean over the step from `t0_s` to
    /// `t1_s`, times `scale`. Adds nothing if `t1_s <= t0_s`.
    ///
    /// # Panics
    /// If `out` is not as long as the columns.
    pub fn accumulate(&mut self, source: &LaserSource, t0_s: f64, t1_s: f64, scale: f64, out: &mut [f64]) {
        assert_eq!(out.len(), self.len(), "out needs one entry a patch");
        let beam = *source.beam();
        let factor = scale * source.absorption().absorptivity() / (t1_s - t0_s);
        source.for_each_point(t0_s, t1_s, |point| {
            let power_w = factor * point.energy_j;
            match beam.separable() {
                Some((radius_m, total)) => self.add_separable(&point, radius_m, 0.25 * total * power_w, out),
                None => self.add(&point, beam.reach_m(), out, |low, high| {
                    power_w * beam.fraction_in_rectangle(low[0], high[0], low[1], high[1])
                }),
            }
        });
    }

    /// Adds a Gaussian: differences of error functions at the edges, times `amplitude`.
    fn add_separable(&mut self, point: &QuadraturePoint, radius_m: f64, amplitude: f64, out: &mut [f64]) {
        let columns = self.x_edges.evaluate_erf(point.x_m, radius_m);
        let lines = self.y_edges.evaluate_erf(point.y_m, radius_m);
        let (x_erf, y_erf) = (self.x_edges.erf(), self.y_edges.erf());
        for row in lit_rows(&self.rows, &lines) {
            let height = amplitude * (y_erf[row.y_high as usize] - y_erf[row.y_low as usize]);
            for cell in lit_cells(&self.cells[row.cells.clone()], &columns) {
                out[cell.patch as usize] +=
                    height * (x_erf[cell.x_high as usize] - x_erf[cell.x_low as usize]);
            }
        }
    }

    /// Adds any profile: `power` of the low and the high corner of each square relative to the beam's centre.
    fn add(
        &self,
        point: &QuadraturePoint,
        reach_m: f64,
        out: &mut [f64],
        power: impl Fn([f64; 2], [f64; 2]) -> f64,
    ) {
        let columns = self.x_edges.within(point.x_m, reach_m);
        let lines = self.y_edges.within(point.y_m, reach_m);
        for row in lit_rows(&self.rows, &lines) {
            let (y_low, y_high) =
                (self.y_edges.at(row.y_low) - point.y_m, self.y_edges.at(row.y_high) - point.y_m);
            for cell in lit_cells(&self.cells[row.cells.clone()], &columns) {
                let (low, high) = (self.x_edges.at(cell.x_low), self.x_edges.at(cell.x_high));
                out[cell.patch as usize] += power([low - point.x_m, y_low], [high - point.x_m, y_high]);
            }
        }
    }
}

/// The rows that reach into `lines`, a range of y-edges near the beam.
fn lit_rows<'a>(rows: &'a [Row], lines: &std::ops::Range<u32>) -> impl Iterator<Item = &'a Row> {
    let (start, end) = (lines.start, lines.end);
    let last = rows.partition_point(|row| row.y_low < end);
    rows[..last].iter().filter(move |row| row.y_high >= start)
}

/// The cells of a row that reach into `columns`, a range of x-edges near the beam.
fn lit_cells<'a>(cells: &'a [Cell], columns: &std::ops::Range<u32>) -> &'a [Cell] {
    let first = cells.partition_point(|cell| cell.x_high < columns.start);
    let last = cells.partition_point(|cell| cell.x_low < columns.end);
    &cells[first..last.max(first)]
}

fn validate(x_m: &[f64], y_m: &[f64], half_width_m: &[f64]) -> Result<(), Error> {
    for (field, column) in [("y_m", y_m), ("half_width_m", half_width_m)] {
        if column.len() != x_m.len() {
            return Err(Error::ColumnLength { field, found: column.len(), accepted: x_m.len() });
        }
    }
    for i in 0..x_m.len() {
        require_coordinate(&format!("x_m[{i}]"), x_m[i])?;
        require_coordinate(&format!("y_m[{i}]"), y_m[i])?;
        require_length(&format!("half_width_m[{i}]"), half_width_m[i])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
