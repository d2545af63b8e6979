//! RKL2: a stabilised explicit super step of second order for diffusion.

mod coefficients;

pub use coefficients::{Rkl2Coefficients, Stage, max_step, stages_for};

/// Work columns of [`rkl2_step`], as long as the state.
#[derive(Debug, Clone)]
pub struct Rkl2Scratch {
    start: Vec<f64>,
    before: Vec<f64>,
    start_rate: Vec<f64>,
    rate: Vec<f64>,
}

impl Rkl2Scratch {
    /// Columns for a state of `size` numbers.
    #[must_use]
    pub fn new(size: usize) -> Self {
        let column = vec![0.0; size];
        Self { start: column.clone(), before: column.clone(), start_rate: column.clone(), rate: column }
    }
}

/// Advances `y` by one super step of `tau_s` of y' = `rhs`(y); RKL2 of Meyer, Balsara and Aslam (2014).
///
/// `rhs(y, rate)` writes the rate of change; it must not depend on time within the step. The step is stable
/// if `tau_s` is at most [`max_step`]. This driver is written for clarity; where the right-hand side is a row
/// product, fuse it with the stage update from [`Rkl2Coefficients`] in one pass.
///
/// # Panics
/// If `y` is not as long as `scratch`.
pub fn rkl2_step(
    y: &mut [f64],
    tau_s: f64,
    coefficients: &Rkl2Coefficients,
    mut rhs: impl FnMut(&[f64], &mut [f64]),
    scratch: &mut Rkl2Scratch,
) {
    let Rkl2Scratch { start, before, start_rate, rate } = scratch;
    start.copy_from_slice(y);
    before.copy_from_slice(y);
    rhs(y, start_rate);
    for i in 0..y.len() {
        y[i] += coefficients.first_mu_tilde() * tau_s * start_rate[i];
    }
    for stage in coefficients.stages() {
        rhs(y, rate);
        for i in 0..y.len() {
            let next = stage.mu * y[i]
                + stage.nu * before[i]
                + stage.one_minus_mu_nu * start[i]
                + tau_s * (stage.mu_tilde * rate[i] + stage.gamma_tilde * start_rate[i]);
            before[i] = y[i];
            y[i] = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_problems::{observed_order, riccati, riccati_exact, ring};

    fn coefficients(stages: usize) -> Rkl2Coefficients {
        Rkl2Coefficients::new(stages).unwrap()
    }

    #[test]
    fn order_two_on_a_nonlinear_problem() {
        for stages in [3, 5, 9, 21] {
            let order = observed_order(|steps| {
                let (mut y, mut scratch) = (riccati_exact(0.0).to_vec(), Rkl2Scratch::new(3));
                for _ in 0..steps {
                    rkl2_step(&mut y, 1.0 / f64::from(steps), &coefficients(stages), riccati, &mut scratch);
                }
                y
            });
            assert!((order - 2.0).abs() < 0.1, "{stages} stages: order {order}");
        }
    }

    /// Mean size of the shortest wave of a ring of 64 under `factor` times the largest step, over 50 steps.
    fn growth(stages: usize, factor: f64) -> f64 {
        // Largest eigenvalue of the ring 4, so an Euler step may be 2/4.
        let tau_s = factor * max_step(stages, 0.5);
        let mut y: Vec<f64> = (0..64).map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
        let mut scratch = Rkl2Scratch::new(64);
        for _ in 0..50 {
            rkl2_step(&mut y, tau_s, &coefficients(stages), ring, &mut scratch);
        }
        y.iter().map(|value| value.abs()).sum::<f64>() / 64.0
    }

    #[test]
    fn stable_at_the_limit_and_unstable_just_beyond() {
        for stages in [3, 5, 9, 15, 31] {
            let (inside, beyond) = (growth(stages, 0.999), growth(stages, 1.2));
            assert!(inside < 1.0, "{stages} stages: {inside}");
            assert!(beyond > 1e3 || !beyond.is_finite(), "{stages} stages: {beyond}");
        }
    }

    #[test]
    fn all_waves_are_damped_at_the_limit() {
        let size = 64;
        let mut y: Vec<f64> = (0..size).map(|i| ((i * i * 7 + 3 * i) % 13) as f64 - 6.0).collect();
        let mean = y.iter().sum::<f64>() / size as f64;
        let mut scratch = Rkl2Scratch::new(size);
        let mut last = f64::INFINITY;
        for _ in 0..30 {
            rkl2_step(&mut y, max_step(9, 0.5), &coefficients(9), ring, &mut scratch);
            let square: f64 = y.iter().map(|value| (value - mean).powi(2)).sum();
            assert!(square < last);
            last = square;
        }
    }

    #[test]
    fn sum_is_kept_to_round_off_by_an_antisymmetric_right_hand_side() {
        let mut y: Vec<f64> = (0..100).map(|i| 300.0 + f64::from(i * i % 17)).collect();
        let sum: f64 = y.iter().sum();
        let mut scratch = Rkl2Scratch::new(100);
        for _ in 0..100 {
            rkl2_step(&mut y, max_step(7, 0.5), &coefficients(7), ring, &mut scratch);
        }
        let drift = y.iter().sum::<f64>() / sum - 1.0;
        assert!(drift.abs() < 1e-14, "{drift}");
    }

    #[test]
    fn a_constant_source_is_integrated_exactly() {
        let mut y = vec![1.0];
        rkl2_step(&mut y, 0.3, &coefficients(11), |_, rate| rate[0] = 5.0, &mut Rkl2Scratch::new(1));
        assert!((y[0] - 2.5).abs() < 1e-14);
    }
}
