//! A picture in memory: plotters draws frames and text on it, fields and thin lines go straight into its pixels.

use super::{ObserveError, whole_file};
use plotters::coord::Shift;
use plotters::prelude::{BitMapBackend, DrawingArea, IntoDrawingArea};
use plotters::style::{FontStyle, RGBColor, register_font};
use std::io;
use std::path::Path;
use std::sync::Once;

/// The family that every text of a picture asks for.
pub(super) const FONT: &str = "sans-serif";

/// A subset of DejaVu Sans; its licence lies beside it. Pictures must not depend on the fonts of a machine.
static FONT_BYTES: &[u8] = include_bytes!("../../assets/DejaVuSans-Latin.ttf");

/// What plotters draws on.
pub(super) type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;

/// Why something could not be drawn; plotters has an error type for each kind of canvas.
pub(super) type DrawError = Box<dyn std::error::Error>;

/// Makes the font known to plotters; no text can be styled or measured before.
pub(super) fn bring_font() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        let registered = register_font(FONT, FontStyle::Normal, FONT_BYTES);
        assert!(registered.is_ok(), "the font that comes with the program is a font");
    });
}

/// Red, green and blue of every pixel, row after row from the top.
pub(super) struct Canvas {
    width: u32,
    height: u32,
    pixels: Vec<u8>,
}

impl Canvas {
    /// A white canvas.
    pub fn new(width: u32, height: u32) -> Self {
        bring_font();
        Canvas { width, height, pixels: vec![255; 3 * width as usize * height as usize] }
    }

    /// Lets plotters draw.
    pub fn draw<T>(&mut self, paint: impl FnOnce(&Area) -> Result<T, DrawError>) -> Result<T, DrawError> {
        let size = (self.width, self.height);
        let area = BitMapBackend::with_buffer(&mut self.pixels, size).into_drawing_area();
        let painted = paint(&area)?;
        area.present()?;
        Ok(painted)
    }

    /// Sets the pixels of a row from a column on.
    pub fn fill_row(&mut self, from: i32, row: i32, colours: impl Iterator<Item = [u8; 3]>) {
        let start = 3 * (row as usize * self.width as usize + from as usize);
        let end = 3 * (row as usize + 1) * self.width as usize;
        let (pixels, _) = self.pixels[start..end].as_chunks_mut::<3>();
        pixels.iter_mut().zip(colours).for_each(|(pixel, colour)| *pixel = colour);
    }

    /// Red, green and blue of a pixel.
    #[cfg(test)]
    pub fn get(&mut self, x: i32, y: i32) -> [u8; 3] {
        self.pixel(x, y).map(|pixel| [pixel[0], pixel[1], pixel[2]]).expect("a pixel of the canvas")
    }

    /// Draws a line between two points, given in pixels, with round ends and smooth edges.
    pub fn line(
        &mut self,
        from: (f64, f64),
        to: (f64, f64),
        width: f64,
        RGBColor(red, green, blue): RGBColor,
    ) {
        let reach = 0.5 * width + 0.5;
        let span = |one: f64, other: f64| {
            (one.min(other) - reach).floor() as i32..=(one.max(other) + reach).ceil() as i32
        };
        for y in span(from.1, to.1) {
            for x in span(from.0, to.0) {
                let cover = (reach - distance((f64::from(x), f64::from(y)), from, to)).clamp(0.0, 1.0);
                if let Some(pixel) = self.pixel(x, y).filter(|_| cover > 0.0) {
                    for (value, new) in pixel.iter_mut().zip([red, green, blue]) {
                        *value = (f64::from(*value) * (1.0 - cover) + f64::from(new) * cover).round() as u8;
                    }
                }
            }
        }
    }

    /// Writes the picture as PNG, whole or not at all.
    pub fn save(&self, path: &Path) -> Result<(), ObserveError> {
        self.encode()
            .map_err(io::Error::other)
            .and_then(|bytes| whole_file::replace(path, &bytes))
            .map_err(ObserveError::file("write", path))
    }

    fn encode(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Fastest);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()?;
        Ok(bytes)
    }

    fn pixel(&mut self, x: i32, y: i32) -> Option<&mut [u8]> {
        let (x, y) = (u32::try_from(x).ok()?, u32::try_from(y).ok()?);
        if x >= self.width || y >= self.height {
            return None;
        }
        let start = 3 * (y as usize * self.width as usize + x as usize);
        self.pixels.get_mut(start..start + 3)
    }
}

/// Distance of a point from the line between two others.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let along = (to.0 - from.0, to.1 - from.1);
    let offset = (point.0 - from.0, point.1 - from.1);
    let length_squared = along.0 * along.0 + along.1 * along.1;
    let part = if length_squared > 0.0 {
        ((offset.0 * along.0 + offset.1 * along.1) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (offset.0 - part * along.0).hypot(offset.1 - part * along.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use plotters::prelude::{BLACK, IntoFont, RED, Text};

    fn darkness(canvas: &Canvas) -> f64 {
        canvas.pixels.iter().map(|&value| f64::from(255 - value) / 255.0).sum::<f64>() / 3.0
    }

    #[test]
    fn a_line_covers_its_width_times_its_length_in_any_direction() {
        for angle in [0.0_f64, 0.4, 0.9, 1.6, 2.5] {
            let mut canvas = Canvas::new(100, 100);
            let (sine, cosine) = angle.sin_cos();
            let end = |length: f64| (50.2 + length * cosine, 49.7 + length * sine);
            canvas.line(end(-30.0), end(30.0), 3.0, BLACK);
            let expected = 60.0 * 3.0 + std::f64::consts::PI * 1.5 * 1.5;
            assert!((darkness(&canvas) / expected - 1.0).abs() < 0.03, "{}", darkness(&canvas));
        }
    }

    #[test]
    fn what_lies_outside_is_not_drawn() {
        let mut canvas = Canvas::new(10, 8);
        canvas.line((-5.0, -5.0), (30.0, -5.0), 2.0, BLACK);
        canvas.line((12.0, 0.0), (12.0, 30.0), 2.0, BLACK);
        assert_eq!(darkness(&canvas), 0.0);
        canvas.fill_row(8, 7, std::iter::repeat([0, 0, 9]));
        assert_eq!([canvas.get(7, 7), canvas.get(8, 7), canvas.get(9, 7)], [[255; 3], [0, 0, 9], [0, 0, 9]]);
        assert!(darkness(&canvas) < 2.0);
    }

    #[test]
    fn text_needs_no_font_of_the_machine() {
        let mut canvas = Canvas::new(200, 40);
        let text = Text::new("Température 1 µm²", (5, 5), (FONT, 20).into_font().color(&RED));
        canvas.draw(|area| Ok(area.draw(&text)?)).unwrap();
        assert!(darkness(&canvas) > 50.0);
    }

    #[test]
    fn the_file_is_a_png_of_the_same_pixels() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("top.png");
        let mut canvas = Canvas::new(33, 21);
        canvas.line((3.0, 3.0), (30.0, 18.0), 2.0, RED);
        canvas.save(&path).unwrap();
        let mut reader =
            png::Decoder::new(io::BufReader::new(std::fs::File::open(&path).unwrap())).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (33, 21));
        assert_eq!(pixels, canvas.pixels);
    }
}
