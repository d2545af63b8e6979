//! The course of a run: time loop, observers, checkpoints, summary, dossier. Written once for all kinds of scenes.

use super::{Scenario, StepReport};
use crate::case::scene::ResolvedOutput;
use crate::cli::{ExitStatus, RunArguments, say};
use crate::model::ModelError;
use crate::observe::{
    CheckpointError, CheckpointFolder, Field, Found, FrameWriter, HistoryWriter, ObserveError, Observer,
    PictureWriter, Pictures, Precision, Pulse, Schedule, Status, Summary, Values, View, case_digest, dossier,
    peak_memory_bytes, process_cpu_s, progress::Progress, whole_file,
};
use crate::physics::{Column, Failure};
use crate::version;
use nalgebra::SVector;
use std::path::{Path, PathBuf};
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Why a run did not come to its end.
#[derive(Debug, thiserror::Error)]
pub(super) enum RunError {
    #[error("{0}")]
    Model(#[from] ModelError),
    #[error("{0}")]
    Observe(#[from] ObserveError),
    #[error("{0}")]
    Checkpoint(#[from] CheckpointError),
    #[error("{0}")]
    Case(String),
    /// Melt has reached coarse particles that the program itself had chosen.
    #[error("melt has reached particles of a coarser level")]
    Outgrown,
}

/// What a run is to leave behind, and what it may cost.
#[derive(Debug, Clone)]
pub(super) struct Plan {
    /// Name of the case.
    pub name: String,
    /// The case as resolved, for case.ron; tells checkpoints of other cases apart.
    pub resolved: String,
    /// What is written, and how often.
    pub output: ResolvedOutput,
    /// Most steps.
    pub max_steps: u64,
}

/// How the time loop ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    Done,
    Until,
    Interrupted,
    Failed,
    Left,
}

/// A moment of a run at which observers look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Moment {
    Init,
    Step,
    Finish,
}

/// Runs a scene whose particles suffice from its start, or from where `arguments` resume it, to its end.
pub(super) fn run<const D: usize, S: Scenario<D>>(
    plan: Plan,
    arguments: &RunArguments,
    build: impl FnOnce() -> Result<S, ModelError>,
) -> Result<ExitStatus, RunError> {
    let mut course = Course::start(plan, arguments, arguments.resume, |_| Ok(build()?))?;
    let ended = course.go(arguments.until_s);
    course.end(ended)
}

/// A scene under way, with all that stands around it.
pub(super) struct Course<const D: usize, S> {
    /// The scene.
    pub scenario: S,
    plan: Plan,
    folder: PathBuf,
    checkpoints: CheckpointFolder,
    checkpoint_due: Schedule,
    digest: u32,
    observers: Vec<Box<dyn Observer<D>>>,
    last: StepReport,
    started: Instant,
    setup_s: f64,
    stop: &'static AtomicBool,
}

impl<const D: usize, S: Scenario<D>> Course<D, S> {
    /// Makes the folder, finds the checkpoint to `resume` from, and builds the scene, which may ask that checkpoint.
    pub fn start(
        plan: Plan,
        arguments: &RunArguments,
        resume: bool,
        build: impl FnOnce(Option<&Found>) -> Result<S, RunError>,
    ) -> Result<Self, RunError> {
        let started = Instant::now();
        let folder = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(&plan.name));
        let create = |error| ObserveError::file("create", &folder)(error);
        std::fs::create_dir_all(&folder).map_err(create)?;
        let digest = case_digest(&plan.resolved);
        let checkpoints = CheckpointFolder::of_run(&folder);
        let found = if resume {
            let found = checkpoints.latest(version::PROGRAM, digest)?;
            let missing = || {
                format!("{}: there is no checkpoint to resume from; run without --resume\n", folder.display())
            };
            Some(found.ok_or_else(|| RunError::Case(missing()))?)
        } else {
            checkpoints.clear()?;
            None
        };
        let mut scenario = build(found.as_ref())?;
        if let Some(Found { checkpoint, path, .. }) = &found {
            scenario.restore(checkpoint).map_err(|error| error.in_file(path))?;
        }
        let case_path = folder.join("case.ron");
        whole_file::replace(&case_path, plan.resolved.as_bytes())
            .map_err(ObserveError::file("write", &case_path))?;
        let mut checkpoint_due = Schedule::new(plan.output.checkpoint_interval_s);
        checkpoint_due.advance_past(scenario.time());
        Ok(Self {
            observers: observers(&plan.output, &folder, arguments.quiet),
            scenario,
            plan,
            checkpoints,
            checkpoint_due,
            digest,
            last: StepReport { step: 0.0, limit: "start" },
            setup_s: started.elapsed().as_secs_f64(),
            started,
            stop: interrupt_flag(),
            folder,
        })
    }

