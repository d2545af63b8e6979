//! Text on pictures: sizes, numbers, and the key that names the lines.

use super::canvas::{Area, Canvas, DrawError, FONT, bring_font};
use plotters::prelude::{IntoFont, Text};
use plotters::style::{BLACK, RGBColor};

/// Heights of text in pixels: tick labels and keys, axes, titles.
pub(super) const SMALL: i32 = 16;
pub(super) const MEDIUM: i32 = 18;
pub(super) const LARGE: i32 = 22;

/// The edge that makes a light line stand out from any ground.
pub(super) const HALO: RGBColor = RGBColor(20, 20, 20);

/// One line in a key: its name and its strokes, lowest first, as width and colour.
pub(super) struct KeyEntry {
    pub name: String,
    pub strokes: Vec<(f64, RGBColor)>,
}

/// The strokes of a light line on a dark or coloured ground.
pub(super) fn with_halo(colour: RGBColor) -> Vec<(f64, RGBColor)> {
    vec![(5.0, HALO), (2.0, colour)]
}

/// Writes text with its upper left corner at a place.
pub(super) fn write_text(area: &Area, text: &str, at: (i32, i32), size: i32) -> Result<(), DrawError> {
    Ok(area.draw(&Text::new(text, at, (FONT, size).into_font().color(&BLACK)))?)
}

/// How wide text of a size will be, in pixels.
pub(super) fn text_width(text: &str, size: i32) -> Result<u32, DrawError> {
    bring_font();
    Ok((FONT, size).into_font().box_size(text)?.0)
}

/// Length of a line in a key, and the gap between it and its name \[pixels\].
const SAMPLE: i32 = 26;
const GAP: i32 = 9;

/// How wide an entry of a key will be, with the gap to the next, in pixels.
pub(super) fn key_width(entry: &KeyEntry) -> Result<u32, DrawError> {
    Ok((SAMPLE + 4 * GAP) as u32 + text_width(&entry.name, SMALL)?)
}

/// Draws a key in a row that starts at a place.
pub(super) fn draw_key(canvas: &mut Canvas, entries: &[KeyEntry], at: (i32, i32)) -> Result<(), DrawError> {
    let mut x = at.0;
    for entry in entries {
        // Text sits high in its line.
        let middle = f64::from(at.1 + SMALL / 2 - 3);
        for &(width, colour) in &entry.strokes {
            let (from, to) = (f64::from(x) + 3.0, f64::from(x + SAMPLE) - 3.0);
            canvas.line((from, middle), (to, middle), width, colour);
        }
        canvas.draw(|area| write_text(area, &entry.name, (x + SAMPLE + GAP, at.1), SMALL))?;
        x += key_width(entry)? as i32;
    }
    Ok(())
}

/// A number with as many digits as it needs, and no more than a label has room for.
pub(super) fn tidy(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.replace('-', "\u{2212}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_have_no_stray_digits() {
        assert_eq!(tidy(0.1 + 0.2), "0.3");
        assert_eq!(tidy(-1e-17), "0");
        assert_eq!(tidy(-0.25), "\u{2212}0.25");
        assert_eq!(tidy(1200.0), "1200");
    }

    #[test]
    fn entries_of_a_key_stand_side_by_side_with_strokes_in_order() {
        let mut canvas = Canvas::new(400, 40);
        let red = RGBColor(255, 0, 0);
        let entry = |name: &str| KeyEntry { name: name.to_string(), strokes: with_halo(red) };
        let names = ["liquidus 933 K", "solidus 823 K"];
        draw_key(&mut canvas, &names.map(entry), (10, 10)).unwrap();
        let second = 10 + 26 + 36 + text_width(names[0], SMALL).unwrap() as i32;
        for x in [10 + 13, second + 13] {
            assert_eq!(canvas.get(x, 15), [255, 0, 0]);
            assert_eq!(canvas.get(x, 17), [20, 20, 20]);
            assert_eq!(canvas.get(x, 21), [255, 255, 255]);
        }
    }
}
