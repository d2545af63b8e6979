//! What a picture shows: values on a plain regular grid, as the measuring code sampled them.

/// A cut through a field, sampled on a regular grid.
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
    /// What the values are, with their unit, such as "temperature, K".
    pub quantity: &'static str,
    /// Values, row after row (`y` outer, `x` inner); not a number means outside the part.
    pub value: Vec<f64>,
    /// Levels of the value to draw as lines, with their names, such as "liquidus".
    pub levels: Vec<(f64, &'static str)>,
    /// What the levels are of, where it is not the value: another field on the same grid, with its unit.
    pub levels_of: Option<(Vec<f64>, &'static str)>,
}

/// The pictures of one moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pictures {
    /// Sections, each with the name of its file without ending; a name met again replaces the picture.
    pub sections: Vec<(String, SectionGrid)>,
}

#[cfg(test)]
impl SectionGrid {
    /// A hot spot in the middle of the upper edge, from 293 K to 1493 K.
    pub(crate) fn example() -> Self {
        let (x_m, y_m): (Vec<f64>, Vec<f64>) = (
            (0..81).map(|index| (index as f64 - 40.0) * 25e-6).collect(),
            (0..41).map(|index| (index as f64 - 40.0) * 25e-6).collect(),
        );
        let rise = |x: f64, y: f64| 293.0 + 1200.0 * (-(x * x + 1.6 * y * y) / 2.5e-7).exp();
        let value = y_m.iter().flat_map(|&y| x_m.iter().map(move |&x| rise(x, y))).collect();
        SectionGrid {
            title: "Section through the beam, t = 5 ms".into(),
            x_label: "across the beam x",
            y_label: "height z",
            x_m,
            y_m,
            quantity: "temperature, K",
            value,
            levels: vec![(933.0, "liquidus"), (873.0, "solidus")],
            levels_of: None,
        }
    }
}
