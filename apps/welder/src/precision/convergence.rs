//! What three values of one quantity at three spacings say about its error: observed order, Richardson extrapolation and
//! the grid convergence index.
//!
//! With f(h) = f0 + C h^p the order p solves (f3 - f2) / (f2 - f1) = (h3^p - h2^p) / (h2^p - h1^p), for spacings
//! h1 < h2 < h3 in any ratio: eq. 5 of Celik et al., J. Fluids Eng. 130, 078001 (2008), solved by bisection instead of
//! their fixed point. The extrapolated value is f0 = f1 + (f1 - f2) / (r^p - 1) with r = h2 / h1, and the index is
//! F |f1 - f2| / (|f1| (r^p - 1)) with a safety factor F (Roache, J. Fluids Eng. 116, 405-413 (1994)).

use serde::Serialize;

/// Order of the scheme in the spacing: conduction between particles at rest, and isotherms interpolated between them.
pub(super) const PROMISED_ORDER: f64 = 2.0;

/// Observed orders over the promised one that count as the asymptotic range.
const ASYMPTOTIC: std::ops::RangeInclusive<f64> = 0.5..=1.5;

/// Safety factor F where three values lie in the asymptotic range (Roache 1994, Celik et al. 2008).
pub(super) const SAFETY_FACTOR: f64 = 1.25;

/// Safety factor F where the order is assumed or not to be trusted (Roache 1994, for two grids).
pub(super) const CAREFUL_SAFETY_FACTOR: f64 = 3.0;

/// Orders are sought below this one.
const LARGEST_ORDER: f64 = 32.0;

/// What the three finest values of a quantity say. Errors are relative to the extrapolated value, the index to the finest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct Convergence {
    /// Order p; none where the values swing or drift apart.
    pub(super) order: Option<f64>,
    /// The value at spacing zero, in the unit of the values.
    pub(super) extrapolated: Option<f64>,
    /// |f1 - f0| / |f0| of the finest value.
    pub(super) error: Option<f64>,
    /// Grid convergence index of the finest value.
    pub(super) index: Option<f64>,
    /// Whether the values converge monotonically with about the promised order.
    pub(super) asymptotic: bool,
}

impl Convergence {
    /// Judges (spacing, value) pairs, coarse to fine; the three finest count. None for fewer than three.
    pub(super) fn of(ladder: &[(f64, f64)]) -> Option<Self> {
        let &[.., (h3, f3), (h2, f2), (h1, f1)] = ladder else { return None };
        let nothing =
            Convergence { order: None, extrapolated: None, error: None, index: None, asymptotic: false };
        let Some(order) = observed_order([h1, h2, h3], (f3 - f2) / (f2 - f1)) else { return Some(nothing) };
        let shift_of = |order: f64| (f1 - f2) / ((h2 / h1).powf(order) - 1.0);
        let asymptotic = ASYMPTOTIC.contains(&(order / PROMISED_ORDER));
        let shift = shift_of(order);
        // Values that seem to converge faster than they can are about to turn: their order would hide the error.
        let careful = CAREFUL_SAFETY_FACTOR * shift_of(order.min(PROMISED_ORDER));
        let bound = if asymptotic { SAFETY_FACTOR * shift } else { careful };
        Some(Convergence {
            order: Some(order),
            extrapolated: Some(f1 + shift),
            error: Some((shift / (f1 + shift)).abs()),
            index: Some((bound / f1).abs()),
            asymptotic,
        })
    }
}

/// Grid convergence index of `fine`, relative to it, from one coarser value whose spacing is `ratio` times as large: with
/// order one and the careful factor.
pub(super) fn index_of_two(fine: f64, coarse: f64, ratio: f64) -> f64 {
    CAREFUL_SAFETY_FACTOR * ((coarse - fine) / fine).abs() / (ratio - 1.0)
}

