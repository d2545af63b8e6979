//! Pair weights folded onto particles: what is left of pairs and images once their geometry is done with.

use super::pairs::NO_IMAGE;
use super::{JointPair, PairTable};

/// Heat that a particle exchanges with a face of fixed potential: coefficient (theta_face - theta_i) \[W\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallCoupling {
    /// The particle.
    pub particle: u32,
    /// Axis of the face.
    pub axis: u8,
    /// 0 for the low face, 1 for the high face.
    pub side: u8,
    /// Coefficient \[m\] (2-D: a number).
    pub coefficient: f64,
}

/// Where a row stands in the columns.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    start: usize,
    length: usize,
    /// Entries that there is room for.
    room: usize,
}

impl Place {
    fn range(&self) -> std::ops::Range<usize> {
        self.start..self.start + self.length
    }
}

/// A row that outgrows its place gets a new one with this much room over its length, so that rows of particles that move
/// on and on fill little more than they need.
const ROOM: f64 = 1.25;

/// Conduction weights g_ij of particles at rest: a row a particle, neighbours rising, without the particle itself.
#[derive(Debug, Clone, PartialEq)]
pub struct ConductionRows {
    places: Vec<Place>,
    neighbors: Vec<u32>,
    weights: Vec<f64>,
    walls: Vec<WallCoupling>,
}

impl ConductionRows {
    /// Folds one weight per entry of `pairs` onto particles: images onto their sources, own images dropped (they hold
    /// the same potential), reflected ones split into a pair part and a part with the face.
    pub(crate) fn fold<const D: usize>(pairs: &PairTable<'_, D>, weights: &[f64]) -> Self {
        let particles = pairs.particles();
        let mut folded = Self {
            places: Vec::with_capacity(particles),
            neighbors: Vec::with_capacity(weights.len()),
            weights: Vec::with_capacity(weights.len()),
            walls: Vec::new(),
        };
        let mut row: Vec<(u32, f64)> = Vec::new();
        for i in 0..particles {
            row.clear();
            for e in pairs.starts[i]..pairs.starts[i + 1] {
                let parity = match pairs.image[e] {
                    NO_IMAGE => 1.0,
                    image => {
                        folded.add_walls(i, weights[e], &pairs.images.wall[image as usize]);
                        pairs.images.parity[image as usize]
                    }
                };
                row.push((pairs.other[e], parity * weights[e]));
            }
            folded.push_row(i as u32, &mut row);
        }
        folded
    }

    fn add_walls<const D: usize>(&mut self, particle: usize, weight: f64, shares: &[[f64; 2]; D]) {
        for (axis, sides) in shares.iter().enumerate() {
            for (side, share) in sides.iter().enumerate().filter(|(_, share)| **share != 0.0) {
                let (particle, axis, side) = (particle as u32, axis as u8, side as u8);
                self.walls.push(WallCoupling { particle, axis, side, coefficient: weight * share });
            }
        }
    }

    /// Adds up the entries of each neighbour. The sum runs over weights in rising order, so that both ends of a pair
    /// round alike and the exchange stays antisymmetric to the last bit.
    fn push_row(&mut self, own: u32, row: &mut [(u32, f64)]) {
        row.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let start = self.neighbors.len();
        for &(other, weight) in row.iter().filter(|entry| entry.0 != own) {
            let begun = self.neighbors.len() > start;
            if begun && self.neighbors[self.neighbors.len() - 1] == other {
                *self.weights.last_mut().expect("a weight for each neighbour") += weight;
            } else {
                self.neighbors.push(other);
                self.weights.push(weight);
            }
        }
        self.close_row(start);
    }

    fn close_row(&mut self, start: usize) {
        let length = self.neighbors.len() - start;
        self.places.push(Place { start, length, room: length });
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.places.len()
    }

    /// Number of directed pairs.
    pub fn pairs(&self) -> usize {
        self.places.iter().map(|place| place.length).sum()
    }

    /// Neighbours and weights \[m\] of one particle.
    pub fn row(&self, i: usize) -> (&[u32], &[f64]) {
        let range = self.places[i].range();
        (&self.neighbors[range.clone()], &self.weights[range])
    }

