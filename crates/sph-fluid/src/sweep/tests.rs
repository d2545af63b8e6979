//! Tests of the sweep on a free block.

use super::*;
use crate::test_block::Block;
use crate::{SurfaceTension, Tait, ThermalExpansion};

/// A list of all pairs among so many particles.
fn all_pairs(particles: usize) -> (Vec<usize>, Vec<u32>) {
    let starts = (0..=particles).map(|i| i * (particles - 1)).collect();
    let others = |i: usize| (0..particles as u32).filter(move |&j| j as usize != i);
    (starts, (0..particles).flat_map(others).collect())
}

fn controls() -> FluidControls<2> {
    FluidControls {
        dynamic_viscosity: 0.5,
        artificial_viscosity: 0.1,
        density_diffusion: 0.1,
        ..FluidControls::new(Block::kernel(), Tait::new(2.0, 20.0, 7.0).unwrap())
    }
}

/// Densities and accelerations of a disordered block after an evaluation and a step of `dt_s`.
fn evaluated(block: &Block<2>, controls: FluidControls<2>, dt_s: f64) -> (Vec<f64>, Vec<SVector<f64, 2>>) {
    let (starts, neighbors) = all_pairs(block.positions.len());
    let fields = FluidFields {
        positions: &block.positions,
        velocities: &block.velocities,
        masses: &block.masses,
        list_starts: &starts,
        list_neighbors: &neighbors,
        ..FluidFields::default()
    };
    let mut densities = block.densities.clone();
    let mut accelerations = vec![SVector::zeros(); densities.len()];
    let mut sweep = FluidSweep::new(controls).unwrap();
    sweep.accelerations(&fields, &mut densities, 0.0, &mut accelerations);
    assert_eq!(densities, block.densities);
    sweep.accelerations(&fields, &mut densities, dt_s, &mut accelerations);
    (densities, accelerations)
}

#[test]
fn a_free_block_keeps_its_momentum() {
    let block = Block::<2>::new(7, 0.2);
    let (_, accelerations) = evaluated(&block, controls(), 1e-3);
    assert!(block.relative_momentum(&accelerations) < 1e-15);
    assert!(accelerations.iter().any(|found| found.norm() > 1.0));
}

#[test]
fn the_slope_of_pressure_holds_a_weight_in_any_disorder_and_pairs_do_not() {
    let mut block = Block::<2>::new(9, 0.2);
    let weight = SVector::from([0.0, -9.0]);
    let state = controls().state;
    block.densities = block.positions.iter().map(|r| state.density(200.0 - 9.0 * 2.0 * r.y)).collect();
    // What is left of the weight, with the density that pressure gives: the middle of the block, which sees no face.
    let left = |pressure| {
        let controls = FluidControls { pressure, corrected_gradients: true, ..controls() };
        let controls = FluidControls { dynamic_viscosity: 0.0, artificial_viscosity: 0.0, ..controls };
        let (_, accelerations) = evaluated(&block, controls, 0.0);
        let middle = Block::<2>::middle(9);
        (accelerations[middle] * block.densities[middle] / 2.0 + weight).norm()
    };
    assert!(left(PressureForce::Slope) < 1e-9, "{}", left(PressureForce::Slope));
    assert!(left(PressureForce::Pairs) > 1.0, "{}", left(PressureForce::Pairs));
}

#[test]
fn a_tension_that_pulls_is_refused_with_the_slope_of_pressure() {
    let slope = FluidControls { pressure: PressureForce::Slope, ..controls() };
    let tense = |tension| Some(SurfaceTension::new(tension, -0.1, 0.0).unwrap());
    assert!(FluidSweep::new(FluidControls { surface_tension: tense(0.0), ..slope }).is_ok());
    let refused = FluidSweep::new(FluidControls { surface_tension: tense(0.7), ..slope }).unwrap_err();
    assert!(refused.to_string().contains("slope"), "{refused}");
}

#[test]
fn density_advances_before_forces_by_continuity_and_diffusion() {
    let block = Block::<2>::new(7, 0.2);
    let without = FluidControls { density_diffusion: 0.0, ..controls() };
    let (plain, _) = evaluated(&block, without, 1e-3);
    let rates = block.map_rows(|row| density_rate(row, &block.fields()));
    for i in 0..plain.len() {
        assert!((plain[i] - block.densities[i] - 1e-3 * rates[i]).abs() < 1e-14);
    }
    // The forces are those of the new density: the same as of a block that starts with it.
    let later = Block { densities: plain, ..Block::new(7, 0.2) };
    let (_, expected) = evaluated(&later, without, 0.0);
    assert_eq!(evaluated(&block, without, 1e-3).1, expected);
    // Diffusion takes noise away.
    let resting = Block { velocities: vec![SVector::zeros(); 49], ..Block::new(7, 0.2) };
    let noise = |densities: &[f64]| densities.iter().map(|density| (density - 2.0).powi(2)).sum::<f64>();
    let (smoothed, _) = evaluated(&resting, controls(), 1e-3);
    assert!(noise(&smoothed) < 0.999 * noise(&resting.densities));
}

