//! The choice of the next step from the error of the last.

use crate::error::{Error, require};

/// What to do with a step whose error is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Decision {
    /// Keep the step and try `next_s` next (s).
    Accept {
        /// Length to try next (s).
        next_s: f64,
    },
    /// Go back and try again with `retry_s` (s).
    Reject {
        /// Length to try again (s).
        retry_s: f64,
    },
}

/// What the controller remembers; save it and give it back to continue with the same bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ControllerState {
    /// Length of the last accepted step (s); 0 before the first.
    pub last_step_s: f64,
    /// Error of that step over the tolerance.
    pub last_error: f64,
    /// Largest growth of the next step: 1 after a rejection, else infinite.
    pub growth_cap: f64,
}

impl Default for ControllerState {
    fn default() -> Self {
        Self { last_step_s: 0.0, last_error: 0.0, growth_cap: f64::INFINITY }
    }
}

/// The predictive step controller for schemes of second order; Sommeijer, Shampine and Verwer (1998), after
/// Watts (1984).
///
/// The factor on the step is 0.8 (1/e_n)^(1/3), after an earlier accepted step times (e_{n-1}/e_n)^(1/3)
/// h_n/h_{n-1}, and lies between 0.1 and the largest growth; a step after a rejection does not grow.
#[derive(Debug, Clone, PartialEq)]
pub struct StepController {
    tolerance: f64,
    largest_growth: f64,
    state: ControllerState,
}

/// Share of the step that the error would allow.
const SAFETY: f64 = 0.8;
/// Smallest factor on a step.
const SMALLEST_FACTOR: f64 = 0.1;
/// Errors below this share of the tolerance say no more about the step.
const ERROR_FLOOR: f64 = 1e-12;

impl StepController {
    /// A controller that accepts errors up to `tolerance` and lets a step grow by at most `largest_growth`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the tolerance is not positive or the growth not above one.
    pub fn new(tolerance: f64, largest_growth: f64) -> Result<Self, Error> {
        let positive = tolerance.is_finite() && tolerance > 0.0;
        require(positive, "tolerance", tolerance, "a positive number")?;
        let grows = largest_growth.is_finite() && largest_growth > 1.0;
        require(grows, "largest_growth", largest_growth, "a number above one")?;
        Ok(Self { tolerance, largest_growth, state: ControllerState::default() })
    }

    /// What the controller remembers.
    #[must_use]
    pub fn state(&self) -> ControllerState {
        self.state
    }

    /// Sets what the controller remembers, as from [`StepController::state`].
    pub fn restore(&mut self, state: ControllerState) {
        self.state = state;
    }

    /// Judges a step of `step_s` with the error norm `error` and proposes the next. An error that is not
    /// finite is rejected like a very large one.
    pub fn propose(&mut self, step_s: f64, error: f64) -> Decision {
        let error = error / self.tolerance;
        // Not a number fails this comparison.
        if error <= 1.0 { self.accept(step_s, error.max(ERROR_FLOOR)) } else { self.reject(step_s, error) }
    }

    fn accept(&mut self, step_s: f64, error: f64) -> Decision {
        let ControllerState { last_step_s, last_error, growth_cap } = self.state;
        let trend =
            if last_step_s > 0.0 { (last_error / error).cbrt() * (step_s / last_step_s) } else { 1.0 };
        let growth = self.largest_growth.min(growth_cap);
        let factor = (SAFETY / error.cbrt() * trend).clamp(SMALLEST_FACTOR, growth);
        self.state = ControllerState { last_step_s: step_s, last_error: error, growth_cap: f64::INFINITY };
        Decision::Accept { next_s: factor * step_s }
    }

