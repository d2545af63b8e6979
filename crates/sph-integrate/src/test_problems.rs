//! Problems with known solutions on which the schemes are tested.

/// Three coupled numbers that decay as y_i' = -y_i (y_0 + y_1 + y_2); the sum S obeys S' = -S^2.
pub(crate) fn riccati(y: &[f64], rate: &mut [f64]) {
    let sum: f64 = y.iter().sum();
    for i in 0..y.len() {
        rate[i] = -y[i] * sum;
    }
}

/// Solution of [`riccati`] from (0.5, 0.3, 1.2) at t = 0: each is divided by 1 + 2 t.
pub(crate) fn riccati_exact(time_s: f64) -> [f64; 3] {
    [0.5, 0.3, 1.2].map(|start| start / (1.0 + 2.0 * time_s))
}

/// Heat on a ring: y_i' = y_{i-1} - 2 y_i + y_{i+1}, with largest eigenvalue 4 for an even size; keeps the
/// sum.
pub(crate) fn ring(y: &[f64], rate: &mut [f64]) {
    rate.fill(0.0);
    for i in 0..y.len() {
        let next = (i + 1) % y.len();
        let flux = y[next] - y[i];
        rate[i] += flux;
        rate[next] -= flux;
    }
}

/// Observed order of `solve`, which returns the state of [`riccati`] at t = 1 after a number of equal steps.
pub(crate) fn observed_order(solve: impl Fn(i32) -> Vec<f64>) -> f64 {
    let error = |steps: i32| {
        let exact = riccati_exact(1.0);
        solve(steps).iter().zip(exact).map(|(y, exact)| (y - exact).powi(2)).sum::<f64>().sqrt()
    };
    (error(80) / error(160)).log2()
}
