//! Draws the history over time, in panels that each kind of scene names; of a weld peak temperature above, size of the pool below.

use super::canvas::{Area, Canvas, DrawError, FONT};
use super::labels::{Handy, KeyEntry, LARGE, MEDIUM, SMALL, draw_key, handy, tick, write_text};
use super::{HistoryRow, ObserveError};
use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::style::{BLACK, Color, RGBColor, WHITE};
use std::ops::Range;
use std::path::Path;

const WIDTH: u32 = 960;
/// Height of the title, and of each panel with its key and the labels below.
const HEAD: u32 = 44;
const PANEL: u32 = 348;
const KEY: u32 = 34;
const LEFT: u32 = 94;
const EDGE: u32 = 12;
const LINE: f64 = 2.2;
/// What the axis of values is longer by than they are.
const ROOM: f64 = 1.06;
pub(super) const RED: RGBColor = RGBColor(200, 40, 40);
pub(super) const BLUE: RGBColor = RGBColor(30, 100, 200);
pub(super) const GREEN: RGBColor = RGBColor(30, 140, 70);
pub(super) const ORANGE: RGBColor = RGBColor(225, 130, 0);

/// One line of a chart.
pub(super) struct Curve<Row> {
    pub name: &'static str,
    pub colour: RGBColor,
    pub value: fn(&Row) -> f64,
}

/// One chart of the picture: what its upward axis shows with its SI unit, and its lines.
pub(super) struct Panel<Row> {
    pub label: &'static str,
    pub curves: Vec<Curve<Row>>,
}

/// A row whose history can be drawn.
pub(super) trait Charted: Sized {
    /// Title of the picture.
    const TITLE: &'static str;

    /// Physical time of the row.
    fn time_s(&self) -> f64;

    /// The charts, from above.
    fn panels() -> Vec<Panel<Self>>;
}

/// Draws a history into a PNG file.
pub(super) fn draw_history<Row: Charted>(path: &Path, rows: &[Row]) -> Result<(), ObserveError> {
    painted(rows)
        .map_err(|error| ObserveError::Picture { path: path.to_path_buf(), reason: error.to_string() })?
        .save(path)
}

fn painted<Row: Charted>(rows: &[Row]) -> Result<Canvas, DrawError> {
    let panels = Row::panels();
    let mut canvas = Canvas::new(WIDTH, HEAD + panels.len() as u32 * PANEL);
    canvas.draw(|area| write_text(area, Row::TITLE, (LEFT as i32, 14), LARGE))?;
    for (index, panel) in panels.iter().enumerate() {
        draw_panel(&mut canvas, panel, rows, HEAD + index as u32 * PANEL)?;
    }
    Ok(canvas)
}

impl Charted for HistoryRow {
    const TITLE: &'static str = "Peak temperature and melt pool over time";

    fn time_s(&self) -> f64 {
        self.time_s
    }

    fn panels() -> Vec<Panel<Self>> {
        let peak =
            Curve { name: "peak temperature", colour: RED, value: |row: &Self| row.peak_temperature_k };
        let width = Curve { name: "width", colour: BLUE, value: |row: &Self| row.pool_width_m };
        let length = Curve { name: "length", colour: GREEN, value: |row: &Self| row.pool_length_m };
        let depth = Curve { name: "depth", colour: ORANGE, value: |row: &Self| row.pool_depth_m };
        vec![
            Panel { label: "temperature, K", curves: vec![peak] },
            Panel { label: "melt pool, m", curves: vec![width, length, depth] },
        ]
    }
}

fn draw_panel<Row: Charted>(
    canvas: &mut Canvas,
    panel: &Panel<Row>,
    rows: &[Row],
    top: u32,
) -> Result<(), DrawError> {
    let last_s = rows.last().map_or(0.0, Row::time_s);
    let (unit, per_second) = time_unit(last_s);
    let end = if last_s > 0.0 { last_s * per_second } else { 1.0 };
    let Range { start: low, end: high } = value_range(panel, rows);
    let Handy { name, factor } = handy(panel.label, high.max(-low));
    let labels = [format!("time, {unit}"), name];
    let ends = [0.0..end, factor * low..factor * high];
    let (across, down) = canvas.draw(|area| draw_axes(area, labels, ends, top))?;
    let place = |row: &Row, value: f64| {
        let (right, up) = (row.time_s() * per_second / end, (value - low) / (high - low));
        let x = f64::from(across.start) + right * (across.len() - 1) as f64;
        (x, f64::from(down.end) - up * down.len() as f64)
    };
    for curve in &panel.curves {
        for pair in rows.windows(2) {
            let values = [(curve.value)(&pair[0]), (curve.value)(&pair[1])];
            if values.iter().all(|value| value.is_finite()) {
                canvas.line(place(&pair[0], values[0]), place(&pair[1], values[1]), LINE, curve.colour);
            }
        }
    }
    let entry =
        |curve: &Curve<Row>| KeyEntry { name: curve.name.into(), strokes: vec![(LINE, curve.colour)] };
    let entries: Vec<_> = panel.curves.iter().map(entry).collect();
    draw_key(canvas, &entries, (LEFT as i32, top as i32 + 8))
}

