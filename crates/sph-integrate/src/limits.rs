//! Named step limits: how long a step may be, and why.

/// The longest step that one criterion allows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimit {
    /// Name of the criterion, for example `"conduction"`.
    pub name: &'static str,
    /// Longest step that it allows (s).
    pub dt_s: f64,
}

/// The limit that rules: the one with the shortest step; of equal ones the first.
///
/// A step that is not a number rules over all others, so that it is noticed. Without limits the result is
/// called `"none"` and allows an infinite step.
#[must_use]
pub fn smallest(limits: impl IntoIterator<Item = StepLimit>) -> StepLimit {
    let none = StepLimit { name: "none", dt_s: f64::INFINITY };
    limits
        .into_iter()
        .reduce(|ruling, limit| {
            let shorter = limit.dt_s < ruling.dt_s || (limit.dt_s.is_nan() && !ruling.dt_s.is_nan());
            if shorter { limit } else { ruling }
        })
        .unwrap_or(none)
}

/// Counts how often each limit ruled.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LimitCounter {
    counts: Vec<(&'static str, u64)>,
}

impl LimitCounter {
    /// A counter that has counted nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Counts one step that `limit` ruled.
    pub fn record(&mut self, limit: &StepLimit) {
        match self.counts.iter_mut().find(|(name, _)| *name == limit.name) {
            Some((_, count)) => *count += 1,
            None => self.counts.push((limit.name, 1)),
        }
    }

    /// Names and counts in the order in which the limits first ruled.
    #[must_use]
    pub fn counts(&self) -> &[(&'static str, u64)] {
        &self.counts
    }

    /// Number of steps counted.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.counts.iter().map(|(_, count)| count).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limit(name: &'static str, dt_s: f64) -> StepLimit {
        StepLimit { name, dt_s }
    }

    #[test]
    fn the_shortest_rules_and_of_equal_ones_the_first() {
        let limits = [limit("heat", 3.0), limit("sound", 1.0), limit("force", 1.0)];
        assert_eq!(smallest(limits), limit("sound", 1.0));
        assert_eq!(smallest([]), limit("none", f64::INFINITY));
    }

    #[test]
    fn a_step_that_is_not_a_number_is_noticed() {
        for order in [[0, 1, 2], [1, 0, 2], [2, 1, 0]] {
            let limits = [limit("heat", 3.0), limit("broken", f64::NAN), limit("sound", 1.0)];
            assert_eq!(smallest(order.map(|k| limits[k])).name, "broken");
        }
    }

    #[test]
    fn counter_keeps_the_order_of_first_rule() {
        let mut counter = LimitCounter::new();
        for name in ["sound", "heat", "sound", "sound"] {
            counter.record(&limit(name, 1.0));
        }
        assert_eq!(counter.counts(), [("sound", 3), ("heat", 1)]);
        assert_eq!(counter.total(), 4);
    }
}
