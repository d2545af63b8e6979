//! How long a super step may be, and why.

use super::Rkl2Coefficients;
use crate::case::scene::Stepping;
use crate::model::ModelError;
use laser_source::LaserSource;
use serde::{Deserialize, Serialize};
use sph_integrate::{ControllerState, Decision, StepController, StepLimit, max_step, smallest, stages_for};

/// A moving beam goes at most this many beam radii (1/e) in a super step.
const BEAM_RADII_PER_STEP: f64 = 0.08;

/// A pulse is cut into at least this many super steps.
const STEPS_PER_PULSE: f64 = 25.0;

/// A step may grow by this factor at most.
const LARGEST_GROWTH: f64 = 3.0;

/// Steps up to this many Euler steps are always kept: three stages, and then the error of time is below that of space.
const SHORTEST_IN_EULER_STEPS: f64 = 2.5;

/// Estimated error that a step may make over the heat taken up so far, where the scene names none: under a laser, whose
/// own rule holds the steps already; after it, when the pool freezes; and where there is no laser.
const TOLERANCE_LIT: f64 = 0.05;
const TOLERANCE_AFTER: f64 = 0.02;
const TOLERANCE_WITHOUT_LASER: f64 = 1e-3;

/// What to do with a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Verdict {
    /// Keep it.
    Accept,
    /// Take it back and try with this one \[s\].
    Retry(f64),
}

/// What a checkpoint holds.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct State {
    next: f64,
    last: f64,
    error: f64,
    growth_cap: f64,
}

/// Step control of heat: stability, the source's rule, and the estimated error.
pub(super) struct StepSize {
    /// Judges errors over their tolerance.
    controller: Option<StepController>,
    /// The tolerance that the scene names.
    tolerance: Option<f64>,
    /// Longest stable explicit Euler step \[s\].
    euler: f64,
    largest_stages: usize,
    /// Longest step that any limit but the error allows, in Euler steps.
    stable: f64,
    source: Vec<SourceRule>,
    /// Times at which the laser changes \[s\].
    events: Vec<f64>,
    next: f64,
}

/// A span of time in which the laser is on, and the longest step within it \[s\].
struct SourceRule {
    from: f64,
    to: f64,
    longest: f64,
}

impl StepSize {
    pub(super) fn new(
        stepping: Stepping,
        laser: Option<&LaserSource>,
        euler: f64,
    ) -> Result<Self, ModelError> {
        let (tolerance, controller, largest_stages, stable) = match stepping {
            Stepping::SuperSteps { tolerance, max_stages } => {
                // RKL2 takes odd numbers of stages, three at least.
                let stages = (max_stages.max(3) as usize - 1) | 1;
                let stages = if stages > max_stages.max(3) as usize { stages - 2 } else { stages };
                let controller = StepController::new(1.0, LARGEST_GROWTH)?;
                (tolerance, Some(controller), stages, max_step(stages, 1.0))
            }
            Stepping::Euler { factor } => (None, None, 1, factor),
        };
        Ok(Self {
            controller,
            tolerance,
            euler,
            largest_stages,
            stable,
            source: laser.map_or_else(Vec::new, source_rules),
            events: laser.map_or_else(Vec::new, |laser| laser.track().events()),
            next: SHORTEST_IN_EULER_STEPS * euler,
        })
    }

    /// Takes another longest stable Euler step \[s\], after rows have changed.
    pub(super) fn set_euler(&mut self, euler: f64) {
        self.euler = euler;
    }

    pub(super) fn euler(&self) -> f64 {
        self.euler
    }

    /// Steps this short are always kept \[s\].
    pub(super) fn smallest(&self) -> f64 {
        SHORTEST_IN_EULER_STEPS * self.euler
    }

    /// The stages of a step; none for an explicit Euler step.
    pub(super) fn coefficients(&self, step: f64) -> Option<Rkl2Coefficients> {
        self.controller.as_ref()?;
        let stages = stages_for(step, self.euler).min(self.largest_stages);
        Some(Rkl2Coefficients::new(stages).expect("an odd number of stages, three at least"))
    }

