//! Where a field on a regular grid crosses a level, between its nodes.
//!
//! Crossings use the cubic through the four nearest nodes: it halves the error in depth of linear interpolation. The
//! largest of a row of sizes lies between its samples too: the parabola through the largest and its neighbours finds it.

use serde::{Deserialize, Serialize};

/// Size of a region above a level \[m\].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Extent {
    /// Along y: across a seam that runs along x.
    pub width: f64,
    /// Along x.
    pub length: f64,
    /// Below the top face.
    pub depth: f64,
    /// Low and high corner of the region's bounding box, z below zero; empty while nothing is above the level.
    pub bounds: Option<[[f64; 3]; 2]>,
}

impl Extent {
    /// The larger of two sizes, each by itself; bounds cover both.
    pub fn max(&self, other: &Self) -> Self {
        let bounds = match (self.bounds, other.bounds) {
            (Some([low, high]), Some([other_low, other_high])) => Some([
                std::array::from_fn(|axis| low[axis].min(other_low[axis])),
                std::array::from_fn(|axis| high[axis].max(other_high[axis])),
            ]),
            (own, other) => own.or(other),
        };
        Self {
            width: self.width.max(other.width),
            length: self.length.max(other.length),
            depth: self.depth.max(other.depth),
            bounds,
        }
    }
}

/// The polynomial through nodes `(x, f)` at `x`.
pub(crate) fn lagrange(nodes: &[(f64, f64)], x: f64) -> f64 {
    let basis = |k: usize| {
        let others = nodes.iter().enumerate().filter(|(other, _)| *other != k);
        others.map(|(_, node)| (x - node.0) / (nodes[k].0 - node.0)).product::<f64>()
    };
    (0..nodes.len()).map(|k| nodes[k].1 * basis(k)).sum()
}

/// Where the field passes `level` between `inside` and the next of `nodes` (rising x); the caller knows that it is above
/// at `inside` and not above at the next.
pub(crate) fn crossing(nodes: &[(f64, f64)], inside: usize, level: f64) -> f64 {
    let first = inside.saturating_sub(1);
    let near = &nodes[first..(inside + 3).min(nodes.len())];
    let (mut low, mut high) = (nodes[inside].0, nodes[inside + 1].0);
    // The bracket holds, because the polynomial takes the nodes' values. 30 halvings are a billionth of a spacing.
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        if lagrange(near, middle) > level { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// What the parabola through three equally spaced values rises above the middle one, which is the largest.
pub(super) fn rise_above_middle(before: f64, middle: f64, after: f64) -> f64 {
    let bend = before - 2.0 * middle + after;
    if bend >= 0.0 { 0.0 } else { -(before - after).powi(2) / (8.0 * bend) }
}

/// The largest of `values` with its parabola through the neighbours; a mirror plane just beyond an end shows the end
/// again. Values of zero are empty rows: no parabola is laid through them.
pub(super) fn smooth_maximum(values: &[f64], mirror: [bool; 2]) -> f64 {
    let Some((at, &middle)) = values.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)) else { return 0.0 };
    let before = if at > 0 { Some(values[at - 1]) } else { mirror[0].then_some(middle) };
    let after = values.get(at + 1).copied().or(mirror[1].then_some(middle));
    match (before, after) {
        (Some(before), Some(after)) if before > 0.0 && after > 0.0 => {
            middle + rise_above_middle(before, middle, after)
        }
        _ => middle,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn crossings_of_cubics_are_exact(root in 1.05..3.95f64, a in 0.1..2.0f64, b in -0.03..0.03f64) {
            let field = |x: f64| -a * (x - root) + b * (x - root).powi(3);
            let nodes: Vec<_> = (0..6).map(|k| (f64::from(k), field(f64::from(k)))).collect();
            let inside = root.floor() as usize;
            prop_assume!(nodes[inside].1 > 0.0 && nodes[inside + 1].1 <= 0.0);
            prop_assert!((crossing(&nodes, inside, 0.0) - root).abs() < 2e-9);
        }

        #[test]
        fn a_parabola_gives_its_own_vertex(vertex in 1.6..3.4f64, height in 1.0..2.0f64, bend in 0.01..0.1f64) {
            let values: Vec<f64> = (0..6).map(|k| height - bend * (f64::from(k) - vertex).powi(2)).collect();
            prop_assert!((smooth_maximum(&values, [false; 2]) - height).abs() < 1e-12);
        }
    }

    #[test]
    fn a_mirror_puts_the_vertex_on_the_plane() {
        // f = 3 - x² sampled at half spacings: the vertex lies on the plane before the first sample.
        let values: Vec<f64> = (0..4).map(|k| 20.0 - (f64::from(k) + 0.5).powi(2)).collect();
        assert!((smooth_maximum(&values, [true, false]) - 20.0).abs() < 1e-12);
        assert_eq!(smooth_maximum(&values, [false; 2]), values[0]);
    }

    #[test]
    fn near_an_end_fewer_nodes_serve() {
        let line = [(0.0, 1.0), (1.0, -1.0)];
        assert!((crossing(&line, 0, 0.0) - 0.5).abs() < 2e-9);
    }
}
