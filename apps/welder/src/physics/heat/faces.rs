//! Heat through the faces of the part: fixed temperature, given flux, losses.

use crate::build::Workpiece;
use crate::case::scene::{Face, Faces};
use crate::model::{Model, ModelError};
use sph_thermal::boundary::{SurfaceLoss, surface_temperature};
use sph_thermal::conduction::ConductionRows;
use sph_thermal::phase::EnthalpyCurve;

/// Radiation is taken to be as stiff as at this temperature \[K\], above the boiling point of the metals that are welded.
const HOTTEST: f64 = 4000.0;

/// A particle that exchanges heat with a face of fixed temperature.
struct Wall {
    particle: usize,
    coefficient: f64,
    temperature: f64,
}

/// A particle at a face that loses heat to its surroundings.
struct Loss {
    particle: usize,
    area: f64,
    /// Depth of the particle below the face over its area, for the surface temperature \[m\].
    depth: f64,
    law: SurfaceLoss,
}

/// Particles that exchange heat with faces, and how.
pub(super) struct FaceExchange {
    walls: Vec<Wall>,
    losses: Vec<Loss>,
    fluxes: Vec<(usize, f64)>,
    particles: Vec<usize>,
    material: Vec<u8>,
}

impl FaceExchange {
    pub(super) fn new(
        model: &Model,
        workpiece: &Workpiece,
        rows: &ConductionRows,
    ) -> Result<Self, ModelError> {
        let mut exchange = Self {
            walls: walls(&model.faces, rows),
            losses: Vec::new(),
            fluxes: Vec::new(),
            particles: Vec::new(),
            material: workpiece.particles.material.clone(),
        };
        for (axis, side, face) in sides(&model.faces) {
            exchange.add_face(model, workpiece, rows, (axis, side), face)?;
        }
        let walls = exchange.walls.iter().map(|wall| wall.particle);
        let losses = exchange.losses.iter().map(|loss| loss.particle);
        exchange.particles = walls.chain(losses).chain(exchange.fluxes.iter().map(|flux| flux.0)).collect();
        exchange.particles.sort_unstable();
        exchange.particles.dedup();
        Ok(exchange)
    }

    fn add_face(
        &mut self,
        model: &Model,
        workpiece: &Workpiece,
        rows: &ConductionRows,
        (axis, side): (usize, usize),
        face: Face,
    ) -> Result<(), ModelError> {
        match face {
            Face::Adiabatic | Face::Symmetry | Face::FixedTemperature { .. } => {}
            Face::Flux { flux_w_m2 } => {
                let areas = face_areas(workpiece, rows, axis, side);
                self.fluxes.extend(areas.into_iter().map(|(i, area, _)| (i, flux_w_m2 * area)));
            }
            Face::Losses { .. } => {
                let laws: Vec<_> =
                    (0..model.curves.len()).map(|m| model.surface_loss(face, m)).collect::<Result<_, _>>()?;
                for (particle, area, depth) in face_areas(workpiece, rows, axis, side) {
                    let law = laws[self.material[particle] as usize];
                    self.losses.extend(law.map(|law| Loss { particle, area, depth, law }));
                }
            }
        }
        Ok(())
    }

    /// Particles that exchange heat with a face, rising, each once.
    pub(super) fn particles(&self) -> &[usize] {
        &self.particles
    }

    /// Largest share of a particle's heat above its surroundings that it loses in a second \[1/s\].
    pub(super) fn fastest_loss(&self, curves: &[EnthalpyCurve], mass: &[f64]) -> f64 {
        let rate = |loss: &Loss| {
            let curve = &curves[self.material[loss.particle] as usize];
            // However steep the loss, heat must be conducted to the face first.
            let lost = loss.law.slope(HOTTEST) * curve.largest_temperature_slope();
            let conducted = curve.largest_potential_slope() / loss.depth;
            loss.area * lost.min(conducted) / mass[loss.particle]
        };
        self.losses.iter().map(rate).fold(0.0, f64::max)
    }

    /// Adds the heat \[W\] that each particle receives to `power`, and returns the heat \[W\] that leaves the part.
    ///
    /// `laser` is the power \[W\] that the laser gives each particle: it lifts the surface above the particle's centre.
    pub(super) fn add(
        &self,
        enthalpy: &[f64],
        curves: &[EnthalpyCurve],
        laser: &[f64],
        power: &mut [f64],
    ) -> f64 {
        let mut leaving = 0.0;
        let curve = |i: usize| &curves[self.material[i] as usize];
        for wall in &self.walls {
            let curve = curve(wall.particle);
            let received = wall.coefficient
                * (curve.potential_at(wall.temperature) - curve.potential(enthalpy[wall.particle]));
            power[wall.particle] += received;
            leaving -= received;
        }
        for loss in &self.losses {
            let curve = curve(loss.particle);
            let own = curve.potential(enthalpy[loss.particle]);
            let entering = laser[loss.particle] / loss.area;
            let surface = surface_temperature(curve, own, entering, loss.depth, &loss.law);
            let lost = loss.area * loss.law.flux(surface);
            power[loss.particle] -= lost;
            leaving += lost;
        }
        for &(particle, received) in &self.fluxes {
            power[particle] += received;
            leaving -= received;
        }
        leaving
    }
}

fn sides(faces: &Faces) -> [(usize, usize, Face); 6] {
    [
        (0, 0, faces.x_min),
        (0, 1, faces.x_max),
        (1, 0, faces.y_min),
        (1, 1, faces.y_max),
        (2, 0, faces.bottom),
        (2, 1, faces.top),
    ]
}

fn walls(faces: &Faces, rows: &ConductionRows) -> Vec<Wall> {
    let temperature = |axis: u8, side: u8| {
        let found = sides(faces).into_iter().find(|s| (s.0 as u8, s.1 as u8) == (axis, side));
        match found {
            Some((_, _, Face::FixedTemperature { temperature_k })) => temperature_k,
            _ => unreachable!("only faces of fixed temperature reflect"),
        }
    };
    let wall = |wall: &sph_thermal::conduction::WallCoupling| Wall {
        particle: wall.particle as usize,
        coefficient: wall.coefficient,
        temperature: temperature(wall.axis, wall.side),
    };
    rows.walls().iter().map(wall).collect()
}

/// (particle, area, depth) of the particles that stand for a face; areas add up to the face.
pub(super) fn face_areas(
    workpiece: &Workpiece,
    rows: &ConductionRows,
    axis: usize,
    side: usize,
) -> Vec<(usize, f64, f64)> {
    let plane = if side == 0 { workpiece.low[axis] } else { workpiece.high[axis] };
    let position = &workpiece.particles.position;
    let depth = |i: usize| (position[i][axis] - plane).abs();
    // Two layers and half a cell of disorder: what lies deeper has no share of the face.
    let near = |&i: &u32| depth(i as usize) < 2.4 * workpiece.particles.spacing[i as usize];
    let candidates: Vec<u32> = (0..position.len() as u32).filter(near).collect();
    let areas = rows.face_areas(&candidates, depth);
    let whole: f64 = (0..3).filter(|&a| a != axis).map(|a| workpiece.high[a] - workpiece.low[a]).product();
    let kept: Vec<_> = candidates
        .into_iter()
        .zip(areas)
        .filter(|(i, area)| *area > 1e-3 * workpiece.particles.spacing[*i as usize].powi(2))
        .collect();
    let scale = whole / kept.iter().map(|(_, area)| area).sum::<f64>();
    kept.into_iter().map(|(i, area)| (i as usize, scale * area, depth(i as usize))).collect()
}
