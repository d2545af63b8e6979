//! A cube of aluminium at rest with one corner molten: heat spreads, the corner freezes, no energy is lost.
//!
//! Everything is done by hand here, from positions to temperatures: images at the faces, neighbours by brute force, fitted
//! pair weights, the fast matrix, the enthalpy curve, forward Euler. `cargo run -p sph-thermal --example hot_corner`

use nalgebra::Vector3;
use sph_kernel::{Kernel, KernelKind};
use sph_thermal::Error;
use sph_thermal::conduction::{ConductionMatrix, ConductionRows, Images, LANES, PairTable, Planes};
use sph_thermal::phase::{EnthalpyCurve, Table, ThermalMaterial};

/// Particles along an edge, their spacing \[m\], and how far each is shifted from its lattice point, in spacings.
const SIDE: usize = 12;
const SPACING: f64 = 50e-6;
const DISORDER: f64 = 0.1;

/// Smoothing length over spacing: fitted weights hold disorder with 27 neighbours.
const RATIO: f64 = 1.0;

/// End of the run \[s\].
const END: f64 = 2e-3;

fn main() -> Result<(), Error> {
    let material = aluminium()?;
    let curve = EnthalpyCurve::continuous(&material)?;
    let positions = positions();
    let volume = vec![SPACING.powi(3); positions.len()];
    let mass: Vec<f64> = volume.iter().map(|volume| material.density * volume).collect();

    let rows = conduction_rows(&positions, &volume)?;
    let matrix = ConductionMatrix::new(&rows);
    let step = 0.9 * 2.0 / (curve.largest_potential_slope() * rows.gershgorin_bound(&mass, |_, _| 1.0));

    let hot = |p: &Vector3<f64>| p.max() < 4.0 * SPACING;
    let start = |p| curve.enthalpy_at(if hot(p) { 2000.0 } else { 293.0 });
    let mut enthalpy: Vec<f64> = positions.iter().map(start).collect();
    let energy = |enthalpy: &[f64]| enthalpy.iter().zip(&mass).map(|(h, m)| h * m).sum::<f64>();
    let before = energy(&enthalpy);

    println!("{} particles, {} pairs, step {:.2e} s", rows.particles(), rows.pairs(), step);
    println!("  time ms   hottest K   coldest K   molten mm3   energy change");
    let steps = (END / step).ceil() as usize;
    for number in 0..=steps {
        if number % (steps / 8) == 0 {
            let temperature = |h: &f64| curve.temperature(*h);
            let hottest = enthalpy.iter().map(temperature).fold(0.0, f64::max);
            let coldest = enthalpy.iter().map(temperature).fold(f64::INFINITY, f64::min);
            let molten: f64 = enthalpy.iter().zip(&volume).map(|(h, v)| curve.liquid_fraction(*h) * v).sum();
            let change = energy(&enthalpy) / before - 1.0;
            let time = number as f64 * step;
            println!("{:9.3} {hottest:11.1} {coldest:11.1} {:12.5} {change:15.1e}", 1e3 * time, 1e9 * molten);
        }
        conduct(&matrix, &curve, &mass, step, &mut enthalpy);
    }
    let change = energy(&enthalpy) / before - 1.0;
    assert!(change.abs() < 1e-12, "the energy balance is open by {change:.1e}");
    Ok(())
}

// ANCHOR: step
/// One step of forward Euler: dh_i/dt = (1/m_i) sum_j g_ij (theta_j - theta_i).
fn conduct(matrix: &ConductionMatrix, curve: &EnthalpyCurve, mass: &[f64], step: f64, enthalpy: &mut [f64]) {
    let mut potential: Vec<f64> = enthalpy.iter().map(|h| curve.potential(*h)).collect();
    potential.resize(matrix.padded_len(), 0.0);
    for chunk in 0..matrix.chunks() {
        let heat = matrix.chunk_heat(chunk, &potential);
        for (i, heat) in (chunk * LANES..enthalpy.len()).zip(heat) {
            enthalpy[i] += step * heat / mass[i];
        }
    }
}
// ANCHOR_END: step

// ANCHOR: rows
/// Fitted conduction weights of a cube whose faces are all adiabatic.
fn conduction_rows(positions: &[Vector3<f64>], volume: &[f64]) -> Result<ConductionRows, Error> {
    let support = Kernel::<3>::support_radius(KernelKind::WendlandC2, RATIO * SPACING);
    let cube = Planes::adiabatic_box([0.0; 3], [SIDE as f64 * SPACING; 3]);
    let images = Images::new(positions, &vec![2.0 * support; positions.len()], &cube);

    // Neighbours by brute force: particles first, images after them.
    let everything: Vec<_> = positions.iter().chain(&images.position).copied().collect();
    let near = |i: usize| {
        let within = |&j: &u32| j as usize != i && (positions[i] - everything[j as usize]).norm() < support;
        (0..everything.len() as u32).filter(within).collect()
    };
    let neighbors: Vec<Vec<u32>> = (0..positions.len()).map(near).collect();

    let factor = |_, _, r| Kernel::<3>::gradient_factor(KernelKind::WendlandC2, r, RATIO * SPACING);
    let pairs = PairTable::new(positions, volume, &images, |i| &neighbors[i], factor)?;
    let (rows, fit) = pairs.fitted(1e-6)?;
    println!(
        "fit: {} iterations, {:.1} % of the weights negative",
        fit.iterations,
        100.0 * fit.negative_share
    );
    Ok(rows)
}
// ANCHOR_END: rows

/// A cubic lattice, each particle shifted by up to [`DISORDER`] spacings along each axis.
fn positions() -> Vec<Vector3<f64>> {
    let noise = |n: usize| ((n as f64 * 12.9898).sin() * 43758.5453).rem_euclid(2.0) - 1.0;
    let at = |n: usize| {
        let cell = Vector3::new(n % SIDE, n / SIDE % SIDE, n / SIDE / SIDE).map(|i| i as f64 + 0.5);
        SPACING * (cell + DISORDER * Vector3::new(noise(3 * n), noise(3 * n + 1), noise(3 * n + 2)))
    };
    (0..SIDE.pow(3)).map(at).collect()
}

/// The constants of this project's reference solutions, near those of an aluminium alloy.
fn aluminium() -> Result<ThermalMaterial, Error> {
    Ok(ThermalMaterial {
        density: 2500.0,
        solidus: 847.0,
        liquidus: 905.0,
        latent_heat: 3.97e5,
        heat_capacity_solid: Table::constant(1050.0)?,
        heat_capacity_liquid: Table::constant(1180.0)?,
        conductivity_solid: Table::constant(200.0)?,
        conductivity_liquid: Table::constant(95.0)?,
    })
}
