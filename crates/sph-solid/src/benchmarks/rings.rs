//! Rubber rings that collide (Gray, Monaghan and Swift 2001), in the total-Lagrangian and in the paper's form.

use super::largest;
use super::shapes::centred;
use crate::{
    Controls, Error, FindNeighbors, IsotropicModuli, Material, SolidPatch, SolidStart, UpdatedControls,
    UpdatedPatch,
};
use nalgebra::Vector2;
use sph_kernel::KernelKind;
use std::collections::HashMap;

/// Thickness of the walls \[m\]; radii are 3 and 4 times it.
const WALL: f64 = 0.01;

/// Density \[kg/m^3\].
const DENSITY: f64 = 1200.0;

/// How long they are watched \[s\].
const END: f64 = 0.014;

/// Particles nearer than this many spacings hang together.
const LINK: f64 = 1.7;

/// What two rings are made of, and how they meet: radii 0.03 and 0.04 m, E = 1e7 Pa, 1200 kg/m^3.
#[derive(Clone, Copy, Debug)]
pub struct Rings {
    /// Particles over the wall.
    pub cells: usize,
    /// Poisson's ratio \[-\].
    pub poisson: f64,
    /// Speed of each over sqrt(K/rho) \[-\].
    pub speed: f64,
}

/// How they have parted after 14 ms.
#[derive(Debug)]
pub struct Parting<Patch> {
    /// Number of pieces, particles nearer than 1.7 spacings hanging together; 2 is whole.
    pub pieces: usize,
    /// Momentum over that of one ring at the start.
    pub momentum: f64,
    /// Mean speed away over speed towards.
    pub rebound: f64,
    /// Largest displacement that changes its sign from neighbour to neighbour, in spacings: fourth difference of five particles
    /// in a row, over 16.
    pub zigzag: f64,
    /// Energy of motion and of strain that is not there any more, over that of the start: what artificial viscosity and the
    /// scheme itself took.
    pub lost: f64,
    /// The rings.
    pub patch: Patch,
}

impl Rings {
    fn spacing(&self) -> f64 {
        WALL / self.cells as f64
    }

    /// Rubber and the speed of each ring \[m/s\].
    fn rubber(&self) -> Result<(Material, f64), Error> {
        let moduli = IsotropicModuli::from_young_and_poisson(1e7, self.poisson)?;
        Ok((Material::elastic(moduli, DENSITY)?, self.speed * (moduli.bulk_pa() / DENSITY).sqrt()))
    }

    fn positions(&self) -> Vec<Vector2<f64>> {
        let ring = centred([8 * self.cells; 2], self.spacing());
        let ring = ring.into_iter().filter(|x| (3.0 * WALL..4.0 * WALL).contains(&x.norm()));
        let shift = Vector2::new(4.0 * WALL + 1.5 * self.spacing(), 0.0);
        ring.flat_map(|x| [x - shift, x + shift]).collect()
    }
}

/// Largest zigzag of `displacements` \[m\] along rows and columns of a lattice, in spacings: |u_-2 - 4 u_-1 + 6 u_0 - 4 u_1 + u_2|/16
/// of five particles in a row.
///
/// That is a of a displacement a (-1)^k that changes its sign from neighbour to neighbour. A smooth field has next to nothing
/// of it: (dx)^4/16 times its fourth derivative.
fn zigzag(positions: &[Vector2<f64>], displacements: &[Vector2<f64>], spacing: f64) -> f64 {
    let site = |x: &Vector2<f64>| [x.x, x.y].map(|place| (2.0 * place / spacing).round() as i64);
    let sites: HashMap<_, _> = positions.iter().map(site).zip(displacements).collect();
    let along = |[x, y]: [i64; 2], [right, up]: [i64; 2]| -> Option<f64> {
        // Places are counted in halves of a spacing.
        let at = |k: i64| sites.get(&[x + 2 * k * right, y + 2 * k * up]).copied();
        let outer = at(-2)? + at(2)?;
        let inner = at(-1)? + at(1)?;
        Some((outer - inner * 4.0 + at(0)? * 6.0).norm() / (16.0 * spacing))
    };
    let both = |at: [i64; 2]| [[1, 0], [0, 1]].into_iter().filter_map(move |axis| along(at, axis));
    largest(positions.iter().map(site).flat_map(both))
}

