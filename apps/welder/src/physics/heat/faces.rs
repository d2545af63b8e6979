//! Heat through the faces of the part: fixed temperature, given flux, losses.

use crate::build::Workpiece;
use crate::case::scene::{Face, Faces};
use crate::model::{Model, ModelError};
use sph_thermal::boundary::SurfaceLoss;
use sph_thermal::conduction::ConductionRows;
use sph_thermal::phase::EnthalpyCurve;

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
            exchange.add_face(workpiece, rows, (axis, side), face)?;
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
            Face::Losses { convection_w_m2_k, emissivity, ambient_k } => {
                let law = SurfaceLoss::new(convection_w_m2_k, emissivity, ambient_k)?;
                let areas = face_areas(workpiece, rows, axis, side);
                self.losses.extend(areas.into_iter().map(|(particle, area, depth)| Loss {
                    particle,
                    area,
                    depth,
                    law,
                }));
            }
        }
        Ok(())
    }

    /// Particles that exchange heat with a face, rising, each once.
    pub(super) fn particles(&self) -> &[usize] {
        &self.particles
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
            let (own, entering) =
                (curve.potential(enthalpy[loss.particle]), laser[loss.particle] / loss.area);
            let flux_at = |net: f64| loss.law.flux(curve.temperature_at_potential(own + net * loss.depth));
            // What leaves lowers the surface again; one correction, since the fall over a particle is small.
            let lost = loss.area * flux_at(entering - flux_at(entering));
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