    /// Leaves a summary behind a run that could not write or go on, as far as there is room for one, and says how it ended.
    pub fn end(self, ended: Result<ExitStatus, RunError>) -> Result<ExitStatus, RunError> {
        if ended.is_err() && self.write_summary(Status::Failed).is_err() {
            tracing::error!("there is no room for a summary either");
        }
        ended.map(|status| self.tell(status))
    }

    fn write_summary(&self, status: Status) -> Result<(), RunError> {
        let wall_s = self.started.elapsed().as_secs_f64();
        let loop_s = (wall_s - self.setup_s).max(f64::MIN_POSITIVE);
        let scenario = &self.scenario;
        let particles = scenario.positions().len();
        let summary = Summary {
            status,
            version: version::NUMBER.into(),
            commit: version::COMMIT.into(),
            case: scenario.name().into(),
            dimension: D,
            particles,
            spacing_m: scenario.spacing(),
            steps: scenario.steps(),
            step_limits: scenario.limits().clone(),
            rejected_steps: scenario.cost().rejected_steps,
            wall_s,
            cpu_s: process_cpu_s(),
            setup_s: self.setup_s,
            particle_steps_per_s: particles as f64 * scenario.steps() as f64 / loop_s,
            pair_visits: scenario.cost().pair_visits,
            threads: rayon::current_num_threads(),
            peak_memory_bytes: peak_memory_bytes(),
            outcome: scenario.outcome(),
            numbers: scenario.numbers(),
        };
        Ok(summary.write(&self.folder.join("summary.json"))?)
    }

    /// Runs to the end, to `until`, or to an interruption, and writes the summary.
    pub fn go(&mut self, until: Option<f64>) -> Result<ExitStatus, RunError> {
        self.show(Moment::Init)?;
        let ending = self.time_loop(until)?;
        if ending != Ending::Left {
            self.scenario.warnings().iter().for_each(|warning| tracing::warn!("{warning}"));
        }
        let audit = self.scenario.fault();
        let (status, exit) = match (ending, &audit) {
            (Ending::Failed, _) => (Status::Failed, ExitStatus::RunFailed),
            (Ending::Left, None) => (Status::DeepPenetration, ExitStatus::RunFailed),
            (_, Some(_)) => (Status::AuditFailed, ExitStatus::AuditFailed),
            (Ending::Interrupted, None) => (Status::Interrupted, ExitStatus::Interrupted),
            (Ending::Until, None) => (Status::Interrupted, ExitStatus::Done),
            (Ending::Done, None) => (Status::Done, ExitStatus::Done),
        };
        if matches!(ending, Ending::Until | Ending::Interrupted) {
            let path = self.write_checkpoint()?;
            tracing::info!(
                "stopped at t = {:.6e} s; {} goes on from {}",
                self.scenario.time(),
                "--resume",
                path.display()
            );
        }
        self.show(Moment::Finish)?;
        if let Some(fault) = audit {
            tracing::error!("audit: {fault}");
        }
        self.write_summary(status)?;
        Ok(exit)
    }

    fn time_loop(&mut self, until: Option<f64>) -> Result<Ending, RunError> {
        while !self.scenario.finished() {
            if self.stop.load(Ordering::Relaxed) {
                return Ok(Ending::Interrupted);
            }
            if until.is_some_and(|until| self.scenario.time() >= until) {
                return Ok(Ending::Until);
            }
            let due = self.observers.iter().filter_map(|observer| observer.next_time_s());
            let stop = due.filter(|&due| due > self.scenario.time()).fold(self.scenario.end(), f64::min);
            match self.scenario.step(stop) {
                Ok(report) => self.last = report,
                Err(failure) => return self.fail(&failure),
            }
            if self.scenario.outgrown() {
                return Err(RunError::Outgrown);
            }
            if let Some(problem) = self.scenario.problem().or_else(|| self.spent()) {
                return self.fail(&problem);
            }
            if let Some(left) = self.scenario.left_the_model() {
                tracing::error!("{left}");
                return Ok(Ending::Left);
            }
            self.show(Moment::Step)?;
            if self.checkpoint_due.is_due(self.scenario.time()) {
                self.write_checkpoint()?;
                self.checkpoint_due.advance_past(self.scenario.time());
            }
        }
        Ok(Ending::Done)
    }

    /// Whether the run has cost all that it may.
    fn spent(&self) -> Option<Failure> {
        (self.scenario.steps() >= self.plan.max_steps).then(|| Failure {
            physics: "run",
            what: format!("the step budget of {} steps is used up", self.plan.max_steps),
            time: self.scenario.time(),
            at: self.scenario.focus(),
            advice: "raise budget.max_steps, or shorten time.end_s".into(),
        })
    }