/// Momentum of all and mean speed along x of every second particle, the right ring, over those of one ring at the start.
fn momentum_and_rebound(velocities: &[Vector2<f64>], speed: f64) -> (f64, f64) {
    let half = velocities.len() as f64 / 2.0;
    let right: f64 = velocities.iter().skip(1).step_by(2).map(|velocity| velocity.x).sum();
    (velocities.iter().sum::<Vector2<f64>>().norm() / (half * speed), right / (half * speed))
}

/// In the total-Lagrangian form; faces push each other apart by contact.
///
/// # Errors
/// [`Error`] of the body.
pub fn collide(
    rings: &Rings,
    controls: Controls,
    find: FindNeighbors<2>,
) -> Result<Parting<SolidPatch<2>>, Error> {
    let (material, speed) = rings.rubber()?;
    let start = SolidStart { controls, ..SolidStart::new(rings.positions(), rings.spacing(), material) };
    let mut patch = SolidPatch::new(start, find)?;
    patch.let_meet(find);
    patch.set_velocities(|x| Vector2::new(-speed * x.x.signum(), 0.0));
    let (dt, start) = (patch.body().stable_step(0.4), patch.ledger().balance());
    patch.run((END / dt) as usize, dt);
    let (momentum, rebound) = momentum_and_rebound(&patch.velocities, speed);
    let lost = 1.0 - patch.ledger().balance() / start;
    let zigzag = zigzag(patch.positions(), &patch.displacements, rings.spacing());
    Ok(Parting { pieces: patch.pieces(LINK * rings.spacing(), find), momentum, rebound, zigzag, lost, patch })
}

/// In the paper's updated-Lagrangian form, with the artificial stress epsilon \[-\].
///
/// # Errors
/// [`Error`] of the body.
pub fn collide_updated(
    rings: &Rings,
    artificial_stress: f64,
    find: FindNeighbors<2>,
) -> Result<Parting<UpdatedPatch<2>>, Error> {
    let (material, speed) = rings.rubber()?;
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * rings.spacing());
    let controls = UpdatedControls { artificial_stress, ..UpdatedControls::paper(kernel, rings.spacing()) };
    let mut patch = UpdatedPatch::new(rings.positions(), material, controls, find)?;
    for (position, velocity) in patch.positions.iter().zip(&mut patch.velocities) {
        velocity.x = -speed * position.x.signum();
    }
    let (dt, start) = (patch.stable_step(0.4), patch.kinetic_energy());
    patch.run((END / dt) as usize, dt);
    let (momentum, rebound) = momentum_and_rebound(&patch.velocities, speed);
    let lost = 1.0 - (patch.kinetic_energy() + patch.elastic_energy()) / start;
    let displacements: Vec<_> =
        patch.positions.iter().zip(rings.positions()).map(|(x, start)| x - start).collect();
    let zigzag = zigzag(&rings.positions(), &displacements, rings.spacing());
    Ok(Parting { pieces: patch.pieces(LINK * rings.spacing()), momentum, rebound, zigzag, lost, patch })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zigzag_is_seen_and_a_bend_is_not() {
        let spacing = 1e-3;
        let positions = centred([8, 6], spacing);
        let of = |displacement: &dyn Fn(&Vector2<f64>) -> Vector2<f64>| {
            zigzag(&positions, &positions.iter().map(displacement).collect::<Vec<_>>(), spacing)
        };
        let bent =
            |x: &Vector2<f64>| Vector2::new(30.0 * x.x * x.y, 40.0 * x.x * x.x - 7e3 * x.y * x.x * x.x);
        assert!(of(&bent) < 1e-12);
        // Every second column is a tenth of a spacing higher, the others as much lower.
        let sign = |x: &Vector2<f64>| 1.0 - 2.0 * (x.x / spacing).floor().rem_euclid(2.0);
        let jagged = of(&|x| bent(x) + Vector2::new(0.0, 0.1 * spacing * sign(x)));
        assert!((jagged - 0.1).abs() < 1e-12, "{jagged}");
    }
}
