//! Frames for ParaView and pyvista: `frames/frame_000000.vtu` and so on, listed in `frames.pvd`.

use super::frame_list::FrameList;
use super::vtu::{self, Precision};
use super::{Field, ObserveError, Observer, Schedule, View, whole_file};
use std::fs;
use std::path::{Path, PathBuf};

/// Writes a frame each interval, one at the start and one at the end.
///
/// A fresh run removes the frames of an earlier run in the same folder; a resumed one (its first view has a step
/// above zero) goes on after the last frame that the unbroken run would have at that moment.
pub struct FrameWriter {
    folder: PathBuf,
    schedule: Schedule,
    field_names: Vec<String>,
    precision: Precision,
    list: FrameList,
}

impl FrameWriter {
    /// Frames below `run_folder` with the fields of these names, such as `temperature_k`.
    pub fn new(run_folder: &Path, interval_s: f64, field_names: Vec<String>, precision: Precision) -> Self {
        let list = FrameList::new(run_folder.join("frames.pvd"));
        let schedule = Schedule::new(interval_s);
        FrameWriter { folder: run_folder.to_path_buf(), schedule, field_names, precision, list }
    }

    fn take_up(&mut self, resumed_at_s: Option<f64>) -> Result<(), ObserveError> {
        let list_path = self.folder.join("frames.pvd");
        if let Some(now_s) = resumed_at_s.filter(|_| list_path.exists()) {
            self.list = FrameList::read(list_path)?;
            self.list.keep_while(|time_s| time_s <= now_s && self.schedule.contains(time_s));
        }
        let frames = self.folder.join("frames");
        fs::create_dir_all(&frames).map_err(ObserveError::file("create", &frames))?;
        remove_frames_from(self.list.times_s().len(), &frames)
    }

    fn write<const D: usize>(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.schedule.advance_past(view.time_s);
        if self.list.times_s().last() == Some(&view.time_s) {
            return Ok(());
        }
        let path = self.folder.join(FrameList::file_name(self.list.times_s().len()));
        let fields = chosen_fields(&self.field_names, &view.fields)?;
        vtu::encode_points(view.positions_m, &fields, self.precision)
            .and_then(|bytes| whole_file::replace(&path, &bytes))
            .map_err(ObserveError::file("write", &path))?;
        self.list.push(view.time_s)
    }
}

impl<const D: usize> Observer<D> for FrameWriter {
    fn next_time_s(&self) -> Option<f64> {
        self.schedule.next_time_s()
    }

    fn init(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.take_up((view.step > 0).then_some(view.time_s))?;
        if self.schedule.contains(view.time_s) {
            return self.write(view);
        }
        self.schedule.advance_past(view.time_s);
        Ok(())
    }

    fn every(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        if self.schedule.is_due(view.time_s) { self.write(view) } else { Ok(()) }
    }

    fn finish(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.write(view)
    }
}

fn chosen_fields<'a, const D: usize>(
    names: &[String],
    fields: &[Field<'a, D>],
) -> Result<Vec<Field<'a, D>>, ObserveError> {
    let choose = |name: &String| {
        let known = || fields.iter().map(|field| field.name).collect::<Vec<_>>().join(", ");
        let unknown = || ObserveError::UnknownField { name: name.clone(), known: known() };
        fields.iter().find(|field| field.name == name).copied().ok_or_else(unknown)
    };
    names.iter().map(choose).collect()
}

/// Removes the frames of this number and above, and nothing else.
fn remove_frames_from(first: usize, folder: &Path) -> Result<(), ObserveError> {
    for entry in fs::read_dir(folder).map_err(ObserveError::file("list", folder))? {
        let path = entry.map_err(ObserveError::file("list", folder))?.path();
        if index_of(&path).is_some_and(|index| index >= first) || whole_file::is_leftover(&path) {
            fs::remove_file(&path).map_err(ObserveError::file("remove", &path))?;
        }
    }
    Ok(())
}

