//! The pass over the surface: tension and what its change with temperature does.

use super::{FluidFields, FluidSweep};
use crate::{
    PLAIN_SHARE, SurfaceModel, conjugate_colour_gradient, leading_part, marangoni_force, surface_stress,
    surface_stress_force, tension_force,
};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use sph_kernel::Row;
use sph_kernel::operators::{gradient, moment, regularised_inverse};

impl<const D: usize> FluidSweep<D> {
    /// Third pass, over the surface only: tension and Marangoni force.
    pub(super) fn add_surface_forces(
        &mut self,
        fields: &FluidFields<'_, D>,
        densities: &[f64],
        accelerations: &mut [SVector<f64, D>],
    ) {
        if self.controls.surface_tension.is_none() || self.surface.is_none() {
            return;
        }
        self.measure_surface_stresses(accelerations.len() + fields.copies.len());
        let [mut tension, mut marangoni] = [&mut self.tension, &mut self.marangoni].map(std::mem::take);
        tension.resize(accelerations.len(), SVector::zeros());
        marangoni.resize(accelerations.len(), SVector::zeros());
        let this = &*self;
        let kernel = &this.controls.kernel;
        let written = (accelerations, &mut tension, &mut marangoni).into_par_iter().enumerate();
        written.for_each_init(
            || this.buffers.take(),
            |buffer, (i, (sum, tension, marangoni))| {
                (*tension, *marangoni) = (SVector::zeros(), SVector::zeros());
                if !this.feels_surface(fields, i) {
                    return;
                }
                let row = buffer.fill(i, fields.neighbors(i), fields.positions, kernel);
                let [pull, driving] = this.surface_forces(&row);
                (*tension, *marangoni) = (pull / densities[i], driving);
                *sum += *tension + driving / densities[i];
            },
        );
        (self.tension, self.marangoni) = (tension, marangoni);
    }

    /// Stresses of the surface of fluid and copies, where tension acts as one.
    fn measure_surface_stresses(&mut self, mobile: usize) {
        let Self { controls, surface, corrections, surface_stresses, tensions, .. } = self;
        let Some((tension, surface)) = controls.surface_tension.zip(surface.as_ref()) else { return };
        if controls.surface_model == SurfaceModel::Force {
            return;
        }
        surface_stresses.clear();
        surface_stresses.extend((0..mobile).map(|i| {
            let (normal, depth) = &surface.planes()[i];
            if *depth >= surface.profile().support() {
                return SMatrix::zeros();
            }
            let tau = tensions.get(i).copied().unwrap_or(tension.reference()).max(0.0);
            let stress = surface_stress(tau, surface.profile().weight(depth.max(0.0)), normal);
            match corrections.get(i) {
                Some(correction) => stress * correction,
                None => stress * PLAIN_SHARE,
            }
        }));
    }

    /// Whether tension or its change with temperature may act on a particle.
    fn feels_surface(&self, fields: &FluidFields<'_, D>, i: usize) -> bool {
        match self.controls.surface_model {
            SurfaceModel::Force => self.surface_forces_on(i) != [false; 2],
            SurfaceModel::Stress => self.surface.as_ref().is_some_and(|surface| {
                let near = |i: usize| surface.planes()[i].1 < surface.profile().support();
                near(i) || fields.neighbors(i).iter().any(|&j| near(j as usize))
            }),
        }
    }

    /// Whether the force of tension pulls at a particle, and whether that of its change with temperature does.
    fn surface_forces_on(&self, i: usize) -> [bool; 2] {
        let Some(surface) = self.surface.as_ref().filter(|_| self.controls.surface_tension.is_some()) else {
            return [false; 2];
        };
        let driven = !self.tensions.is_empty() && surface.planes()[i].1 < surface.profile().support();
        [surface.curvatures()[i] != 0.0, driven]
    }

    /// Forces on a particle by tension and by its change with temperature \[N/m^3; N/m^2 in 2-D\]; a stress does both at once, as the
    /// first.
    fn surface_forces(&self, row: &Row<'_, D>) -> [SVector<f64, D>; 2] {
        match self.controls.surface_model {
            SurfaceModel::Force => self.forces_of_curvature(row),
            SurfaceModel::Stress if self.surface_stresses.is_empty() => [SVector::zeros(); 2],
            SurfaceModel::Stress => {
                let fluid_row = leading_part(row, self.surface_stresses.len());
                [surface_stress_force(&fluid_row, &self.volumes, &self.surface_stresses), SVector::zeros()]
            }
        }
    }

    fn forces_of_curvature(&self, row: &Row<'_, D>) -> [SVector<f64, D>; 2] {
        let (i, mut found) = (row.index, [SVector::zeros(); 2]);
        let Some((tension, surface)) = self.controls.surface_tension.zip(self.surface.as_ref()) else {
            return found;
        };
        let (volumes, profile, corrections) = (&self.volumes, surface.profile(), &self.corrections);
        let [pulled, driven] = self.surface_forces_on(i);
        if pulled {
            let tau = self.tensions.get(i).copied().unwrap_or(tension.reference()).max(0.0);
            let inwards = if corrections.is_empty() {
                surface.gradients()[i]
            } else {
                conjugate_colour_gradient(row, volumes, corrections)
            };
            found[0] = tension_force(tau, surface.curvatures()[i], &inwards);
        }
        if driven {
            let (normal, depth) = &surface.planes()[i];
            let own = corrections.get(i).copied();
            let inverse = own.unwrap_or_else(|| regularised_inverse(&moment(row, volumes)));
            let slope = gradient(row, volumes, &self.tensions, &inverse);
            let weight = profile.weight(depth.max(0.0));
            found[1] = marangoni_force(weight, normal, &slope);
        }
        found
    }
}
