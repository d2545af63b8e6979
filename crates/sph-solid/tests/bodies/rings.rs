//! Rubber rings that collide (Gray, Monaghan and Swift 2001), in the paper's form.

use crate::scene::lattice;
use crate::updated_scene::UpdatedScene;
use nalgebra::Vector2;
use sph_kernel::KernelKind;
use sph_solid::{IsotropicModuli, Material, UpdatedControls};

/// Two rubber rings (Gray, Monaghan and Swift 2001), 6 particles over the wall, each at 0.059 c, for `time` \[s\]: number of
/// pieces, momentum left over its scale, and speed away over speed towards.
pub fn rings(artificial_stress: f64, time: f64) -> (usize, f64, f64) {
    let spacing = 0.01 / 6.0;
    let kernel = KernelKind::Gaussian.with_smoothing_length(1.2 * spacing);
    let controls = UpdatedControls { artificial_stress, ..UpdatedControls::paper(kernel, spacing) };
    let moduli = IsotropicModuli::from_young_and_poisson(1e7, 0.4).unwrap();
    let material = Material::elastic(moduli, 1200.0).unwrap();
    let ring = lattice([-24.0 * spacing; 2], [48, 48], spacing);
    let ring = ring.into_iter().filter(|x| (18.0..24.0).contains(&(x.norm() / spacing)));
    let shift = Vector2::new(25.5 * spacing, 0.0);
    let positions: Vec<_> = ring.flat_map(|x| [x - shift, x + shift]).collect();
    let mut scene = UpdatedScene::new(positions, material, controls);
    let speed = 0.059 * (moduli.bulk_pa() / 1200.0).sqrt();
    for (position, velocity) in scene.positions.iter().zip(&mut scene.velocities) {
        *velocity = Vector2::new(-speed * position.x.signum(), 0.0);
    }
    let right: Vec<usize> = (0..scene.positions.len()).filter(|&i| scene.positions[i].x > 0.0).collect();
    let dt = scene.stable_step(0.4);
    scene.run((time / dt) as usize, dt);
    let momentum: Vector2<f64> = (0..scene.masses.len()).map(|i| scene.velocities[i] * scene.masses[i]).sum();
    let scale = speed * scene.masses.iter().sum::<f64>();
    let away: f64 = right.iter().map(|&i| scene.velocities[i].x).sum::<f64>() / right.len() as f64;
    (scene.pieces(1.7 * spacing), momentum.norm() / scale, away / speed)
}
