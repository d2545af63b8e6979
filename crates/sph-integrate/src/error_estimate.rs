//! The embedded error estimate of stabilised schemes of second order, and its norm.

/// Estimate of the local error of one unknown over a step of `tau_s`:
/// (12 (y_n - y_{n+1}) + 6 tau (f_n + f_{n+1})) / 15; Sommeijer, Shampine and Verwer (1998), RKC.
///
/// It compares the step with the trapezoidal rule on its two ends: tau^3 y'''/15 to leading order if the step
/// is exact. For RKL2 it is 1.5 (3 stages) to 2 (many stages) times the true error of a linear problem.
#[inline]
#[must_use]
pub fn local_error(y_start: f64, y_end: f64, rate_start: f64, rate_end: f64, tau_s: f64) -> f64 {
    (12.0 * (y_start - y_end) + 6.0 * tau_s * (rate_start + rate_end)) / 15.0
}

/// How large an error of an unknown may be: `absolute + relative * max(|y_n|, |y_{n+1}|)`, in the unit of the
/// unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorWeight {
    /// Error accepted at any size.
    pub absolute: f64,
    /// Error accepted per size of the unknown.
    pub relative: f64,
}

impl ErrorWeight {
    /// Error over accepted error of one unknown.
    #[inline]
    #[must_use]
    pub fn weigh(&self, error: f64, y_start: f64, y_end: f64) -> f64 {
        error / (self.absolute + self.relative * y_start.abs().max(y_end.abs()))
    }
}

/// Root mean square over all unknowns of the weighed [`local_error`]; 0 for none. One is just acceptable.
///
/// The sum runs in index order, so that it has the same bits every time.
///
/// # Panics
/// If a column is shorter than `y_start`.
#[must_use]
pub fn weighted_rms_error(
    [y_start, y_end]: [&[f64]; 2],
    [rate_start, rate_end]: [&[f64]; 2],
    tau_s: f64,
    weight: ErrorWeight,
) -> f64 {
    let square = |i: usize| {
        let error = local_error(y_start[i], y_end[i], rate_start[i], rate_end[i], tau_s);
        weight.weigh(error, y_start[i], y_end[i]).powi(2)
    };
    ((0..y_start.len()).map(square).sum::<f64>() / y_start.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rkl2::{Rkl2Coefficients, Rkl2Scratch, rkl2_step};
    use crate::test_problems::riccati;

    #[test]
    fn third_derivative_of_an_exact_step() {
        // y = exp(-t): tau^3 y'''/15 in the middle of the step.
        let tau_s = 1e-3_f64;
        let estimate = local_error(1.0, (-tau_s).exp(), -1.0, -(-tau_s).exp(), tau_s);
        let expected = -tau_s.powi(3) / 15.0 * (-0.5 * tau_s).exp();
        assert!((estimate / expected - 1.0).abs() < 1e-5, "{estimate} {expected}");
    }

    #[test]
    fn vanishes_for_quadratics() {
        let y = |t: f64| 3.0 * t * t - 2.0 * t + 1.0;
        let rate = |t: f64| 6.0 * t - 2.0;
        assert!(local_error(y(1.0), y(1.7), rate(1.0), rate(1.7), 0.7).abs() < 1e-15);
    }

    #[test]
    fn falls_with_the_cube_of_a_real_step_and_is_not_below_its_error() {
        let step = |tau_s: f64| {
            let start = [0.5, 0.3, 1.2];
            let (mut y, mut rates) = (start.to_vec(), [[0.0; 3]; 2]);
            let table = Rkl2Coefficients::new(9).unwrap();
            rkl2_step(&mut y, tau_s, &table, riccati, &mut Rkl2Scratch::new(3));
            riccati(&start, &mut rates[0]);
            riccati(&y, &mut rates[1]);
            let weight = ErrorWeight { absolute: 1.0, relative: 0.0 };
            let estimate = weighted_rms_error([&start, &y], [&rates[0], &rates[1]], tau_s, weight);
            let square: f64 = (0..3).map(|i| (y[i] - start[i] / (1.0 + 2.0 * tau_s)).powi(2)).sum();
            (estimate, (square / 3.0).sqrt())
        };
        let ((coarse, true_error), (fine, _)) = (step(2e-3), step(1e-3));
        assert!(((coarse / fine).log2() - 3.0).abs() < 0.05, "{coarse} {fine}");
        assert!(coarse > true_error && coarse < 10.0 * true_error, "{coarse} {true_error}");
    }

    #[test]
    fn overestimates_rkl2_by_the_documented_factor() {
        // R(z) = 1 + z + z^2/2 + c z^3 makes (3 - 12 c)/15 z^3 of a true error (1/6 - c) z^3.
        for (stages, expected) in [(3, 22.0 / 15.0), (51, 2.0)] {
            let (mut y, table) = (vec![1.0], Rkl2Coefficients::new(stages).unwrap());
            rkl2_step(&mut y, 1e-3, &table, |y, rate| rate[0] = -y[0], &mut Rkl2Scratch::new(1));
            let ratio = local_error(1.0, y[0], -1.0, -y[0], 1e-3) / ((-1e-3_f64).exp() - y[0]);
            assert!((ratio / expected - 1.0).abs() < 0.01, "{stages} stages: {ratio}");
        }
    }

    #[test]
    fn weight_mixes_absolute_and_relative() {
        let weight = ErrorWeight { absolute: 0.5, relative: 0.1 };
        assert_eq!(weight.weigh(3.0, -10.0, 25.0), 1.0);
        let columns: [&[f64]; 2] = [&[0.0, 0.0], &[0.0, 1.0]];
        // Errors 0 and -0.8, weights 0.5 and 0.6: rms of (0, 4/3).
        let rms = weighted_rms_error(columns, [&[0.0; 2], &[0.0; 2]], 1.0, weight);
        assert!((rms - (0.8_f64 / 0.6) / 2.0_f64.sqrt()).abs() < 1e-15);
        assert_eq!(weighted_rms_error([&[], &[]], [&[], &[]], 1.0, weight), 0.0);
    }
}
