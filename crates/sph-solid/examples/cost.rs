//! Particle-steps a second of the total-Lagrangian form in 3-D: `cost [CELLS] [H/DX] [STEPS]`.
//!
//! A cube of CELLS^3 particles in Morton order rings after a small kick. Threads as RAYON_NUM_THREADS says.

use nalgebra::SVector;
use sph_kernel::{Kernel, KernelKind};
use sph_neighbors::{PairReach, SearchMethod, spatial_order};
use sph_solid::{
    Controls, Inelastic, IsotropicModuli, Material, Motion, ReferenceColumns, SymmetricTensor,
    TotalLagrangian,
};
use std::time::Instant;

const SPACING: f64 = 1e-3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let argument = |k: usize| std::env::args().nth(k);
    let cells: usize = argument(1).map_or(Ok(46), |text| text.parse())?;
    let ratio: f64 = argument(2).map_or(Ok(0.8), |text| text.parse())?;
    let steps: u32 = argument(3).map_or(Ok(10), |text| text.parse())?;
    let lattice = |k: usize| {
        SVector::from([k % cells, k / cells % cells, k / cells / cells].map(|c| c as f64 * SPACING))
    };
    let mut positions: Vec<SVector<f64, 3>> = (0..cells.pow(3)).map(lattice).collect();
    let order = spatial_order(&positions, SPACING)?;
    order.apply(&mut positions);
    let particles = positions.len();
    let reach = Kernel::<3>::support_radius(KernelKind::Gaussian, ratio * SPACING);
    let list = SearchMethod::default().find(&positions, PairReach::Uniform(reach * (1.0 + 1e-9)))?;
    let columns = ReferenceColumns {
        positions: &positions,
        volumes: &vec![SPACING.powi(3); particles],
        masses: &vec![2700.0 * SPACING.powi(3); particles],
        temperatures: &vec![293.0; particles],
        smoothing_lengths: &vec![ratio * SPACING; particles],
        list_starts: list.starts(),
        list_neighbors: list.indices(),
    };
    let moduli = IsotropicModuli::from_young_and_poisson(70e9, 0.33)?;
    let material = Material::elastic(moduli, 2700.0)?;
    let mut body = TotalLagrangian::new(&columns, KernelKind::Gaussian, material, Controls::default())?;
    let temperatures = vec![293.0; particles];
    let mut displacements = vec![SVector::zeros(); particles];
    let mut velocities: Vec<_> =
        positions.iter().map(|x| SVector::from([0.1 * (300.0 * x.y).sin(), 0.0, 0.0])).collect();
    let mut accelerations = vec![SVector::zeros(); particles];
    let (mut strains, mut equivalents) = (vec![SymmetricTensor::zero(); particles], vec![0.0; particles]);
    let dt = body.stable_step(0.6);
    let start = Instant::now();
    for _ in 0..steps {
        for i in 0..particles {
            velocities[i] += accelerations[i] * dt;
            displacements[i] += velocities[i] * dt;
        }
        let motion = Motion { displacements: &displacements, velocities: &[], temperatures: &temperatures };
        let mut inelastic = Inelastic { strains: &mut strains, equivalents: &mut equivalents };
        body.accelerations(&motion, &mut inelastic, &mut accelerations);
    }
    let seconds = start.elapsed().as_secs_f64();
    let rate = f64::from(steps) * particles as f64 / seconds;
    let neighbors = list.pairs() as f64 / particles as f64;
    let kept = body.stored_pairs() as f64 / (0.5 * list.pairs() as f64);
    println!(
        "{particles} particles, {neighbors:.1} neighbours, {kept:.2} of half the list stored: {:.2} million particle-steps a second, {:.0} million directed pairs a second",
        1e-6 * rate,
        2e-6 * rate * neighbors
    );
    Ok(())
}
