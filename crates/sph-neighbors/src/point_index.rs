//! What a search method must offer: the points within one fixed radius of any place.

use nalgebra::SVector;

/// A static set of points that can be asked which of them are near.
pub(crate) trait PointIndex<const D: usize>: Sized + Sync {
    /// Indexes the `members` among `positions` for queries of `radius` \[m\]. `members` is not empty.
    fn build(positions: &[SVector<f64, D>], members: &[u32], radius: f64) -> Self;

    /// Appends the members nearer to `center` than the radius, by [`distance_squared`], in any order.
    fn collect_within(&self, center: &SVector<f64, D>, found: &mut Vec<u32>);
}

/// |a - b|^2 \[m^2\]; every method decides by this one expression, so that all find the same pairs to the last bit.
/// It is symmetric in a and b.
#[inline]
pub(crate) fn distance_squared<const D: usize>(a: &SVector<f64, D>, b: &SVector<f64, D>) -> f64 {
    let mut sum = 0.0;
    for axis in 0..D {
        let difference = a[axis] - b[axis];
        sum += difference * difference;
    }
    sum
}
