//! What the run loop asks of a scene, whatever it is made of.

use super::StepReport;
use crate::observe::{Checkpoint, CheckpointError, Measures, Pictures};
use crate::physics::{Column, Cost, Failure};
use nalgebra::SVector;
use serde::Serialize;
use std::collections::BTreeMap;

/// A scene on particles that a run takes from its start to its end: a weld, a fluid.
///
/// The run loop owns the clock's stops, the observers, checkpoints, summary and dossier; a scenario owns its state and says what of
/// it is to be seen. It never writes a file.
pub trait Scenario<const D: usize> {
    /// What the summary says of this kind of scene alone.
    type Outcome: Serialize;

    /// Name of the case.
    fn name(&self) -> &str;

    /// Time reached \[s\].
    fn time(&self) -> f64;

    /// When the run ends \[s\].
    fn end(&self) -> f64;

    /// Steps taken.
    fn steps(&self) -> u64;

    /// How often each limit ruled the step.
    fn limits(&self) -> &BTreeMap<String, u64>;

    /// What the run has cost so far.
    fn cost(&self) -> Cost;

    /// Whether there is nothing left to do.
    fn finished(&self) -> bool;

    /// Advances by one step that does not pass `stop` \[s\].
    ///
    /// # Errors
    /// [`Failure`] of what cannot go on.
    fn step(&mut self, stop: f64) -> Result<StepReport, Failure>;

    /// Whether the particles that the program chose do not suffice, so that the run must start anew with others.
    fn outgrown(&self) -> bool {
        false
    }

    /// What ends the run although the state could be stepped on.
    fn problem(&self) -> Option<Failure> {
        None
    }

    /// Where the scene has left what the model holds for, why; the run ends there, with a status of its own.
    fn left_the_model(&self) -> Option<String> {
        None
    }

    /// Where to look when the run ends for a reason that has no place \[m\].
    fn focus(&self) -> Option<[f64; 3]> {
        None
    }

    /// What is wrong with the ledger, if anything.
    fn fault(&self) -> Option<String>;

    /// What the user should know of a run that came to its end.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }

    /// Everything that changes, for a checkpoint of the case with this digest.
    ///
    /// # Errors
    /// [`CheckpointError`] when a column cannot be encoded.
    fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError>;

    /// Takes up the state of a checkpoint of the same case.
    ///
    /// # Errors
    /// [`CheckpointError`] when it is of other particles.
    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError>;

    /// Positions of the particles \[m\].
    fn positions(&self) -> &[SVector<f64, D>];

    /// The spacing that each particle stands for \[m\].
    fn spacings(&self) -> &[f64];

    /// The finest spacing \[m\].
    fn spacing(&self) -> f64;

    /// Every column that frames and dossiers can show, by name with unit.
    fn columns(&self) -> Vec<(&'static str, Column<D>)>;

    /// The measures of this moment, after the step `last`.
    fn measures(&self, last: &StepReport) -> Measures;

    /// Whether this moment is one for pictures; the end always is.
    fn is_picture_time(&self) -> bool {
        false
    }

    /// The pictures of this moment.
    fn pictures(&self, at_end: bool) -> Pictures;

    /// Results for the summary.
    fn outcome(&self) -> Self::Outcome;

    /// Dimensionless numbers, by name.
    fn numbers(&self) -> BTreeMap<String, f64>;

    /// In a few lines, what came out.
    fn told(&self) -> Vec<String>;
}
