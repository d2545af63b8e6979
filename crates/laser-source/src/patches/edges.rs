//! The distinct edges of many intervals along one axis, and the error function at them.

use std::ops::Range;

use crate::beam::REACH;

/// Distinct edges in ascending order, and a table of the error function at them.
#[derive(Debug, Clone)]
pub(crate) struct Edges {
    position_m: Vec<f64>,
    erf: Vec<f64>,
}

impl Edges {
    /// The edges of the intervals `centre - half_width ..= centre + half_width`, and for each interval the
    /// indices of its two edges. Edges within `tolerance_m` above another count as that one.
    pub(crate) fn of_intervals(
        centre_m: &[f64],
        half_width_m: &[f64],
        tolerance_m: f64,
    ) -> (Self, Vec<[u32; 2]>) {
        let ends: Vec<[f64; 2]> =
            centre_m.iter().zip(half_width_m).map(|(centre, half)| [centre - half, centre + half]).collect();
        let mut position_m = ends.as_flattened().to_vec();
        position_m.sort_by(f64::total_cmp);
        // `dedup_by` compares with the first of a group, so that a chain of close edges cannot creep.
        position_m.dedup_by(|later, kept| *later - *kept <= tolerance_m);
        let index = |end: f64| (position_m.partition_point(|&edge| edge <= end) - 1) as u32;
        let spans = ends.iter().map(|end| end.map(index)).collect();
        (Self { erf: vec![0.0; position_m.len()], position_m }, spans)
    }

    /// Position of an edge (m).
    pub(crate) fn at(&self, index: u32) -> f64 {
        self.position_m[index as usize]
    }

    /// The indices of the edges nearer than `reach_m` to `centre_m`.
    pub(crate) fn within(&self, centre_m: f64, reach_m: f64) -> Range<u32> {
        let below = |limit: f64| self.position_m.partition_point(|&edge| edge < limit) as u32;
        below(centre_m - reach_m)..below(centre_m + reach_m)
    }

    /// Fills the table with erf((edge - centre) / radius) and returns the edges where it is not -1 or 1.
    pub(crate) fn evaluate_erf(&mut self, centre_m: f64, radius_m: f64) -> Range<u32> {
        let near = self.within(centre_m, REACH * radius_m);
        let (start, end) = (near.start as usize, near.end as usize);
        self.erf[..start].fill(-1.0);
        self.erf[end..].fill(1.0);
        for index in start..end {
            self.erf[index] = libm::erf((self.position_m[index] - centre_m) / radius_m);
        }
        near
    }

    /// The table that [`Edges::evaluate_erf`] filled.
    pub(crate) fn erf(&self) -> &[f64] {
        &self.erf
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_share_their_edge_in_spite_of_round_off() {
        let centre: Vec<f64> = (0..50).map(|i| 0.1 * f64::from(i) + 0.05).collect();
        let (edges, spans) = Edges::of_intervals(&centre, &[0.05; 50], 1e-11);
        assert_eq!(edges.position_m.len(), 51);
        assert!(spans.iter().enumerate().all(|(i, span)| *span == [i as u32, i as u32 + 1]));
    }

    #[test]
    fn error_function_is_evaluated_near_and_exact_far() {
        let (mut edges, _) = Edges::of_intervals(&[-20.0, 0.3, 20.0], &[1.0, 0.2, 1.0], 1e-9);
        assert_eq!(edges.evaluate_erf(0.0, 1.0), 2..4);
        assert_eq!(edges.erf(), [-1.0, -1.0, libm::erf(edges.at(2)), libm::erf(0.5), 1.0, 1.0]);
        assert!((edges.at(2) - 0.1).abs() < 1e-16);
    }
}
