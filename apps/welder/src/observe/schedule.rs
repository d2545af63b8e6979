//! The times at which an observer wants a view: whole multiples of its interval.
//!
//! The times are products `k * interval_s`, never sums, so a resumed run meets the same bits as an unbroken one.

/// Times that are whole multiples of an interval, and how far a run has come along them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    interval_s: f64,
    next: u64,
}

impl Schedule {
    /// A schedule that starts at time zero. An interval that is not a positive finite number means: never, only
    /// the start and the end of the run count.
    pub fn new(interval_s: f64) -> Self {
        Schedule { interval_s, next: 0 }
    }

    /// The next time, or `None` if there is none.
    pub fn next_time_s(&self) -> Option<f64> {
        self.repeats().then(|| self.time_s(self.next))
    }

    /// Whether a run that has reached `time_s` has come to the next time.
    pub fn is_due(&self, time_s: f64) -> bool {
        self.next_time_s().is_some_and(|next_s| time_s >= next_s)
    }

    /// Moves to the first time after `time_s`.
    pub fn advance_past(&mut self, time_s: f64) {
        if !self.repeats() {
            return;
        }
        // The quotient may be off by one after rounding; the products decide.
        let mut next = ((time_s / self.interval_s).floor() as u64).saturating_sub(1);
        while self.time_s(next) <= time_s {
            next += 1;
        }
        self.next = next;
    }

    /// Whether `time_s` is, to the last bit, one of the times (or the start).
    pub fn contains(&self, time_s: f64) -> bool {
        time_s == 0.0 || self.repeats() && self.time_s((time_s / self.interval_s).round() as u64) == time_s
    }

    fn repeats(&self) -> bool {
        self.interval_s.is_finite() && self.interval_s > 0.0
    }

    fn time_s(&self, index: u64) -> f64 {
        index as f64 * self.interval_s
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn without_an_interval_only_the_start_counts() {
        for interval_s in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let mut schedule = Schedule::new(interval_s);
            schedule.advance_past(0.3);
            assert_eq!(schedule.next_time_s(), None);
            assert!(schedule.contains(0.0) && !schedule.contains(0.3) && !schedule.is_due(0.3));
        }
    }

    #[test]
    fn a_time_is_due_until_it_is_passed() {
        let mut schedule = Schedule::new(0.1);
        assert!(schedule.is_due(0.0));
        schedule.advance_past(0.0);
        assert_eq!(schedule.next_time_s(), Some(0.1));
        assert!(!schedule.is_due(0.1_f64.next_down()) && schedule.is_due(0.1));
        schedule.advance_past(0.35);
        assert_eq!(schedule.next_time_s(), Some(4.0 * 0.1));
    }

    proptest! {
        #[test]
        fn every_multiple_is_met_once(interval_s in 1e-9..1e3, index in 0_u64..1_000_000_000) {
            let mut schedule = Schedule::new(interval_s);
            let time_s = index as f64 * interval_s;
            prop_assert!(schedule.contains(time_s));
            schedule.advance_past(time_s);
            prop_assert_eq!(schedule.next_time_s(), Some((index + 1) as f64 * interval_s));
            schedule.advance_past(time_s.next_down());
            prop_assert_eq!(schedule.next_time_s(), Some(if index == 0 { 0.0 } else { time_s }));
            prop_assert!(!schedule.contains((index as f64 + 0.5) * interval_s));
        }
    }
}
