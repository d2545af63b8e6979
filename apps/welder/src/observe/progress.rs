//! The progress bar on the terminal.

use super::{ObserveError, Observer, Pulse, View};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Ends of the bar, which counts shares of the physical time.
const SHARES: u64 = 10_000;
/// Nobody reads faster; a run of many short steps must not pay for its bar.
const PAUSE: Duration = Duration::from_millis(60);

/// Shows how far the run is, what limits its step, the pool, the peak and the time left.
///
/// It asks for no views of its own, so that a run takes the same steps with and without it.
pub struct Progress {
    bar: ProgressBar,
    measures: String,
    shown: Instant,
}

impl Progress {
    /// A bar on stderr; none when quiet, or when nobody looks because stderr is not a terminal.
    pub fn new(quiet: bool) -> Self {
        let hidden = quiet || !std::io::stderr().is_terminal();
        Progress::on(if hidden { ProgressBar::hidden() } else { ProgressBar::new(SHARES) })
    }

    fn on(bar: ProgressBar) -> Self {
        let style = ProgressStyle::with_template("{bar:24.cyan/blue} {percent:>3} %  {msg}  {eta} left");
        bar.set_style(style.expect("the template of the bar is right"));
        bar.set_length(SHARES);
        Progress { bar, measures: String::new(), shown: Instant::now() }
    }

    /// Runs something that writes to the terminal, such as a log message, without tearing the bar.
    pub fn suspend<T>(&self, write: impl FnOnce() -> T) -> T {
        self.bar.suspend(write)
    }

    fn show(&mut self, pulse: &Pulse) {
        self.shown = Instant::now();
        self.bar.set_position(share(pulse.time_s, pulse.end_s));
        self.bar.set_message(format!("{}{}", clock_text(pulse), self.measures));
    }

    fn measure<const D: usize>(&mut self, view: &View<D>) {
        self.measures = view.history.words();
        self.show(&view.pulse());
    }
}

impl<const D: usize> Observer<D> for Progress {
    fn init(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.measure(view);
        // The part of a resumed run that was done before says nothing about the speed of this one.
        self.bar.reset_eta();
        Ok(())
    }

    fn stepped(&mut self, pulse: &Pulse) {
        if !self.bar.is_hidden() && self.shown.elapsed() >= PAUSE {
            self.show(pulse);
        }
    }

    fn every(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.measure(view);
        Ok(())
    }

    fn finish(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.measure(view);
        self.bar.finish_and_clear();
        Ok(())
    }
}

fn share(time_s: f64, end_s: f64) -> u64 {
    // A run that ends at once has come to its end.
    let share = if end_s > 0.0 { (time_s / end_s).clamp(0.0, 1.0) } else { 1.0 };
    (share * SHARES as f64) as u64
}

fn clock_text(pulse: &Pulse) -> String {
    let (now, end) = (scaled(pulse.time_s, "s"), scaled(pulse.end_s, "s"));
    format!("{now} of {end}, step {}, dt {} by {}", pulse.step, scaled(pulse.dt_s, "s"), pulse.dt_limit)
}

/// A quantity with three digits or more and a prefix from nano to none.
pub(super) fn scaled(value: f64, unit: &str) -> String {
    let prefixes = [(1.0, ""), (1e-3, "m"), (1e-6, "\u{b5}"), (1e-9, "n")];
    // Rounding must not turn 0.9999 m into 1000 mm.
    let fits = |&&(size, _): &&(f64, &str)| value.abs() >= 0.9995 * size;
    match prefixes.iter().find(fits) {
        Some((size, prefix)) => {
            let number = value / size;
            let digits = if number < 9.995 { 2 } else { usize::from(number < 99.95) };
            format!("{number:.digits$} {prefix}{unit}")
        }
        None => format!("{value} {unit}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::{HistoryRow, Measures};

    fn view(time_s: f64, step: u64, pool_m: f64) -> View<'static, 3> {
        let history = HistoryRow {
            pool_width_m: 2.0 * pool_m,
            pool_depth_m: pool_m,
            peak_temperature_k: 1620.4,
            ..HistoryRow::default()
        };
        View { end_s: 15e-3, dt_s: 12.3e-6, history: Measures::Weld(history), ..View::bare(time_s, step) }
    }

    #[test]
    fn the_line_says_where_the_run_is() {
        let mut progress = Progress::on(ProgressBar::hidden());
        progress.every(&view(3e-3, 417, 0.31e-3)).unwrap();
        let expected = "3.00 ms of 15.0 ms, step 417, dt 12.3 \u{b5}s by conduction, \
                        pool 620 \u{b5}m wide, 310 \u{b5}m deep, peak 1620 K";
        assert_eq!(progress.bar.message(), expected);
        assert_eq!(progress.bar.position(), SHARES / 5);
        progress.every(&view(15e-3, 418, 0.0)).unwrap();
        assert!(progress.bar.message().ends_with("conduction, peak 1620 K"));
        assert_eq!(progress.bar.position(), SHARES);
    }

    #[test]
    fn it_is_silent_when_quiet_and_wants_no_time_of_its_own() {
        let progress = Progress::new(true);
        assert!(progress.bar.is_hidden());
        assert_eq!(Observer::<2>::next_time_s(&progress), None);
    }

    #[test]
    fn quantities_have_a_fitting_prefix() {
        let texts = [1.5, 0.99999, 0.015, 12.345e-6, 3e-9, 0.0].map(|value| scaled(value, "s"));
        assert_eq!(texts, ["1.50 s", "1.00 s", "15.0 ms", "12.3 \u{b5}s", "3.00 ns", "0 s"]);
    }

    #[test]
    fn a_run_without_length_is_at_its_end() {
        assert_eq!([share(0.0, 0.0), share(2.0, 1.0), share(0.25, 1.0)], [SHARES, SHARES, SHARES / 4]);
    }
}
