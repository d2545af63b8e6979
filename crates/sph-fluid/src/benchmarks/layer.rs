//! Flat layers driven by a surface temperature that rises along x: the open film, the shallow return flow (Birikh 1966), and a
//! layer between end walls. Density, viscosity, height and slope of temperature are one.

use super::Scheme;
use super::lattice::{Site, lattice};
use crate::{
    Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Renewal, SurfaceModel, SurfaceTension,
    acoustic_step, viscous_step,
};
use nalgebra::{Matrix2, Vector2};
use std::f64::consts::PI;

/// tau_T of the layers.
pub const SLOPE: f64 = -0.1;
/// Particles along x of a layer that repeats.
const COLUMNS: usize = 12;
/// Length of the closed layer.
const LENGTH: usize = 6;
/// Tension at x = 0 where it acts as a stress.
const STRESSED_TENSION: f64 = 0.3;

/// Layers that repeat: sound fifty times as fast as the film.
pub const SCHEME: Scheme = Scheme::new(5.0);
/// The closed layer, held flat by its weight: without renewal and corrected gradients it stalls.
pub const CLOSED_SCHEME: Scheme = Scheme {
    renewal: Some(Renewal { shifting: 3.0, density_pull: 0.005 }),
    corrected_gradients: true,
    ..Scheme::new(30.0)
};

fn controls(scheme: Scheme, spacing: f64) -> Result<FluidControls<2>, Error> {
    // A stress cannot push: it needs a tension that stays above zero along the layer, which changes nothing where the surface is flat.
    let tension = match scheme.surface_model {
        SurfaceModel::Force => 0.0,
        SurfaceModel::Stress => STRESSED_TENSION,
    };
    Ok(FluidControls {
        dynamic_viscosity: 1.0,
        surface_tension: Some(SurfaceTension::new(tension, SLOPE, 0.0)?),
        ..scheme.controls(spacing)?
    })
}

/// Columns and rows of fluid; a wall below, some columns wider on both sides, which also stands at the ends where `closed`.
fn sites(columns: usize, rows: usize, wall_rows: i32, closed: bool) -> PatchStart<2> {
    let (width, height) = (columns as i32, rows as i32);
    let beside = if closed { wall_rows } else { wall_rows + 2 };
    let start = lattice(1.0 / rows as f64, -beside..width + beside, -wall_rows..height, |column, row| {
        let inside = (0..width).contains(&column);
        match row {
            0.. if inside => Site::Fluid,
            0.. if !closed => Site::Empty,
            _ => Site::Wall,
        }
    });
    PatchStart { temperature: |position: &Vector2<f64>| position.x, ..start }
}

/// A layer that repeats along x, at rest over a wall, its surface open.
fn layer(rows: usize, scheme: Scheme, find: FindNeighbors<2>) -> Result<FluidPatch<2>, Error> {
    let start = sites(COLUMNS, rows, scheme.wall_rows(), false);
    let (spacing, period) = (start.spacing, COLUMNS as f64 * start.spacing);
    let start = PatchStart { periods: [Some(period), None], ..start };
    FluidPatch::new(start, controls(scheme, spacing)?, find)
}

fn step(patch: &FluidPatch<2>, scheme: Scheme) -> f64 {
    let length = patch.sweep().kernel().smoothing_length();
    viscous_step(length, 1.0).min(acoustic_step(length, scheme.sound_speed, SLOPE.abs()))
}

/// Surface value of the fit u = a z + b z^2 through the particles that `chosen` takes.
fn surface_speed(patch: &FluidPatch<2>, chosen: impl Fn(&Vector2<f64>) -> bool) -> f64 {
    let (mut matrix, mut right) = (Matrix2::zeros(), Vector2::zeros());
    for (position, velocity) in patch.positions().iter().zip(patch.velocities()) {
        if chosen(position) {
            let basis = Vector2::new(position.y, position.y * position.y);
            matrix += basis * basis.transpose();
            right += basis * velocity.x;
        }
    }
    matrix.try_inverse().map_or(f64::NAN, |inverse| (inverse * right).sum())
}