fn index_of(path: &Path) -> Option<usize> {
    path.file_name()?.to_str()?.strip_prefix("frame_")?.strip_suffix(".vtu")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::Values;
    use nalgebra::Vector3;

    const POSITIONS_M: [Vector3<f64>; 2] = [Vector3::new(0.0, 0.0, 0.0), Vector3::new(1.0, 0.0, 0.0)];

    fn view<'a>(time_s: f64, step: u64, temperatures_k: &'a [f64]) -> View<'a, 3> {
        View {
            positions_m: &POSITIONS_M,
            spacing_m: &[1.0, 1.0],
            fields: vec![Field { name: "temperature_k", values: Values::Scalar(temperatures_k) }],
            ..View::bare(time_s, step)
        }
    }

    fn writer(folder: &Path) -> FrameWriter {
        FrameWriter::new(folder, 0.25, vec!["temperature_k".into()], Precision::Float64)
    }

    /// Runs from a step to a step of a tenth of a second that also lands on the frames.
    fn run(folder: &Path, steps: std::ops::RangeInclusive<u64>) {
        let mut frames = writer(folder);
        let (first, last) = (*steps.start(), *steps.end());
        for step in steps {
            let time_s = step as f64 * 0.05;
            let temperatures_k = [300.0 + time_s, 300.0];
            let view = view(time_s, step, &temperatures_k);
            if step == first {
                frames.init(&view).unwrap()
            } else {
                frames.every(&view).unwrap()
            }
            if step == last {
                frames.finish(&view).unwrap();
            }
        }
    }

    fn content(folder: &Path) -> Vec<(String, Vec<u8>)> {
        let files = [folder.to_path_buf(), folder.join("frames")].map(|folder| fs::read_dir(folder).unwrap());
        let paths =
            files.into_iter().flatten().map(|entry| entry.unwrap().path()).filter(|path| path.is_file());
        let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_string();
        let mut content: Vec<_> = paths.map(|path| (name(&path), fs::read(&path).unwrap())).collect();
        content.sort();
        content
    }

    #[test]
    fn frames_come_at_the_interval_and_a_resumed_run_leaves_the_same_files() {
        let (unbroken, broken) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        run(unbroken.path(), 0..=18);
        let expected = content(unbroken.path());
        let names: Vec<_> = expected.iter().map(|(name, _)| name.as_str()).collect();
        let frames = [0, 1, 2, 3, 4].map(|index| format!("frame_00000{index}.vtu"));
        assert_eq!(names, [frames.as_slice(), &["frames.pvd".to_string()]].concat());
        for stop in 1..18 {
            run(broken.path(), 0..=stop);
            run(broken.path(), stop..=18);
            assert_eq!(content(broken.path()), expected, "stopped at step {stop}");
            run(broken.path(), stop..=18);
            assert_eq!(content(broken.path()), expected, "killed at the end, taken up at step {stop}");
        }
    }

    #[test]
    fn a_fresh_run_removes_old_frames_but_no_other_file() {
        let folder = tempfile::tempdir().unwrap();
        run(folder.path(), 0..=18);
        fs::write(folder.path().join("frames/notes.txt"), b"mine").unwrap();
        run(folder.path(), 0..=1);
        let names: Vec<_> = content(folder.path()).into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, ["frame_000000.vtu", "frame_000001.vtu", "frames.pvd", "notes.txt"]);
    }

    #[test]
    fn an_unknown_field_is_named_with_those_there_are() {
        let folder = tempfile::tempdir().unwrap();
        let mut frames =
            FrameWriter::new(folder.path(), 0.25, vec!["temprature_k".into()], Precision::Float64);
        let error = frames.init(&view(0.0, 0, &[1.0, 2.0])).unwrap_err().to_string();
        assert!(error.contains("`temprature_k`") && error.ends_with("it has: temperature_k"), "{error}");
    }
}
