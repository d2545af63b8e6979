//! The explicit Euler step, order 1.

/// Advances `y` by one explicit Euler step: y + dt f(t, y).
///
/// `rhs(t, y, rate)` writes the rate of change; `rate` is a work column as long as `y`.
pub fn euler_step(
    y: &mut [f64],
    time_s: f64,
    dt_s: f64,
    mut rhs: impl FnMut(f64, &[f64], &mut [f64]),
    rate: &mut [f64],
) {
    rhs(time_s, y, rate);
    for i in 0..y.len() {
        y[i] += dt_s * rate[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_problems::{observed_order, riccati, riccati_exact, ring};

    #[test]
    fn order_one() {
        let order = observed_order(|steps| {
            let (mut y, mut rate) = (riccati_exact(0.0).to_vec(), vec![0.0; 3]);
            for _ in 0..steps {
                euler_step(&mut y, 0.0, 1.0 / f64::from(steps), |_, y, rate| riccati(y, rate), &mut rate);
            }
            y
        });
        assert!((order - 1.0).abs() < 0.1, "{order}");
    }

    #[test]
    fn stable_at_two_over_the_largest_eigenvalue_and_unstable_beyond() {
        let growth = |dt_s: f64| {
            let (mut y, mut rate) = ([1.0, -1.0, 1.0, -1.0], [0.0; 4]);
            (0..100).for_each(|_| euler_step(&mut y, 0.0, dt_s, |_, y, rate| ring(y, rate), &mut rate));
            y[0].abs()
        };
        assert!(growth(0.499) < 1.0 && growth(0.51) > 10.0);
    }

    #[test]
    fn keeps_the_sum() {
        let (mut y, mut rate) = ([3.0, -1.0, 7.0, 2.0], [0.0; 4]);
        (0..100).for_each(|_| euler_step(&mut y, 0.0, 0.3, |_, y, rate| ring(y, rate), &mut rate));
        assert!((y.iter().sum::<f64>() - 11.0).abs() < 1e-13);
    }
}