/// Draws the axes of a panel, and tells where its lines go.
fn draw_axes(
    area: &Area,
    [x_label, y_label]: [String; 2],
    [x, y]: [Range<f64>; 2],
    top: u32,
) -> Result<(Range<i32>, Range<i32>), DrawError> {
    let (across, up) = (x.end - x.start, y.end - y.start);
    let mut chart = ChartBuilder::on(&area.clone().shrink((0, top), (WIDTH, PANEL)))
        .margin_left(EDGE)
        .margin_right(2 * EDGE)
        .margin_top(KEY)
        .set_label_area_size(LabelAreaPosition::Left, LEFT - EDGE)
        .set_label_area_size(LabelAreaPosition::Bottom, 58)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .bold_line_style(BLACK.mix(0.12))
        .x_desc(x_label)
        .y_desc(y_label)
        .x_labels(12)
        .y_labels(7)
        .x_label_formatter(&|value| tick(*value, across))
        .y_label_formatter(&|value| tick(*value, up))
        .label_style((FONT, SMALL))
        .axis_desc_style((FONT, MEDIUM))
        .draw()?;
    Ok(chart.plotting_area().get_pixel_range())
}

/// The range of a chart: zero and every finite value, with some room; a chart of zeros still needs one.
fn value_range<Row>(panel: &Panel<Row>, rows: &[Row]) -> Range<f64> {
    let values = panel.curves.iter().flat_map(|curve| rows.iter().map(curve.value));
    let finite = values.filter(|value| value.is_finite());
    let (low, high) =
        finite.fold((0.0, 0.0), |(low, high): (f64, f64), value| (low.min(value), high.max(value)));
    if high > low { ROOM * low..ROOM * high } else { 0.0..ROOM }
}

/// The unit of time that gives handy numbers, and how many of it are in a second.
fn time_unit(last_s: f64) -> (&'static str, f64) {
    match last_s {
        _ if last_s >= 2.0 => ("s", 1.0),
        _ if last_s >= 2e-3 => ("ms", 1e3),
        _ => ("\u{b5}s", 1e6),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<HistoryRow> {
        let row = |index: usize| {
            let time_s = 1.5e-4 * index as f64;
            let heat = (time_s / 5e-3).min(1.0).sqrt() * (1.0 - ((time_s - 5e-3) / 8e-3).max(0.0));
            HistoryRow {
                time_s,
                peak_temperature_k: 293.0 + 1500.0 * heat,
                pool_width_m: 1.2e-3 * (heat - 0.4).max(0.0),
                pool_length_m: if index == 7 { f64::NAN } else { 1.5e-3 * (heat - 0.4).max(0.0) },
                pool_depth_m: 0.5e-3 * (heat - 0.4).max(0.0),
                ..HistoryRow::default()
            }
        };
        (0..=100).map(row).collect()
    }

    #[test]
    fn the_axis_holds_every_finite_value() {
        let panels = HistoryRow::panels();
        let [temperature, pool] = panels.as_slice() else { panic!("two panels") };
        let hottest = rows().iter().map(|row| row.peak_temperature_k).fold(0.0, f64::max);
        assert_eq!(value_range(temperature, &rows()).end, ROOM * hottest);
        let longest = rows().iter().map(|row| row.pool_length_m).fold(0.0, f64::max);
        assert_eq!(value_range(pool, &rows()), 0.0..ROOM * longest);
        assert_eq!(value_range(pool, &[]), 0.0..ROOM);
        let cooled = HistoryRow { peak_temperature_k: -3.0, ..HistoryRow::default() };
        assert_eq!(value_range(temperature, &[cooled]), -3.0 * ROOM..0.0);
    }

    #[test]
    fn times_have_handy_units() {
        assert_eq!([5.0, 0.5, 15e-3, 2e-5].map(|last_s| time_unit(last_s).0), ["s", "ms", "ms", "\u{b5}s"]);
        assert!((15e-3 * time_unit(15e-3).1 - 15.0).abs() < 1e-12);
    }

    #[test]
    fn a_history_of_any_length_can_be_drawn() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.png");
        for count in [0, 1, 2, 101] {
            draw_history(&path, &rows()[..count]).unwrap();
            assert!(path.metadata().unwrap().len() > 5_000);
        }
        let error = draw_history(&folder.path().join("none/history.png"), &rows()).unwrap_err();
        assert!(error.to_string().contains("none/history.png"), "{error}");
    }
}
