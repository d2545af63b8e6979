//! Values at the nodes of the finest grid, from particles that may not stand there.
//!
//! Particles on their lattice are the nodes. Disordered ones are read by moving least squares with full quadratics
//! (Lancaster and Salkauskas 1981), images included, so that a field that is quadratic near a node is read exactly; the
//! weights of particles at rest are computed once.

use crate::build::{Members, Workpiece, planes};
use crate::case::scene::Faces;
use crate::particles::bounding_box;
use nalgebra::{SMatrix, SVector, Vector3};
use sph_neighbors::{PairReach, Parts, SearchMethod};
use sph_thermal::conduction::Images;

/// Radius within which particles speak for a node, in spacings.
const RADIUS: f64 = 2.3;

/// A particle this near to its node, in spacings, stands on it.
const ON_NODE: f64 = 1e-6;

/// How the nodes of the finest grid are read off the particles.
pub enum Sampler {
    /// Node n is particle `[n]`.
    Lattice(Vec<u32>),
    /// Node n is a weighted sum over the particles of its row.
    Scattered {
        /// Start of each node's row.
        starts: Vec<usize>,
        /// Particle and weight.
        entries: Vec<(u32, f64)>,
    },
}

impl Sampler {
    /// The sampler of the finest grid of `workpiece`.
    pub fn new(workpiece: &Workpiece, faces: &Faces) -> Self {
        if workpiece.disorder == 0.0 {
            return Self::Lattice(workpiece.finest_particles.clone());
        }
        scattered(workpiece, faces)
    }

    /// Reads `field(particle)` at all nodes.
    pub fn read(&self, field: impl Fn(usize) -> f64, nodes: &mut [f64]) {
        match self {
            Self::Lattice(particles) => {
                nodes
                    .iter_mut()
                    .zip(particles)
                    .for_each(|(node, &particle)| *node = field(particle as usize));
            }
            Self::Scattered { starts, entries } => {
                for (node, range) in nodes.iter_mut().zip(starts.windows(2)) {
                    *node = entries[range[0]..range[1]].iter().map(|&(i, w)| w * field(i as usize)).sum();
                }
            }
        }
    }

    /// Gives particles what stands at the nodes, by the weights that [`read`](Self::read) has: the sum of `nodes` is
    /// kept.
    pub fn spread(&self, nodes: &[f64], mut give: impl FnMut(usize, f64)) {
        match self {
            Self::Lattice(particles) => {
                nodes.iter().zip(particles).for_each(|(&value, &particle)| give(particle as usize, value));
            }
            Self::Scattered { starts, entries } => {
                for (value, range) in nodes.iter().zip(starts.windows(2)) {
                    entries[range[0]..range[1]]
                        .iter()
                        .for_each(|&(i, weight)| give(i as usize, weight * value));
                }
            }
        }
    }
}

fn scattered(workpiece: &Workpiece, faces: &Faces) -> Sampler {
    let particles = &workpiece.particles;
    let radius = RADIUS * workpiece.spacing;
    let [nx, ny, nz] = workpiece.finest.counts();
    let node = |n: usize| {
        let at = [n % nx, n / nx % ny, n / nx / ny];
        let x = |axis: usize| (workpiece.finest.low[axis] as f64 + at[axis] as f64 + 0.5) * workpiece.spacing;
        Vector3::new(workpiece.low[0] + x(0), workpiece.low[1] + x(1), -x(2))
    };
    let own = |n: usize| workpiece.finest_particles[n];
    let count = nx * ny * nz;
    // Where a particle stands on its node, it speaks for it alone.
    let stands =
        |n: usize| (particles.position[own(n) as usize] - node(n)).norm() < ON_NODE * workpiece.spacing;
    let open: Vec<usize> = (0..count).filter(|&n| !stands(n)).collect();
    let mut everything: Vec<_> = open.iter().map(|&n| node(n)).collect();
    let [low, high] = bounding_box(&everything);
    let margin = Vector3::repeat(radius);
    let near = Members::within(&particles.position, low - margin, high + margin);
    everything.extend(near.gather(&particles.position));
    let reach = vec![2.0 * radius; near.len()];
    let planes = planes(workpiece.low, workpiece.high, faces);
    let images = Images::new(&everything[open.len()..], &reach, &planes);
    everything.extend_from_slice(&images.position);
    // Of particles and images, who are near which node is all that is asked.
    let parts = Parts { owned: open.len(), copies: everything.len() - open.len() };
    let list = SearchMethod::default().find_for(&everything, PairReach::Uniform(radius), parts);
    let list = list.expect("positions of a built workpiece are finite");
    let source =
        |k: usize| near.indices()[if k < near.len() { k } else { images.source[k - near.len()] as usize }];
    let (mut starts, mut entries) = (vec![0], Vec::new());
    let mut opened = open.iter().enumerate().peekable();
    for n in 0..count {
        match opened.next_if(|(_, node)| **node == n) {
            None => entries.push((own(n), 1.0)),
            Some((row, _)) => {
                let speakers = list.row(row).iter().map(|&k| k as usize).filter(|&k| k >= open.len());
                let speakers: Vec<usize> = speakers.collect();
                let offsets: Vec<_> =
                    speakers.iter().map(|&k| (everything[k] - everything[row]) / radius).collect();
                if speakers.is_empty() {
                    // Nobody is left here: the nearest speaks for this place.
                    entries.extend(nearest(&particles.position, &near, &node(n)).map(|i| (i, 1.0)));
                }
                let weighted = speakers.iter().zip(weights(&offsets));
                entries.extend(weighted.map(|(&k, w)| (source(k - open.len()), w)));
            }
        }
        starts.push(entries.len());
    }
    Sampler::Scattered { starts, entries }
}

