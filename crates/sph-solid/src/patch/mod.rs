//! Bodies that are stepped by themselves: all columns of one body with the sweep that drives it.

mod drive;
mod meeting;
mod total;
mod updated;

pub use total::{MechanicalLedger, SolidPatch, SolidStart};
pub use updated::UpdatedPatch;

use nalgebra::SVector;

/// Neighbours of all positions \[m\] nearer than a reach \[m\]: where each row starts (one entry more than positions), and a full
/// list with ascending rows. `sph-neighbors` gives both.
pub type FindNeighbors<const D: usize> = fn(&[SVector<f64, D>], f64) -> (Vec<usize>, Vec<u32>);

/// Temperature at which patches start \[K\].
pub const START_TEMPERATURE: f64 = 293.0;

/// Adds what accelerations give in `dt` \[s\] to the velocities, where components are free.
fn kick<const D: usize>(
    velocities: &mut [SVector<f64, D>],
    accelerations: &[SVector<f64, D>],
    free: &[SVector<f64, D>],
    dt: f64,
) {
    for i in 0..velocities.len() {
        velocities[i] += accelerations[i].component_mul(&free[i]) * dt;
    }
}

/// Kinetic energy \[J; J/m in plane strain\].
fn kinetic_energy<const D: usize>(masses: &[f64], velocities: &[SVector<f64, D>]) -> f64 {
    masses.iter().zip(velocities).map(|(mass, velocity)| 0.5 * mass * velocity.norm_squared()).sum()
}

/// Number of pieces: positions nearer than `link` \[m\] hang together.
fn pieces<const D: usize>(positions: &[SVector<f64, D>], link: f64, find: FindNeighbors<D>) -> usize {
    let (starts, neighbors) = find(positions, link);
    let mut seen = vec![false; positions.len()];
    let mut pieces = 0;
    for start in 0..seen.len() {
        let mut open = if seen[start] { vec![] } else { vec![start] };
        pieces += usize::from(!seen[start]);
        while let Some(i) = open.pop() {
            if !std::mem::replace(&mut seen[i], true) {
                open.extend(neighbors[starts[i]..starts[i + 1]].iter().map(|&j| j as usize));
            }
        }
    }
    pieces
}
