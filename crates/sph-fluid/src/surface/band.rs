//! The band of particles that make the surface, found anew at each evaluation.

use super::{
    PlaneProfile, curvature, is_surface, may_be_surface, plane_of_surface, smoothed_curvature,
    smoothed_normal, unit_or_zero,
};
use crate::sweep::{Buffers, FluidFields, copy_images};
use nalgebra::SVector;
use rayon::prelude::*;
use sph_kernel::operators::{colour_gradient, summation};
use sph_kernel::{Row, ScaledKernel};

/// Columns of the surface; all but the gradients are of use near it only. Walls have no entries but zeros and `false`: they
/// count in the colour, and the band is one of fluid.
#[derive(Clone, Debug)]
pub struct SurfaceBand<const D: usize> {
    kernel: ScaledKernel<D>,
    buffers: Buffers<D>,
    profile: PlaneProfile,
    /// grad C \[1/m\], pointing inwards.
    gradients: Vec<SVector<f64, D>>,
    /// Depth by the colour where a particle may belong to the band, on which curvature rests \[m\].
    colour_depths: Vec<f64>,
    /// Depth by the centroid in the same places, which crowding does not change \[m\].
    offset_depths: Vec<f64>,
    flags: Vec<bool>,
    normals: Vec<SVector<f64, D>>,
    raw_curvatures: Vec<f64>,
    curvatures: Vec<f64>,
    /// Outward normal of the smoothed surface and depth below it, infinite away from it.
    planes: Vec<(SVector<f64, D>, f64)>,
    /// How far the normals of the band near a particle of fluid agree.
    agreements: Vec<f64>,
}

impl<const D: usize> SurfaceBand<D> {
    /// A band that has seen no particles.
    #[must_use]
    pub fn new(kernel: ScaledKernel<D>) -> Self {
        Self {
            profile: PlaneProfile::new(&kernel),
            kernel,
            buffers: Buffers::default(),
            gradients: Vec::new(),
            colour_depths: Vec::new(),
            offset_depths: Vec::new(),
            flags: Vec::new(),
            normals: Vec::new(),
            raw_curvatures: Vec::new(),
            curvatures: Vec::new(),
            planes: Vec::new(),
            agreements: Vec::new(),
        }
    }

    /// What the kernel sees below a plane.
    #[must_use]
    pub fn profile(&self) -> &PlaneProfile {
        &self.profile
    }

    /// grad C \[1/m\] of each particle of fluid, then of copies.
    #[must_use]
    pub fn gradients(&self) -> &[SVector<f64, D>] {
        &self.gradients
    }

    /// Whether a particle belongs to the band.
    #[must_use]
    pub fn flags(&self) -> &[bool] {
        &self.flags
    }

    /// Curvature \[1/m\] of each particle, smoothed; zero away from the band.
    #[must_use]
    pub fn curvatures(&self) -> &[f64] {
        &self.curvatures
    }

    /// Outward normal of the surface over a particle and the particle's depth below it \[m\], infinite away from it.
    #[must_use]
    pub fn planes(&self) -> &[(SVector<f64, D>, f64)] {
        &self.planes
    }

    /// How far the normals of the surface near a particle agree \[-\]: one under a plane, less where the surface bends or folds, zero
    /// where it is torn and away from it.
    #[must_use]
    pub fn agreements(&self) -> &[f64] {
        &self.agreements
    }

    /// Finds the surface of `fluid` particles and their copies; `bends` also measures curvature.
    pub fn measure(&mut self, fields: &FluidFields<'_, D>, volumes: &[f64], fluid: usize, bends: bool) {
        self.fit(fields.positions.len());
        self.measure_colour(fields, volumes, fluid);
        self.mark(fields, fluid);
        self.smooth_normals(fields, fluid);
        self.find_planes(fields, fluid);
        if bends {
            self.measure_curvature(fields, volumes, fluid);
        }
    }

    fn fit(&mut self, particles: usize) {
        self.gradients.resize(particles, SVector::zeros());
        self.colour_depths.resize(particles, 0.0);
        self.offset_depths.resize(particles, 0.0);
        self.flags.resize(particles, false);
        self.normals.resize(particles, SVector::zeros());
        self.raw_curvatures.resize(particles, 0.0);
        self.curvatures.resize(particles, 0.0);
        self.planes.resize(particles, (SVector::zeros(), f64::INFINITY));
        self.agreements.resize(particles, 0.0);
        // Where fluid and copies change in number, walls take the places of both.
        self.flags.fill(false);
    }

