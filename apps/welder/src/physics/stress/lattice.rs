//! The body's own particles where melt flows: they stay on their lattice, and read the temperatures of those that have moved.

use crate::build::Workpiece;
use crate::case::scene::Faces;
use crate::measure::Sampler;
use crate::model::Model;

/// Between the body's particles, which stand on the nodes of one grid, and the scene's, which started there.
pub(super) struct Lattice {
    faces: Faces,
    sampler: Sampler,
    /// The body's particle at each node.
    nodes: Vec<u32>,
    /// The body's particle in whose cell each particle of the scene is.
    homes: Vec<u32>,
    values: Vec<f64>,
}

impl Lattice {
    pub(super) fn new(model: &Model, workpiece: &Workpiece) -> Self {
        let nodes = workpiece.finest_particles.clone();
        let mut lattice = Self {
            faces: model.faces,
            sampler: Sampler::new(workpiece, &model.faces),
            homes: (0..workpiece.particles.len() as u32).collect(),
            values: vec![0.0; nodes.len()],
            nodes,
        };
        lattice.follow(workpiece);
        lattice
    }

    /// Takes up the new places of the scene's particles.
    pub(super) fn follow(&mut self, workpiece: &Workpiece) {
        self.sampler = Sampler::new(workpiece, &self.faces);
        let counts = workpiece.finest.counts();
        for (home, position) in self.homes.iter_mut().zip(&workpiece.particles.position) {
            let cell: [usize; 3] = std::array::from_fn(|axis| {
                // The third axis counts cells down from the top face.
                let along = if axis == 2 {
                    workpiece.high[2] - position.z
                } else {
                    position[axis] - workpiece.low[axis]
                };
                ((along / workpiece.spacing).floor().max(0.0) as usize).min(counts[axis] - 1)
            });
            *home = self.nodes[(cell[2] * counts[1] + cell[1]) * counts[0] + cell[0]];
        }
    }

    /// Reads `field`, a value of each particle of the scene, at the body's particles.
    pub(super) fn read(&mut self, field: impl Fn(usize) -> f64, body: &mut [f64]) {
        self.sampler.read(field, &mut self.values);
        for (&particle, &value) in self.nodes.iter().zip(&self.values) {
            body[particle as usize] = value;
        }
    }

    /// Gives the particles of the scene what the body's have, `give(particle, share)`, by the weights that they are
    /// read with: the sum is kept.
    pub(super) fn spread(&mut self, body: &[f64], give: impl FnMut(usize, f64)) {
        for (value, &particle) in self.values.iter_mut().zip(&self.nodes) {
            *value = body[particle as usize];
        }
        self.sampler.spread(&self.values, give);
    }

    /// What the particles of the scene show of a column of the body's.
    pub(super) fn shown<T: Copy>(&self, column: &[T]) -> Vec<T> {
        self.homes.iter().map(|&home| column[home as usize]).collect()
    }
}
