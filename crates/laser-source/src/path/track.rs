//! Tracks: position and commanded power, linear in time between points. Every path is evaluated in this form.

use serde::{Deserialize, Serialize};

use crate::error::{Error, require, require_coordinate, require_power, require_time};
use crate::path::piece::{Piece, between};
use crate::rectangle::Rectangle;

/// Where the beam is at one time, and its commanded power.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TrackPoint {
    /// Time (s).
    pub time_s: f64,
    /// Position of the beam's centre along x (m).
    pub x_m: f64,
    /// Position of the beam's centre along y (m).
    pub y_m: f64,
    /// Commanded power (W).
    pub power_w: f64,
}

/// Points in order of time, with position and power linear between them.
///
/// Before the first and from the last point on the power is zero and the beam rests at that point. Where the
/// power jumps, the value after the jump holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    points: Vec<TrackPoint>,
}

impl Track {
    /// The track through `points`.
    ///
    /// # Errors
    /// [`Error::TooFew`] for fewer than two points; [`Error::OutOfRange`] if a number is not finite, a power
    /// is negative, times run backwards, more than two points share a time, or the position jumps.
    pub fn new(points: Vec<TrackPoint>) -> Result<Self, Error> {
        if points.len() < 2 {
            return Err(Error::TooFew { field: "points", found: points.len(), accepted: 2 });
        }
        for (i, point) in points.iter().enumerate() {
            require_time(&format!("points[{i}].time_s"), point.time_s)?;
            require_coordinate(&format!("points[{i}].x_m"), point.x_m)?;
            require_coordinate(&format!("points[{i}].y_m"), point.y_m)?;
            require_power(&format!("points[{i}].power_w"), point.power_w)?;
        }
        for i in 1..points.len() {
            check_order(&points, i)?;
        }
        Ok(Self { points })
    }

    /// The points, in order of time.
    #[must_use]
    pub fn points(&self) -> &[TrackPoint] {
        &self.points
    }

    /// Position of the beam's centre at `time_s` (m).
    #[must_use]
    pub fn position(&self, time_s: f64) -> [f64; 2] {
        let point = match self.segment_after(time_s) {
            0 => self.points[0],
            next if next == self.points.len() => self.points[next - 1],
            next => between(&self.points[next - 1], &self.points[next], time_s),
        };
        [point.x_m, point.y_m]
    }

    /// Commanded power at `time_s` (W); zero before the first point and from the last on.
    #[must_use]
    pub fn power(&self, time_s: f64) -> f64 {
        match self.segment_after(time_s) {
            0 => 0.0,
            next if next == self.points.len() => 0.0,
            next => between(&self.points[next - 1], &self.points[next], time_s).power_w,
        }
    }

    /// Commanded energy from `t0_s` to `t1_s` (J), exact; zero if `t1_s <= t0_s`.
    #[must_use]
    pub fn energy(&self, t0_s: f64, t1_s: f64) -> f64 {
        self.pieces(t0_s, t1_s).map(|piece| piece.duration_s() * piece.mean_power_w()).sum()
    }

    /// All times at which power or direction may be not smooth (s), sorted, each once. Steps should end
    /// there.
    #[must_use]
    pub fn events(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.points.iter().map(|point| point.time_s).collect();
        times.dedup();
        times
    }

    /// Time of the last point (s); the power is zero from here on.
    #[must_use]
    pub fn end_time(&self) -> f64 {
        self.points[self.points.len() - 1].time_s
    }

    /// The smallest rectangle that holds every position of the beam's centre; its sides may coincide.
    #[must_use]
    pub fn bounding_box(&self) -> Rectangle {
        let far = f64::INFINITY;
        let nothing = Rectangle { x_min_m: far, x_max_m: -far, y_min_m: far, y_max_m: -far };
        self.points.iter().fold(nothing, |hull, point| Rectangle {
            x_min_m: hull.x_min_m.min(point.x_m),
            x_max_m: hull.x_max_m.max(point.x_m),
            y_min_m: hull.y_min_m.min(point.y_m),
            y_max_m: hull.y_max_m.max(point.y_m),
        })
    }

    /// Largest speed of the beam's centre while there is power (m/s).
    #[must_use]
    pub fn max_speed(&self) -> f64 {
        self.lit_segments().map(|piece| piece.travel_m() / piece.duration_s()).fold(0.0, f64::max)
    }

    /// The longest intervals `[start_s, end_s]` throughout which there is power, in order.
    #[must_use]
    pub fn on_intervals(&self) -> Vec<[f64; 2]> {
        let mut intervals: Vec<[f64; 2]> = Vec::new();
        for piece in self.lit_segments() {
            match intervals.last_mut() {
                Some(last) if last[1] == piece.start.time_s => last[1] = piece.end.time_s,
                _ => intervals.push([piece.start.time_s, piece.end.time_s]),
            }
        }
        intervals
    }

    /// The lit parts of the segments between `t0_s` and `t1_s`, in order.
    pub(crate) fn pieces(&self, t0_s: f64, t1_s: f64) -> impl Iterator<Item = Piece> + '_ {
        let first = self.segment_after(t0_s).max(1) - 1;
        self.points[first..].windows(2).take_while(move |ends| ends[0].time_s < t1_s).filter_map(
            move |ends| {
                let (start_s, end_s) = (ends[0].time_s.max(t0_s), ends[1].time_s.min(t1_s));
                let lit = ends[0].power_w > 0.0 || ends[1].power_w > 0.0;
                (lit && end_s > start_s).then(|| Piece {
                    start: between(&ends[0], &ends[1], start_s),
                    end: between(&ends[0], &ends[1], end_s),
                })
            },
        )
    }

    fn lit_segments(&self) -> impl Iterator<Item = Piece> + '_ {
        self.pieces(f64::NEG_INFINITY, f64::INFINITY)
    }

    /// Index of the first point later than `time_s`; the number of points if there is none.
    fn segment_after(&self, time_s: f64) -> usize {
        self.points.partition_point(|point| point.time_s <= time_s)
    }
}

