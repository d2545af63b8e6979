//! The workpiece: a box with its top face at z = 0, its faces, and boxes of other material inside it.

use serde::{Deserialize, Serialize};

/// The workpiece. Material fills `low_corner_m` to `low_corner_m + size_m` in x and y, and -size z to 0 in z.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Length along x, y, z in metres; each a whole number of spacings.
    pub size_m: [f64; 3],
    /// x and y of the low corner in metres. Default: (0, 0).
    #[serde(default)]
    pub low_corner_m: [f64; 2],
    /// Name of a material card in cases/materials or in the scene's `materials`, or a path to a card (ending in .ron)
    /// relative to the scene file.
    pub material: String,
    /// Temperature at the start in kelvin.
    pub start_k: f64,
    /// What happens at each face. Default: adiabatic.
    #[serde(default)]
    pub faces: Faces,
    /// Boxes of another material or start temperature; where they overlap, the later one holds. Default: none.
    #[serde(default)]
    pub regions: Vec<Region>,
}

impl Part {
    /// The low corner (x, y, z) in metres.
    pub fn low_m(&self) -> [f64; 3] {
        [self.low_corner_m[0], self.low_corner_m[1], -self.size_m[2]]
    }

    /// The high corner (x, y, z) in metres; its z is the top face, 0.
    pub fn high_m(&self) -> [f64; 3] {
        [self.low_corner_m[0] + self.size_m[0], self.low_corner_m[1] + self.size_m[1], 0.0]
    }
}

/// A box inside the part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// Low corner (x, y, z) in metres.
    pub low_m: [f64; 3],
    /// High corner (x, y, z) in metres.
    pub high_m: [f64; 3],
    /// Material of the box, named as in `part.material`. Default: that of the part.
    #[serde(default)]
    pub material: Option<String>,
    /// Temperature at the start in kelvin. Default: that of the part.
    #[serde(default)]
    pub start_k: Option<f64>,
}

impl Region {
    /// Whether the point (x, y, z) in metres lies in the box; the low faces belong to it, the high ones do not.
    pub fn contains(&self, point_m: [f64; 3]) -> bool {
        (0..3).all(|axis| self.low_m[axis] <= point_m[axis] && point_m[axis] < self.high_m[axis])
    }
}

/// The six faces of the part.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Faces {
    /// The face at low x.
    pub x_min: Face,
    /// The face at high x.
    pub x_max: Face,
    /// The face at low y.
    pub y_min: Face,
    /// The face at high y.
    pub y_max: Face,
    /// The face at z = -size.
    pub bottom: Face,
    /// The face at z = 0, which the laser meets.
    pub top: Face,
}

impl Faces {
    /// The faces with their names in the scene, in the order x_min, x_max, y_min, y_max, bottom, top.
    pub fn named(&self) -> [(&'static str, Face); 6] {
        [
            ("x_min", self.x_min),
            ("x_max", self.x_max),
            ("y_min", self.y_min),
            ("y_max", self.y_max),
            ("bottom", self.bottom),
            ("top", self.top),
        ]
    }
}

/// What happens at one face.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Face {
    /// No heat crosses it (besides the laser's).
    #[default]
    Adiabatic,
    /// A mirror plane: the part goes on beyond it, mirrored. Faces in x and y only.
    Symmetry,
    /// Held at a temperature.
    FixedTemperature {
        /// The temperature in kelvin.
        temperature_k: f64,
    },
    /// A steady flux of heat.
    Flux {
        /// Heat into the part in W/m2; negative: out of it.
        flux_w_m2: f64,
    },
    /// Convection and radiation to the surroundings, and evaporation into them.
    Losses {
        /// Heat transfer coefficient in W/(m2 K). Default: 0.
        #[serde(default)]
        convection_w_m2_k: f64,
        /// Emissivity of the surface, 0 to 1. Default: 0.
        #[serde(default)]
        emissivity: f64,
        /// Temperature of the surroundings in kelvin. Default: 293.
        #[serde(default = "room_temperature_k")]
        ambient_k: f64,
        /// Whether the melt evaporates, which takes heat; the material must give boiling_k, heat_of_evaporation_j_kg and
        /// molar_mass_kg_mol. Default: false.
        #[serde(default)]
        evaporation: bool,
    },
}

fn room_temperature_k() -> f64 {
    293.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_holds_its_low_faces_only() {
        let region = Region { low_m: [0.0; 3], high_m: [1.0; 3], material: None, start_k: None };
        assert!(region.contains([0.0, 0.5, 0.0]));
        assert!(!region.contains([1.0, 0.5, 0.5]));
        assert!(!region.contains([0.5, -0.1, 0.5]));
    }

    #[test]
    fn the_part_lies_below_its_top_face() {
        let part = Part {
            size_m: [1.0, 2.0, 3.0],
            low_corner_m: [-0.5, 1.0],
            material: String::new(),
            start_k: 293.0,
            faces: Faces::default(),
            regions: Vec::new(),
        };
        assert_eq!(part.low_m(), [-0.5, 1.0, -3.0]);
        assert_eq!(part.high_m(), [0.5, 3.0, 0.0]);
    }
}
