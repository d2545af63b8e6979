//! The classical Runge-Kutta step, order 4 (Kutta 1901).

use super::ExplicitScratch;

/// Advances `y` by one step of the classical Runge-Kutta scheme.
///
/// `rhs(t, y, rate)` writes the rate of change.
///
/// # Panics
/// If `y` is not as long as `scratch`.
pub fn rk4_step(
    y: &mut [f64],
    time_s: f64,
    dt_s: f64,
    mut rhs: impl FnMut(f64, &[f64], &mut [f64]),
    scratch: &mut ExplicitScratch,
) {
    let ExplicitScratch { start, rate, sum } = scratch;
    start.copy_from_slice(y);
    sum.fill(0.0);
    // Weight of each stage's rate, and the share of the step at which the next stage stands.
    for (weight, offset, next) in
        [(1.0 / 6.0, 0.0, 0.5), (1.0 / 3.0, 0.5, 0.5), (1.0 / 3.0, 0.5, 1.0), (1.0 / 6.0, 1.0, 0.0)]
    {
        rhs(time_s + offset * dt_s, y, rate);
        for i in 0..y.len() {
            sum[i] += weight * rate[i];
            y[i] = start[i] + next * dt_s * rate[i];
        }
    }
    for i in 0..y.len() {
        y[i] = start[i] + dt_s * sum[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_problems::{observed_order, riccati, riccati_exact, ring};

    #[test]
    fn order_four() {
        let order = observed_order(|steps| {
            let (mut y, mut scratch) = (riccati_exact(0.0).to_vec(), ExplicitScratch::new(3));
            for _ in 0..steps {
                rk4_step(&mut y, 0.0, 1.0 / f64::from(steps), |_, y, rate| riccati(y, rate), &mut scratch);
            }
            y
        });
        assert!((order - 4.0).abs() < 0.1, "{order}");
    }

    #[test]
    fn exact_for_a_rate_cubic_in_time() {
        let mut y = [1.0];
        rk4_step(
            &mut y,
            2.0,
            0.5,
            |time, _, rate| rate[0] = 4.0 * time.powi(3),
            &mut ExplicitScratch::new(1),
        );
        assert!((y[0] - (1.0 + 2.5_f64.powi(4) - 16.0)).abs() < 1e-13);
    }

    #[test]
    fn keeps_the_sum() {
        let (mut y, mut scratch) = ([3.0, -1.0, 7.0, 2.0], ExplicitScratch::new(4));
        (0..100).for_each(|_| rk4_step(&mut y, 0.0, 0.3, |_, y, rate| ring(y, rate), &mut scratch));
        assert!((y.iter().sum::<f64>() - 11.0).abs() < 1e-13);
    }
}
