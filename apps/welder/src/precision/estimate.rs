//! Estimates of error for each setting and quantity, and the cheapest run that is as exact as wanted.

use super::Point;
use super::convergence::{Convergence, index_of_two};
use super::quantity::{QUANTITIES, Quantity};
use super::settings::TIGHT;
use serde::Serialize;

/// What the spacings of one setting say about one quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Estimate {
    pub(super) setting: String,
    pub(super) quantity: &'static str,
    pub(super) unit: &'static str,
    /// The finest spacing.
    pub(super) spacing_m: f64,
    /// The value there, in `unit`.
    pub(super) value: f64,
    #[serde(flatten)]
    pub(super) convergence: Convergence,
}

/// Estimates for every setting that ran at three spacings or more.
pub(super) fn estimates(points: &[Point]) -> Vec<Estimate> {
    let pairs = names(points).into_iter().flat_map(|name| QUANTITIES.iter().map(move |q| (name, q)));
    pairs.filter_map(|(setting, quantity)| estimate(setting, quantity, points)).collect()
}

/// The settings in the order in which they ran.
pub(super) fn names(points: &[Point]) -> Vec<&str> {
    let mut names: Vec<_> = points.iter().map(|point| point.setting.as_str()).collect();
    names.dedup();
    names
}

fn estimate(setting: &str, quantity: &Quantity, points: &[Point]) -> Option<Estimate> {
    let own = points.iter().filter(|point| point.setting == setting);
    let ladder: Vec<_> = own.map(|p| (p.spacing_m, quantity.scale * (quantity.of)(&p.sizes))).collect();
    let convergence = Convergence::of(&ladder)?;
    let &(spacing_m, value) = ladder.last()?;
    let (quantity, unit) = (quantity.name, quantity.unit);
    Some(Estimate { setting: setting.into(), quantity, unit, spacing_m, value, convergence })
}

/// Relative uncertainty of the reference in each quantity: the grid convergence index of the ladder that ends with it, or,
/// where the ladder shows no order, that of its two finest runs.
pub(super) fn reference_indices(points: &[Point], estimates: &[Estimate]) -> Vec<f64> {
    let mut own = points.iter().rev().filter(|point| point.setting == TIGHT);
    let (Some(fine), Some(coarse)) = (own.next(), own.next()) else {
        return vec![f64::NAN; QUANTITIES.len()];
    };
    let index = |quantity: &Quantity| {
        let ladder = estimates.iter().find(|e| e.setting == TIGHT && e.quantity == quantity.name);
        let of_two = || {
            let value = |point: &Point| (quantity.of)(&point.sizes);
            index_of_two(value(fine), value(coarse), coarse.spacing_m / fine.spacing_m)
        };
        ladder.and_then(|estimate| estimate.convergence.index).unwrap_or_else(of_two)
    };
    QUANTITIES.iter().map(index).collect()
}

/// Largest error of a run over the quantities, and of which: its difference to the reference and what the reference may be
/// off. Quantities that the case does not have (no melt) are no numbers and do not count.
pub(super) fn bound(point: &Point, reference_indices: &[f64]) -> (f64, &'static str) {
    let bounds = QUANTITIES
        .iter()
        .zip(reference_indices)
        .map(|(quantity, index)| ((quantity.error)(&point.errors).abs() + index, quantity.name));
    bounds.fold((0.0, "nothing"), |largest, one| if one.0 > largest.0 { one } else { largest })
}

/// The run of least processor time whose bound is at most `wanted`.
pub(super) fn cheapest<'a>(points: &'a [Point], reference_indices: &[f64], wanted: f64) -> Option<&'a Point> {
    let good = points.iter().filter(|point| bound(point, reference_indices).0 <= wanted);
    good.min_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s))
}

/// The run of the least bound.
pub(super) fn most_exact<'a>(points: &'a [Point], reference_indices: &[f64]) -> Option<&'a Point> {
    let bound = |point: &&Point| bound(point, reference_indices).0;
    points.iter().min_by(|a, b| bound(a).total_cmp(&bound(b)))
}

#[cfg(test)]
mod tests {
    use super::super::quantity::{Errors, Sizes};
    use super::*;

    /// A run whose sizes are all off by `error`.
    fn point(setting: &str, spacing_m: f64, cpu_s: f64, error: f64) -> Point {
        let size = 1.0 + error;
        let sizes = Sizes {
            width_m: size,
            depth_m: size,
            length_m: size,
            peak_temperature_k: 300.0 + size,
            peak_rise_k: size,
            weld_volume_m3: 0.0,
            solidified_at_s: None,
        };
        let one = Sizes { width_m: 1.0, depth_m: 1.0, length_m: 1.0, peak_rise_k: 1.0, ..sizes };
        Point {
            setting: setting.into(),
            spacing_m,
            cpu_s,
            errors: Errors::against(&sizes, &one),
            sizes,
            ..Point::default()
        }
    }

    fn ladder() -> Vec<Point> {
        let default = |h: f64, cpu_s| point("default", h, cpu_s, 0.5 * h * h);
        vec![default(0.4, 1.0), default(0.2, 16.0), default(0.1, 250.0), point("Euler", 0.2, 9.0, 0.015)]
    }

    #[test]
    fn each_quantity_of_a_ladder_of_three_is_judged() {
        let found = estimates(&ladder());
        assert_eq!(found.len(), QUANTITIES.len());
        assert!(found.iter().all(|e| e.setting == "default" && e.spacing_m == 0.1));
        assert!((found[0].convergence.order.unwrap() - 2.0).abs() < 1e-9);
        assert!((found[0].convergence.extrapolated.unwrap() / 1e6 - 1.0).abs() < 1e-9);
        // No weld: five zeros show no order.
        assert_eq!(found[4].convergence.order, None);
    }

    #[test]
    fn the_cheapest_that_meets_the_wish_is_chosen() {
        let points = ladder();
        let exact = [0.0, 0.0, 0.0, 0.0, f64::NAN];
        let chosen = |wanted: f64| cheapest(&points, &exact, wanted).map(|p| (p.setting.as_str(), p.cpu_s));
        assert_eq!(chosen(0.1), Some(("default", 1.0)));
        assert_eq!(chosen(0.03), Some(("Euler", 9.0)));
        assert_eq!(chosen(0.01), Some(("default", 250.0)));
        assert_eq!(chosen(0.001), None);
        assert_eq!(most_exact(&points, &exact).unwrap().cpu_s, 250.0);
    }

    #[test]
    fn what_the_reference_may_be_off_counts() {
        let tight = |h: f64| point(TIGHT, h, 1.0, 0.5 * h * h);
        let mut points = ladder();
        points.extend([0.2, 0.1, 0.05].map(tight));
        let indices = reference_indices(&points, &estimates(&points));
        assert!((indices[0] / (1.25 * 0.5 * 0.05 * 0.05) - 1.0).abs() < 2e-3, "{indices:?}");
        assert!(indices[4].is_nan());
        // Two runs alone take order one and the factor for two.
        let two = [tight(0.1), tight(0.05)];
        let careful = reference_indices(&two, &estimates(&two))[0];
        assert!((careful / (3.0 * 0.5 * (0.1 * 0.1 - 0.05 * 0.05)) - 1.0).abs() < 2e-3, "{careful}");
        assert!(bound(&points[2], &indices).0 > bound(&points[2], &[0.0; 5]).0);
        assert_eq!(bound(&points[0], &[0.0, 0.02, 0.0, 0.0, f64::NAN]).1, "depth");
    }
}
