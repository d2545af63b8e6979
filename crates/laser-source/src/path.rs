//! Paths as they are written in a case file: where the beam goes and how much power it is commanded to have.

mod piece;
mod pulse;
mod track;

use serde::{Deserialize, Serialize};

use crate::error::{Error, require, require_coordinate, require_length, require_power, require_time};

pub(crate) use piece::Piece;
pub use pulse::{PowerPoint, Pulse};
pub use track::{Track, TrackPoint};

/// The way of the beam's centre over the surface, and its commanded power over time.
///
/// In a case file:
///
/// ```text
/// Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 15e-3, power_w: 900.0))
/// Straight(from_m: (0.0, 0.0), to_m: (0.01, 0.0), speed_m_s: 0.1, power_w: 900.0, start_s: 0.0)
/// Polyline(points: [(time_s: 0.0, x_m: 0.0, y_m: 0.0, power_w: 500.0), ..])
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Path {
    /// A beam that stands still.
    Spot {
        /// Where it stands (m).
        position_m: [f64; 2],
        /// Its power over time.
        pulse: Pulse,
    },
    /// A beam that goes from one point to another at constant speed and power.
    Straight {
        /// Where it starts (m).
        from_m: [f64; 2],
        /// Where it ends (m).
        to_m: [f64; 2],
        /// Its speed (m/s).
        speed_m_s: f64,
        /// Its power while it moves (W).
        power_w: f64,
        /// When it starts (s).
        start_s: f64,
    },
    /// A beam through given points; position and power are linear in time between them.
    Polyline {
        /// The points in order of time. Two points may share a time and a place: the power jumps there.
        points: Vec<TrackPoint>,
    },
}

impl Path {
    /// The path as a table of points, the form in which it is evaluated.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] that names the field if a number is not finite, a length, speed or duration is
    /// not positive, a power is negative, or times run backwards; [`Error::TooFew`] for fewer than two
    /// points.
    pub fn track(&self) -> Result<Track, Error> {
        match self {
            Self::Spot { position_m, pulse } => spot(*position_m, pulse),
            Self::Straight { from_m, to_m, speed_m_s, power_w, start_s } => {
                straight(*from_m, *to_m, *speed_m_s, *power_w, *start_s)
            }
            Self::Polyline { points } => Track::new(points.clone()),
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// Those of [`Path::track`].
    pub fn validate(&self) -> Result<(), Error> {
        self.track().map(|_| ())
    }
}

/// The track of a spot: the points of its pulse, all at one place.
fn spot(position_m: [f64; 2], pulse: &Pulse) -> Result<Track, Error> {
    require_coordinate("position_m[0]", position_m[0])?;
    require_coordinate("position_m[1]", position_m[1])?;
    let [x_m, y_m] = position_m;
    let points = pulse.points()?;
    Track::new(
        points
            .iter()
            .map(|&PowerPoint { time_s, power_w }| TrackPoint { time_s, x_m, y_m, power_w })
            .collect(),
    )
}

/// The track of a straight seam: its two ends.
fn straight(
    from_m: [f64; 2],
    to_m: [f64; 2],
    speed_m_s: f64,
    power_w: f64,
    start_s: f64,
) -> Result<Track, Error> {
    for (field, found) in
        [("from_m[0]", from_m[0]), ("from_m[1]", from_m[1]), ("to_m[0]", to_m[0]), ("to_m[1]", to_m[1])]
    {
        require_coordinate(field, found)?;
    }
    let accepted = "a positive speed in metres per second";
    require(speed_m_s.is_finite() && speed_m_s > 0.0, "speed_m_s", speed_m_s, accepted)?;
    require_power("power_w", power_w)?;
    require_time("start_s", start_s)?;
    let length_m = (to_m[0] - from_m[0]).hypot(to_m[1] - from_m[1]);
    require_length("distance from from_m to to_m", length_m)?;
    let end_s = start_s + length_m / speed_m_s;
    Track::new(vec![
        TrackPoint { time_s: start_s, x_m: from_m[0], y_m: from_m[1], power_w },
        TrackPoint { time_s: end_s, x_m: to_m[0], y_m: to_m[1], power_w },
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seam(speed_m_s: f64) -> Path {
        Path::Straight { from_m: [1.0, 2.0], to_m: [4.0, 6.0], speed_m_s, power_w: 700.0, start_s: 0.5 }
    }

    #[test]
    fn straight_seam_moves_at_its_speed() {
        let track = seam(2.0).track().unwrap(); // 5 m at 2 m/s
        assert_eq!(track.end_time(), 3.0);
        assert_eq!(track.position(0.0), [1.0, 2.0]);
        assert_eq!(track.position(1.75), [2.5, 4.0]);
        assert_eq!(track.position(9.0), [4.0, 6.0]);
        assert_eq!([track.power(0.4), track.power(1.0), track.power(3.1)], [0.0, 700.0, 0.0]);
        assert!((track.max_speed() - 2.0).abs() < 1e-15);
        assert!((track.energy(0.0, 9.0) - 1750.0).abs() < 1e-9);
    }

    #[test]
    fn spot_stands_still() {
        let pulse = Pulse::Constant { start_s: 0.0, duration_s: 15e-3, power_w: 900.0 };
        let track = Path::Spot { position_m: [1e-3, -2e-3], pulse }.track().unwrap();
        assert_eq!([track.position(0.0), track.position(7e-3)], [[1e-3, -2e-3]; 2]);
        assert!((track.energy(-1.0, 1.0) - 13.5).abs() < 1e-13);
        assert_eq!(track.max_speed(), 0.0);
    }

    #[test]
    fn reads_from_a_case_file() {
        let spot: Path = ron::from_str(
            "Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 15e-3, power_w: 900.0))",
        )
        .unwrap();
        assert_eq!(spot.track().unwrap().end_time(), 15e-3);
        let line: Path = ron::from_str(
            "Polyline(points: [\
                (time_s: 0.0, x_m: 0.0, y_m: 0.0, power_w: 1.0), \
                (time_s: 1.0, x_m: 1.0, y_m: 0.0, power_w: 3.0)])",
        )
        .unwrap();
        assert_eq!(line.track().unwrap().power(0.5), 2.0);
        assert!(ron::from_str::<Path>("Polyline(points: [], speed: 1)").is_err());
        let text = ron::to_string(&seam(2.0)).unwrap();
        assert_eq!(ron::from_str::<Path>(&text).unwrap(), seam(2.0));
    }

    #[test]
    fn bad_numbers_are_named() {
        assert!(seam(0.0).validate().unwrap_err().to_string().starts_with("speed_m_s is 0, but must be"));
        let still =
            Path::Straight { from_m: [0.0; 2], to_m: [0.0; 2], speed_m_s: 1.0, power_w: 1.0, start_s: 0.0 };
        assert!(still.validate().unwrap_err().to_string().contains("from from_m to to_m is 0"));
        let pulse = Pulse::Constant { start_s: 0.0, duration_s: 1.0, power_w: 1.0 };
        let lost = Path::Spot { position_m: [0.0, f64::NAN], pulse };
        assert!(lost.validate().unwrap_err().to_string().starts_with("position_m[1] is NaN"));
    }
}
