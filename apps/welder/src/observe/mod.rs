//! What a run shows to those who watch it: progress, history, frames, pictures, checkpoints, summary.
//!
//! Observers stand outside the physics. The run loop hands them a [`View`] of the particles; they never reach
//! into the state and never change it, so a run gives the same bits whoever watches.

mod canvas;
pub mod checkpoint;
pub mod checkpoint_error;
pub mod checkpoint_format;
mod colour_field;
pub mod contour;
pub mod dossier;
pub mod error;
pub mod fluid_row;
pub mod frame_list;
pub mod frames;
pub mod history;
pub mod history_picture;
mod labels;
pub mod machine;
pub mod measures;
pub mod picture_data;
pub mod pictures;
pub mod progress;
pub mod scatter_picture;
pub mod schedule;
pub mod section_picture;
pub mod solid_row;
pub mod summary;
pub mod vtu;
pub mod whole_file;

use nalgebra::SVector;

pub use checkpoint::{CheckpointFolder, Found};
pub use checkpoint_error::CheckpointError;
pub use checkpoint_format::{Checkpoint, case_digest};
pub use dossier::{Failure, write_dossier};
pub use error::ObserveError;
pub use fluid_row::FluidRow;
pub use frames::FrameWriter;
pub use history::{HistoryRow, HistoryWriter, read_history};
pub use machine::{Machine, peak_memory_bytes, process_cpu_s};
pub use measures::Measures;
pub use picture_data::{Pictures, SectionGrid};
pub use pictures::PictureWriter;
pub use progress::Progress;
pub use schedule::Schedule;
pub use solid_row::SolidRow;
pub use summary::{
    Energy, FluidEnergy, FluidOutcome, Pool, PoolSize, SolidEnergy, SolidOutcome, Status, StressEnd, Summary,
    Weld, WeldOutcome,
};
pub use vtu::Precision;

/// The values of one field, one entry a particle.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a, const D: usize> {
    /// One number a particle.
    Scalar(&'a [f64]),
    /// One vector a particle.
    Vector(&'a [SVector<f64, D>]),
    /// Three numbers a particle in any dimension.
    Triple(&'a [[f64; 3]]),
    /// A small whole number a particle: a phase, a flag.
    Byte(&'a [u8]),
}

impl<const D: usize> Values<'_, D> {
    /// The number of particles that the field has values for.
    pub fn len(&self) -> usize {
        match self {
            Values::Scalar(values) => values.len(),
            Values::Vector(values) => values.len(),
            Values::Triple(values) => values.len(),
            Values::Byte(values) => values.len(),
        }
    }

    /// Whether the field has no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A named column of particle values.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a, const D: usize> {
    /// The name with its unit, such as `temperature_k`.
    pub name: &'static str,
    /// The values, in the order of the positions.
    pub values: Values<'a, D>,
}

/// The clock of a run after one step: cheap enough to hand out after each.
#[derive(Clone, Copy, Debug)]
pub struct Pulse<'a> {
    /// Physical time reached.
    pub time_s: f64,
    /// Physical time at which the run ends.
    pub end_s: f64,
    /// Steps taken so far.
    pub step: u64,
    /// Length of the last step.
    pub dt_s: f64,
    /// The name of the limit that ruled the last step.
    pub dt_limit: &'a str,
}

/// What an observer sees of a run at one moment.
#[derive(Clone, Debug)]
pub struct View<'a, const D: usize> {
    /// Physical time reached.
    pub time_s: f64,
    /// Physical time at which the run ends.
    pub end_s: f64,
    /// Steps taken so far; not zero in the first view of a resumed run.
    pub step: u64,
    /// Length of the last step.
    pub dt_s: f64,
    /// The name of the limit that ruled the last step.
    pub dt_limit: &'a str,
    /// Where the particles are.
    pub positions_m: &'a [SVector<f64, D>],
    /// The spacing that each particle stands for.
    pub spacing_m: &'a [f64],
    /// Every field that this run has.
    pub fields: Vec<Field<'a, D>>,
    /// The measures of this moment.
    pub history: Measures,
    /// Pictures to draw, if this is a moment for them.
    pub pictures: Option<Pictures>,
}

impl<const D: usize> View<'_, D> {
    /// The clock alone.
    pub fn pulse(&self) -> Pulse<'_> {
        Pulse {
            time_s: self.time_s,
            end_s: self.end_s,
            step: self.step,
            dt_s: self.dt_s,
            dt_limit: self.dt_limit,
        }
    }
}

/// Someone who watches a run.
///
/// The run loop lands a step exactly on the smallest [`next_time_s`](Observer::next_time_s) of its observers (it
/// assigns that number to its clock, instead of adding up steps) and then hands every observer a view.
pub trait Observer<const D: usize> {
    /// The next physical time at which this observer wants a view, or `None` if it takes what comes.
    fn next_time_s(&self) -> Option<f64> {
        None
    }

    /// Whether it would use a view at `time_s`; a view that nobody uses is not made.
    fn is_due(&self, time_s: f64) -> bool {
        self.next_time_s().is_some_and(|due_s| time_s >= due_s)
    }

    /// Called once before the first step, also of a resumed run.
    fn init(&mut self, view: &View<D>) -> Result<(), ObserveError>;

    /// Called after each step, when there is no view: must cost next to nothing.
    fn stepped(&mut self, _pulse: &Pulse) {}

    /// Called whenever the run loop has made a view; an observer that is not due yet lets it pass.
    fn every(&mut self, view: &View<D>) -> Result<(), ObserveError>;

    /// Called once after the last step, also when the run was interrupted or failed.
    fn finish(&mut self, view: &View<D>) -> Result<(), ObserveError>;
}

#[cfg(test)]
impl<const D: usize> View<'static, D> {
    /// A view without particles, to build the views of tests on.
    pub(crate) fn bare(time_s: f64, step: u64) -> Self {
        View {
            time_s,
            end_s: 1.0,
            step,
            dt_s: 0.1,
            dt_limit: "conduction",
            positions_m: &[],
            spacing_m: &[],
            fields: Vec::new(),
            history: Measures::Weld(HistoryRow::default()),
            pictures: None,
        }
    }
}