#[test]
fn results_are_the_same_on_one_and_two_threads() {
    let block = Block::<2>::new(9, 0.2);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| evaluated(&block, controls(), 1e-3))
    };
    assert_eq!(on(1), on(2));
}

#[test]
fn bad_controls_are_named() {
    let message = |controls| FluidSweep::new(controls).map(|_| ()).unwrap_err().to_string();
    let negative = FluidControls { dynamic_viscosity: -1.0, ..controls() };
    assert_eq!(message(negative), "dynamic_viscosity is -1, but must be zero or above");
    let falling = FluidControls { body_acceleration: SVector::from([0.0, f64::NAN]), ..controls() };
    assert!(message(falling).starts_with("body_acceleration is NaN"));
}

/// A lattice with the density that warmth gives it has no pressure, diffuses nothing and stays where it is; with that of the reference
/// temperature it bursts.
#[test]
fn warm_fluid_of_its_own_density_has_no_pressure() {
    let block = Block::<2>::lattice(6, |_| SVector::zeros());
    let (starts, neighbors) = all_pairs(block.positions.len());
    let expansion = ThermalExpansion::new(0.01, 300.0).unwrap();
    let temperatures: Vec<f64> = block.positions.iter().map(|r| 300.0 + 2.0 * r.x * r.x - r.y).collect();
    let masses: Vec<f64> = temperatures.iter().map(|&warmth| 2.0 / expansion.stretch(warmth)).collect();
    let fields = FluidFields {
        positions: &block.positions,
        velocities: &block.velocities,
        masses: &masses,
        temperatures: &temperatures,
        list_starts: &starts,
        list_neighbors: &neighbors,
        ..FluidFields::default()
    };
    let controls = FluidControls { thermal_expansion: Some(expansion), ..controls() };
    let mut accelerations = vec![SVector::zeros(); masses.len()];
    let mut densities = masses.clone();
    let mut sweep = FluidSweep::new(controls).unwrap();
    sweep.accelerations(&fields, &mut densities, 0.0, &mut accelerations);
    sweep.accelerations(&fields, &mut densities, 1e-3, &mut accelerations);
    assert!(accelerations.iter().all(|a: &SVector<f64, 2>| a.norm() < 1e-10), "{accelerations:?}");
    assert!(densities.iter().zip(&masses).all(|(now, then)| (now - then).abs() < 1e-12));
    // As dense as at 300 K, the hottest corner presses with more than rho c^2 beta dT, by the power of seven.
    let mut dense = vec![2.0; masses.len()];
    sweep.accelerations(&fields, &mut dense, 0.0, &mut accelerations);
    let hottest = temperatures.iter().zip(sweep.pressures()).max_by(|a, b| a.0.total_cmp(b.0)).unwrap();
    assert!(*hottest.1 > 2.0 * 20.0 * 20.0 * 0.01 * (hottest.0 - 300.0), "{hottest:?}");
}

/// Columns of tension and viscosity that say what the constants say change nothing; others do.
#[test]
fn columns_of_the_controls_own_tension_and_viscosity_change_nothing() {
    let block = Block::<2>::new(7, 0.2);
    let (starts, neighbors) = all_pairs(block.positions.len());
    let temperatures: Vec<f64> = block.positions.iter().map(|r| 900.0 + 30.0 * r.x).collect();
    let tension = SurfaceTension::new(0.9, -1e-3, 900.0).unwrap();
    let controls = FluidControls { surface_tension: Some(tension), ..controls() };
    let found = |tensions: &[f64], viscosities: &[f64]| {
        let fields = FluidFields {
            positions: &block.positions,
            velocities: &block.velocities,
            masses: &block.masses,
            temperatures: &temperatures,
            tensions,
            viscosities,
            list_starts: &starts,
            list_neighbors: &neighbors,
            ..FluidFields::default()
        };
        let mut accelerations = vec![SVector::zeros(); temperatures.len()];
        let mut sweep = FluidSweep::new(controls).unwrap();
        sweep.accelerations(&fields, &mut block.densities.clone(), 0.0, &mut accelerations);
        accelerations
    };
    let own: Vec<f64> = temperatures.iter().map(|&temperature| tension.at(temperature)).collect();
    let (even, plain) = (vec![0.9; own.len()], found(&[], &[]));
    assert_eq!(found(&own, &[]), plain);
    assert_eq!(found(&own, &vec![0.5; own.len()]), plain);
    assert_ne!(found(&even, &[]), plain);
    assert_ne!(found(&own, &vec![0.4; own.len()]), plain);
}
