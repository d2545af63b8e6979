//! Bodies whose answer is known, for tests, examples and `welder verify`: a scene and what is measured of it, no verdicts.

pub mod aluminium;
pub mod beam;
pub mod clamped_plate;
pub mod gough_joule;
pub mod plate;
pub mod rings;
pub mod rotation;
pub mod round;
pub mod shapes;
pub mod stability;
pub mod thermal;
pub mod waves;

/// Time \[s\] at which a value that `step` gives after every `dt` \[s\] is back at zero from above; NaN if it is not within
/// `longest` \[s\].
fn time_of_return(dt: f64, longest: f64, mut step: impl FnMut() -> f64) -> f64 {
    let (mut time, mut before) = (0.0, 0.0);
    while time < longest {
        let now = step();
        time += dt;
        if before > 0.0 && now <= 0.0 {
            return time - dt * now / (now - before);
        }
        before = now;
    }
    f64::NAN
}

/// The largest of values from zero on; no number is the largest of all, so that a run that went astray does not look right.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, value| if value > largest || value.is_nan() { value } else { largest })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_is_back_after_half_its_period() {
        let mut phase = 0.0_f64;
        let time = time_of_return(0.01, 4.0, || {
            phase += 0.01;
            phase.sin()
        });
        assert!((time - std::f64::consts::PI).abs() < 1e-6, "{time}");
        assert!(time_of_return(0.1, 1.0, || 1.0).is_nan());
    }

    #[test]
    fn no_number_is_the_largest() {
        assert_eq!(largest([1.0, 3.0, 2.0].into_iter()), 3.0);
        assert!(largest([1.0, f64::NAN, 2.0].into_iter()).is_nan());
    }
}
