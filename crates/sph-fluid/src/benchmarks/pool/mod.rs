//! Pools of melt held by a solid and by their own tension, with a hot spot in the middle of their flat top: a half-disc in 2-D, a
//! half-sphere in 3-D.

mod half_disc;
mod half_sphere;

pub use half_disc::HalfDiscFlow;
pub use half_sphere::HalfSphereFlow;

use crate::{Error, FindNeighbors, FluidControls, FluidPatch, PatchStart, Renewal, SurfaceTension, Tait};
use nalgebra::SVector;
use sph_kernel::KernelKind;

/// Radius of a pool \[m\].
pub const RADIUS: f64 = 0.5e-3;
/// Density \[kg/m^3\], tension \[N/m\] and its slope \[N/(m K)\], and viscosity \[Pa s\] of liquid aluminium.
const DENSITY: f64 = 2385.0;
const TENSION: f64 = 0.9;
const SLOPE: f64 = -3.5e-4;
const VISCOSITY: f64 = 1.1e-3;
const GRAVITY: f64 = 9.81;
/// Width of the spot \[radii\].
const WIDTH: f64 = 0.7;
/// Modes that are free of drive, and powers of the shear.
const MODES: usize = 60;
const POWERS: usize = 30;

/// What a pool is made of.
#[derive(Clone, Copy, Debug)]
pub struct PoolSetting {
    /// Spacings to the radius.
    pub across: usize,
    /// Viscosity over that of liquid aluminium.
    pub thickening: f64,
    /// Artificial viscosity alpha \[-\].
    pub artificial_viscosity: f64,
    /// Temperature of the spot over its surroundings \[K\]; zero leaves the pool at rest.
    pub spot: f64,
    /// Artificial speed of sound \[m/s\].
    pub sound_speed: f64,
}

/// A pool that runs.
#[derive(Debug)]
pub struct Pool<const D: usize> {
    /// The melt.
    pub patch: FluidPatch<D>,
    setting: PoolSetting,
}

/// Means of a part of a run.
#[derive(Clone, Copy, Debug, Default)]
pub struct PoolMeans {
    /// Outward speed just below the top between 0.3 and 0.7 of the radius \[m/s\].
    pub outward: f64,
    /// The same over that of the exact flow at the same places.
    pub speed: f64,
    /// Share of the exact flow in that of all particles, sum v.v_exact/sum v_exact^2.
    pub projection: f64,
    /// L2 error of all velocities over the L2 norm of the exact ones.
    pub field: f64,
}

impl<const D: usize> Pool<D> {
    /// A pool cut out of a lattice, in a solid one support thick. Tension alone holds it: it wants renewal, and keeps plain gradients.
    ///
    /// # Errors
    /// [`Error`] of the sweep.
    pub fn new(
        setting: PoolSetting,
        renewal: Option<Renewal>,
        corrected_gradients: bool,
        find: FindNeighbors<D>,
    ) -> Result<Self, Error> {
        let spacing = RADIUS / setting.across as f64;
        let (melt, solid) = sites(setting.across);
        let kernel = KernelKind::WendlandC2.with_smoothing_length(1.5 * spacing);
        let mut weight = SVector::zeros();
        weight[D - 1] = -GRAVITY;
        let controls = FluidControls {
            dynamic_viscosity: setting.thickening * VISCOSITY,
            artificial_viscosity: setting.artificial_viscosity,
            density_diffusion: 0.1,
            body_acceleration: weight,
            // The temperature of the patch is that of a spot of one kelvin.
            surface_tension: Some(SurfaceTension::new(TENSION, SLOPE * setting.spot, 0.0)?),
            renewal,
            corrected_gradients,
            ..FluidControls::new(kernel, Tait::new(DENSITY, setting.sound_speed, 7.0)?)
        };
        let start = PatchStart {
            wall_velocities: vec![SVector::zeros(); solid.len()],
            walls: solid,
            pressure: |position: &SVector<f64, D>| -DENSITY * GRAVITY * position[D - 1],
            temperature: spot,
            ..PatchStart::free(melt.clone(), vec![spacing.powi(D as i32); melt.len()], spacing)
        };
        Ok(Self { patch: FluidPatch::new(start, controls, find)?, setting })
    }

    /// sqrt(tau/(rho R)) \[m/s\].
    #[must_use]
    pub fn capillary_speed() -> f64 {
        (TENSION / (DENSITY * RADIUS)).sqrt()
    }

    /// Steps to a time \[s\]; the largest speed on the way \[m/s\].
    pub fn run_to(&mut self, time: f64) -> f64 {
        let dt = self.step();
        let mut largest = 0.0_f64;
        while self.patch.time() < time {
            self.patch.step(dt);
            largest = super::largest([largest, self.patch.largest_speed()].into_iter());
        }
        largest
    }

