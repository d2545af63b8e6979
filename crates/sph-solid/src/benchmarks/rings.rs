//! Rubber rings that collide (Gray, Monaghan and Swift 2001), in the paper's form.

use super::shapes::centred;
use crate::{Error, FindNeighbors, IsotropicModuli, Material, UpdatedControls, UpdatedPatch};
use nalgebra::Vector2;
use sph_kernel::KernelKind;

/// Thickness of the walls \[m\]; radii are 3 and 4 times it.
const WALL: f64 = 0.01;

/// Density \[kg/m^3\].
const DENSITY: f64 = 1200.0;

/// How long they are watched \[s\].
const END: f64 = 0.014;

/// What two rings are made of, and how they meet.
#[derive(Clone, Copy, Debug)]
pub struct Rings {
    /// Particles over the wall.
    pub cells: usize,
    /// Poisson's ratio \[-\].
    pub poisson: f64,
    /// Speed of each over sqrt(K/rho) \[-\].
    pub speed: f64,
    /// Artificial stress epsilon \[-\].
    pub artificial_stress: f64,
}

/// How they part.
#[derive(Debug)]
pub struct Parting {
    /// Number of pieces, particles nearer than 1.7 spacings hanging together; 2 is whole.
    pub pieces: usize,
    /// Momentum over that of one ring at the start.
    pub momentum: f64,
    /// Mean speed away over speed towards.
    pub rebound: f64,
    /// The rings.
    pub patch: UpdatedPatch<2>,
}

/// Radii 0.03 and 0.04 m, E = 1e7 Pa, 1200 kg/m^3, until 14 ms: rings at 0.06 c0 have parted by then.
///
/// # Errors
/// [`Error`] of the body.
pub fn collide(rings: &Rings, find: FindNeighbors<2>) -> Result<Parting, Error> {
    let spacing = WALL / rings.cells as f64;
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
    let artificial_stress = rings.artificial_stress;
    let controls = UpdatedControls { artificial_stress, ..UpdatedControls::paper(kernel, spacing) };
    let moduli = IsotropicModuli::from_young_and_poisson(1e7, rings.poisson)?;
    let ring = centred([8 * rings.cells; 2], spacing);
    let ring = ring.into_iter().filter(|x| (3.0 * WALL..4.0 * WALL).contains(&x.norm()));
    let shift = Vector2::new(4.0 * WALL + 1.5 * spacing, 0.0);
    let positions = ring.flat_map(|x| [x - shift, x + shift]).collect();
    let mut patch = UpdatedPatch::new(positions, Material::elastic(moduli, DENSITY)?, controls, find)?;
    let speed = rings.speed * (moduli.bulk_pa() / DENSITY).sqrt();
    for (position, velocity) in patch.positions.iter().zip(&mut patch.velocities) {
        velocity.x = -speed * position.x.signum();
    }
    let right: Vec<usize> = (0..patch.positions.len()).filter(|&i| patch.positions[i].x > 0.0).collect();
    let dt = patch.stable_step(0.4);
    patch.run((END / dt) as usize, dt);
    let momentum: Vector2<f64> =
        patch.masses().iter().zip(&patch.velocities).map(|(mass, velocity)| velocity * *mass).sum();
    let scale = speed * right.iter().map(|&i| patch.masses()[i]).sum::<f64>();
    let away: f64 = right.iter().map(|&i| patch.velocities[i].x).sum::<f64>() / right.len() as f64;
    let (pieces, momentum) = (patch.pieces(1.7 * spacing), momentum.norm() / scale);
    Ok(Parting { pieces, momentum, rebound: away / speed, patch })
}
