//! Point sets and the brute-force search that tests compare with.

use crate::PairReach;
use crate::point_index::distance_squared;
use nalgebra::SVector;
use proptest::prelude::*;

/// Every pair looked at: the rows that any search must give.
pub fn brute_force<const D: usize>(positions: &[SVector<f64, D>], reach: PairReach<'_>) -> Vec<Vec<u32>> {
    let is_pair = |i: usize, j: usize| {
        let limit = reach.of_pair(i, j);
        i != j && distance_squared(&positions[i], &positions[j]) < limit * limit
    };
    (0..positions.len())
        .map(|i| (0..positions.len()).filter(|&j| is_pair(i, j)).map(|j| j as u32).collect())
        .collect()
}

/// `count` points a side at unit spacing, each coordinate moved by up to `amplitude` (deterministic).
pub fn perturbed_lattice<const D: usize>(count: usize, amplitude: f64) -> Vec<SVector<f64, D>> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut offset = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        amplitude * (2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0)
    };
    (0..count.pow(D as u32))
        .map(|k| SVector::from_fn(|axis, _| (k / count.pow(axis as u32) % count) as f64 + offset()))
        .collect()
}

/// Random points with coordinates in -1 to 1.
fn cloud<const D: usize>() -> impl Strategy<Value = Vec<SVector<f64, D>>> {
    let point = prop::array::uniform::<_, D>(-1.0..1.0_f64).prop_map(SVector::from);
    prop::collection::vec(point, 0..150)
}

/// Clouds bent into the sets that break searches: lattices, clusters, shear, planes, coincident points, far outliers.
pub fn any_set<const D: usize>() -> impl Strategy<Value = Vec<SVector<f64, D>>> {
    (cloud::<D>(), 0..8, -1e3..1e3).prop_map(|(mut points, bend, shift)| {
        for (index, point) in points.iter_mut().enumerate() {
            match bend {
                0 => *point = point.map(|x| 0.2 * (5.0 * x).round()),
                1 => *point = point.map(|x| (index % 3) as f64 + 0.01 * x),
                2 => point[0] += 30.0 * point[1],
                3 => point[D - 1] = 0.25,
                4 => *point = SVector::repeat(0.5),
                5 if index % 20 == 0 => *point *= 1e9,
                6 => *point = point.map(|x| x + shift),
                _ => {}
            }
        }
        points
    })
}

/// A set and a reach for each of its points, of five levels.
pub fn any_reach<const D: usize>() -> impl Strategy<Value = (Vec<SVector<f64, D>>, Vec<f64>)> {
    (any_set::<D>(), 0.02..0.2, prop::collection::vec((0..5_i32, 1.0..1.3), 150)).prop_map(
        |(points, smallest, levels)| {
            let reaches = levels[..points.len()]
                .iter()
                .map(|&(level, factor)| smallest * factor * 2_f64.powi(level))
                .collect();
            (points, reaches)
        },
    )
}
