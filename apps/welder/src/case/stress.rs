//! Settings of thermal stress.

use serde::{Deserialize, Serialize};

/// Settings of thermal stress: a thermoelastic body with yield that follows the temperatures of heat.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Stress {
    /// How often a pressure wave crosses the whole part while the body settles in one step of heat: the work grows with it,
    /// what is left of the motion falls. Default: 1.
    pub crossings: f64,
    /// Faces that do not move. Default: none, the part is free.
    pub clamped: Clamped,
    /// Whether pressing and stretching change temperatures (Gough-Joule), and yield makes heat: below a kelvin in
    /// most welds. Default: false.
    pub heat_of_deformation: bool,
}

impl Default for Stress {
    fn default() -> Self {
        Stress { crossings: 1.0, clamped: Clamped::default(), heat_of_deformation: false }
    }
}

/// Which faces of the part are clamped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Clamped {
    /// The face at low x. Default: false, as for all.
    pub x_min: bool,
    /// The face at high x.
    pub x_max: bool,
    /// The face at low y.
    pub y_min: bool,
    /// The face at high y.
    pub y_max: bool,
    /// The face at z = -size.
    pub bottom: bool,
}

impl Clamped {
    /// The faces with their names in the scene: low and high of x, low and high of y, bottom.
    pub fn named(&self) -> [(&'static str, bool); 5] {
        [
            ("x_min", self.x_min),
            ("x_max", self.x_max),
            ("y_min", self.y_min),
            ("y_max", self.y_max),
            ("bottom", self.bottom),
        ]
    }
}
