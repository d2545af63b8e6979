//! Cells of a lattice.

use nalgebra::SVector;

/// Centre of a cell, in cells.
pub fn centre_of<const D: usize>(site: [i64; D]) -> SVector<f64, D> {
    SVector::from_fn(|axis, _| site[axis] as f64 + 0.5)
}

/// All cells of a box, x first.
pub fn sites<const D: usize>(low: [i64; D], high: [i64; D]) -> impl Iterator<Item = [i64; D]> {
    let counts: [i64; D] = std::array::from_fn(|axis| (high[axis] - low[axis]).max(0));
    (0..counts.iter().product()).map(move |mut index| {
        std::array::from_fn(|axis| {
            let k = index % counts[axis];
            index /= counts[axis];
            low[axis] + k
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_has_all_its_cells_once_x_first() {
        let found: Vec<[i64; 3]> = sites([-1, 0, 5], [1, 2, 6]).collect();
        assert_eq!(found, [[-1, 0, 5], [0, 0, 5], [-1, 1, 5], [0, 1, 5]]);
        assert_eq!(sites([0, 0], [3, 0]).count(), 0);
    }
}
