//! Quadrature and roots.

use gauss_quad::GaussLegendre;
use std::num::NonZeroUsize;
use std::sync::LazyLock;

/// Points of the rule on each panel.
const POINTS: usize = 20;

/// Largest number of panels.
const LARGEST_PANELS: usize = 4096;

static RULE: LazyLock<GaussLegendre> =
    LazyLock::new(|| GaussLegendre::new(NonZeroUsize::new(POINTS).expect("twenty is not zero")));

/// Integral of `f` from `a` to `b` by Gauss-Legendre panels, halved until the sum changes by 1e-13 of itself.
pub(super) fn integral(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let with = |panels: usize| -> f64 {
        let edge = |k: usize| a + (b - a) * k as f64 / panels as f64;
        (0..panels).map(|k| RULE.integrate(edge(k), edge(k + 1), &f)).sum()
    };
    let (mut panels, mut last) = (1, with(1));
    loop {
        panels *= 2;
        let next = with(panels);
        if (next - last).abs() <= 1e-13 * next.abs() || panels >= LARGEST_PANELS {
            return next;
        }
        last = next;
    }
}

/// Root between `low` and `high` of a function that is positive at `low` and not at `high`, to the last bit or so.
pub(super) fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrals_of_known_functions() {
        assert!((integral(f64::exp, 0.0, 1.0) - (1f64.exp() - 1.0)).abs() < 1e-14);
        let gauss = integral(|x| (-x * x).exp(), 0.0, 3.0);
        assert!((gauss - 0.5 * std::f64::consts::PI.sqrt() * libm::erf(3.0)).abs() < 1e-14);
        let narrow = integral(|x| 1.0 / (1e-6 + x * x), -1.0, 1.0);
        assert!((narrow / (2e3 * 1e3f64.atan()) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn roots_to_the_last_bit() {
        assert!((root(|x| 2.0 - x * x, 0.0, 2.0) - 2f64.sqrt()).abs() < 1e-15);
        assert!((root(f64::cos, 1.0, 2.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }
}
