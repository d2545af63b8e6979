//! The columns that a sweep reads, fluid, copies and walls behind each other.

use crate::Viscosity;
use nalgebra::SVector;

/// What the caller owns and the sweep reads. Order of all columns: fluid, copies of fluid, walls.
#[derive(Clone, Copy, Debug, Default)]
pub struct FluidFields<'a, const D: usize> {
    /// Positions at the end of the drift \[m\].
    pub positions: &'a [SVector<f64, D>],
    /// Velocities of the drift that led there \[m/s\]; walls and copies included.
    pub velocities: &'a [SVector<f64, D>],
    /// Masses \[kg; kg/m in 2-D\].
    pub masses: &'a [f64],
    /// Temperatures \[K\] of all particles; read only where tension or density change with temperature, and may be empty
    /// without.
    pub temperatures: &'a [f64],
    /// Dynamic viscosity eta \[Pa s\] of all particles, of a wall that of the fluid at its temperature; empty where that of the
    /// controls holds everywhere.
    pub viscosities: &'a [f64],
    /// Surface tension tau \[N/m\] at the temperatures of all particles; empty where the controls' law gives it.
    pub tensions: &'a [f64],
    /// Pressures of walls that have their own \[Pa\], of walls alone; empty where walls carry the pressure of the fluid.
    pub wall_pressures: &'a [f64],
    /// For each copy (image across a period or in a mirror plane) the fluid particle that it shows.
    pub copies: &'a [u32],
    /// For each copy the sign by which each component of a vector continues: -1 on mirrored axes. Empty where no copy is a
    /// mirror image.
    pub mirrors: &'a [[f64; D]],
    /// Where each particle's row starts in `list_neighbors`; one entry more than particles.
    pub list_starts: &'a [usize],
    /// A list with ascending rows; entries outside the support do no harm. Rows of fluid are full, those of walls hold fluid and copies at
    /// least, those of copies are not read.
    pub list_neighbors: &'a [u32],
}

impl<'a, const D: usize> FluidFields<'a, D> {
    /// The list of a particle.
    #[inline]
    pub(crate) fn neighbors(&self, i: usize) -> &'a [u32] {
        &self.list_neighbors[self.list_starts[i]..self.list_starts[i + 1]]
    }

    /// Viscosity of the particles; `even` \[Pa s\] where none has one of its own.
    pub(crate) fn viscosity(&self, even: f64) -> Viscosity<'a> {
        if self.viscosities.is_empty() { Viscosity::Even(even) } else { Viscosity::Each(self.viscosities) }
    }

    /// Gives each copy, stored behind the fluid, the vector of the particle that it shows, mirrored where the copy is.
    pub(crate) fn copy_vectors(&self, column: &mut [SVector<f64, D>], fluid: usize) {
        copy_images(column, fluid, self.copies);
        for (vector, mirror) in column[fluid..].iter_mut().zip(self.mirrors) {
            vector.component_mul_assign(&SVector::from(*mirror));
        }
    }
}

/// Gives each copy, stored behind the fluid, the value of the particle that it shows.
pub(crate) fn copy_images<T: Copy>(column: &mut [T], fluid: usize, copies: &[u32]) {
    for (k, &source) in copies.iter().enumerate() {
        column[fluid + k] = column[source as usize];
    }
}