    /// Puts `entries` (neighbours, rising, and weights \[m\]) in the place of the row of a particle that has moved. Energy is
    /// exchanged, and not made, once the rows of its neighbours are replaced alike.
    pub fn replace_row(&mut self, i: usize, entries: &[(u32, f64)]) {
        let place = &mut self.places[i];
        if entries.len() > place.room {
            let room = (ROOM * entries.len() as f64).ceil() as usize;
            *place = Place { start: self.neighbors.len(), length: 0, room };
            self.neighbors.resize(place.start + room, 0);
            self.weights.resize(place.start + room, 0.0);
        }
        place.length = entries.len();
        for (at, &(neighbor, weight)) in place.range().zip(entries) {
            (self.neighbors[at], self.weights[at]) = (neighbor, weight);
        }
    }

    /// Exchange with faces of fixed potential.
    pub fn walls(&self) -> &[WallCoupling] {
        &self.walls
    }

    /// Heat that each particle receives \[W\] at potentials `theta` \[W/m\]: the plain form that fast paths are held against.
    pub fn heat(&self, theta: &[f64]) -> Vec<f64> {
        let received = |i: usize| {
            let (neighbors, weights) = self.row(i);
            neighbors.iter().zip(weights).map(|(&j, g)| g * (theta[j as usize] - theta[i])).sum()
        };
        (0..self.particles()).map(received).collect()
    }

    /// Area that each of the given particles shows to a plane face: A_i = sum_j g_ij (z_j - z_i) with z the depth below
    /// the face \[m\]. A flux q through the face that enters as q A_i carries a linear depth field exactly.
    ///
    /// `candidates` are particles within a kernel's reach of the face; farther ones have no share.
    pub fn face_areas(&self, candidates: &[u32], depth: impl Fn(usize) -> f64) -> Vec<f64> {
        let area = |&i: &u32| {
            let (neighbors, weights) = self.row(i as usize);
            let own = depth(i as usize);
            neighbors.iter().zip(weights).map(|(&j, g)| g * (depth(j as usize) - own)).sum()
        };
        candidates.iter().map(area).collect()
    }

    /// Bound on the spectrum of `d h_i/dt = (1/inertia_i) sum_j g_ij (h_j - h_i)` by the largest row sum (Gershgorin), with
    /// `inertia` = rho V \[kg\] and weights multiplied by `scale(i, j)`, which is one but where a pair conducts better than
    /// its potentials say.
    pub fn gershgorin_bound(&self, inertia: &[f64], scale: impl Fn(usize, usize) -> f64) -> f64 {
        let row_sum = |i: usize| -> f64 {
            let (neighbors, weights) = self.row(i);
            neighbors.iter().zip(weights).map(|(&j, g)| scale(i, j as usize) * g.abs()).sum()
        };
        let mut diagonal: Vec<f64> = (0..self.particles()).map(row_sum).collect();
        for wall in &self.walls {
            diagonal[wall.particle as usize] += 0.5 * wall.coefficient.abs();
        }
        2.0 * diagonal.iter().zip(inertia).map(|(sum, inertia)| sum / inertia).fold(0.0, f64::max)
    }

    /// Takes out the pairs whose ends differ in material; the rest keeps its Kirchhoff form.
    pub fn split_joints(self, material: &[u8]) -> (Self, Vec<JointPair>) {
        let mut kept = Self {
            places: Vec::new(),
            neighbors: Vec::new(),
            weights: Vec::new(),
            walls: self.walls.clone(),
        };
        let mut joints = Vec::new();
        for i in 0..self.particles() {
            let (neighbors, weights) = self.row(i);
            let start = kept.neighbors.len();
            for (&j, &weight) in neighbors.iter().zip(weights) {
                if material[i] == material[j as usize] {
                    kept.neighbors.push(j);
                    kept.weights.push(weight);
                } else if (i as u32) < j {
                    joints.push(JointPair { first: i as u32, second: j, weight });
                }
            }
            kept.close_row(start);
        }
        (kept, joints)
    }
}
