//! Flat layers driven by a surface temperature that rises along x: the open film, the shallow return flow (Birikh 1966), and a
//! layer between end walls. Density, viscosity, height and slope of temperature are one.

use super::lattice::{Site, WALL_ROWS, lattice};
use crate::{Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Renewal, SurfaceTension, Tait};
use nalgebra::{Matrix2, Vector2};
use sph_kernel::KernelKind;
use std::f64::consts::PI;

/// tau_T of the layers.
pub const SLOPE: f64 = -0.1;
/// Particles along x of a layer that repeats.
const COLUMNS: usize = 12;
/// Length of the closed layer.
const LENGTH: usize = 6;

fn controls(spacing: f64, sound_speed: f64, renewal: Option<Renewal>) -> Result<FluidControls<2>, Error> {
    let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
    Ok(FluidControls {
        dynamic_viscosity: 1.0,
        density_diffusion: 0.1,
        surface_tension: Some(SurfaceTension::new(0.0, SLOPE, 0.0)?),
        renewal,
        ..FluidControls::new(kernel, Tait::new(1.0, sound_speed, 7.0)?)
    })
}

/// Columns and rows of fluid; a wall below, `beside` columns wider on both sides, which also stands at the ends where
/// `closed`.
fn sites(columns: usize, rows: usize, beside: i32, closed: bool) -> PatchStart<2> {
    let (width, height) = (columns as i32, rows as i32);
    let start = lattice(1.0 / rows as f64, -beside..width + beside, -WALL_ROWS..height, |column, row| {
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
fn layer(rows: usize, renewal: Option<Renewal>, find: FindNeighbors<2>) -> Result<FluidPatch<2>, Error> {
    let start = sites(COLUMNS, rows, 6, false);
    let (spacing, period) = (start.spacing, COLUMNS as f64 * start.spacing);
    let start = PatchStart { periods: [Some(period), None], ..start };
    FluidPatch::new(start, controls(spacing, 5.0, renewal)?, find)
}

fn step(patch: &FluidPatch<2>) -> f64 {
    let length = 1.5 * patch.spacing();
    (0.125 * length * length).min(0.25 * length / 5.1)
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
pub fn film(
    rows: usize,
    renewal: Option<Renewal>,
    find: FindNeighbors<2>,
) -> Result<(f64, FluidPatch<2>), Error> {
    let mut patch = layer(rows, renewal, find)?;
    patch.run_to(2.0, step(&patch));
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
    renewal: Option<Renewal>,
    find: FindNeighbors<2>,
) -> Result<(f64, f64, FluidPatch<2>), Error> {
    let mut patch = layer(rows, renewal, find)?;
    let (dt, mut force) = (step(&patch), 0.0);
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
}

impl ClosedLayer {
    /// At rest under its weight.
    ///
    /// # Errors
    /// [`Error`] of the sweep.
    pub fn new(
        rows: usize,
        renewal: Option<Renewal>,
        corrected_gradients: bool,
        find: FindNeighbors<2>,
    ) -> Result<Self, Error> {
        let start = PatchStart {
            pressure: |position: &Vector2<f64>| 20.0 * (1.0 - position.y),
            ..sites(LENGTH * rows, rows, WALL_ROWS, true)
        };
        let controls = FluidControls {
            body_acceleration: Vector2::new(0.0, -20.0),
            corrected_gradients,
            ..controls(start.spacing, 30.0, renewal)?
        };
        Ok(Self { patch: FluidPatch::new(start, controls, find)? })
    }

    /// Steps to a time.
    pub fn run_to(&mut self, time: f64) {
        self.patch.run_to(time, 0.5 * 1.5 * self.patch.spacing() / 30.0);
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
