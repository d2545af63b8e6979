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

/// Prefixes of units, a thousand apart, and the place of the one that is none.
const PREFIXES: [&str; 9] = ["p", "n", "\u{b5}", "m", "", "k", "M", "G", "T"];
const NONE: i32 = 4;

/// A quantity in the multiple of its unit that gives handy numbers.
#[derive(Debug, PartialEq)]
pub(super) struct Handy {
    /// Its name with that unit, such as "stress, MPa".
    pub name: String,
    /// What its values are multiplied by.
    pub factor: f64,
}

/// A quantity named with its SI unit, such as "stress, Pa", whose `largest` value gets one to three digits before the point; one
/// of four digits stays as it is. Without a unit, as "plastic strain", a power of ten stands for it.
pub(super) fn handy(quantity: &str, largest: f64) -> Handy {
    let size = largest.abs();
    let is_handy = size == 0.0 || !size.is_finite() || (1.0..1e4).contains(&size);
    let thousands = if is_handy { 0 } else { ((size.log10() / 3.0).floor() as i32).clamp(-NONE, NONE) };
    let name = match quantity.rsplit_once(", ") {
        _ if thousands == 0 => quantity.to_string(),
        Some((name, unit)) => format!("{name}, {}{unit}", PREFIXES[(thousands + NONE) as usize]),
        None => format!("{quantity}, 1e{}", 3 * thousands),
    };
    Handy { name, factor: 10f64.powi(-3 * thousands) }
}

/// A number on an axis of the length `span`: with the digits that tell a hundredth of it, and none that say nothing.
pub(super) fn tick(value: f64, span: f64) -> String {
    let digits = (2.0 - span.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.digits$}");
    let text = if digits > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_string() } else { text.replace('-', "\u{2212}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plotters::coord::ranged1d::Ranged;
    use plotters::coord::types::RangedCoordf64;

    #[test]
    fn labels_have_no_stray_digits() {
        assert_eq!(tick(0.1 + 0.2, 1.0), "0.3");
        assert_eq!(tick(-1e-17, 1.0), "0");
        assert_eq!(tick(-0.25, 1.0), "\u{2212}0.25");
        assert_eq!(tick(1200.0, 5000.0), "1200");
    }

    #[test]
    fn a_label_tells_what_its_axis_tells_apart() {
        assert_eq!([0.3262, 0.3284].map(|value| tick(value, 0.02)), ["0.3262", "0.3284"]);
        assert_eq!([933.0, 933.5].map(|value| tick(value, 3.0)), ["933", "933.5"]);
        assert_eq!(tick(40.0, 90.0), "40");
    }

    #[test]
    fn quantities_come_in_handy_units() {
        let found = |quantity, largest| {
            let handy = handy(quantity, largest);
            (handy.name, (1e3 * handy.factor * largest).round())
        };
        let expected = |name: &str, value| (name.to_string(), value);
        assert_eq!(found("von Mises stress, Pa", 9.6e7), expected("von Mises stress, MPa", 96e3));
        assert_eq!(found("speed, m/s", 3.26e-4), expected("speed, \u{b5}m/s", 326e3));
        assert_eq!(found("pressure, Pa", -2.34e4), expected("pressure, kPa", -23_400.0));
        assert_eq!(found("temperature, K", 2743.0), expected("temperature, K", 2_743_000.0));
        assert_eq!(found("plastic strain", 4.5e-3), expected("plastic strain, 1e-3", 4500.0));
        assert_eq!(found("speed, m/s", 0.0), expected("speed, m/s", 0.0));
        assert_eq!(handy("strain", f64::NAN).factor, 1.0);
    }

    /// As many ticks as a bar can have, from its least to its largest value, whatever their size and distance.
    #[test]
    fn the_ticks_of_a_bar_differ_and_fit_beside_it() {
        for exponent in -11..12 {
            for (low, high) in [(0.0, 9.99), (3.262, 3.284), (-9.99, 2.0), (-1.003, -1.0), (9.97, 9.99)] {
                let (low, high) = (low * 10f64.powi(exponent), high * 10f64.powi(exponent));
                let factor = handy("q, m", low.abs().max(high)).factor;
                let (low, high) = (factor * low, factor * high);
                let points = RangedCoordf64::from(low..high).key_points(12);
                let labels: Vec<String> = points.iter().map(|&value| tick(value, high - low)).collect();
                assert!(labels.len() > 3 && labels.windows(2).all(|pair| pair[0] != pair[1]), "{labels:?}");
                for (label, value) in labels.iter().zip(&points) {
                    let said: f64 = label.replace('\u{2212}', "-").parse().unwrap();
                    assert!((said - value).abs() < 1e-3 * (high - low), "{label} for {value}");
                    assert!(text_width(label, SMALL).unwrap() <= 62, "{label} in {labels:?}");
                }
            }
        }
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
