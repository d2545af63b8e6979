//! Draws a section: the value as colour, some of its levels as lines, both axes in millimetres and to the same scale.

use super::canvas::{Area, Canvas, DrawError, FONT};
use super::colour_field::{Window, fill_bar, fill_field};
use super::contour::contour;
use super::labels::{
    Handy, KeyEntry, LARGE, MEDIUM, SMALL, draw_key, handy, text_width, tick, with_halo, write_text,
};
use super::{ObserveError, SectionGrid};
use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::style::RGBColor;
use std::ops::Range;
use std::path::Path;

const MILLIMETRES: f64 = 1e3;
/// The largest and the least size of the field itself, in pixels.
const LARGEST: (f64, f64) = (820.0, 560.0);
const LEAST: f64 = 140.0;
/// Room for the title and the key, for the labels of each axis, and for the bar with its labels.
const HEAD: u32 = 74;
const LEFT: u32 = 86;
const FOOT: u32 = 58;
const RIGHT: u32 = 24;
const BAR: u32 = 96;
/// Room for labels of 62 pixels and their ticks.
const LABELS_OF_BAR: u32 = 70;
const EDGE: u32 = 12;
/// The width that the key needs, should the field be narrow.
const KEY: u32 = 460;

const LINES: [RGBColor; 3] = [RGBColor(255, 255, 255), RGBColor(70, 215, 255), RGBColor(140, 255, 140)];

/// Draws a section into a PNG file.
pub fn draw_section(path: &Path, grid: &SectionGrid) -> Result<(), ObserveError> {
    let failed = |reason: String| ObserveError::Picture { path: path.to_path_buf(), reason };
    let (columns, rows) = (grid.x_m.len(), grid.y_m.len());
    if columns < 2 || rows < 2 || grid.value.len() != columns * rows {
        let count = grid.value.len();
        return Err(failed(format!("a grid of {columns} x {rows} with {count} values")));
    }
    painted(grid).map_err(|error| failed(error.to_string()))?.save(path)
}

fn painted(grid: &SectionGrid) -> Result<Canvas, DrawError> {
    let field = field_size(grid);
    let content = LEFT + field.0 + RIGHT + BAR;
    let title = LEFT + text_width(&grid.title, LARGE)? + EDGE;
    let mut canvas = Canvas::new(content.max(title).max(KEY), HEAD + field.1 + FOOT);
    let range = value_range(&grid.value);
    let (window, bar) = canvas.draw(|area| draw_frames(area, grid, field, range.clone()))?;
    fill_field(&mut canvas, grid, &window, &range);
    fill_bar(&mut canvas, &bar);
    for (index, (level, _)) in grid.levels.iter().enumerate().rev() {
        draw_level(&mut canvas, grid, *level, LINES[index % LINES.len()], &window);
    }
    let own_unit = grid.quantity.rsplit(", ").next().unwrap_or_default();
    let unit = grid.levels_of.as_ref().map_or(own_unit, |(_, unit)| unit);
    let entry = |(index, (level, name)): (usize, &(f64, &str))| KeyEntry {
        // Hundredths are enough for the temperatures that levels are of.
        name: format!("{name} {} {unit}", tick(*level, 1.0)),
        strokes: with_halo(LINES[index % LINES.len()]),
    };
    let entries: Vec<_> = grid.levels.iter().enumerate().map(entry).collect();
    draw_key(&mut canvas, &entries, (LEFT as i32, 46))?;
    Ok(canvas)
}

/// The size of the field in pixels: both axes to the same scale, unless one would become too small to see.
fn field_size(grid: &SectionGrid) -> (u32, u32) {
    let (width_m, height_m) = (extent(&grid.x_m), extent(&grid.y_m));
    let scale = (LARGEST.0 / width_m).min(LARGEST.1 / height_m);
    ((scale * width_m).max(LEAST).round() as u32, (scale * height_m).max(LEAST).round() as u32)
}

