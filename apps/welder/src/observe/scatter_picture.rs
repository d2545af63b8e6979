//! Draws error against cost or resolution, both on logarithmic axes: one line a setting or entry, one point a run.

use super::ObserveError;
use super::canvas::{Area, Canvas, DrawError, FONT};
use super::labels::{KeyEntry, LARGE, MEDIUM, SMALL, draw_key, key_width, write_text};
use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::coord::combinators::IntoLogRange;
use plotters::style::{BLACK, Color, RGBColor, WHITE};
use std::ops::Range;
use std::path::Path;

const WIDTH: u32 = 900;
const HEIGHT: u32 = 664;
const HEAD: u32 = 152;
const LEFT: u32 = 90;
const EDGE: u32 = 12;
const LINE: f64 = 2.0;
const DOT: f64 = 7.0;
const COLOURS: [RGBColor; 14] = [
    RGBColor(20, 20, 20),
    RGBColor(200, 40, 40),
    RGBColor(30, 100, 200),
    RGBColor(30, 140, 70),
    RGBColor(225, 130, 0),
    RGBColor(130, 60, 170),
    RGBColor(0, 150, 160),
    RGBColor(160, 110, 60),
    RGBColor(220, 90, 160),
    RGBColor(110, 110, 110),
    RGBColor(140, 160, 0),
    RGBColor(80, 80, 200),
    RGBColor(250, 190, 0),
    RGBColor(120, 0, 0),
];

/// One line of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Its name in the key.
    pub name: String,
    /// (cost or resolution, error), both above zero; others are left out.
    pub points: Vec<(f64, f64)>,
}

/// Draws `series` into a PNG file.
///
/// # Errors
/// [`ObserveError`] when the picture cannot be drawn or written.
pub fn draw_scatter(
    path: &Path,
    title: &str,
    (x_label, y_label): (&str, &str),
    series: &[Series],
) -> Result<(), ObserveError> {
    painted(title, (x_label, y_label), series)
        .map_err(|error| ObserveError::Picture { path: path.to_path_buf(), reason: error.to_string() })?
        .save(path)
}

fn painted(title: &str, labels: (&str, &str), series: &[Series]) -> Result<Canvas, DrawError> {
    let mut canvas = Canvas::new(WIDTH, HEIGHT);
    let x = decades(series, |point| point.0);
    let y = decades(series, |point| point.1);
    canvas.draw(|area| write_text(area, title, (LEFT as i32, 14), LARGE))?;
    let (across, down) = canvas.draw(|area| draw_axes(area, labels, (x.clone(), y.clone())))?;
    let share = |value: f64, range: &Range<f64>| (value / range.start).ln() / (range.end / range.start).ln();
    let place = |&(cost, error): &(f64, f64)| {
        let right = f64::from(across.start) + share(cost, &x) * (across.len() - 1) as f64;
        (right, f64::from(down.end) - share(error, &y) * down.len() as f64)
    };
    for (index, line) in series.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let points: Vec<_> = line.points.iter().filter(|p| drawable(p)).map(place).collect();
        for pair in points.windows(2) {
            canvas.line(pair[0], pair[1], LINE, colour);
        }
        for &point in &points {
            canvas.line(point, point, DOT, colour);
        }
    }
    let entry = |(index, line): (usize, &Series)| KeyEntry {
        name: line.name.clone(),
        strokes: vec![(LINE, COLOURS[index % COLOURS.len()])],
    };
    for (row, entries) in key_rows(series.iter().enumerate().map(entry))?.iter().enumerate() {
        draw_key(&mut canvas, entries, (LEFT as i32, 46 + 24 * row as i32))?;
    }
    Ok(canvas)
}

