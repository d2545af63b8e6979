//! Laser light that becomes heat in particles.

use super::faces::face_areas;
use crate::build::Workpiece;
use crate::model::ModelError;
use crate::physics::Exchange;
use laser_source::{Absorption, LaserSource, Rectangle, SurfacePatches};
use sph_thermal::conduction::ConductionRows;

/// Share of the light below which a particle under a Beer-Lambert beam is left out.
const SMALLEST_SHARE: f64 = 1e-9;

/// A laser and the particles that take up its light.
pub(super) struct Deposit {
    source: LaserSource,
    patches: SurfacePatches,
    particles: Vec<usize>,
    /// Share of the light on its square that each particle takes up.
    share: Vec<f64>,
    light: Vec<f64>,
    /// Top face of the modelled part, and of the whole part with its mirror images.
    face: Rectangle,
    whole: Rectangle,
    copies: f64,
    /// Share of the entering light that the part's thickness holds back (Beer-Lambert; one for a surface source).
    held: f64,
}

impl Deposit {
    /// `mirrored` says, for the low and high face of x and y, whether it is a symmetry plane.
    pub(super) fn new(
        source: &LaserSource,
        workpiece: &Workpiece,
        rows: &ConductionRows,
        mirrored: [[bool; 2]; 2],
    ) -> Result<Self, ModelError> {
        let shares = match source.absorption() {
            Absorption::Surface { .. } => surface_shares(workpiece, rows),
            absorption @ Absorption::BeerLambert { .. } => depth_shares(workpiece, absorption),
        };
        let particles: Vec<usize> = shares.iter().map(|share| share.0).collect();
        let column = |axis: usize| -> Vec<f64> {
            particles.iter().map(|&i| workpiece.particles.position[i][axis]).collect()
        };
        let half: Vec<f64> = particles.iter().map(|&i| 0.5 * workpiece.particles.spacing[i]).collect();
        let span = |axis: usize, whole: bool| {
            let (low, high) = (workpiece.low[axis], workpiece.high[axis]);
            let grow = |mirror: bool| if whole && mirror { high - low } else { 0.0 };
            (low - grow(mirrored[axis][0]), high + grow(mirrored[axis][1]))
        };
        let rectangle = |whole: bool| {
            let ((x_min_m, x_max_m), (y_min_m, y_max_m)) = (span(0, whole), span(1, whole));
            Rectangle { x_min_m, x_max_m, y_min_m, y_max_m }
        };
        Ok(Self {
            source: source.clone(),
            patches: SurfacePatches::new(&column(0), &column(1), &half)?,
            light: vec![0.0; particles.len()],
            share: shares.iter().map(|share| share.1).collect(),
            particles,
            face: rectangle(false),
            whole: rectangle(true),
            held: source.absorption().share_between(0.0, workpiece.high[2] - workpiece.low[2]),
            copies: mirrored.iter().flatten().map(|&mirror| if mirror { 2.0 } else { 1.0 }).product(),
        })
    }

    /// Sets `power` \[W\] to the mean power of each particle from `start` to `end` \[s\]; elsewhere it stays as it is.
    ///
    /// Shares are scaled so that their sum is exactly the light absorbed by the face. Returns that sum \[W\].
    pub(super) fn fill(&mut self, start: f64, end: f64, power: &mut [f64]) -> f64 {
        self.light.fill(0.0);
        self.patches.accumulate(&self.source, start, end, 1.0, &mut self.light);
        self.light.iter_mut().zip(&self.share).for_each(|(light, share)| *light *= share);
        let taken: f64 = self.light.iter().sum();
        let absorbed = self.held * self.source.mean_absorbed_power(start, end, &self.face);
        let scale = if taken > 0.0 { absorbed / taken } else { 0.0 };
        for (&particle, light) in self.particles.iter().zip(&self.light) {
            power[particle] = scale * light;
        }
        if taken > 0.0 { absorbed } else { 0.0 }
    }

    /// Where the light of a step went, as the modelled share of the whole part's audit.
    pub(super) fn audit(&self, start: f64, end: f64, absorbed: f64) -> Exchange {
        let audit = self.source.audit(start, end, &self.whole);
        Exchange {
            emitted: audit.emitted_j / self.copies,
            absorbed,
            reflected: audit.reflected_j / self.copies,
            // Light that leaves through the bottom has missed the part too.
            missed: (audit.missed_j + (1.0 - self.held) * audit.absorbed_j) / self.copies,
            ..Exchange::default()
        }
    }

    /// Particles that light can reach.
    pub(super) fn particles(&self) -> &[usize] {
        &self.particles
    }

    /// The source.
    pub(super) fn source(&self) -> &LaserSource {
        &self.source
    }
}

/// Particles of the top face and the share of their square that they stand for.
fn surface_shares(workpiece: &Workpiece, rows: &ConductionRows) -> Vec<(usize, f64)> {
    let square = |i: usize| workpiece.particles.spacing[i].powi(2);
    face_areas(workpiece, rows, 2, 1).into_iter().map(|(i, area, _)| (i, area / square(i))).collect()
}

/// Every particle that light reaches, with the share absorbed between the top and the bottom of its cell.
fn depth_shares(workpiece: &Workpiece, absorption: &Absorption) -> Vec<(usize, f64)> {
    let particles = &workpiece.particles;
    let share = |i: usize| {
        let (middle, half) = (-particles.position[i].z, 0.5 * particles.spacing[i]);
        absorption.share_between((middle - half).max(0.0), middle + half)
    };
    (0..particles.len()).map(|i| (i, share(i))).filter(|&(_, share)| share > SMALLEST_SHARE).collect()
}
