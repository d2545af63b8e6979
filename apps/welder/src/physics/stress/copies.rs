//! Copies of particles beyond mirror planes: they move as their particles do, mirrored.

use crate::build::{Workpiece, planes};
use crate::model::Model;
use crate::physics::heat::mirrored;
use nalgebra::Vector3;
use sph_thermal::conduction::{Images, Parity, Planes};

/// A particle that has a copy needs whole rows in both; so a layer of twice the reach of a kernel is copied.
const LAYERS: f64 = 2.0;

/// Copies, in columns after their particles.
pub(super) struct Copies {
    images: Images<3>,
}

impl Copies {
    /// The copies of `workpiece` beyond the mirror planes of `model`, for pairs up to `reach` \[m\] apart.
    pub fn new(model: &Model, workpiece: &Workpiece, reach: f64) -> Self {
        let faces = mirrored(model);
        let all: Planes<3> = planes(workpiece.low, workpiece.high, &model.faces);
        let mirror = |axis: usize, end: usize| {
            let mirrors = faces.get(axis).is_some_and(|ends: &[bool; 2]| ends[end]);
            mirrors.then_some(Parity::Even)
        };
        let parity = [0, 1, 2].map(|axis| [mirror(axis, 0), mirror(axis, 1)]);
        let farthest = vec![LAYERS * reach; workpiece.particles.len()];
        let planes = Planes { parity, ..all };
        Self { images: Images::new(&workpiece.particles.position, &farthest, &planes) }
    }

    /// Positions of particles and then of copies \[m\].
    pub fn all_positions(&self, own: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        own.iter().chain(&self.images.position).copied().collect()
    }

    /// A column of particles continued over copies.
    pub fn all_scalars(&self, mut column: Vec<f64>) -> Vec<f64> {
        column.extend(self.images.source.iter().map(|&source| column[source as usize]).collect::<Vec<_>>());
        column
    }

    /// Gives copies the values of their particles.
    pub fn copy(&self, column: &mut [f64]) {
        let (own, copies) = column.split_at_mut(column.len() - self.images.len());
        copies.iter_mut().zip(&self.images.source).for_each(|(copy, &source)| *copy = own[source as usize]);
    }

    /// Gives copies the mirrored vectors of their particles.
    pub fn mirror(&self, column: &mut [Vector3<f64>]) {
        let (own, copies) = column.split_at_mut(column.len() - self.images.len());
        let sources = self.images.source.iter().zip(&self.images.mirror);
        for (copy, (&source, signs)) in copies.iter_mut().zip(sources) {
            *copy = own[source as usize].component_mul(&Vector3::from(*signs));
        }
    }
}