    /// Steps to a time \[s\] and takes the means of all steps on the way.
    pub fn means(&mut self, time: f64, exact: impl Fn(&SVector<f64, D>) -> SVector<f64, D>) -> PoolMeans {
        let dt = self.step();
        let (mut means, mut steps) = (PoolMeans::default(), 0.0);
        while self.patch.time() < time {
            self.patch.step(dt);
            let now = self.now(&exact);
            means.outward += now.outward;
            means.speed += now.speed;
            means.projection += now.projection;
            means.field += now.field;
            steps += 1.0;
        }
        PoolMeans {
            outward: means.outward / steps,
            speed: means.speed / steps,
            projection: means.projection / steps,
            field: means.field / steps,
        }
    }

    /// How far the farthest particle lies outside the pool \[spacings\].
    #[must_use]
    pub fn outside(&self) -> f64 {
        let spacing = self.patch.spacing();
        let outside = |place: &SVector<f64, D>| (place.norm() - RADIUS).max(place[D - 1]) / spacing;
        self.patch.positions().iter().map(outside).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Share of particles that lie more than some spacings outside the pool.
    #[must_use]
    pub fn share_outside(&self, spacings: f64) -> f64 {
        let limit = spacings * self.patch.spacing();
        let outside = |place: &&SVector<f64, D>| place.norm() - RADIUS > limit || place[D - 1] > limit;
        self.patch.positions().iter().filter(outside).count() as f64 / self.patch.positions().len() as f64
    }

    fn step(&self) -> f64 {
        0.5 * 1.5 * self.patch.spacing() / self.setting.sound_speed
    }

    fn now(&self, exact: impl Fn(&SVector<f64, D>) -> SVector<f64, D>) -> PoolMeans {
        let unit = -SLOPE * self.setting.spot / (self.setting.thickening * VISCOSITY);
        let (mut found_outward, mut exact_outward, mut count) = (0.0, 0.0, 0.0);
        let (mut wrong, mut along, mut size) = (0.0, 0.0, 0.0);
        for (position, velocity) in self.patch.positions().iter().zip(self.patch.velocities()) {
            let place = position / RADIUS;
            // Above the flat top the exact flow is that of the top, in the solid there is none.
            let mut level = place;
            level[D - 1] = level[D - 1].min(0.0);
            let expected = if level.norm() < 1.0 { exact(&level) * unit } else { SVector::zeros() };
            let mut aside = place;
            aside[D - 1] = 0.0;
            if place[D - 1] > -TOP && (0.3..0.7).contains(&aside.norm()) {
                found_outward += velocity.dot(&aside) / aside.norm();
                exact_outward += expected.dot(&aside) / aside.norm();
                count += 1.0;
            }
            wrong += (velocity - expected).norm_squared();
            along += velocity.dot(&expected);
            size += expected.norm_squared();
        }
        PoolMeans {
            outward: found_outward / count,
            speed: found_outward / exact_outward,
            projection: along / size,
            field: (wrong / size).sqrt(),
        }
    }
}

/// Depth of what counts as the top \[radii\].
const TOP: f64 = 0.125;

fn spot<const D: usize>(position: &SVector<f64, D>) -> f64 {
    let aside = position.norm_squared() - position[D - 1].powi(2);
    (-aside / (WIDTH * RADIUS).powi(2)).exp()
}

/// Melt and solid on one lattice, the solid as thick as the kernel and one more.
fn sites<const D: usize>(across: usize) -> (Vec<SVector<f64, D>>, Vec<SVector<f64, D>>) {
    let (spacing, n) = (RADIUS / across as f64, 2 * (across + 4));
    let (mut melt, mut solid) = (Vec::new(), Vec::new());
    for k in 0..n.pow(D as u32) / 2 {
        // The last axis runs slowest, so that the first half of the cells lies below.
        let cell = |axis: usize| (k / n.pow(axis as u32) % n) as f64 + 0.5 - 0.5 * n as f64;
        let position = SVector::<f64, D>::from_fn(|axis, _| cell(axis) * spacing);
        if position.norm() < RADIUS {
            melt.push(position);
        } else if position.norm() < RADIUS + 4.0 * spacing {
            solid.push(position);
        }
    }
    (melt, solid)
}

/// Powers f_m of -(2/w^2) x exp(-x^2/w^2), m odd: the shear that the depth sees, for tau_T < 0.
fn shear_powers(width: f64) -> [(i32, f64); POWERS] {
    let mut power = -2.0 / (width * width);
    std::array::from_fn(|k| {
        let found = (2 * k as i32 + 1, power);
        power *= -1.0 / (width * width * (k + 1) as f64);
        found
    })
}
