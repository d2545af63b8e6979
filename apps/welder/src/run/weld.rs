//! A weld as the run loop sees it, with the fine box that grows where melt leaves it.

use super::course::{Course, Plan, RunError};
use super::watch::{columns, deformations, last_pictures, measures, pictures};
use super::{Scenario, Simulation, StepReport, level_plan, report};
use crate::case::scene::Levels;
use crate::case::source::Source;
use crate::case::{self, Case, CaseError};
use crate::cli::{ExitStatus, RunArguments};
use crate::model::Model;
use crate::observe::{Checkpoint, CheckpointError, Measures, Pictures, WeldOutcome};
use crate::physics::{Column, Cost, Failure};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// A melt faster than this share of its artificial sound is told of: it is compressed by half the square of it.
const LARGEST_MACH: f64 = 0.2;

/// Melt that reaches coarse particles widens the fine box by this many beam radii and starts anew.
const GROWTH_BEAM_RADII: f64 = 1.5;

/// How often the fine box is widened before the run gives up.
const LARGEST_GROWTHS: usize = 4;

/// Runs the case; where melt leaves the fine box that the program chose, widens it and starts anew.
pub(super) fn run(case: &Case, arguments: &RunArguments) -> Result<ExitStatus, RunError> {
    let step = case.scene.laser.as_ref().map_or(0.0, |laser| GROWTH_BEAM_RADII * laser.beam.radius_m());
    let plan = Plan {
        name: case.name.clone(),
        resolved: case::resolved_ron(case),
        output: case.scene.output(),
        max_steps: case.scene.budget.max_steps,
    };
    let mut resume = arguments.resume;
    for growth in 0..=LARGEST_GROWTHS {
        let mut course = Course::start(plan.clone(), arguments, resume, |found| {
            let grown = found.map_or(Ok(step * growth as f64), |found| {
                Simulation::grown_of(&found.checkpoint).map_err(|error| error.in_file(&found.path))
            })?;
            let may_grow = case.scene.resolution.levels == Levels::Auto && growth < LARGEST_GROWTHS;
            let boiling = case.materials[0].card.boiling_k.as_ref().map(|boiling| boiling.value);
            Ok(WeldRun { simulation: build(case, grown)?, grown, may_grow, boiling })
        })?;
        match course.go(arguments.until_s) {
            Err(RunError::Outgrown) => {
                tracing::warn!(
                    "melt reached coarse particles at t = {:.3e} s; starting anew with a larger fine box",
                    course.scenario.time()
                );
                resume = false;
            }
            ended => return course.end(ended),
        }
    }
    Err(RunError::Outgrown)
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

/// A weld under way.
pub(crate) struct WeldRun {
    simulation: Simulation,
    /// By how much the fine box was grown \[m\].
    grown: f64,
    /// Whether a fine box that turns out too small is widened instead of refused.
    may_grow: bool,
    /// Boiling point of the part's own material \[K\], where its card has one.
    boiling: Option<f64>,
}

impl WeldRun {
    /// A weld at its start, to be looked at.
    pub(crate) fn at_start(simulation: Simulation) -> Self {
        Self { simulation, grown: 0.0, may_grow: false, boiling: None }
    }

    fn laser_off(&self) -> Option<f64> {
        self.simulation.model().laser.as_ref().map(|laser| laser.track().end_time())
    }
}

impl Scenario<3> for WeldRun {
    type Outcome = WeldOutcome;

    fn name(&self) -> &str {
        &self.simulation.model().name
    }

    fn time(&self) -> f64 {
        self.simulation.time()
    }

    fn end(&self) -> f64 {
        self.simulation.model().end
    }

    fn steps(&self) -> u64 {
        self.simulation.steps()
    }

    fn limits(&self) -> &BTreeMap<String, u64> {
        self.simulation.limits()
    }

    fn cost(&self) -> Cost {
        self.simulation.cost()
    }

    fn finished(&self) -> bool {
        self.simulation.finished()
    }

    fn step(&mut self, stop: f64) -> Result<StepReport, Failure> {
        self.simulation.step(stop)
    }

    fn outgrown(&self) -> bool {
        self.may_grow && self.simulation.records().now.beyond_finest
    }

    fn problem(&self) -> Option<Failure> {
        self.simulation.records().now.beyond_finest.then(|| Failure {
            physics: "run",
            what: "melt has reached particles of a coarser level".into(),
            time: self.time(),
            at: self.focus(),
            advice: "enlarge the fine box of resolution.levels, or use Auto or Uniform".into(),
        })
    }

    fn focus(&self) -> Option<[f64; 3]> {
        self.simulation.records().solidus.bounds.map(|bounds| bounds[1])
    }

    fn fault(&self) -> Option<String> {
        self.simulation.ledger().fault()
    }

    /// Conduction mode ends where the surface boils and the recoil of its vapour is more than tension can hold: the numbers from there
    /// on would be those of a weld that does not exist.
    fn left_the_model(&self) -> Option<String> {
        let (peak, recoil) =
            (self.simulation.records().peak_temperature, self.simulation.records().recoil_over_tension);
        let boiling = self.boiling.filter(|&boiling| peak > boiling && recoil > 1.0)?;
        Some(format!(
            "deep penetration at t = {:.6e} s: the surface has reached {peak:.0} K, above the boiling point of {boiling:.0} K, and its \
             vapour presses {recoil:.1} times as hard as tension can hold: a keyhole opens, which this model of conduction mode does \
             not compute; use less power, a wider beam or more speed",
            self.time()
        ))
    }

    fn warnings(&self) -> Vec<String> {
        let peak = self.simulation.records().peak_temperature;
        let recoil = self.simulation.records().recoil_over_tension;
        let tell = |boiling: f64| {
            format!(
                "the surface reached {peak:.0} K, above the boiling point of {boiling:.0} K: it evaporates (evaporation: true of \
                 its Losses computes the heat of that), and its vapour dents it, which is not computed"
            )
        };
        let boils = self.boiling.filter(|&boiling| peak > boiling).map(tell);
        let dents = (boils.is_none() && recoil > 1.0).then(|| {
            format!(
                "at {peak:.0} K the surface does not boil yet, but its vapour presses {recoil:.1} times as hard as tension can hold: \
                 the dent is not computed"
            )
        });
        let mach = report::flow_numbers(&self.simulation).get("mach").copied().unwrap_or(0.0);
        let compressed = format!(
            "the melt reached {mach:.2} of its artificial sound: it is compressed by {:.1} %; set sound_speed_m_s of Flow higher",
            50.0 * mach * mach
        );
        boils.into_iter().chain(dents).chain((mach > LARGEST_MACH).then_some(compressed)).collect()
    }

    fn save(&self, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
        self.simulation.save(case_digest, self.grown)
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointError> {
        self.simulation.restore(checkpoint)
    }

    fn positions(&self) -> &[Vector3<f64>] {
        &self.simulation.particles().position
    }

    fn spacings(&self) -> &[f64] {
        &self.simulation.particles().spacing
    }

    fn spacing(&self) -> f64 {
        self.simulation.model().spacing()
    }

    fn columns(&self) -> Vec<(&'static str, Column<3>)> {
        columns(&self.simulation)
    }

    fn measures(&self, last: &StepReport) -> Measures {
        Measures::Weld(measures(&self.simulation, last))
    }

    /// The pool is largest when the laser goes off.
    fn is_picture_time(&self) -> bool {
        Some(self.time()) == self.laser_off()
    }

    /// A run that does not get to the end of the laser shows its last state.
    fn pictures(&self, at_end: bool) -> Pictures {
        let dark = self.laser_off().is_some_and(|off| self.time() >= off);
        let mut drawn =
            if at_end && dark { last_pictures(&self.simulation) } else { pictures(&self.simulation) };
        if at_end {
            drawn.sections.extend(deformations(&self.simulation));
        }
        drawn
    }

    fn outcome(&self) -> WeldOutcome {
        report::outcome(&self.simulation)
    }

    fn numbers(&self) -> BTreeMap<String, f64> {
        let mut numbers = report::numbers(self.simulation.model());
        numbers.extend(report::flow_numbers(&self.simulation));
        numbers.extend(report::vapour_numbers(&self.simulation));
        numbers
    }

    fn told(&self) -> Vec<String> {
        let (records, ledger) = (self.simulation.records(), self.simulation.ledger());
        let pool = &records.liquidus;
        let mut lines = vec![format!(
            "  pool at the liquidus: width {:.1} um, length {:.1} um, depth {:.1} um; peak {:.0} K",
            1e6 * pool.width,
            1e6 * pool.length,
            1e6 * pool.depth,
            records.peak_temperature
        )];
        lines.extend(records.solidified_at.map(|at| format!("  all solid again at {:.3} ms", 1e3 * at)));
        lines.push(format!(
            "  energy: {:.4} J absorbed of {:.4} J emitted, {:.4} J lost, residual {:.1e}",
            ledger.absorbed, ledger.emitted, ledger.lost, ledger.residual
        ));
        lines
    }
}
