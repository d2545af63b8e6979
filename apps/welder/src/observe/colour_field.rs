//! Fills parts of a picture with the colours of values.

use super::SectionGrid;
use super::canvas::Canvas;
use std::ops::Range;

const SHADES: usize = 512;
const OUTSIDE: [u8; 3] = [225, 225, 225];

/// The part of the canvas, in pixels, that a chart fills with its content.
pub(super) type Window = (Range<i32>, Range<i32>);

/// Colours every pixel of the field by the value between the grid points around it.
pub(super) fn fill_field(
    canvas: &mut Canvas,
    grid: &SectionGrid,
    (across, down): &Window,
    range: &Range<f64>,
) {
    let columns = grid.x_m.len();
    let along_x: Vec<_> = (0..across.len()).map(|pixel| neighbours(pixel, across.len(), columns)).collect();
    let colours = colours();
    let per_unit = 1.0 / (range.end - range.start);
    for y in down.clone() {
        let (row, up) = neighbours((down.end - 1 - y) as usize, down.len(), grid.y_m.len());
        let low = &grid.value[row * columns..][..columns];
        let high = &grid.value[(row + 1) * columns..][..columns];
        let value = |&(left, part): &(usize, f64)| {
            let below = low[left] + part * (low[left + 1] - low[left]);
            let above = high[left] + part * (high[left + 1] - high[left]);
            below + up * (above - below)
        };
        let share = |place| (value(place) - range.start) * per_unit;
        canvas.fill_row(across.start, y, along_x.iter().map(|place| colour(&colours, share(place))));
    }
}

/// Fills the colour bar, least below.
pub(super) fn fill_bar(canvas: &mut Canvas, (across, down): &Window) {
    let colours = colours();
    for y in down.clone() {
        let share = f64::from(down.end - 1 - y) / (down.len() - 1) as f64;
        canvas.fill_row(across.start, y, across.clone().map(|_| colour(&colours, share)));
    }
}

/// The grid point before a pixel, and how far the pixel is on the way to the next one.
fn neighbours(pixel: usize, pixels: usize, points: usize) -> (usize, f64) {
    let place = pixel as f64 / (pixels - 1) as f64 * (points - 1) as f64;
    let before = (place as usize).min(points - 2);
    (before, place - before as f64)
}

/// The scale of colours, from the least to the largest: working one out for each pixel would take too long.
fn colours() -> Vec<[u8; 3]> {
    let colour = |index: usize| colorous::INFERNO.eval_rational(index, SHADES).as_array();
    (0..SHADES).map(colour).collect()
}

/// The colour of a share of the range; not a number is outside the part.
fn colour(colours: &[[u8; 3]], share: f64) -> [u8; 3] {
    if share.is_nan() {
        return OUTSIDE;
    }
    // A negative number becomes zero.
    colours[((share * SHADES as f64) as usize).min(SHADES - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_field_stands_the_right_way_up() {
        let grid = SectionGrid::example();
        let mut canvas = Canvas::new(101, 51);
        fill_field(&mut canvas, &grid, &(0..101, 0..51), &(293.0..1493.0));
        // The hottest point is in the middle of the upper edge, the corners below are cold.
        let colours = colours();
        assert_eq!(canvas.get(50, 0), colours[SHADES - 1]);
        assert_eq!([canvas.get(0, 50), canvas.get(100, 50)], [colours[0]; 2]);
        // Half way between two rows of the grid the colour is between theirs.
        let between_k = 0.5 * (grid.value[30 * 81 + 40] + grid.value[31 * 81 + 40]);
        let mut fine = Canvas::new(101, 81);
        fill_field(&mut fine, &grid, &(0..101, 0..81), &(293.0..1493.0));
        assert_eq!(fine.get(50, 80 - 61), colour(&colours, (between_k - 293.0) / 1200.0));
    }

    #[test]
    fn outside_the_part_and_beyond_the_range_have_their_colours() {
        let colours = colours();
        assert_eq!(colour(&colours, f64::NAN), OUTSIDE);
        assert_eq!([colour(&colours, -3.0), colour(&colours, 2.0)], [colours[0], colours[SHADES - 1]]);
    }
}
