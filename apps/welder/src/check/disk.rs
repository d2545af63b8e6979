//! What a run will leave on the disk.

use crate::case::scene::ResolvedOutput;
use crate::observe::checkpoint::KEPT;
use crate::physics::Column;
use crate::run::Scenario;
use std::collections::BTreeSet;

/// Bytes of a compressed frame over those of its numbers: 0.57 where particles rest on a lattice, 0.96 in fluid that splashes.
const COMPRESSED: f64 = 0.75;

/// Bytes of base64 for one of the file.
const AS_TEXT: f64 = 4.0 / 3.0;

/// Bytes of a particle in a frame beside its columns: its place in single precision, and its cell.
const PLACE: usize = 3 * 4 + 9;

/// Bytes of a row of the history, of 220 to 320 in runs of this project.
const ROW: f64 = 270.0;

/// Bytes of a picture, of 70 to 310 thousand in runs of this project.
const PICTURE: f64 = 2e5;

/// The forecast \[bytes\] for a run to the end of the scene; a weld that ends when all is solid leaves less.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Disk {
    frames: f64,
    frame: f64,
    checkpoint: f64,
    history: f64,
    pictures: f64,
}

/// The forecast for a scene at its start, as a line.
pub(super) fn line<const D: usize>(scene: &impl Scenario<D>, output: &ResolvedOutput) -> String {
    Disk::of(scene, output).line()
}

impl Disk {
    fn of<const D: usize>(scene: &impl Scenario<D>, output: &ResolvedOutput) -> Self {
        let columns = if output.frames { scene.columns() } else { Vec::new() };
        let shown = columns.iter().filter(|(name, _)| output.fields.iter().any(|field| field == name));
        let particle = PLACE + shown.map(|(_, column)| bytes_of(column)).sum::<usize>();
        let checkpoint = scene.save(0).and_then(|checkpoint| checkpoint.to_bytes());
        // Those of the run, those of its end, and the history.
        let names: BTreeSet<String> = [false, true]
            .into_iter()
            .flat_map(|at_end| scene.pictures(at_end).sections)
            .map(|(name, _)| name)
            .collect();
        let when = |is_on: bool, value: f64| if is_on { value } else { 0.0 };
        Self {
            frames: when(output.frames, moments(scene.end(), output.frame_interval_s)),
            frame: AS_TEXT * COMPRESSED * (particle * scene.positions().len()) as f64,
            checkpoint: checkpoint.expect("numbers and columns always serialise").len() as f64,
            history: ROW * moments(scene.end(), output.history_interval_s),
            pictures: when(output.pictures, PICTURE * (names.len() + 1) as f64),
        }
    }

    fn total(&self) -> f64 {
        self.frames * self.frame + KEPT as f64 * self.checkpoint + self.history + self.pictures
    }

    fn line(&self) -> String {
        let megabytes = |bytes: f64| format!("{:.3} MB", 1e-6 * bytes);
        format!(
            "  disk           about {}: {:.0} frames of {}, {KEPT} checkpoints of {}, history {}, pictures {}",
            megabytes(self.total()),
            self.frames,
            megabytes(self.frame),
            megabytes(self.checkpoint),
            megabytes(self.history),
            megabytes(self.pictures)
        )
    }
}

/// Bytes of a particle in a column of a frame, in single precision and with three components.
fn bytes_of<const D: usize>(column: &Column<D>) -> usize {
    match column {
        Column::Scalar(_) => 4,
        Column::Vector(_) | Column::Triple(_) => 12,
        Column::Byte(_) => 1,
    }
}

/// Multiples of the interval in a run, its start and its end among them.
fn moments(end: f64, interval: f64) -> f64 {
    let between = if interval > 0.0 { (end / interval).ceil() - 1.0 } else { 0.0 };
    2.0 + between.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn start_end_and_what_lies_between_count() {
        assert_eq!(moments(1.0, 0.25), 5.0);
        assert_eq!(moments(1.1, 0.25), 6.0, "the end is no multiple");
        assert_eq!([0.0, 2.0, f64::INFINITY].map(|interval| moments(1.0, interval)), [2.0; 3]);
    }

    #[test]
    fn the_sum_holds_all_frames_and_the_kept_checkpoints() {
        let disk = Disk { frames: 11.0, frame: 2e6, checkpoint: 3e6, history: 1e5, pictures: 4e5 };
        assert_eq!(disk.total(), 22e6 + 6e6 + 5e5);
        assert!(disk.line().contains("about 28.500 MB: 11 frames of 2.000 MB"), "{}", disk.line());
    }
}