/// Draws title, axes and bar, and tells where field and bar go.
fn draw_frames(
    area: &Area,
    grid: &SectionGrid,
    field: (u32, u32),
    range: Range<f64>,
) -> Result<(Window, Window), DrawError> {
    write_text(area, &grid.title, (LEFT as i32, 14), LARGE)?;
    let (x_mm, y_mm) = (millimetres(&grid.x_m), millimetres(&grid.y_m));
    let (across_mm, up_mm) = (x_mm.end - x_mm.start, y_mm.end - y_mm.start);
    let size = (LEFT + field.0, field.1 + FOOT);
    let mut chart = ChartBuilder::on(&area.clone().shrink((0, HEAD), size))
        .margin_left(EDGE)
        .set_label_area_size(LabelAreaPosition::Left, LEFT - EDGE)
        .set_label_area_size(LabelAreaPosition::Bottom, FOOT)
        .build_cartesian_2d(x_mm, y_mm)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc(format!("{}, mm", grid.x_label))
        .y_desc(format!("{}, mm", grid.y_label))
        .x_labels((field.0 / 70) as usize)
        .y_labels((field.1 / 45) as usize)
        .x_label_formatter(&|value| tick(*value, across_mm))
        .y_label_formatter(&|value| tick(*value, up_mm))
        .label_style((FONT, SMALL))
        .axis_desc_style((FONT, MEDIUM))
        .draw()?;
    let bar_at = (LEFT + field.0 + RIGHT, HEAD);
    let Handy { name, factor } = handy(grid.quantity, range.start.abs().max(range.end.abs()));
    let (low, high) = (factor * range.start, factor * range.end);
    let mut bar = ChartBuilder::on(&area.clone().shrink(bar_at, (BAR, field.1)))
        .set_label_area_size(LabelAreaPosition::Right, LABELS_OF_BAR)
        .build_cartesian_2d(0.0..1.0, low..high)?;
    bar.configure_mesh()
        .disable_mesh()
        .disable_x_axis()
        .y_labels((field.1 / 45) as usize)
        .y_label_formatter(&|value| tick(*value, high - low))
        .label_style((FONT, SMALL))
        .set_tick_mark_size(LabelAreaPosition::Right, 8)
        .draw()?;
    // Below the bar, and inside the picture however long it is.
    let right = area.dim_in_pixel().0 as i32 - text_width(&name, SMALL)? as i32 - EDGE as i32;
    let label_at = (right.min(bar_at.0 as i32 - 16), (HEAD + field.1) as i32 + 24);
    write_text(area, &name, label_at, SMALL)?;
    Ok((chart.plotting_area().get_pixel_range(), bar.plotting_area().get_pixel_range()))
}

fn draw_level(canvas: &mut Canvas, grid: &SectionGrid, level: f64, line: RGBColor, (across, down): &Window) {
    let columns = grid.x_m.len();
    let scale_x = (across.len() - 1) as f64 / (columns - 1) as f64;
    let scale_y = (down.len() - 1) as f64 / (grid.y_m.len() - 1) as f64;
    let place = |(column, row): (f64, f64)| {
        (f64::from(across.start) + scale_x * column, f64::from(down.end - 1) - scale_y * row)
    };
    let field = grid.levels_of.as_ref().map_or(&grid.value, |(field, _)| field);
    let pieces = contour(field, columns, level);
    // The whole halo first: the halo of a piece must not cover the line of its neighbour.
    for (width, colour) in with_halo(line) {
        pieces.iter().for_each(|&[from, to]| canvas.line(place(from), place(to), width, colour));
    }
}

fn value_range(values: &[f64]) -> Range<f64> {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
    match high - low {
        spread if spread >= 1e-3 * high.abs() && spread > 0.0 => low..high,
        // One value everywhere, or no part at all: a bar needs a range all the same.
        spread if spread >= 0.0 => {
            let half = if high == 0.0 { 0.5 } else { 1e-3 * high.abs() };
            low - half..high + half
        }
        _ => 0.0..1.0,
    }
}

fn extent(ascending: &[f64]) -> f64 {
    ascending[ascending.len() - 1] - ascending[0]
}

fn millimetres(ascending_m: &[f64]) -> Range<f64> {
    ascending_m[0] * MILLIMETRES..ascending_m[ascending_m.len() - 1] * MILLIMETRES
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_axes_have_one_scale() {
        let (width, height) = field_size(&SectionGrid::example());
        assert_eq!((width, height), (820, 410));
        let long = SectionGrid { x_m: vec![0.0, 1.0], y_m: vec![0.0, 1e-3], ..SectionGrid::example() };
        assert_eq!(field_size(&long), (820, LEAST as u32));
    }

    #[test]
    fn the_range_holds_for_a_cold_part_and_for_none() {
        assert_eq!(value_range(&[300.0, f64::NAN, 900.0]), 300.0..900.0);
        assert_eq!(value_range(&[300.0, 300.0]), 299.7..300.3);
        assert_eq!(value_range(&[0.0, 0.0]), -0.5..0.5);
        assert_eq!(value_range(&[f64::NAN]), 0.0..1.0);
    }

    #[test]
    fn a_grid_that_does_not_fit_its_values_is_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("section.png");
        let wrong = SectionGrid { x_m: vec![0.0, 1.0], ..SectionGrid::example() };
        let error = draw_section(&path, &wrong).unwrap_err().to_string();
        assert!(error.contains("section.png") && error.contains("2 x 41 with 3321"), "{error}");
        draw_section(&path, &SectionGrid::example()).unwrap();
        assert!(path.metadata().unwrap().len() > 10_000);
    }
}
