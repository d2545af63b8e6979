//! Places of particles.

use nalgebra::SVector;

/// Lattice positions \[m\], spacing `spacing`, at the centres of the cells of a box from `low`, `counts` cells along the axes.
#[must_use]
pub fn lattice<const D: usize>(low: [f64; D], counts: [usize; D], spacing: f64) -> Vec<SVector<f64, D>> {
    let at = |k: usize, axis: usize| k / counts[..axis].iter().product::<usize>() % counts[axis];
    (0..counts.iter().product())
        .map(|k| SVector::from_fn(|axis, _| low[axis] + spacing * (at(k, axis) as f64 + 0.5)))
        .collect()
}

/// The same about the origin.
#[must_use]
pub fn centred<const D: usize>(counts: [usize; D], spacing: f64) -> Vec<SVector<f64, D>> {
    lattice(counts.map(|count| -0.5 * spacing * count as f64), counts, spacing)
}

/// Lattice positions \[m\] inside a disc or ball of `cells` spacings over its radius, about the origin.
#[must_use]
pub fn ball<const D: usize>(cells: usize, spacing: f64) -> Vec<SVector<f64, D>> {
    let radius = cells as f64 * spacing;
    let cube = centred([2 * cells; D], spacing);
    cube.into_iter().filter(|position| position.norm() < radius).collect()
}