    fn reject(&mut self, step_s: f64, error: f64) -> Decision {
        self.state.growth_cap = 1.0;
        let factor =
            if error.is_finite() { (SAFETY / error.cbrt()).max(SMALLEST_FACTOR) } else { SMALLEST_FACTOR };
        Decision::Reject { retry_s: factor * step_s }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error_estimate::local_error;
    use crate::explicit::{ExplicitScratch, rk2_step};

    fn next(decision: Decision) -> f64 {
        match decision {
            Decision::Accept { next_s } => next_s,
            Decision::Reject { retry_s } => retry_s,
        }
    }

    #[test]
    fn first_step_follows_the_cube_root() {
        let mut controller = StepController::new(1e-3, 10.0).unwrap();
        let decision = controller.propose(2.0, 1e-3 / 8.0);
        assert!(matches!(decision, Decision::Accept { next_s } if (next_s - 3.2).abs() < 1e-14));
        // The trend: error up 8 times on an equal step halves what the error alone would allow.
        let decision = controller.propose(2.0, 1e-3);
        assert!((next(decision) - 2.0 * 0.8 * 0.5).abs() < 1e-14);
    }

    #[test]
    fn growth_and_shrinkage_are_bounded() {
        let mut controller = StepController::new(1.0, 3.0).unwrap();
        assert_eq!(controller.propose(1.0, 0.0), Decision::Accept { next_s: 3.0 });
        assert_eq!(controller.propose(1.0, 1e30), Decision::Reject { retry_s: 0.1 });
        assert_eq!(controller.propose(1.0, f64::NAN), Decision::Reject { retry_s: 0.1 });
        assert_eq!(
            controller.propose(0.1, 0.0),
            Decision::Accept { next_s: 0.1 },
            "no growth after a rejection"
        );
        assert_eq!(controller.propose(0.1, 1e-12), Decision::Accept { next_s: 0.1 * 3.0 });
    }

    #[test]
    fn restored_controller_continues_with_the_same_bits() {
        let errors = [0.3, 0.9, 1.7, 0.4, 0.01, 0.6];
        let mut through = StepController::new(1.0, 5.0).unwrap();
        let expected: Vec<Decision> = errors.iter().map(|&error| through.propose(1.0, error)).collect();
        for cut in 0..errors.len() {
            let mut first = StepController::new(1.0, 5.0).unwrap();
            errors[..cut].iter().for_each(|&error| _ = first.propose(1.0, error));
            let mut second = StepController::new(1.0, 5.0).unwrap();
            second.restore(first.state());
            let rest: Vec<Decision> = errors[cut..].iter().map(|&error| second.propose(1.0, error)).collect();
            assert_eq!(rest, expected[cut..]);
        }
    }

    #[test]
    fn error_of_a_run_follows_the_tolerance() {
        // A fast transient, then slow: y' = -50 (y - cos t) from 0.
        let rhs = |time: f64, y: &[f64], rate: &mut [f64]| rate[0] = -50.0 * (y[0] - time.cos());
        let run = |tolerance: f64| {
            let mut controller = StepController::new(tolerance, 5.0).unwrap();
            let (mut time, mut step, mut y, mut steps) = (0.0, 1e-4, [0.0], 0);
            while time < 1.0 - 1e-12 {
                let (start, mut rates) = (y, [[0.0]; 2]);
                step = f64::min(step, 1.0 - time);
                rhs(time, &start, &mut rates[0]);
                rk2_step(&mut y, time, step, rhs, &mut ExplicitScratch::new(1));
                rhs(time + step, &y, &mut rates[1]);
                let error = local_error(start[0], y[0], rates[0][0], rates[1][0], step).abs();
                match controller.propose(step, error) {
                    Decision::Accept { next_s } => (time, step, steps) = (time + step, next_s, steps + 1),
                    Decision::Reject { retry_s } => (step, y) = (retry_s, start),
                }
            }
            // y = (2500 cos t + 50 sin t)/2501 + C exp(-50 t).
            let exact = (2500.0 * 1.0_f64.cos() + 50.0 * 1.0_f64.sin()) / 2501.0;
            ((y[0] - exact).abs(), steps)
        };
        let ((loose, few), (tight, many)) = (run(1e-4), run(1e-7));
        assert!(loose < 1e-3 && tight < 1e-6, "{loose} {tight}");
        assert!(few > 20 && few < 100 && many > 2 * few && many < 30 * few, "{few} {many}");
    }

    #[test]
    fn bad_settings_are_refused() {
        assert!(StepController::new(0.0, 5.0).unwrap_err().to_string().starts_with("tolerance is 0"));
        assert!(StepController::new(1.0, 1.0).unwrap_err().to_string().starts_with("largest_growth is 1"));
    }
}
