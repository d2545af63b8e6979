//! Wrong cases: the path of the laser.

use super::Row;

const PULSE: &str = "Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0)";
const SPOT: &str =
    "Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0))";
/// Faults of the path of the laser.
pub const PATHS: &[Row] = &[
    (
        PULSE,
        "Table(start_s: 0, points: [(time_s: 0, power_w: 900), (time_s: -1e-3, power_w: 900)])",
        "-1e-3",
        &["laser.path.pulse.points.1.time_s", "before"],
    ),
    (
        PULSE,
        "Table(start_s: 0, points: [(time_s: 0, power_w: 0), (time_s: 1e-3, power_w: 0)])",
        "[(time_s",
        &["laser.path.pulse.points", "never on"],
    ),
    (
        PULSE,
        "Constant(start_s: 1.0, duration_s: 0.015, power_w: 1250.0)",
        "0.03",
        &["time.end_s", "before the laser starts"],
    ),
    (
        SPOT,
        "Straight(from_m: (0, 0), to_m: (0, 3e-3), speed_m_s: 1000, power_w: 1250, start_s: 0)",
        "1000",
        &["laser.path.speed_m_s", "mm/min (then write 0.0166667)"],
    ),
    (
        SPOT,
        "Straight(from_m: (0, 0), to_m: (0, 3e-3), speed_m_s: 0.01, power_w: 1250, start_s: 0)",
        "(0, 0)",
        &["laser.path.from_m", "mirror plane at y = 0"],
    ),
    (
        SPOT,
        "Straight(from_m: (0, 0), to_m: (0, 0), speed_m_s: 0.01, power_w: 1250, start_s: 0)",
        "(0, 0), speed",
        &["laser.path.to_m", "distance"],
    ),
    (
        SPOT,
        "Straight(from_m: (0, 9e-3), to_m: (0, 8e-3), speed_m_s: 0.01, power_w: 1250, start_s: 0)",
        "(0, 9e-3)",
        &["laser.path.from_m", "beside the part"],
    ),
    (
        SPOT,
        "Polyline(points: [(time_s: 0, x_m: 0, y_m: 0, power_w: 900), (time_s: -1, x_m: 0, y_m: 0, power_w: 900)])",
        "-1,",
        &["laser.path.points.1.time_s"],
    ),
    (
        SPOT,
        "Polyline(points: [(time_s: 0, x_m: 0, y_m: 0, power_w: 900)])",
        "[(time_s",
        &["laser.path.points", "at least 2"],
    ),
    (
        PULSE,
        "Constant(start_s: -1e-3, duration_s: 0.015, power_w: 1250.0)",
        "-1e-3",
        &["laser.path.pulse.start_s", "before the run"],
    ),
];