/// Surface speed of the open film at t = 2 over the exact tau_T G H/eta, less what is left of the start-up there; with the
/// layer.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn film(rows: usize, scheme: Scheme, find: FindNeighbors<2>) -> Result<(f64, FluidPatch<2>), Error> {
    let mut patch = layer(rows, scheme, find)?;
    patch.run_to(2.0, step(&patch, scheme));
    let rest = 8.0 / (PI * PI) * (-PI * PI / 4.0 * patch.time()).exp();
    Ok((surface_speed(&patch, |_| true) / (SLOPE * (1.0 - rest)), patch))
}

/// Surface speed at t = 2 of the layer without net flux over the exact tau_T G H/(4 eta), and the force that holds the flux
/// over the exact 3/2 tau_T G/H; with the layer.
///
/// # Errors
/// [`Error`] of the sweep.
pub fn return_flow(
    rows: usize,
    scheme: Scheme,
    find: FindNeighbors<2>,
) -> Result<(f64, f64, FluidPatch<2>), Error> {
    let mut patch = layer(rows, scheme, find)?;
    let (dt, mut force) = (step(&patch, scheme), 0.0);
    while patch.time() < 2.0 {
        patch.step(dt);
        let velocities = patch.velocities_mut();
        let mean = velocities.iter().map(|velocity| velocity.x).sum::<f64>() / velocities.len() as f64;
        velocities.iter_mut().for_each(|velocity| velocity.x -= mean);
        force = -mean / dt;
    }
    Ok((surface_speed(&patch, |_| true) / (SLOPE / 4.0), force / (-1.5 * SLOPE), patch))
}

/// A layer of length 6 between end walls, held flat by its weight (g = 20, c0 = 30): what flows out along the surface must
/// dive at one end and rise at the other.
#[derive(Debug)]
pub struct ClosedLayer {
    /// The fluid.
    pub patch: FluidPatch<2>,
    dt: f64,
}

impl ClosedLayer {
    /// At rest under its weight.
    ///
    /// # Errors
    /// [`Error`] of the sweep.
    pub fn new(rows: usize, scheme: Scheme, find: FindNeighbors<2>) -> Result<Self, Error> {
        let start = PatchStart {
            pressure: |position: &Vector2<f64>| 20.0 * (1.0 - position.y),
            ..sites(LENGTH * rows, rows, scheme.wall_rows(), true)
        };
        let dt = scheme.acoustic_step(0.5, start.spacing);
        let body_acceleration = Vector2::new(0.0, -20.0);
        let controls = FluidControls { body_acceleration, ..controls(scheme, start.spacing)? };
        Ok(Self { patch: FluidPatch::new(start, controls, find)?, dt })
    }

    /// Steps to a time.
    pub fn run_to(&mut self, time: f64) {
        self.patch.run_to(time, self.dt);
    }

    /// Mean height of the upper row: of the topmost particle in each of six parts of the layer \[H\].
    #[must_use]
    pub fn height(&self) -> f64 {
        let mut tops = [0.0_f64; LENGTH];
        for position in self.patch.positions() {
            let part = (position.x.max(0.0) as usize).min(LENGTH - 1);
            tops[part] = tops[part].max(position.y);
        }
        tops.iter().sum::<f64>() / LENGTH as f64
    }

    /// Surface speed over Birikh's in the middle 30 % of the layer, and the L2 error of the velocities there.
    #[must_use]
    pub fn middle(&self) -> (f64, f64) {
        let inside = |position: &Vector2<f64>| (position.x - 0.5 * LENGTH as f64).abs() < 0.9;
        let (mut wrong, mut exact) = (0.0, 0.0);
        for (position, velocity) in self.patch.positions().iter().zip(self.patch.velocities()) {
            if inside(position) {
                let birikh = SLOPE * (0.75 * position.y * position.y - 0.5 * position.y);
                wrong += (velocity - Vector2::new(birikh, 0.0)).norm_squared();
                exact += birikh * birikh;
            }
        }
        (surface_speed(&self.patch, inside) / (SLOPE / 4.0), (wrong / exact).sqrt())
    }
}