    /// Forgets what steps before `time` \[s\] proposed if the laser has just changed: the field next to it has no smooth past.
    pub(super) fn begin(&mut self, time: f64) {
        self.next = self.proposed(time);
    }

    fn proposed(&self, time: f64) -> f64 {
        if self.events.contains(&time) { self.next.min(self.smallest()) } else { self.next }
    }

    /// The longest step from `time` \[s\] and what limits it.
    pub(super) fn limit(&self, time: f64) -> StepLimit {
        // A laser that has just changed starts anew: the field next to it has no smooth past.
        let by_error = self.proposed(time);
        let rule = self.source.iter().find(|rule| time >= rule.from && time < rule.to);
        let stability = if self.controller.is_some() { "heat stages" } else { "heat Euler step" };
        let mut limits = vec![StepLimit { name: stability, dt_s: self.stable * self.euler }];
        if self.controller.is_some() {
            limits.push(StepLimit { name: "heat error", dt_s: by_error });
            limits.extend(rule.map(|rule| StepLimit { name: "laser", dt_s: rule.longest }));
        }
        smallest(limits)
    }

    /// Shortest of the laser's own limits \[s\].
    pub(super) fn laser_step(&self) -> Option<f64> {
        self.source.iter().map(|rule| rule.longest).reduce(f64::min)
    }

    /// The next time after `time` at which the laser changes \[s\].
    pub(super) fn next_event(&self, time: f64) -> Option<f64> {
        self.events.iter().copied().find(|&event| event > time)
    }

    /// The tolerance of a step that starts at `time` \[s\].
    fn tolerance_at(&self, time: f64) -> f64 {
        self.tolerance.unwrap_or(match self.source.last() {
            None => TOLERANCE_WITHOUT_LASER,
            Some(last) if time >= last.to => TOLERANCE_AFTER,
            Some(_) => TOLERANCE_LIT,
        })
    }

    /// Judges a step of `step` from `time` \[s\] with the estimated relative error `error`.
    pub(super) fn judge(&mut self, time: f64, step: f64, error: f64) -> Verdict {
        let (shortest, tolerance) = (self.smallest(), self.tolerance_at(time));
        let Some(controller) = &mut self.controller else { return Verdict::Accept };
        match controller.propose(step, error / tolerance) {
            Decision::Accept { next_s } => {
                // A step that an event cut short says nothing against the longer one that was proposed before it.
                let proposed = if step < self.next { self.next } else { shortest };
                self.next = next_s.max(proposed).max(shortest);
                Verdict::Accept
            }
            Decision::Reject { .. } if step <= shortest => {
                self.next = shortest;
                Verdict::Accept
            }
            Decision::Reject { retry_s } => {
                self.next = retry_s.max(shortest);
                Verdict::Retry(self.next)
            }
        }
    }

    pub(super) fn state(&self) -> State {
        let controller = self.controller.as_ref().map(StepController::state).unwrap_or_default();
        let ControllerState { last_step_s: last, last_error: error, growth_cap } = controller;
        State { next: self.next, last, error, growth_cap }
    }

    pub(super) fn restore(&mut self, state: State) {
        self.next = state.next;
        if let Some(controller) = &mut self.controller {
            let State { last: last_step_s, error: last_error, growth_cap, .. } = state;
            controller.restore(ControllerState { last_step_s, last_error, growth_cap });
        }
    }
}

fn source_rules(laser: &LaserSource) -> Vec<SourceRule> {
    let speed = laser.track().max_speed();
    let by_speed =
        if speed > 0.0 { BEAM_RADII_PER_STEP * laser.beam().radius_m() / speed } else { f64::INFINITY };
    let rule = |[from, to]: [f64; 2]| {
        let by_pulse = if speed > 0.0 { f64::INFINITY } else { (to - from) / STEPS_PER_PULSE };
        SourceRule { from, to, longest: by_speed.min(by_pulse) }
    };
    laser.track().on_intervals().into_iter().map(rule).collect()
}
