//! `welder run`: builds a case, runs it with its observers, and says how it ended.

use super::watch::{Shown, last_pictures, pictures, view};
use super::{Simulation, StepReport, level_plan, summary};
use crate::case::scene::Levels;
use crate::case::source::Source;
use crate::case::{self, Case, CaseError};
use crate::cli::{ExitStatus, RunArguments, refuse, say};
use crate::model::{Model, ModelError};
use crate::observe::{
    CheckpointError, CheckpointFolder, Found, FrameWriter, HistoryWriter, ObserveError, Observer,
    PictureWriter, Precision, Pulse, Schedule, Status, case_digest, dossier, progress::Progress, whole_file,
};
use crate::physics::Failure;
use std::path::{Path, PathBuf};
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Melt that reaches coarse particles widens the fine box by this many beam radii and starts anew.
const GROWTH_BEAM_RADII: f64 = 1.5;

/// How often the fine box is widened before the run gives up.
const LARGEST_GROWTHS: usize = 4;

/// Why a run did not come to its end.
#[derive(Debug, thiserror::Error)]
enum RunError {
    #[error("{0}")]
    Model(#[from] ModelError),
    #[error("{0}")]
    Failure(#[from] Failure),
    #[error("{0}")]
    Observe(#[from] ObserveError),
    #[error("{0}")]
    Checkpoint(#[from] CheckpointError),
    #[error("{0}")]
    Case(String),
    /// Melt has reached coarse particles that the program itself had chosen.
    #[error("melt has reached particles of a coarser level")]
    FineBoxTooSmall,
}

/// Runs the case of `arguments`.
pub fn command(arguments: &RunArguments) -> ExitStatus {
    let case = match case::load(&arguments.case, &arguments.overrides) {
        Ok(case) => case,
        Err(error) => return refuse(&error),
    };
    let mut pool = rayon::ThreadPoolBuilder::new();
    if let Some(threads) = arguments.threads {
        pool = pool.num_threads(threads as usize);
    }
    match pool.build() {
        Ok(pool) => pool.install(|| run(&case, arguments)),
        Err(error) => {
            tracing::error!("the threads cannot be started: {error}");
            ExitStatus::RunFailed
        }
    }
}

fn run(case: &Case, arguments: &RunArguments) -> ExitStatus {
    interrupt_flag();
    match run_growing(case, arguments) {
        Ok((run, status)) => run.tell(status),
        Err(RunError::Case(report)) => {
            eprint!("{report}");
            ExitStatus::WrongInput
        }
        Err(RunError::Checkpoint(
            error @ (CheckpointError::OtherCase { .. } | CheckpointError::OtherVersion { .. }),
        )) => {
            tracing::error!("{error}");
            ExitStatus::WrongInput
        }
        Err(RunError::Model(error)) => {
            tracing::error!("the case cannot be built: {error}");
            ExitStatus::WrongInput
        }
        Err(error) => {
            tracing::error!("{error}");
            ExitStatus::RunFailed
        }
    }
}

/// Runs the case; where melt leaves the fine box that the program chose, widens it and starts anew.
fn run_growing(case: &Case, arguments: &RunArguments) -> Result<(Run, ExitStatus), RunError> {
    let step = case.scene.laser.as_ref().map_or(0.0, |laser| GROWTH_BEAM_RADII * laser.beam.radius_m());
    let mut resume = arguments.resume;
    for growth in 0..=LARGEST_GROWTHS {
        let mut run = Run::start(case, arguments, resume, step * growth as f64)?;
        run.may_grow = case.scene.resolution.levels == Levels::Auto && growth < LARGEST_GROWTHS;
        match run.go(arguments.until_s) {
            Err(RunError::FineBoxTooSmall) => {
                tracing::warn!(
                    "melt reached coarse particles at t = {:.3e} s; starting anew with a larger fine box",
                    run.simulation.time()
                );
                resume = false;
            }
            ended => return run.end(ended),
        }
    }
    Err(RunError::FineBoxTooSmall)
}

/// How the time loop ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    Done,
    Until,
    Interrupted,
    Failed,
}

struct Run {
    simulation: Simulation,
    folder: PathBuf,
    checkpoints: CheckpointFolder,
    checkpoint_due: Schedule,
    digest: u32,
    grown: f64,
    observers: Vec<Box<dyn Observer<3>>>,
    frames: bool,
    pictures: bool,
    last: StepReport,
    started: Instant,
    setup_s: f64,
    max_steps: u64,
    /// Boiling point of the part's own material \[K\], where its card has one.
    boiling: Option<f64>,
    /// Whether a fine box that turns out too small is widened instead of refused.
    may_grow: bool,
    stop: &'static AtomicBool,
}

impl Run {
    fn start(case: &Case, arguments: &RunArguments, resume: bool, grown: f64) -> Result<Self, RunError> {
        let started = Instant::now();
        let folder = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(&case.name));
        let create = |error| ObserveError::file("create", &folder)(error);
        std::fs::create_dir_all(&folder).map_err(create)?;
        let resolved = case::resolved_ron(case);
        let digest = case_digest(&resolved);
        let checkpoints = CheckpointFolder::of_run(&folder);
        let found = if resume {
            let found = checkpoints.latest(env!("CARGO_PKG_VERSION"), digest)?;
            let missing = || {
                format!("{}: there is no checkpoint to resume from; run without --resume\n", folder.display())
            };
            Some(found.ok_or_else(|| RunError::Case(missing()))?)
        } else {
            checkpoints.clear()?;
            None
        };
        let grown = found.as_ref().map_or(Ok(grown), |found| {
            Simulation::grown_of(&found.checkpoint).map_err(|error| error.in_file(&found.path))
        })?;
        let mut simulation = build(case, grown)?;
        if let Some(Found { checkpoint, path, .. }) = &found {
            simulation.restore(checkpoint).map_err(|error| error.in_file(path))?;
        }
        let case_path = folder.join("case.ron");
        whole_file::replace(&case_path, resolved.as_bytes())
            .map_err(ObserveError::file("write", &case_path))?;
        let scene = &case.scene;
        let mut checkpoint_due = Schedule::new(scene.checkpoint_interval_s());
        checkpoint_due.advance_past(simulation.time());
        Ok(Self {
            observers: observers(case, &folder, arguments.quiet),
            simulation,
            checkpoints,
            checkpoint_due,
            digest,
            grown,
            frames: scene.output.frames,
            pictures: scene.output.pictures,
            last: StepReport { step: 0.0, limit: "start" },
            setup_s: started.elapsed().as_secs_f64(),
            started,
            max_steps: scene.budget.max_steps,
            boiling: case.materials[0].card.boiling_k.as_ref().map(|boiling| boiling.value),
            may_grow: false,
            stop: interrupt_flag(),
            folder,
        })
    }

    /// Leaves a summary behind a run that could not write or go on, as far as there is room for one.
    fn end(self, ended: Result<ExitStatus, RunError>) -> Result<(Self, ExitStatus), RunError> {
        if ended.is_err() && self.write_summary(Status::Failed).is_err() {
            tracing::error!("there is no room for a summary either");
        }
        ended.map(|status| (self, status))
    }

    fn write_summary(&self, status: Status) -> Result<(), RunError> {
        let wall_s = self.started.elapsed().as_secs_f64();
        let summary = summary(&self.simulation, status, wall_s, self.setup_s);
        Ok(summary.write(&self.folder.join("summary.json"))?)
    }

    /// Runs to the end, to `until`, or to an interruption, and writes the summary.
    fn go(&mut self, until: Option<f64>) -> Result<ExitStatus, RunError> {
        self.show(Moment::Init)?;
        let ending = self.time_loop(until)?;
        self.warn_of_boiling();
        let audit = self.simulation.ledger().fault();
        let (status, exit) = match (ending, &audit) {
            (Ending::Failed, _) => (Status::Failed, ExitStatus::RunFailed),
            (_, Some(_)) => (Status::AuditFailed, ExitStatus::AuditFailed),
            (Ending::Interrupted, None) => (Status::Interrupted, ExitStatus::Interrupted),
            (Ending::Until, None) => (Status::Interrupted, ExitStatus::Done),
            (Ending::Done, None) => (Status::Done, ExitStatus::Done),
        };
        if matches!(ending, Ending::Until | Ending::Interrupted) {
            let path = self.write_checkpoint()?;
            tracing::info!(
                "stopped at t = {:.6e} s; {} goes on from {}",
                self.simulation.time(),
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
        let laser_off = self.simulation.model().laser.as_ref().map(|laser| laser.track().end_time());
        while !self.simulation.finished() {
            if self.stop.load(Ordering::Relaxed) {
                return Ok(Ending::Interrupted);
            }
            if until.is_some_and(|until| self.simulation.time() >= until) {
                return Ok(Ending::Until);
            }
            let due = self.observers.iter().filter_map(|observer| observer.next_time_s());
            let stop =
                due.filter(|&due| due > self.simulation.time()).fold(self.simulation.model().end, f64::min);
            match self.simulation.step(stop) {
                Ok(report) => self.last = report,
                Err(failure) => return self.fail(&failure),
            }
            if self.may_grow && self.simulation.records().now.beyond_finest {
                return Err(RunError::FineBoxTooSmall);
            }
            if let Some(problem) = self.problem() {
                return self.fail(&problem);
            }
            self.show(if Some(self.simulation.time()) == laser_off {
                Moment::LaserOff
            } else {
                Moment::Step
            })?;
            if self.checkpoint_due.is_due(self.simulation.time()) {
                self.write_checkpoint()?;
                self.checkpoint_due.advance_past(self.simulation.time());
            }
        }
        Ok(Ending::Done)
    }

    /// Conduction mode ends where the surface boils: the numbers are then those of a weld that does not exist.
    fn warn_of_boiling(&self) {
        let peak = self.simulation.records().peak_temperature;
        if let Some(boiling) = self.boiling.filter(|&boiling| peak > boiling) {
            tracing::warn!(
                "the surface reached {peak:.0} K, above the boiling point of {boiling:.0} K: evaporation and a keyhole, \
                 which are not computed, would change this weld"
            );
        }
    }

    /// What ends a run although the physics could go on.
    fn problem(&self) -> Option<Failure> {
        let (time, records) = (self.simulation.time(), self.simulation.records());
        let failure = |what: String, advice: &str| Failure {
            physics: "run",
            what,
            time,
            at: records.solidus.bounds.map(|bounds| bounds[1]),
            advice: advice.into(),
        };
        if records.now.beyond_finest {
            let advice = "enlarge the fine box of resolution.levels, or use Auto or Uniform";
            return Some(failure("melt has reached particles of a coarser level".into(), advice));
        }
        if self.simulation.steps() >= self.max_steps {
            let what = format!("the step budget of {} steps is used up", self.max_steps);
            return Some(failure(what, "raise budget.max_steps, or shorten time.end_s"));
        }
        None
    }

    fn fail(&mut self, failure: &Failure) -> Result<Ending, RunError> {
        tracing::error!("{failure}");
        let particles = self.simulation.particles();
        let nearest = failure.at.and_then(|at| {
            let distance = |i: &usize| (particles.position[*i] - nalgebra::Vector3::from(at)).norm_squared();
            (0..particles.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        });
        let told = dossier::Failure {
            what: failure.to_string(),
            particle: nearest,
            try_next: vec![failure.advice.clone()],
        };
        let mut shown = Shown::default();
        shown.fill(&self.simulation);
        let view = view(&self.simulation, &self.last, Some(&shown), None);
        let path = dossier::write_dossier(&self.folder, &told, &view)?;
        tracing::error!("the dossier is {}", path.display());
        Ok(Ending::Failed)
    }

    fn write_checkpoint(&self) -> Result<PathBuf, RunError> {
        Ok(self.checkpoints.write(&self.simulation.save(self.digest, self.grown)?)?)
    }

    /// Lets the observers look; views, fields and pictures are made only for those who need them.
    fn show(&mut self, moment: Moment) -> Result<(), RunError> {
        let time = self.simulation.time();
        self.pulse();
        let wants_pictures = self.pictures && self.picture_moment(moment);
        let last = self.pictures && moment == Moment::Finish && !wants_pictures;
        let last = last.then(|| last_pictures(&self.simulation));
        let at_end = matches!(moment, Moment::Init | Moment::Finish);
        if !at_end && !wants_pictures && !self.observers.iter().any(|observer| observer.is_due(time)) {
            return Ok(());
        }
        let framed =
            self.observers.iter().filter_map(|observer| observer.next_time_s()).any(|due| time >= due);
        let wants_fields = self.frames && (framed || at_end);
        let mut shown = Shown::default();
        if wants_fields {
            shown.fill(&self.simulation);
        }
        let drawn = if wants_pictures { Some(pictures(&self.simulation)) } else { last };
        let view = view(&self.simulation, &self.last, wants_fields.then_some(&shown), drawn);
        for observer in &mut self.observers {
            match moment {
                Moment::Init => observer.init(&view)?,
                Moment::Finish => observer.finish(&view)?,
                Moment::Step | Moment::LaserOff => observer.every(&view)?,
            }
        }
        Ok(())
    }

    /// Tells the observers the time.
    fn pulse(&mut self) {
        let pulse = Pulse {
            time_s: self.simulation.time(),
            end_s: self.simulation.model().end,
            step: self.simulation.steps(),
            dt_s: self.last.step,
            dt_limit: self.last.limit,
        };
        self.observers.iter_mut().for_each(|observer| observer.stepped(&pulse));
    }

    /// The pool is largest when the laser goes off; a run that does not get there shows its last state.
    fn picture_moment(&self, moment: Moment) -> bool {
        let laser = self.simulation.model().laser.as_ref();
        let lit = laser.is_none_or(|laser| self.simulation.time() < laser.track().end_time());
        moment == Moment::LaserOff || (moment == Moment::Finish && lit)
    }

    /// Says in a few lines what came out.
    fn tell(&self, exit: ExitStatus) -> ExitStatus {
        let (records, ledger) = (self.simulation.records(), self.simulation.ledger());
        let pool = &records.liquidus;
        let mut lines = vec![
            format!(
                "{}: {} particles, {} steps to t = {:.4e} s in {:.2} s",
                self.simulation.model().name,
                self.simulation.particles().len(),
                self.simulation.steps(),
                self.simulation.time(),
                self.started.elapsed().as_secs_f64()
            ),
            format!(
                "  pool at the liquidus: width {:.1} um, length {:.1} um, depth {:.1} um; peak {:.0} K",
                1e6 * pool.width,
                1e6 * pool.length,
                1e6 * pool.depth,
                records.peak_temperature
            ),
        ];
        lines.extend(records.solidified_at.map(|at| format!("  all solid again at {:.3} ms", 1e3 * at)));
        lines.push(format!(
            "  energy: {:.4} J absorbed of {:.4} J emitted, {:.4} J lost, residual {:.1e}",
            ledger.absorbed, ledger.emitted, ledger.lost, ledger.residual
        ));
        lines.push(format!("  results in {}", self.folder.display()));
        say(&lines.join("\n"));
        exit
    }
}

/// A moment of a run at which observers look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Moment {
    Init,
    Step,
    LaserOff,
    Finish,
}

fn observers(case: &Case, folder: &Path, quiet: bool) -> Vec<Box<dyn Observer<3>>> {
    let scene = &case.scene;
    let history = HistoryWriter::new(folder.join("history.csv"), scene.history_interval_s());
    let mut observers: Vec<Box<dyn Observer<3>>> = vec![Box::new(Progress::new(quiet)), Box::new(history)];
    if scene.output.frames {
        let fields = scene.frame_fields();
        observers.push(Box::new(FrameWriter::new(
            folder,
            scene.frame_interval_s(),
            fields,
            Precision::Float32,
        )));
    }
    if scene.output.pictures {
        observers.push(Box::new(PictureWriter::new(folder)));
    }
    observers
}

/// Builds the particles; where the fine box turns out too small, that is found out before anything is written.
fn build(case: &Case, grown: f64) -> Result<Simulation, RunError> {
    let model = Model::from_case(case)?;
    let plan = level_plan(&model, grown)?;
    let particles = plan.count();
    let allowed = case.scene.budget.max_particles;
    if particles > allowed {
        let reason = format!("{particles} particles are more than budget.max_particles = {allowed}");
        let remedy = "use a larger spacing_m, levels: Auto, or raise budget.max_particles";
        let source = Source::of_text(&case.path, case.source_text.clone());
        let problem =
            source.map_or_else(|problem| problem, |s| s.problem("resolution.spacing_m", &reason, remedy));
        return Err(RunError::Case(CaseError::from(problem).report(false)));
    }
    Ok(Simulation::with_plan(model, &plan)?)
}

/// The flag that Ctrl-C raises; its handler is set once for the whole program.
fn interrupt_flag() -> &'static AtomicBool {
    static RAISED: AtomicBool = AtomicBool::new(false);
    static HANDLER: Once = Once::new();
    HANDLER.call_once(|| {
        if let Err(error) = ctrlc::set_handler(|| RAISED.store(true, Ordering::Relaxed)) {
            tracing::warn!("Ctrl-C will not write a checkpoint: {error}");
        }
    });
    &RAISED
}
