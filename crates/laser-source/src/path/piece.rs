//! A part of a track on which position and power are linear.

use crate::path::TrackPoint;

/// The part of one segment of a track inside a time interval.
pub(crate) struct Piece {
    /// Where it starts.
    pub(crate) start: TrackPoint,
    /// Where it ends.
    pub(crate) end: TrackPoint,
}

impl Piece {
    /// How long it lasts (s).
    pub(crate) fn duration_s(&self) -> f64 {
        self.end.time_s - self.start.time_s
    }

    /// Its mean commanded power (W).
    pub(crate) fn mean_power_w(&self) -> f64 {
        0.5 * (self.start.power_w + self.end.power_w)
    }

    /// How far the beam moves (m).
    pub(crate) fn travel_m(&self) -> f64 {
        (self.end.x_m - self.start.x_m).hypot(self.end.y_m - self.start.y_m)
    }

    /// Position and power at the share `along` (0 to 1) of the piece.
    pub(crate) fn at(&self, along: f64) -> TrackPoint {
        mix(&self.start, &self.end, along)
    }
}

/// The point at `time_s` between two points of different times.
pub(crate) fn between(start: &TrackPoint, end: &TrackPoint, time_s: f64) -> TrackPoint {
    let along = (time_s - start.time_s) / (end.time_s - start.time_s);
    TrackPoint { time_s, ..mix(start, end, along) }
}

/// The point at the share `along` of the way from one point to another.
fn mix(start: &TrackPoint, end: &TrackPoint, along: f64) -> TrackPoint {
    let linear = |a: f64, b: f64| a + along * (b - a);
    TrackPoint {
        time_s: linear(start.time_s, end.time_s),
        x_m: linear(start.x_m, end.x_m),
        y_m: linear(start.y_m, end.y_m),
        power_w: linear(start.power_w, end.power_w),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_in_time() {
        let start = TrackPoint { time_s: 1.0, x_m: 0.0, y_m: 2.0, power_w: 100.0 };
        let end = TrackPoint { time_s: 3.0, x_m: 3.0, y_m: 6.0, power_w: 200.0 };
        let middle = TrackPoint { time_s: 1.5, x_m: 0.75, y_m: 3.0, power_w: 125.0 };
        assert_eq!(between(&start, &end, 1.5), middle);
        let piece = Piece { start, end };
        assert_eq!(piece.at(0.25), middle);
        assert_eq!([piece.duration_s(), piece.mean_power_w(), piece.travel_m()], [2.0, 150.0, 5.0]);
    }
}