    fn fail(&mut self, failure: &Failure) -> Result<Ending, RunError> {
        tracing::error!("{failure}");
        let positions = self.scenario.positions();
        let nearest = failure.at.and_then(|at| {
            let at = SVector::<f64, D>::from_fn(|axis, _| at[axis]);
            let distance = |i: &usize| (positions[*i] - at).norm_squared();
            (0..positions.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        });
        let told = dossier::Failure {
            what: failure.to_string(),
            particle: nearest,
            try_next: vec![failure.advice.clone()],
        };
        let columns = self.scenario.columns();
        let path = dossier::write_dossier(&self.folder, &told, &self.view(&columns, None))?;
        tracing::error!("the dossier is {}", path.display());
        Ok(Ending::Failed)
    }

    fn write_checkpoint(&self) -> Result<PathBuf, RunError> {
        Ok(self.checkpoints.write(&self.scenario.save(self.digest)?)?)
    }

    /// Lets the observers look; views, fields and pictures are made only for those who need them.
    fn show(&mut self, moment: Moment) -> Result<(), RunError> {
        let time = self.scenario.time();
        self.pulse();
        let at_end = matches!(moment, Moment::Init | Moment::Finish);
        let wants_pictures = match moment {
            Moment::Init => false,
            Moment::Step => self.plan.output.pictures && self.scenario.is_picture_time(),
            Moment::Finish => self.plan.output.pictures,
        };
        if !at_end && !wants_pictures && !self.observers.iter().any(|observer| observer.is_due(time)) {
            return Ok(());
        }
        let framed =
            self.observers.iter().filter_map(|observer| observer.next_time_s()).any(|due| time >= due);
        let wants_fields = self.plan.output.frames && (framed || at_end);
        let columns = if wants_fields { self.scenario.columns() } else { Vec::new() };
        let drawn = wants_pictures.then(|| self.scenario.pictures(moment == Moment::Finish));
        let mut observers = std::mem::take(&mut self.observers);
        let view = self.view(&columns, drawn);
        for observer in &mut observers {
            match moment {
                Moment::Init => observer.init(&view)?,
                Moment::Finish => observer.finish(&view)?,
                Moment::Step => observer.every(&view)?,
            }
        }
        self.observers = observers;
        Ok(())
    }

    fn view<'a>(
        &'a self,
        columns: &'a [(&'static str, Column<D>)],
        pictures: Option<Pictures>,
    ) -> View<'a, D> {
        View {
            time_s: self.scenario.time(),
            end_s: self.scenario.end(),
            step: self.scenario.steps(),
            dt_s: self.last.step,
            dt_limit: self.last.limit,
            positions_m: self.scenario.positions(),
            spacing_m: self.scenario.spacings(),
            fields: columns.iter().map(|(name, column)| Field { name, values: values(column) }).collect(),
            history: self.scenario.measures(&self.last),
            pictures,
        }
    }

    /// Tells the observers the time.
    fn pulse(&mut self) {
        let pulse = Pulse {
            time_s: self.scenario.time(),
            end_s: self.scenario.end(),
            step: self.scenario.steps(),
            dt_s: self.last.step,
            dt_limit: self.last.limit,
        };
        self.observers.iter_mut().for_each(|observer| observer.stepped(&pulse));
    }

    /// Says in a few lines what came out.
    fn tell(&self, exit: ExitStatus) -> ExitStatus {
        let scenario = &self.scenario;
        let first = format!(
            "{}: {} particles, {} steps to t = {:.4e} s in {:.2} s",
            scenario.name(),
            scenario.positions().len(),
            scenario.steps(),
            scenario.time(),
            self.started.elapsed().as_secs_f64()
        );
        let last = format!("  results in {}", self.folder.display());
        say(&[vec![first], scenario.told(), vec![last]].concat().join("\n"));
        exit
    }
}

fn values<const D: usize>(column: &Column<D>) -> Values<'_, D> {
    match column {
        Column::Scalar(values) => Values::Scalar(values),
        Column::Vector(values) => Values::Vector(values),
        Column::Triple(values) => Values::Triple(values),
        Column::Byte(values) => Values::Byte(values),
    }
}

fn observers<const D: usize>(
    output: &ResolvedOutput,
    folder: &Path,
    quiet: bool,
) -> Vec<Box<dyn Observer<D>>> {
    let history = HistoryWriter::new(folder.join("history.csv"), output.history_interval_s);
    let mut observers: Vec<Box<dyn Observer<D>>> = vec![Box::new(Progress::new(quiet)), Box::new(history)];
    if output.frames {
        let (interval_s, fields) = (output.frame_interval_s, output.fields.clone());
        observers.push(Box::new(FrameWriter::new(folder, interval_s, fields, Precision::Float32)));
    }
    if output.pictures {
        observers.push(Box::new(PictureWriter::new(folder)));
    }
    observers
}

/// The flag that Ctrl-C raises; its handler is set once for the whole program.
pub(super) fn interrupt_flag() -> &'static AtomicBool {
    static RAISED: AtomicBool = AtomicBool::new(false);
    static HANDLER: Once = Once::new();
    HANDLER.call_once(|| {
        if let Err(error) = ctrlc::set_handler(|| RAISED.store(true, Ordering::Relaxed)) {
            tracing::warn!("Ctrl-C will not write a checkpoint: {error}");
        }
    });
    &RAISED
}
