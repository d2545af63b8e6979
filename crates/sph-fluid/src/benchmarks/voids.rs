//! Voids that particles in the plane enclose.

use crate::FluidPatch;

/// Gauge points to a spacing along each axis.
const FINENESS: f64 = 4.0;
/// What has a particle within this many spacings is fluid.
const REACH: f64 = 0.85;

/// Radius of the largest circle over the spacing that holds no particle and lies inside the fluid. 0.71 on a lattice, 1.0 where one particle
/// is missing.
///
/// Inside is what cannot be reached from afar through places without a particle within 0.85 spacings: through gaps of less than 1.7.
#[must_use]
pub fn largest_void(patch: &FluidPatch<2>) -> f64 {
    let (positions, step) = (patch.positions(), patch.spacing() / FINENESS);
    let range = |axis: usize| {
        let along = positions.iter().map(|position| position[axis]);
        (along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max))
    };
    let (horizontal, vertical) = (range(0), range(1));
    // Five steps beyond the farthest particles all is empty.
    let margin = 5.0 * step;
    let count = |(low, high): (f64, f64)| ((high - low + 2.0 * margin) / step).ceil() as usize + 1;
    let (columns, rows) = (count(horizontal), count(vertical));
    let mut distances = vec![f64::INFINITY; columns * rows];
    // A particle is looked for as far as two spacings.
    let reach = 2 * FINENESS as usize;
    for position in positions {
        let place = [position.x - horizontal.0 + margin, position.y - vertical.0 + margin].map(|x| x / step);
        let nearby =
            |x: f64, count: usize| (x as usize).saturating_sub(reach)..(x as usize + reach + 2).min(count);
        for row in nearby(place[1], rows) {
            for column in nearby(place[0], columns) {
                let apart = (column as f64 - place[0]).hypot(row as f64 - place[1]) / FINENESS;
                let distance = &mut distances[row * columns + column];
                *distance = distance.min(apart);
            }
        }
    }
    let outside = reached(&distances, columns);
    let inside =
        distances.iter().zip(&outside).filter(|(_, outside)| !**outside).map(|(distance, _)| *distance);
    super::largest(inside.filter(|distance| distance.is_finite()))
}

/// Which gauge points the corner reaches through empty ones.
fn reached(distances: &[f64], columns: usize) -> Vec<bool> {
    let mut reached = vec![false; distances.len()];
    let mut next = vec![0];
    reached[0] = true;
    while let Some(point) = next.pop() {
        let column = point % columns;
        let beside = [
            (column > 0).then(|| point - 1),
            (column + 1 < columns).then_some(point + 1),
            point.checked_sub(columns),
            (point + columns < distances.len()).then_some(point + columns),
        ];
        for other in beside.into_iter().flatten() {
            if !reached[other] && distances[other] > REACH {
                reached[other] = true;
                next.push(other);
            }
        }
    }
    reached
}
