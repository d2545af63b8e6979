//! The workpiece cut into particles.

use super::{Cell, CellBox, LevelPlan};
use crate::case::scene::{Face, Faces};
use crate::model::Model;
use crate::particles::Particles;
use nalgebra::{SVector, Vector3};
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;
use sph_thermal::conduction::{Parity, Planes};

/// Disorder of melt that flows, in spacings: rows must reach as far as if a particle had left its cell.
const FLOWING: f64 = 0.5;

/// Particles of a part, and where they came from.
#[derive(Debug, Clone)]
pub struct Workpiece {
    /// The particles, sorted in space, with start temperatures.
    pub particles: Particles<3>,
    /// Finest spacing \[m\].
    pub spacing: f64,
    /// Low corner of the part \[m\].
    pub low: [f64; 3],
    /// High corner of the part \[m\].
    pub high: [f64; 3],
    /// The box of finest cells; its third axis counts down from the top face.
    pub finest: CellBox<3>,
    /// For each cell of `finest`, first axis fastest: its particle.
    pub finest_particles: Vec<u32>,
    /// Levels of spacing in use.
    pub levels: usize,
    /// Largest shift of a particle from its cell's centre, in spacings of its own.
    pub disorder: f64,
}

impl Workpiece {
    /// Cuts the part of `model` into the cells of `plan`.
    pub fn new(model: &Model, plan: &LevelPlan<3>) -> Self {
        let (low, high) = model.bounds();
        let cells = plan.cells();
        let mut particles = Particles::default();
        let mut jitter = Pcg64Mcg::seed_from_u64(model.resolution.seed);
        for cell in &cells {
            let edge = model.spacing() * (1u64 << cell.level) as f64;
            let shift = disorder(&mut jitter, model.resolution.disorder, edge);
            push(&mut particles, model, centre(cell, model.spacing(), &low) + shift, edge);
        }
        let finest = plan.finest_box();
        Self {
            finest_particles: index_finest(&cells, &finest),
            particles,
            spacing: model.spacing(),
            low,
            high,
            finest,
            levels: plan.levels(),
            disorder: if model.flow.is_some() { FLOWING } else { model.resolution.disorder },
        }
    }
}

/// Centre of a cell \[m\]: x and y from the low corner, z down from the top face.
fn centre(cell: &Cell<3>, spacing: f64, low: &[f64; 3]) -> Vector3<f64> {
    let middle = cell.low.map(|low| low as f64 + 0.5 * (1u64 << cell.level) as f64);
    Vector3::new(low[0] + spacing * middle[0], low[1] + spacing * middle[1], -spacing * middle[2])
}

/// A random shift \[m\] of the particle of a cell with the given edge, along each axis at most `amplitude` edges.
pub fn disorder<const D: usize>(random: &mut Pcg64Mcg, amplitude: f64, edge: f64) -> SVector<f64, D> {
    if amplitude == 0.0 {
        return SVector::zeros();
    }
    SVector::from_fn(|_, _| amplitude * edge * random.random_range(-1.0..=1.0))
}

fn push(particles: &mut Particles<3>, model: &Model, position: Vector3<f64>, edge: f64) {
    let (material, temperature) = (model.start)(position.into());
    let enthalpy = model.curves[material as usize].enthalpy_at(temperature);
    let volume = edge.powi(3);
    particles.position.push(position);
    particles.spacing.push(edge);
    particles.volume.push(volume);
    particles.mass.push(model.materials[material as usize].density * volume);
    particles.material.push(material);
    particles.enthalpy.push(enthalpy);
    particles.start_enthalpy.push(enthalpy);
    particles.peak_enthalpy.push(enthalpy);
}

fn index_finest(cells: &[Cell<3>], finest: &CellBox<3>) -> Vec<u32> {
    let [nx, ny, nz] = finest.counts();
    let mut index = vec![u32::MAX; nx * ny * nz];
    for (particle, cell) in cells.iter().enumerate().filter(|(_, cell)| cell.level == 0) {
        let at: [i64; 3] = std::array::from_fn(|axis| cell.low[axis] - finest.low[axis]);
        if (0..3).all(|axis| at[axis] >= 0 && cell.low[axis] < finest.high[axis]) {
            index[(at[2] as usize * ny + at[1] as usize) * nx + at[0] as usize] = particle as u32;
        }
    }
    index
}

/// The plane faces of the part: every face mirrors what is inside, one of fixed temperature with the sign turned.
pub fn planes(low: [f64; 3], high: [f64; 3], faces: &Faces) -> Planes<3> {
    planes_of(low, high, faces, |face| {
        Some(match face {
            Face::FixedTemperature { .. } => Parity::Odd,
            _ => Parity::Even,
        })
    })
}

/// The symmetry planes of the part: faces of any other kind mirror nothing.
pub fn symmetry_planes(low: [f64; 3], high: [f64; 3], faces: &Faces) -> Planes<3> {
    planes_of(low, high, faces, |face| (face == Face::Symmetry).then_some(Parity::Even))
}

fn planes_of(
    low: [f64; 3],
    high: [f64; 3],
    faces: &Faces,
    parity: impl Fn(Face) -> Option<Parity>,
) -> Planes<3> {
    let mut planes = Planes::adiabatic_box(low, high);
    planes.parity = [
        [parity(faces.x_min), parity(faces.x_max)],
        [parity(faces.y_min), parity(faces.y_max)],
        [parity(faces.bottom), parity(faces.top)],
    ];
    planes
}