    fn measure_colour(&mut self, fields: &FluidFields<'_, D>, volumes: &[f64], fluid: usize) {
        let (kernel, buffers, profile) = (&self.kernel, &self.buffers, &self.profile);
        let central = kernel.value(0.0);
        let written = self.gradients[..fluid]
            .par_iter_mut()
            .zip(self.colour_depths[..fluid].par_iter_mut())
            .zip(self.offset_depths[..fluid].par_iter_mut());
        written.enumerate().for_each_init(
            || buffers.take(),
            |buffer, (i, ((gradient, colour), offset))| {
                let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                *gradient = colour_gradient(&row, volumes);
                if may_be_surface(gradient, kernel.smoothing_length()) {
                    *colour = profile.depth_of_colour(summation(&row, volumes, central));
                    *offset = profile.depth_of_offset(centroid(&row, central).norm());
                }
            },
        );
        fields.copy_vectors(&mut self.gradients, fluid);
        copy_images(&mut self.colour_depths, fluid, fields.copies);
        copy_images(&mut self.offset_depths, fluid, fields.copies);
    }

    fn mark(&mut self, fields: &FluidFields<'_, D>, fluid: usize) {
        let Self { kernel, profile, buffers, gradients, colour_depths, flags, .. } = self;
        let mobile = fluid + fields.copies.len();
        gradients[mobile..].fill(SVector::zeros());
        flags[..fluid].par_iter_mut().enumerate().for_each_init(
            || buffers.take(),
            |buffer, (i, flag)| {
                let length = kernel.smoothing_length();
                // A gradient without a void is that of a crowd below: the force of one such particle tore a pool.
                let sees_a_void = colour_depths[i] < profile.support();
                if may_be_surface(&gradients[i], length) && sees_a_void {
                    let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                    *flag = is_surface(&row, gradients, length);
                }
            },
        );
        copy_images(flags, fluid, fields.copies);
    }

    fn smooth_normals(&mut self, fields: &FluidFields<'_, D>, fluid: usize) {
        let Self { kernel, buffers, gradients, flags, normals, .. } = self;
        let central = kernel.value(0.0);
        normals[..fluid].par_iter_mut().enumerate().for_each_init(
            || buffers.take(),
            |buffer, (i, normal)| {
                *normal = if flags[i] {
                    let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                    smoothed_normal(&row, gradients, flags, central)
                } else {
                    -unit_or_zero(&gradients[i])
                };
            },
        );
        fields.copy_vectors(normals, fluid);
    }

    fn find_planes(&mut self, fields: &FluidFields<'_, D>, fluid: usize) {
        let Self { kernel, buffers, gradients, flags, normals, offset_depths, planes, agreements, .. } = self;
        let central = kernel.value(0.0);
        let written = planes[..fluid].par_iter_mut().zip(agreements[..fluid].par_iter_mut()).enumerate();
        written.for_each_init(
            || buffers.take(),
            |buffer, (i, (plane, agreement))| {
                (*plane, *agreement) = ((SVector::zeros(), f64::INFINITY), 0.0);
                if near_band(fields, flags, i) {
                    let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                    let found = plane_of_surface(&row, gradients, normals, offset_depths, flags, central);
                    if let Some((normal, depth, length)) = found {
                        (*plane, *agreement) = ((normal, depth), length);
                    }
                }
            },
        );
        copy_images(planes, fluid, fields.copies);
        for ((normal, _), mirror) in planes[fluid..].iter_mut().zip(fields.mirrors) {
            normal.component_mul_assign(&SVector::from(*mirror));
        }
    }

    fn measure_curvature(&mut self, fields: &FluidFields<'_, D>, volumes: &[f64], fluid: usize) {
        let Self {
            kernel,
            buffers,
            gradients,
            flags,
            normals,
            colour_depths,
            raw_curvatures,
            curvatures,
            ..
        } = self;
        let raw = raw_curvatures[..fluid].par_iter_mut().enumerate();
        raw.for_each_init(
            || buffers.take(),
            |buffer, (i, kappa)| {
                *kappa = 0.0;
                if flags[i] {
                    let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                    let largest = volumes[i].powf(-1.0 / D as f64);
                    *kappa = curvature(&row, volumes, gradients, normals, colour_depths, flags, largest);
                }
            },
        );
        copy_images(raw_curvatures, fluid, fields.copies);
        let central = kernel.value(0.0);
        let smoothed = curvatures[..fluid].par_iter_mut().enumerate();
        smoothed.for_each_init(
            || buffers.take(),
            |buffer, (i, kappa)| {
                *kappa = 0.0;
                if near_band(fields, flags, i) {
                    let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                    let mean = smoothed_curvature(&row, volumes, gradients, raw_curvatures, flags, central);
                    *kappa = mean.unwrap_or(0.0);
                }
            },
        );
        copy_images(curvatures, fluid, fields.copies);
    }
}

/// Whether a particle or one of its list belongs to the band.
fn near_band<const D: usize>(fields: &FluidFields<'_, D>, flags: &[bool], i: usize) -> bool {
    flags[i] || fields.neighbors(i).iter().any(|&j| flags[j as usize])
}

/// sum_b W (x_b - x_a)/(W(0) + sum_b W) \[m\].
fn centroid<const D: usize>(row: &Row<'_, D>, central_value: f64) -> SVector<f64, D> {
    let (mut total, mut sum) = (central_value, SVector::zeros());
    for (separation, &value) in row.separations.iter().zip(row.values) {
        total += value;
        sum -= separation * value;
    }
    sum / total
}
