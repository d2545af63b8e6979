//! Rubber rings that collide (Gray, Monaghan and Swift 2001), in the total-Lagrangian and in the paper's form.

use super::shapes::centred;
use crate::{
    Error, FindNeighbors, IsotropicModuli, Material, SolidPatch, SolidStart, UpdatedControls, UpdatedPatch,
};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

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
pub fn collide(rings: &Rings, find: FindNeighbors<2>) -> Result<Parting<SolidPatch<2>>, Error> {
    let (material, speed) = rings.rubber()?;
    let mut patch = SolidPatch::new(SolidStart::new(rings.positions(), rings.spacing(), material), find)?;
    patch.let_meet(find);
    patch.set_velocities(|x| Vector2::new(-speed * x.x.signum(), 0.0));
    let (dt, start) = (patch.body().stable_step(0.4), patch.ledger().balance());
    patch.run((END / dt) as usize, dt);
    let (momentum, rebound) = momentum_and_rebound(&patch.velocities, speed);
    let lost = 1.0 - patch.ledger().balance() / start;
    Ok(Parting { pieces: patch.pieces(LINK * rings.spacing(), find), momentum, rebound, lost, patch })
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
    Ok(Parting { pieces: patch.pieces(LINK * rings.spacing()), momentum, rebound, lost, patch })
}
