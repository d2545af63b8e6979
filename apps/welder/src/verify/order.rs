//! The order of convergence that errors at several resolutions show.

use super::LevelResult;

/// Errors this small are round-off and show no order.
pub(super) const ROUND_OFF: f64 = 1e-11;

/// Minus the slope of log(error) over log(resolution), by least squares; none for fewer than two levels or round-off.
pub fn observed_order(levels: &[LevelResult]) -> Option<f64> {
    if levels.len() < 2 || levels.iter().any(|level| level.error.is_nan() || level.error <= ROUND_OFF) {
        return None;
    }
    let points: Vec<_> = levels.iter().map(|level| (level.resolution.ln(), level.error.ln())).collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    Some(-covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(errors: &[f64]) -> Vec<LevelResult> {
        let level = |(k, &error): (usize, &f64)| LevelResult {
            resolution: 10.0 * 2f64.powi(k as i32),
            particles: 1,
            error,
            pair_visits: 0,
            cpu_s: None,
            wall_s: 0.0,
        };
        errors.iter().enumerate().map(level).collect()
    }

    #[test]
    fn powers_are_found() {
        assert!((observed_order(&levels(&[0.16, 0.04, 0.01])).unwrap() - 2.0).abs() < 1e-12);
        assert!((observed_order(&levels(&[0.1, 0.2])).unwrap() + 1.0).abs() < 1e-12);
    }

    #[test]
    fn round_off_and_single_levels_show_none() {
        assert_eq!(observed_order(&levels(&[0.1])), None);
        assert_eq!(observed_order(&levels(&[1e-14, 1e-15, 0.0])), None);
        assert_eq!(observed_order(&levels(&[0.1, f64::NAN])), None);
    }
}
