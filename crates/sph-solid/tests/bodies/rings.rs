//! Rubber rings that collide (Gray, Monaghan and Swift 2001), in the paper's form.

use crate::scene::lattice;
use crate::updated_scene::UpdatedScene;
use nalgebra::Vector2;
use sph_kernel::KernelKind;
use sph_solid::{IsotropicModuli, Material, UpdatedControls};

/// What two rings are made of, and how they meet.
pub struct Rings {
    /// Poisson's ratio.
    pub poisson: f64,
    /// Speed of each over sqrt(K/rho).
    pub speed: f64,
    /// Artificial stress epsilon.
    pub artificial_stress: f64,
}

/// How they part.
pub struct Outcome {
    /// Number of pieces, particles nearer than 1.7 spacings hanging together; 2 is whole.
    pub pieces: usize,
    /// Momentum over that of one ring at the start.
    pub momentum: f64,
    /// Mean speed away over speed towards.
    pub rebound: f64,
}

/// Radii 0.03 and 0.04 m, E = 1e7 Pa, 1200 kg/m^3, 6 particles over the wall; until 12 ms for slow soft rings.
pub fn collide(rings: &Rings) -> Outcome {
    let spacing = 0.01 / 6.0;
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
    let artificial_stress = rings.artificial_stress;
    let controls = UpdatedControls { artificial_stress, ..UpdatedControls::paper(kernel, spacing) };
    let moduli = IsotropicModuli::from_young_and_poisson(1e7, rings.poisson).unwrap();
    let material = Material::elastic(moduli, 1200.0).unwrap();
    let ring = lattice([-24.0 * spacing; 2], [48, 48], spacing);
    let ring = ring.into_iter().filter(|x| (18.0..24.0).contains(&(x.norm() / spacing)));
    let shift = Vector2::new(25.5 * spacing, 0.0);
    let mut scene =
        UpdatedScene::new(ring.flat_map(|x| [x - shift, x + shift]).collect(), material, controls);
    let speed = rings.speed * (moduli.bulk_pa() / 1200.0).sqrt();
    for (position, velocity) in scene.positions.iter().zip(&mut scene.velocities) {
        *velocity = Vector2::new(-speed * position.x.signum(), 0.0);
    }
    let right: Vec<usize> = (0..scene.positions.len()).filter(|&i| scene.positions[i].x > 0.0).collect();
    let dt = scene.stable_step(0.4);
    scene.run((0.012 / dt) as usize, dt);
    let momentum: Vector2<f64> = (0..scene.masses.len()).map(|i| scene.velocities[i] * scene.masses[i]).sum();
    let scale = speed * right.iter().map(|&i| scene.masses[i]).sum::<f64>();
    let away: f64 = right.iter().map(|&i| scene.velocities[i].x).sum::<f64>() / right.len() as f64;
    let pieces = scene.pieces(1.7 * spacing);
    Outcome { pieces, momentum: momentum.norm() / scale, rebound: away / speed }
}
