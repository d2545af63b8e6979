//! The explicit midpoint step, order 2 (Runge 1895).

use super::ExplicitScratch;

/// Advances `y` by one step of the midpoint rule: y + dt f(t + dt/2, y + dt/2 f(t, y)).
///
/// `rhs(t, y, rate)` writes the rate of change.
///
/// # Panics
/// If `y` is not as long as `scratch`.
pub fn rk2_step(
    y: &mut [f64],
    time_s: f64,
    dt_s: f64,
    mut rhs: impl FnMut(f64, &[f64], &mut [f64]),
    scratch: &mut ExplicitScratch,
) {
    let ExplicitScratch { start, rate, .. } = scratch;
    start.copy_from_slice(y);
    rhs(time_s, y, rate);
    for i in 0..y.len() {
        y[i] = start[i] + 0.5 * dt_s * rate[i];
    }
    rhs(time_s + 0.5 * dt_s, y, rate);
    for i in 0..y.len() {
        y[i] = start[i] + dt_s * rate[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_problems::{observed_order, riccati, riccati_exact, ring};

    #[test]
    fn order_two() {
        let order = observed_order(|steps| {
            let (mut y, mut scratch) = (riccati_exact(0.0).to_vec(), ExplicitScratch::new(3));
            for _ in 0..steps {
                rk2_step(&mut y, 0.0, 1.0 / f64::from(steps), |_, y, rate| riccati(y, rate), &mut scratch);
            }
            y
        });
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }

    #[test]
    fn exact_for_a_rate_linear_in_time() {
        let mut y = [1.0];
        rk2_step(&mut y, 2.0, 0.5, |time, _, rate| rate[0] = 6.0 * time, &mut ExplicitScratch::new(1));
        assert!((y[0] - (1.0 + 3.0 * (6.25 - 4.0))).abs() < 1e-14);
    }

    #[test]
    fn keeps_the_sum() {
        let (mut y, mut scratch) = ([3.0, -1.0, 7.0, 2.0], ExplicitScratch::new(4));
        (0..100).for_each(|_| rk2_step(&mut y, 0.0, 0.3, |_, y, rate| ring(y, rate), &mut scratch));
        assert!((y.iter().sum::<f64>() - 11.0).abs() < 1e-13);
    }
}
