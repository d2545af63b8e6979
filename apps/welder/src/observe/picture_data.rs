//! What a picture shows: temperatures on a plain regular grid, as the measuring code sampled them.

/// A cut through the temperature field, sampled on a regular grid.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionGrid {
    /// What the picture shows, such as "Section through the beam, t = 5 ms".
    pub title: String,
    /// The axis to the right, without unit.
    pub x_label: &'static str,
    /// The upward axis, without unit.
    pub y_label: &'static str,
    /// Columns of the grid, ascending and evenly spaced.
    pub x_m: Vec<f64>,
    /// Rows of the grid, ascending and evenly spaced.
    pub y_m: Vec<f64>,
    /// Temperatures, row after row (`y` outer, `x` inner); not a number means outside the part.
    pub temperature_k: Vec<f64>,
    /// Isotherms to draw as lines, with their names, such as "liquidus".
    pub isotherms_k: Vec<(f64, &'static str)>,
}

/// The pictures of one moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pictures {
    /// Sections, each with the name of its file without ending; a name met again replaces the picture.
    pub sections: Vec<(String, SectionGrid)>,
}
