//! Copies of particles beyond mirror planes, where they move mirrored, and beyond clamped faces, where they move against
//! their particles, so that nothing moves on the face between.

use crate::build::{Workpiece, planes};
use crate::model::{Model, StressModel};
use nalgebra::Vector3;
use sph_thermal::conduction::{Images, Parity, Planes};

/// A particle that has a copy needs whole rows in both; so a layer of twice the reach of a kernel is copied.
const LAYERS: f64 = 2.0;

/// How displacements continue across a face.
#[derive(Clone, Copy, PartialEq)]
enum Continuation {
    None,
    Mirrored,
    Held,
}

/// Copies, in columns after their particles.
pub(super) struct Copies {
    /// The particle that a copy shows.
    source: Vec<u32>,
    /// Where copies stand \[m\].
    positions: Vec<Vector3<f64>>,
    /// What each component of a displacement is multiplied by.
    signs: Vec<Vector3<f64>>,
}

impl Copies {
    /// The copies of `workpiece`, for pairs up to `reach` \[m\] apart.
    pub fn new(model: &Model, stress: &StressModel, workpiece: &Workpiece, reach: f64) -> Self {
        let faces = continuations(model, stress);
        let parity = faces.map(|ends| ends.map(|end| (end != Continuation::None).then_some(Parity::Even)));
        let planes = Planes { parity, ..planes(workpiece.low, workpiece.high, &model.faces) };
        let farthest = vec![LAYERS * reach; workpiece.particles.len()];
        let images = Images::new(&workpiece.particles.position, &farthest, &planes);
        let signs = images.position.iter().map(|position| signs(position, workpiece, &faces)).collect();
        Self { source: images.source, positions: images.position, signs }
    }

    /// Positions of particles and then of copies \[m\].
    pub fn all_positions(&self, own: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        own.iter().chain(&self.positions).copied().collect()
    }

    /// A column of particles continued over copies.
    pub fn all_scalars(&self, own: &[f64]) -> Vec<f64> {
        let copies = self.source.iter().map(|&source| own[source as usize]);
        own.iter().copied().chain(copies).collect()
    }

    /// Gives copies the values of their particles.
    pub fn copy(&self, column: &mut [f64]) {
        let (own, copies) = column.split_at_mut(column.len() - self.source.len());
        copies.iter_mut().zip(&self.source).for_each(|(copy, &source)| *copy = own[source as usize]);
    }

    /// Gives copies the displacements that continue those of their particles.
    pub fn reflect(&self, displacements: &mut [Vector3<f64>]) {
        let (own, copies) = displacements.split_at_mut(displacements.len() - self.source.len());
        for (copy, (&source, signs)) in copies.iter_mut().zip(self.source.iter().zip(&self.signs)) {
            *copy = own[source as usize].component_mul(signs);
        }
    }
}

/// Low and high face of each axis.
fn continuations(model: &Model, stress: &StressModel) -> [[Continuation; 2]; 3] {
    let clamped = stress.settings.clamped;
    let held = [[clamped.x_min, clamped.x_max], [clamped.y_min, clamped.y_max], [clamped.bottom, false]];
    let mirrored = model.mirrored();
    std::array::from_fn(|axis| {
        std::array::from_fn(|end| {
            if held[axis][end] {
                Continuation::Held
            } else if mirrored.get(axis).is_some_and(|ends| ends[end]) {
                Continuation::Mirrored
            } else {
                Continuation::None
            }
        })
    })
}

/// The signs of a copy at `position`, by the faces that it lies beyond.
fn signs(position: &Vector3<f64>, workpiece: &Workpiece, faces: &[[Continuation; 2]; 3]) -> Vector3<f64> {
    let mut signs = Vector3::repeat(1.0);
    for axis in 0..3 {
        let beyond = if position[axis] < workpiece.low[axis] {
            faces[axis][0]
        } else if position[axis] > workpiece.high[axis] {
            faces[axis][1]
        } else {
            Continuation::None
        };
        match beyond {
            Continuation::None => {}
            Continuation::Mirrored => signs[axis] = -signs[axis],
            Continuation::Held => signs = -signs,
        }
    }
    signs
}