/// The order p > 0 for which the spacings h1 < h2 < h3 give this ratio of differences, if there is one.
fn observed_order([h1, h2, h3]: [f64; 3], ratio: f64) -> Option<f64> {
    // (h3^p - h2^p) / (h2^p - h1^p), in a form that does not overflow; it rises with p from ln(h3/h2) / ln(h2/h1).
    let of = |p: f64| ((h3 / h2).powf(p) - 1.0) / (1.0 - (h1 / h2).powf(p));
    let (mut low, mut high) = (1e-3, LARGEST_ORDER);
    if !(of(low)..of(high)).contains(&ratio) {
        return None;
    }
    // Halved until the bounds are neighbours.
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if of(middle) <= ratio { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ladder(spacings: [f64; 3], f: impl Fn(f64) -> f64) -> Convergence {
        Convergence::of(&spacings.map(|h| (h, f(h)))).unwrap()
    }

    #[test]
    fn a_power_is_found_exactly() {
        for (order, asymptotic) in
            [(0.7, false), (1.1, true), (2.0, true), (2.9, true), (3.2, false), (6.0, false)]
        {
            let found = ladder([0.4, 0.2, 0.1], |h| 5.0 - 0.3 * h.powf(order));
            assert!((found.order.unwrap() - order).abs() < 1e-9, "{found:?}");
            assert!((found.extrapolated.unwrap() - 5.0).abs() < 1e-12, "{found:?}");
            assert_eq!(found.asymptotic, asymptotic, "{found:?}");
            let (error, finest) = (0.3 * 0.1f64.powf(order), 5.0 - 0.3 * 0.1f64.powf(order));
            // Above the promised order the careful index takes that: 0.3 (0.2^p - 0.1^p) / (2^2 - 1).
            let index = match (asymptotic, order > 2.0) {
                (true, _) => 1.25 * error,
                (false, false) => 3.0 * error,
                (false, true) => 0.3 * (0.2f64.powf(order) - 0.1f64.powf(order)),
            };
            assert!((found.error.unwrap() / (error / 5.0) - 1.0).abs() < 1e-6, "{found:?}");
            assert!((found.index.unwrap() / (index / finest) - 1.0).abs() < 1e-6, "{found:?}");
        }
    }

    #[test]
    fn only_the_three_finest_count() {
        let values = [(0.8, -100.0), (0.4, 0.16), (0.2, 0.04), (0.1, 0.01)];
        assert!((Convergence::of(&values).unwrap().order.unwrap() - 2.0).abs() < 1e-9);
        assert_eq!(Convergence::of(&values[..2]), None);
    }

    /// The first example of Celik et al. (2008): 18000, 8000 and 4500 cells in two dimensions.
    #[test]
    fn the_published_example_is_met() {
        let spacings = [4500.0f64, 8000.0, 18000.0].map(|cells| cells.sqrt().recip());
        let values = [5.863, 5.972, 6.063];
        let rungs: Vec<_> = spacings.into_iter().zip(values).collect();
        let found = Convergence::of(&rungs).unwrap();
        assert!((found.order.unwrap() - 1.53).abs() < 0.01, "{found:?}");
        assert!((found.extrapolated.unwrap() - 6.1685).abs() < 5e-4, "{found:?}");
        assert!((found.index.unwrap() - 0.022).abs() < 5e-4, "{found:?}");
    }

    #[test]
    fn swinging_drifting_and_equal_values_have_no_order() {
        for values in [
            [1.0, 1.2, 1.1],
            [1.0, 1.1, 1.3],
            [1.0, 1.1, 1.2],
            [1.0, 1.0, 1.1],
            [1.1, 1.0, 1.0],
            [1.0, 1.0, 1.0],
            [0.0, 0.0, 0.0],
            [1.0, f64::NAN, 1.1],
        ] {
            let rungs: Vec<_> = [0.4, 0.2, 0.1].into_iter().zip(values).collect();
            let found = Convergence::of(&rungs).unwrap();
            assert_eq!((found.order, found.index, found.asymptotic), (None, None, false), "{values:?}");
        }
    }

    #[test]
    fn two_values_take_order_one_and_the_careful_factor() {
        assert!((index_of_two(1.0, 1.03, 2.0) - 0.09).abs() < 1e-12);
        assert!((index_of_two(-1.0, -1.03, 4.0) - 0.03).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn order_and_limit_come_back(
            order in 0.3..6.0f64, limit in 0.5..2.0f64, lead in 0.01..0.3f64, falls: bool,
            fine in 1.2..2.5f64, coarse in 1.2..2.5f64,
        ) {
            let lead = if falls { -lead } else { lead };
            let found = ladder([fine * coarse, fine, 1.0], |h| limit + lead * (h / (fine * coarse)).powf(order));
            prop_assert!((found.order.unwrap() - order).abs() < 1e-6, "{:?}", found);
            prop_assert!((found.extrapolated.unwrap() - limit).abs() < 1e-6, "{:?}", found);
            prop_assert_eq!(found.asymptotic, (1.0..=3.0).contains(&found.order.unwrap()));
        }

        #[test]
        fn any_three_values_have_an_answer(values: [f64; 3]) {
            let rungs: Vec<_> = [0.4, 0.2, 0.1].into_iter().zip(values).collect();
            let found = Convergence::of(&rungs).unwrap();
            prop_assert!(found.order.is_none_or(|order| order > 0.0 && order <= LARGEST_ORDER));
        }
    }
}
