//! Lines of equal value on a regular grid, by marching squares.
//!
//! Lorensen and Cline, "Marching cubes" (1987), in two dimensions; a saddle is resolved by the mean of its corners.

/// A straight piece of a line, in units of grid cells: `(column, row)` at both ends.
pub type Piece = [(f64, f64); 2];

/// The pieces of the line on which values, given row after row with `columns` in each, equal `level`.
///
/// A cell with a corner that is not a number has no line.
pub fn contour(values: &[f64], columns: usize, level: f64) -> Vec<Piece> {
    let mut pieces = Vec::new();
    if columns < 2 {
        return pieces;
    }
    let rows = values.len() / columns;
    for row in 0..rows.saturating_sub(1) {
        for column in 0..columns - 1 {
            let first = row * columns + column;
            let corners = [first, first + 1, first + columns + 1, first + columns].map(|index| values[index]);
            cell_pieces(corners, level, |end| (end.0 + column as f64, end.1 + row as f64), &mut pieces);
        }
    }
    pieces
}

/// The pieces in one cell; its corners go round from the origin by way of the next column.
fn cell_pieces(
    corners: [f64; 4],
    level: f64,
    place: impl Fn((f64, f64)) -> (f64, f64),
    pieces: &mut Vec<Piece>,
) {
    let above = corners.map(|value| value >= level);
    if above.iter().all(|&is_above| is_above == above[0]) || corners.iter().any(|value| value.is_nan()) {
        return;
    }
    let crossed: Vec<usize> = (0..4).filter(|&edge| above[edge] != above[(edge + 1) % 4]).collect();
    let end = |edge: usize| place(crossing(corners, edge, level));
    if let [one, other] = crossed[..] {
        pieces.push([end(one), end(other)]);
        return;
    }
    // A saddle: the lines cut off those two corners that differ from the middle.
    let middle_above = corners.iter().sum::<f64>() / 4.0 >= level;
    for corner in (0..4).filter(|&corner| above[corner] != middle_above) {
        pieces.push([end((corner + 3) % 4), end(corner)]);
    }
}

/// Where the line crosses the edge that starts at a corner, in the cell.
fn crossing(corners: [f64; 4], edge: usize, level: f64) -> (f64, f64) {
    let (from, to) = (corners[edge], corners[(edge + 1) % 4]);
    let part = (level - from) / (to - from);
    [(part, 0.0), (1.0, part), (1.0 - part, 1.0), (0.0, 1.0 - part)][edge]
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: usize = 81;
    const ROWS: usize = 61;

    fn sampled(function: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let value = |index: usize| function((index % COLUMNS) as f64, (index / COLUMNS) as f64);
        (0..COLUMNS * ROWS).map(value).collect()
    }

    fn circle(x: f64, y: f64) -> f64 {
        (x - 40.3).hypot(y - 29.6)
    }

    fn length(pieces: &[Piece]) -> f64 {
        pieces.iter().map(|[from, to]| (from.0 - to.0).hypot(from.1 - to.1)).sum()
    }

    #[test]
    fn a_circle_has_its_radius_and_its_circumference_and_is_closed() {
        let pieces = contour(&sampled(circle), COLUMNS, 20.0);
        let ends: Vec<(f64, f64)> = pieces.iter().flatten().copied().collect();
        assert!(ends.iter().all(|&(x, y)| (circle(x, y) - 20.0).abs() < 0.01));
        assert!((length(&pieces) / (2.0 * std::f64::consts::PI * 20.0) - 1.0).abs() < 1e-3);
        for end in &ends {
            let near = |other: &&(f64, f64)| (end.0 - other.0).hypot(end.1 - other.1) < 1e-9;
            assert_eq!(ends.iter().filter(near).count(), 2);
        }
    }

    #[test]
    fn a_plane_gives_a_straight_line_from_edge_to_edge() {
        let pieces = contour(&sampled(|x, y| x + 0.5 * y), COLUMNS, 50.25);
        assert!(pieces.iter().flatten().all(|(x, y)| (x + 0.5 * y - 50.25).abs() < 1e-9));
        assert!((length(&pieces) - 60.0 * 1.25_f64.sqrt()).abs() < 1e-9);
    }

    #[test]
    fn a_saddle_never_crosses_itself() {
        let pieces = contour(&[1.0, 0.0, 0.0, 1.0], 2, 0.4);
        assert_eq!(pieces, [[(0.6, 0.0), (1.0, 0.4)], [(0.4, 1.0), (0.0, 0.6)]]);
        let pieces = contour(&[1.0, 0.0, 0.0, 1.0], 2, 0.6);
        assert_eq!(pieces, [[(0.0, 0.4), (0.4, 0.0)], [(1.0, 0.6), (0.6, 1.0)]]);
    }

    #[test]
    fn cells_outside_the_part_have_no_line() {
        let half = sampled(|x, y| if y > 29.5 { f64::NAN } else { circle(x, y) });
        let pieces = contour(&half, COLUMNS, 20.0);
        assert!(!pieces.is_empty() && pieces.iter().flatten().all(|&(_, y)| y <= 29.0));
        assert!(contour(&half, COLUMNS, 500.0).is_empty());
        assert!(contour(&half, 1, 20.0).is_empty() && contour(&[], 5, 20.0).is_empty());
    }
}
