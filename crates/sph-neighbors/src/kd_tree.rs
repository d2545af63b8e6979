//! Search by a k-d tree.

use crate::point_index::{PointIndex, distance_squared};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use nalgebra::SVector;

/// kiddo's immutable tree over the members. The mutable one splits its buckets at one coordinate and fails when more
/// points than a bucket holds share it, as on lattices and coplanar sets; this one is built at once and takes any set.
pub(crate) struct KdTree<const D: usize> {
    tree: ImmutableKdTree<f64, D>,
    radius: f64,
    points: Vec<SVector<f64, D>>,
    ids: Vec<u32>,
}

impl<const D: usize> PointIndex<D> for KdTree<D> {
    fn build(positions: &[SVector<f64, D>], members: &[u32], radius: f64) -> Self {
        let points: Vec<_> = members.iter().map(|&member| positions[member as usize]).collect();
        let coordinates: Vec<[f64; D]> = points.iter().map(|&point| point.into()).collect();
        let tree = ImmutableKdTree::new_from_slice(&coordinates)
            .expect("an immutable tree fails only for more points than 32-bit items can number");
        Self { tree, radius, points, ids: members.to_vec() }
    }

    fn collect_within(&self, center: &SVector<f64, D>, found: &mut Vec<u32>) {
        let limit = self.radius * self.radius;
        let query: [f64; D] = (*center).into();
        // The tree sums squares in an order of its own: ask for a hair more, then decide by the shared expression.
        let candidates = self
            .tree
            .query(&query)
            .within::<SquaredEuclidean<f64>>(limit * (1.0 + 1e-12))
            .unsorted()
            .execute();
        for candidate in candidates {
            let member = candidate.item as usize;
            if distance_squared(center, &self.points[member]) < limit {
                found.push(self.ids[member]);
            }
        }
    }
}