/// The particle among `near` that is nearest to `place`.
fn nearest(positions: &[Vector3<f64>], near: &Members, place: &Vector3<f64>) -> Option<u32> {
    let distance = |i: &u32| (positions[*i as usize] - place).norm_squared();
    near.indices().iter().copied().min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// Sum of the sizes of weights above which points lie too badly for a quadratic: on the edge of a void that melt has left, say.
const LARGEST_WEIGHTS: f64 = 3.0;

/// Points whose weighted middle is this far from the node, in radii, lie on one side of it: the node is outside the melt's surface.
/// Disordered points all around stay below half of this.
const ONE_SIDED: f64 = 0.15;

/// Moving-least-squares weights at the origin of points at `offsets` (in radii), or those of a plain mean where the former would
/// extrapolate.
fn weights(offsets: &[Vector3<f64>]) -> Vec<f64> {
    let basis = |r: &Vector3<f64>| {
        SVector::<f64, 10>::from([
            1.0,
            r.x,
            r.y,
            r.z,
            r.x * r.x,
            r.y * r.y,
            r.z * r.z,
            r.x * r.y,
            r.y * r.z,
            r.z * r.x,
        ])
    };
    let weight = |r: &Vector3<f64>| (1.0 - r.norm()).max(0.0).powi(4) * (1.0 + 4.0 * r.norm()) + 1e-9;
    let total: f64 = offsets.iter().map(weight).sum();
    let mean = || offsets.iter().map(|r| weight(r) / total).collect();
    let middle = offsets.iter().fold(Vector3::zeros(), |sum, r| sum + r * (weight(r) / total));
    if middle.norm() > ONE_SIDED {
        return mean();
    }
    let mut moments = SMatrix::<f64, 10, 10>::zeros();
    for r in offsets {
        moments += weight(r) * basis(r) * basis(r).transpose();
    }
    let value = SVector::<f64, 10>::from_fn(|row, _| if row == 0 { 1.0 } else { 0.0 });
    let solved = moments.lu().solve(&value).unwrap_or(SVector::zeros());
    let quadratic: Vec<f64> = offsets.iter().map(|r| weight(r) * solved.dot(&basis(r))).collect();
    let sizes: f64 = quadratic.iter().map(|w| w.abs()).sum();
    if (0.5..=LARGEST_WEIGHTS).contains(&sizes) { quadratic } else { mean() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_one_side_are_not_carried_on_beyond_their_range() {
        let offsets: Vec<_> = (0..12)
            .map(|n| {
                Vector3::new(0.5 + 0.04 * f64::from(n % 4), 0.1 * f64::from(n / 4) - 0.1, 0.02 * f64::from(n))
            })
            .collect();
        let weights = weights(&offsets);
        assert!(weights.iter().all(|&w| (0.0..=1.0).contains(&w)), "{weights:?}");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn quadratics_are_read_exactly_from_scattered_points() {
        let noise = |n: u32| ((f64::from(n) * 12.9898).sin() * 43758.5453).rem_euclid(2.0) - 1.0;
        let offsets: Vec<_> =
            (0..40).map(|n| 0.55 * Vector3::new(noise(3 * n), noise(3 * n + 1), noise(3 * n + 2))).collect();
        let field = |r: &Vector3<f64>| 2.0 + r.x - 3.0 * r.y + r.z * r.x + 0.5 * r.y * r.y - r.z * r.z;
        let read: f64 = offsets.iter().zip(weights(&offsets)).map(|(r, w)| w * field(r)).sum();
        assert!((read - 2.0).abs() < 1e-9, "{read}");
    }
}
