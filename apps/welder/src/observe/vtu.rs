//! VTK XML files of particles (`.vtu`): each particle is a vertex cell; arrays are compressed (zlib) and inline.
//!
//! An array is base64 of `[blocks, block bytes, last block bytes, compressed bytes]` (u64 each), followed by base64
//! of the compressed bytes, as "VTK XML Formats" of the VTK documentation lays down; one block holds it all.

use super::{Field, Values};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::{Compression, write::ZlibEncoder};
use nalgebra::SVector;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

/// VTK's number for a cell that is a single point.
const VERTEX_CELL: u8 = 1;

/// How many bits of each number a frame keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Precision {
    /// 32 bits: seven digits, enough to look at.
    #[default]
    Float32,
    /// 64 bits: every digit.
    Float64,
}

impl Precision {
    fn vtk_name(self) -> &'static str {
        match self {
            Precision::Float32 => "Float32",
            Precision::Float64 => "Float64",
        }
    }

    fn append(self, bytes: &mut Vec<u8>, number: f64) {
        match self {
            Precision::Float32 => bytes.extend_from_slice(&(number as f32).to_le_bytes()),
            Precision::Float64 => bytes.extend_from_slice(&number.to_le_bytes()),
        }
    }
}

/// The bytes of a file that holds these particles and fields.
pub fn encode_points<const D: usize>(
    positions_m: &[SVector<f64, D>],
    fields: &[Field<D>],
    precision: Precision,
) -> io::Result<Vec<u8>> {
    let mut xml = Writer::new(Vec::new());
    xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let (format, count) = (root_attributes("UnstructuredGrid"), positions_m.len().to_string());
    xml.create_element("VTKFile").with_attributes(format).write_inner_content(|xml| {
        xml.create_element("UnstructuredGrid").write_inner_content(|xml| {
            let size = [("NumberOfPoints", count.as_str()), ("NumberOfCells", count.as_str())];
            xml.create_element("Piece").with_attributes(size).write_inner_content(|xml| {
                write_fields(xml, fields, precision)?;
                xml.create_element("Points").write_inner_content(|xml| {
                    write_array(xml, "position_m", precision.vtk_name(), 3, &vectors(positions_m, precision))
                })?;
                write_cells(xml, positions_m.len())
            })?;
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(xml.into_inner())
}

/// The attributes of the root element of a VTK XML file.
pub(super) fn root_attributes(kind: &str) -> [(&str, &str); 5] {
    [
        ("type", kind),
        ("version", "1.0"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
        ("compressor", "vtkZLibDataCompressor"),
    ]
}

fn write_fields<const D: usize>(
    xml: &mut Writer<Vec<u8>>,
    fields: &[Field<D>],
    precision: Precision,
) -> io::Result<()> {
    xml.create_element("PointData").write_inner_content(|xml| {
        for field in fields {
            let (kind, components, bytes) = match field.values {
                Values::Scalar(values) => (precision.vtk_name(), 1, scalars(values, precision)),
                Values::Vector(values) => (precision.vtk_name(), 3, vectors(values, precision)),
                Values::Triple(values) => {
                    (precision.vtk_name(), 3, scalars(values.as_flattened(), precision))
                }
                Values::Byte(values) => ("UInt8", 1, values.to_vec()),
            };
            write_array(xml, field.name, kind, components, &bytes)?;
        }
        Ok(())
    })?;
    Ok(())
}

fn write_cells(xml: &mut Writer<Vec<u8>>, count: usize) -> io::Result<()> {
    let points: Vec<u8> = (0..count as u32).flat_map(u32::to_le_bytes).collect();
    let ends: Vec<u8> = (1..=count as u32).flat_map(u32::to_le_bytes).collect();
    xml.create_element("Cells").write_inner_content(|xml| {
        write_array(xml, "connectivity", "Int32", 1, &points)?;
        write_array(xml, "offsets", "Int32", 1, &ends)?;
        write_array(xml, "types", "UInt8", 1, &vec![VERTEX_CELL; count])
    })?;
    Ok(())
}

fn write_array(
    xml: &mut Writer<Vec<u8>>,
    name: &str,
    kind: &str,
    components: usize,
    bytes: &[u8],
) -> io::Result<()> {
    let components = components.to_string();
    let attributes =
        [("type", kind), ("Name", name), ("NumberOfComponents", components.as_str()), ("format", "binary")];
    let text = compressed_text(bytes)?;
    xml.create_element("DataArray")
        .with_attributes(attributes)
        .write_text_content(BytesText::from_escaped(text))?;
    Ok(())
}

fn compressed_text(bytes: &[u8]) -> io::Result<String> {
    let mut encoder = ZlibEncoder::new(Vec::with_capacity(bytes.len() / 2), Compression::fast());
    encoder.write_all(bytes)?;
    let compressed = encoder.finish()?;
    let length = bytes.len() as u64;
    let header: Vec<u8> =
        [1, length, length, compressed.len() as u64].into_iter().flat_map(u64::to_le_bytes).collect();
    let mut text = STANDARD.encode(header);
    STANDARD.encode_string(compressed, &mut text);
    Ok(text)
}

fn scalars(values: &[f64], precision: Precision) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(8 * values.len());
    values.iter().for_each(|&value| precision.append(&mut bytes, value));
    bytes
}

/// Vectors with three components each, the missing ones zero.
fn vectors<const D: usize>(values: &[SVector<f64, D>], precision: Precision) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(24 * values.len());
    for value in values {
        (0..3).for_each(|axis| precision.append(&mut bytes, value.get(axis).copied().unwrap_or(0.0)));
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    /// The bytes of the array of a name, and its attributes, found without the XML library.
    fn array<'a>(file: &'a str, name: &str) -> (&'a str, Vec<u8>) {
        let start = file.find(&format!("Name=\"{name}\"")).unwrap();
        let (attributes, rest) = file[start..].split_once('>').unwrap();
        let text = rest.split_once('<').unwrap().0;
        let header = STANDARD.decode(&text[..44]).unwrap();
        let header: Vec<u64> =
            header.chunks(8).map(|word| u64::from_le_bytes(word.try_into().unwrap())).collect();
        let compressed = STANDARD.decode(&text[44..]).unwrap();
        let mut bytes = Vec::new();
        flate2::write::ZlibDecoder::new(&mut bytes).write_all(&compressed).unwrap();
        assert_eq!(header, [1, bytes.len() as u64, bytes.len() as u64, compressed.len() as u64]);
        (attributes, bytes)
    }

    fn encoded(precision: Precision) -> String {
        let positions_m = [Vector2::new(0.1, 0.2), Vector2::new(-0.3, 1e-5)];
        let velocities = [Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0)];
        let fields = [
            Field { name: "temperature_k", values: Values::Scalar(&[293.15, f64::NAN]) },
            Field { name: "velocity_m_s", values: Values::Vector(&velocities) },
            Field {
                name: "principal_stress_pa",
                values: Values::Triple(&[[3.0, 0.5, -1.0], [6.0, 0.0, -2.0]]),
            },
            Field { name: "phase", values: Values::Byte(&[0, 2]) },
        ];
        String::from_utf8(encode_points(&positions_m, &fields, precision).unwrap()).unwrap()
    }

    #[test]
    fn doubles_keep_every_bit_and_the_plane_gets_a_zero() {
        let file = encoded(Precision::Float64);
        let (attributes, bytes) = array(&file, "position_m");
        let numbers: Vec<f64> =
            bytes.chunks(8).map(|word| f64::from_le_bytes(word.try_into().unwrap())).collect();
        assert_eq!(numbers, [0.1, 0.2, 0.0, -0.3, 1e-5, 0.0]);
        assert!(attributes.contains("NumberOfComponents=\"3\""), "{attributes}");
        let (_, bytes) = array(&file, "temperature_k");
        assert_eq!(bytes, [293.15_f64.to_le_bytes(), f64::NAN.to_le_bytes()].concat());
    }

    #[test]
    fn singles_and_bytes_say_what_they_are() {
        let file = encoded(Precision::Float32);
        let (_, bytes) = array(&file, "velocity_m_s");
        let expected: Vec<u8> =
            [1.0_f32, 2.0, 0.0, 3.0, 4.0, 0.0].into_iter().flat_map(f32::to_le_bytes).collect();
        assert_eq!(bytes, expected);
        assert!(file.contains("type=\"Float32\" Name=\"velocity_m_s\""));
        let (attributes, bytes) = array(&file, "principal_stress_pa");
        let expected = [3.0_f32, 0.5, -1.0, 6.0, 0.0, -2.0].map(f32::to_le_bytes);
        assert!(
            bytes == expected.as_flattened() && attributes.contains("NumberOfComponents=\"3\""),
            "{attributes}"
        );
        assert!(file.contains("type=\"UInt8\" Name=\"phase\""));
        assert_eq!(array(&file, "phase").1, [0, 2]);
    }

    #[test]
    fn every_particle_is_a_vertex() {
        let file = encoded(Precision::Float32);
        assert!(file.contains("NumberOfPoints=\"2\" NumberOfCells=\"2\""));
        assert_eq!(array(&file, "connectivity").1, [0, 0, 0, 0, 1, 0, 0, 0]);
        assert_eq!(array(&file, "offsets").1, [1, 0, 0, 0, 2, 0, 0, 0]);
        assert_eq!(array(&file, "types").1, [1, 1]);
    }
}
