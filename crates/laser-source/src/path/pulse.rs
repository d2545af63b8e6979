//! Pulse shapes: the power of a beam that stands still, over time.

use serde::{Deserialize, Serialize};

use crate::error::{Error, require, require_power, require_time};

/// The commanded power at one time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PowerPoint {
    /// Time (s): of the simulation in results, since the start of the pulse in [`Pulse::Table`].
    pub time_s: f64,
    /// Commanded power (W).
    pub power_w: f64,
}

/// The power of a spot over time; zero before and after.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Pulse {
    /// Constant power from a start, for a duration.
    Constant {
        /// When the pulse starts (s).
        start_s: f64,
        /// How long it lasts (s).
        duration_s: f64,
        /// Its power (W).
        power_w: f64,
    },
    /// Power linear between the points of a table.
    Table {
        /// When the pulse starts (s).
        start_s: f64,
        /// The points in order of time since the start; two that share a time make a jump.
        points: Vec<PowerPoint>,
    },
}

impl Pulse {
    /// The pulse as points in simulation time.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if a number is not finite, a power negative, or the duration not positive.
    /// The order of the times is checked by [`crate::Track::new`].
    pub fn points(&self) -> Result<Vec<PowerPoint>, Error> {
        match self {
            Self::Constant { start_s, duration_s, power_w } => {
                require_time("start_s", *start_s)?;
                let accepted = "a positive duration in seconds";
                require(duration_s.is_finite() && *duration_s > 0.0, "duration_s", *duration_s, accepted)?;
                require_power("power_w", *power_w)?;
                Ok([*start_s, start_s + duration_s]
                    .map(|time_s| PowerPoint { time_s, power_w: *power_w })
                    .to_vec())
            }
            Self::Table { start_s, points } => {
                require_time("start_s", *start_s)?;
                Ok(points
                    .iter()
                    .map(|point| PowerPoint { time_s: start_s + point.time_s, ..*point })
                    .collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Path;

    #[test]
    fn table_is_shifted_by_its_start() {
        let pulse: Pulse = ron::from_str(
            "Table(start_s: 2.0, points: [(time_s: 0.0, power_w: 100.0), (time_s: 1.0, power_w: 300.0)])",
        )
        .unwrap();
        let track = Path::Spot { position_m: [0.0; 2], pulse }.track().unwrap();
        assert_eq!([track.power(1.9), track.power(2.5), track.power(3.1)], [0.0, 200.0, 0.0]);
        assert_eq!(track.energy(0.0, 9.0), 200.0);
    }

    #[test]
    fn bad_numbers_are_named() {
        let pulse = |duration_s, power_w| Pulse::Constant { start_s: 0.0, duration_s, power_w };
        let message = pulse(0.0, 1.0).points().unwrap_err().to_string();
        assert_eq!(message, "duration_s is 0, but must be a positive duration in seconds");
        assert!(pulse(1.0, -5.0).points().unwrap_err().to_string().starts_with("power_w is -5"));
        let table = Pulse::Table { start_s: 0.0, points: vec![PowerPoint { time_s: 0.0, power_w: 1.0 }] };
        let message = Path::Spot { position_m: [0.0; 2], pulse: table }.validate().unwrap_err().to_string();
        assert_eq!(message, "points has 1 entries, but needs at least 2");
    }
}