/// Checks that point `i` may follow the one before it.
fn check_order(points: &[TrackPoint], i: usize) -> Result<(), Error> {
    let (before, point) = (&points[i - 1], &points[i]);
    let field = format!("points[{i}].time_s");
    require(
        point.time_s >= before.time_s,
        &field,
        point.time_s,
        "a time not before that of the point before",
    )?;
    if point.time_s == before.time_s {
        let third = i >= 2 && points[i - 2].time_s == point.time_s;
        require(!third, &field, point.time_s, "a time shared by at most two points")?;
        let accepted = "the same place as that of the point before, which has the same time";
        require(point.x_m == before.x_m, &format!("points[{i}].x_m"), point.x_m, accepted)?;
        require(point.y_m == before.y_m, &format!("points[{i}].y_m"), point.y_m, accepted)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(time_s: f64, x_m: f64, y_m: f64, power_w: f64) -> TrackPoint {
        TrackPoint { time_s, x_m, y_m, power_w }
    }

    /// A ramp along x, a jump to 50 W, a corner into y, a dark way back, a last flash.
    fn track() -> Track {
        Track::new(vec![
            point(1.0, 0.0, 0.0, 0.0),
            point(3.0, 4.0, 0.0, 100.0),
            point(3.0, 4.0, 0.0, 50.0),
            point(4.0, 4.0, 3.0, 50.0),
            point(4.0, 4.0, 3.0, 0.0),
            point(5.0, -9.0, 3.0, 0.0),
            point(5.0, -9.0, 3.0, 10.0),
            point(6.0, -9.0, 3.0, 10.0),
        ])
        .unwrap()
    }

    #[test]
    fn position_and_power_are_linear_between_points() {
        let track = track();
        assert_eq!([track.position(1.5), track.position(3.5)], [[1.0, 0.0], [4.0, 1.5]]);
        assert_eq!([track.position(0.0), track.position(7.0)], [[0.0, 0.0], [-9.0, 3.0]]);
        assert_eq!(
            [0.5, 1.0, 2.0, 3.0, 3.5, 4.5, 5.0, 6.0].map(|t| track.power(t)),
            [0.0, 0.0, 50.0, 50.0, 50.0, 0.0, 10.0, 0.0]
        );
    }

    #[test]
    fn energy_is_exact() {
        let track = track();
        assert_eq!(track.energy(0.0, 9.0), 100.0 + 50.0 + 10.0);
        assert_eq!(track.energy(1.0, 2.0), 25.0);
        assert_eq!(track.energy(2.0, 3.5), 75.0 + 25.0);
        assert_eq!(track.energy(4.25, 4.75), 0.0);
        assert_eq!([track.energy(3.0, 3.0), track.energy(4.0, 3.0), track.energy(7.0, 8.0)], [0.0; 3]);
    }

    #[test]
    fn summaries() {
        let track = track();
        assert_eq!(track.events(), [1.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(track.end_time(), 6.0);
        assert_eq!(track.on_intervals(), [[1.0, 4.0], [5.0, 6.0]]);
        assert_eq!(track.max_speed(), 3.0, "the dark way back at 13 m/s does not count");
        assert_eq!(
            track.bounding_box(),
            Rectangle { x_min_m: -9.0, x_max_m: 4.0, y_min_m: 0.0, y_max_m: 3.0 }
        );
    }

    proptest! {
        #[test]
        fn energies_of_parts_add_up(cut in 0.0..7.0_f64) {
            let sum = track().energy(0.0, cut) + track().energy(cut, 7.0);
            prop_assert!((sum - 160.0).abs() < 1e-12);
        }

        #[test]
        fn power_is_the_rate_of_energy(time in 1.01..5.99_f64) {
            prop_assume!([3.0, 4.0, 5.0].iter().all(|event: &f64| (event - time).abs() > 1e-3));
            let rate = (track().energy(0.0, time + 1e-3) - track().energy(0.0, time - 1e-3)) / 2e-3;
            prop_assert!((rate - track().power(time)).abs() < 1e-9);
        }
    }

    #[test]
    fn wrong_order_is_refused() {
        let message = |points: Vec<TrackPoint>| Track::new(points).unwrap_err().to_string();
        let backwards = message(vec![point(1.0, 0.0, 0.0, 1.0), point(0.5, 1.0, 0.0, 1.0)]);
        assert_eq!(
            backwards,
            "points[1].time_s is 0.5, but must be a time not before that of the point before"
        );
        let jump = message(vec![point(1.0, 0.0, 0.0, 1.0), point(1.0, 2.0, 0.0, 1.0)]);
        assert!(jump.starts_with("points[1].x_m is 2, but must be the same place"), "{jump}");
        assert!(message(vec![point(1.0, 0.0, 0.0, 1.0); 3]).contains("at most two points"));
        assert!(message(vec![point(1.0, 0.0, 0.0, -1.0); 2]).starts_with("points[0].power_w is -1"));
        assert!(message(vec![point(f64::NAN, 0.0, 0.0, 1.0); 2]).starts_with("points[0].time_s is NaN"));
    }
}
