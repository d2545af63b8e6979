//! `frames.pvd`: the list of frames and their times that ParaView opens as one animation.

use super::{ObserveError, vtu, whole_file};
use quick_xml::events::{BytesDecl, BytesStart, Event};
use quick_xml::{Reader, Writer, XmlVersion};
use std::fs;
use std::io;
use std::path::PathBuf;

/// The frames so far; their files are numbered in the order of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameList {
    path: PathBuf,
    times_s: Vec<f64>,
}

impl FrameList {
    /// An empty list that will be written to `path`.
    pub fn new(path: PathBuf) -> Self {
        FrameList { path, times_s: Vec::new() }
    }

    /// Reads the list at `path`.
    pub fn read(path: PathBuf) -> Result<Self, ObserveError> {
        let text = fs::read_to_string(&path).map_err(ObserveError::file("read", &path))?;
        match parse_times(&text) {
            Ok(times_s) => Ok(FrameList { path, times_s }),
            Err(reason) => Err(ObserveError::FrameList { path, reason }),
        }
    }

    /// Where the file of a frame lies, seen from the folder of the list.
    pub fn file_name(index: usize) -> String {
        format!("frames/frame_{index:06}.vtu")
    }

    /// The times of the frames.
    pub fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// Keeps the first frames, as long as `keeps` holds for their times.
    pub fn keep_while(&mut self, keeps: impl Fn(f64) -> bool) {
        let kept = self.times_s.iter().take_while(|&&time_s| keeps(time_s)).count();
        self.times_s.truncate(kept);
    }

    /// Adds a frame, and writes the list whole or not at all.
    pub fn push(&mut self, time_s: f64) -> Result<(), ObserveError> {
        self.times_s.push(time_s);
        let written = self.encode().and_then(|bytes| whole_file::replace(&self.path, &bytes));
        written.map_err(ObserveError::file("write", &self.path))
    }

    fn encode(&self) -> io::Result<Vec<u8>> {
        let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
        xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
        let format = vtu::root_attributes("Collection");
        xml.create_element("VTKFile").with_attributes(format).write_inner_content(|xml| {
            xml.create_element("Collection").write_inner_content(|xml| {
                for (index, time_s) in self.times_s.iter().enumerate() {
                    let (time, file) = (time_s.to_string(), FrameList::file_name(index));
                    let attributes = [("timestep", time.as_str()), ("part", "0"), ("file", file.as_str())];
                    xml.create_element("DataSet").with_attributes(attributes).write_empty()?;
                }
                Ok(())
            })?;
            Ok(())
        })?;
        Ok(xml.into_inner())
    }
}

fn parse_times(text: &str) -> Result<Vec<f64>, String> {
    let mut reader = Reader::from_str(text);
    let mut times_s = Vec::new();
    loop {
        match reader.read_event().map_err(|error| error.to_string())? {
            Event::Empty(element) | Event::Start(element) if element.name().as_ref() == "DataSet" => {
                let file = attribute(&element, "file")?;
                if file != FrameList::file_name(times_s.len()) {
                    return Err(format!("frame {} is in {file}", times_s.len()));
                }
                let time = attribute(&element, "timestep")?;
                times_s.push(time.parse().map_err(|_| format!("`{time}` is not a time"))?);
            }
            Event::Eof => return Ok(times_s),
            _ => {}
        }
    }
}

fn attribute(element: &BytesStart, name: &str) -> Result<String, String> {
    let found = element.try_get_attribute(name).map_err(|error| error.to_string())?;
    let found = found.ok_or_else(|| format!("a frame without `{name}`"))?;
    let value = found.normalized_value(XmlVersion::Explicit1_0).map_err(|error| error.to_string())?;
    Ok(value.into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_comes_back_to_the_last_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frames.pvd");
        let mut list = FrameList::new(path.clone());
        for time_s in [0.0, 0.1 + 0.2, 1e-7 / 3.0 + 1.0, 1e20] {
            list.push(time_s).unwrap();
        }
        assert_eq!(FrameList::read(path).unwrap(), list);
        list.keep_while(|time_s| time_s < 1.0);
        assert_eq!(list.times_s(), [0.0, 0.1 + 0.2]);
    }

    #[test]
    fn a_list_that_cannot_be_continued_is_refused_with_its_name_and_the_reason() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frames.pvd");
        for (text, reason) in [
            ("<VTKFile><Collection><DataSet file='frames/frame_000000.vtu'/>", "without `timestep`"),
            ("<DataSet timestep='soon' file='frames/frame_000000.vtu'/>", "`soon` is not a time"),
            ("<DataSet timestep='0' file='other.vtu'/>", "frame 0 is in other.vtu"),
            ("<VTKFile></Collection>", "Collection"),
        ] {
            fs::write(&path, text).unwrap();
            let error = FrameList::read(path.clone()).unwrap_err().to_string();
            assert!(error.contains("frames.pvd") && error.contains(reason), "{error}");
        }
    }
}
