//! What the packed sweep reads and writes.

use nalgebra::SVector;

/// Everything that a pair reads of a particle, side by side in memory: 80 bytes in 3-D, two lines of cache.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedParticle<const D: usize> {
    /// Position r \[m\].
    pub position: SVector<f64, D>,
    /// Volume V = m/rho \[m^D\].
    pub volume: f64,
    /// Velocity v \[m/s\].
    pub velocity: SVector<f64, D>,
    /// Density rho \[kg/m^3\].
    pub density: f64,
    /// Pressure p \[Pa\].
    pub pressure: f64,
    /// Mass m \[kg; kg/m in 2-D\].
    pub mass: f64,
}

/// What a particle receives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedRates<const D: usize> {
    /// dv/dt \[m/s^2\].
    pub acceleration: SVector<f64, D>,
    /// d rho/dt \[kg/(m^3 s)\].
    pub density_rate: f64,
}

impl<const D: usize> PackedRates<D> {
    /// Nothing received.
    #[must_use]
    pub fn zero() -> Self {
        Self { acceleration: SVector::zeros(), density_rate: 0.0 }
    }
}

/// The rows of one block of consecutive particles: a pair of the block stands in one row only, a pair with any other
/// particle in the rows of both. `sph-neighbors` makes them (`BlockedPairs`).
#[derive(Clone, Copy, Debug)]
pub struct PackedRows<'a> {
    /// The first particle of the block; its others follow.
    pub first: usize,
    /// Where the three parts of each row start in `neighbors`: entry 3 k is the start of what the k-th particle of the
    /// block has within the block, 3 k + 1 of fluid elsewhere, 3 k + 2 of particles not owned: copies of fluid, then
    /// walls, by ascending index. One entry more ends the last row.
    pub starts: &'a [u32],
    /// All rows one after the other; entries outside the support do no harm.
    pub neighbors: &'a [u32],
}

/// What the sweep reads.
#[derive(Clone, Copy, Debug)]
pub struct PackedFields<'p, const D: usize, R> {
    /// Fluid in the order of the blocks, copies of fluid, then walls with the pressure that the fluid shall see
    /// ([`wall_state`](crate::wall_state)).
    pub particles: &'p [PackedParticle<D>],
    /// Velocities that friction sees of the walls \[m/s\], one each ([`wall_velocity`](crate::wall_velocity)).
    pub wall_velocities: &'p [SVector<f64, D>],
    /// Number of blocks.
    pub blocks: usize,
    /// Gives the rows of a block: `Fn(usize) -> PackedRows<'_> + Sync`.
    pub rows: R,
}

impl<'a> PackedRows<'a> {
    /// The three parts of a row.
    #[inline]
    pub(super) fn parts(&self, k: usize) -> [&'a [u32]; 3] {
        let bounds = &self.starts[3 * k..3 * k + 4];
        std::array::from_fn(|part| &self.neighbors[bounds[part] as usize..bounds[part + 1] as usize])
    }
}