/// The entries of the key in rows that the picture has room for.
fn key_rows(entries: impl Iterator<Item = KeyEntry>) -> Result<Vec<Vec<KeyEntry>>, DrawError> {
    let mut rows: Vec<Vec<KeyEntry>> = Vec::new();
    let mut taken = 0;
    for entry in entries {
        let width = key_width(&entry)?;
        match rows.last_mut().filter(|_| LEFT + taken + width <= WIDTH) {
            Some(row) => row.push(entry),
            None => {
                rows.push(vec![entry]);
                taken = 0;
            }
        }
        taken += width;
    }
    Ok(rows)
}

fn drawable(&(cost, error): &(f64, f64)) -> bool {
    cost > 0.0 && error > 0.0 && cost.is_finite() && error.is_finite()
}

/// Whole decades around all points.
fn decades(series: &[Series], of: fn(&(f64, f64)) -> f64) -> Range<f64> {
    let values = series.iter().flat_map(|line| line.points.iter().filter(|p| drawable(p)).map(of));
    let (low, high) = values.fold((f64::INFINITY, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
    if high == 0.0 {
        return 1e-3..1.0;
    }
    let start = 10f64.powf(low.log10().floor());
    start..10f64.powf(high.log10().ceil()).max(10.0 * start)
}

fn draw_axes(
    area: &Area,
    (x_label, y_label): (&str, &str),
    (x, y): (Range<f64>, Range<f64>),
) -> Result<(Range<i32>, Range<i32>), DrawError> {
    let mut chart = ChartBuilder::on(&area.clone().shrink((0, HEAD), (WIDTH, HEIGHT - HEAD)))
        .margin_left(EDGE)
        .margin_right(2 * EDGE)
        .set_label_area_size(LabelAreaPosition::Left, LEFT - EDGE)
        .set_label_area_size(LabelAreaPosition::Bottom, 58)
        .build_cartesian_2d(x.log_scale(), y.log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .bold_line_style(BLACK.mix(0.12))
        .x_desc(x_label)
        .y_desc(y_label)
        .x_label_formatter(&|value| decade(*value))
        .y_label_formatter(&|value| decade(*value))
        .label_style((FONT, SMALL))
        .axis_desc_style((FONT, MEDIUM))
        .draw()?;
    Ok(chart.plotting_area().get_pixel_range())
}

/// A power of ten, which the axis knows but for round-off.
fn decade(value: f64) -> String {
    let exponent = value.log10().round() as i32;
    match exponent {
        -3..=4 => format!("{}", 10f64.powi(exponent)),
        _ => format!("1e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_whole_decades() {
        let labels = [9.999_999_999e-6, 1e-3, 0.1, 1.0, 1_000.000_000_1, 1e7].map(decade);
        assert_eq!(labels, ["1e-5", "0.001", "0.1", "1", "1000", "1e7"]);
    }

    #[test]
    fn axes_hold_every_point_in_whole_decades() {
        let line = Series { name: "a".into(), points: vec![(0.02, 3.0), (1.5, 0.4), (9.0, -1.0)] };
        assert_eq!(decades(std::slice::from_ref(&line), |p| p.0), 0.01..10.0);
        assert_eq!(decades(&[line], |p| p.1), 0.1..10.0);
        assert_eq!(decades(&[], |p| p.0), 1e-3..1.0);
    }

    #[test]
    fn points_are_drawn_in_the_colour_of_their_line() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scatter.png");
        let lines = [
            Series { name: "fitted 0.7".into(), points: vec![(0.1, 2.0), (1.0, 0.5)] },
            Series { name: "plain".into(), points: vec![(0.2, 9.0), (2.0, 5.0)] },
        ];
        let mut canvas = painted("t", ("cpu, s", "error, %"), &lines).unwrap();
        let red = (0..HEIGHT as i32).flat_map(|y| (0..WIDTH as i32).map(move |x| (x, y)));
        let red: Vec<_> =
            red.filter(|&(x, y)| y > HEAD as i32 && canvas.get(x, y) == [200, 40, 40]).collect();
        assert!(red.len() > 60, "{}", red.len());
        draw_scatter(&path, "t", ("cpu, s", "error, %"), &lines).unwrap();
        assert!(path.exists());
    }
}
