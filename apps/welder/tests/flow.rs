//! Heat and flow together, through the program's library: a pool that nothing drives, and pools that Marangoni's stress drives
//! outwards or inwards.

use nalgebra::Vector3;
use std::path::Path;
use welder::case::load;
use welder::model::Model;
use welder::physics::Column;
use welder::run::Simulation;

/// The card of the model aluminium whose melt expands.
fn expanding(coefficient_1_k: f64) -> String {
    let end = ")\n";
    let card = metal();
    let expansion =
        format!("    volume_expansion_liquid_1_k: (value: {coefficient_1_k:e}, source: \"test\"),\n)\n");
    card.strip_suffix(end).expect("a card ends with its bracket").to_string() + &expansion
}

/// A spot that melts a pool into a small block, with the given list of physics and change of tension with temperature.
fn spot(physics: &str, slope: &str) -> Simulation {
    spot_of(physics, slope, "50e-6", "1.2e-3")
}

/// The same with a spacing and an end \[s\].
fn spot_of(physics: &str, slope: &str, spacing: &str, end: &str) -> Simulation {
    spot_in(&metal().replace("-3.5e-4", slope), physics, spacing, end)
}

/// The card of the model aluminium.
fn metal() -> String {
    let card = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/materials/aluminium-model.ron");
    std::fs::read_to_string(Path::new(card)).unwrap()
}

/// The same of the material of a card.
fn spot_in(metal: &str, physics: &str, spacing: &str, end: &str) -> Simulation {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("metal.ron"), metal).unwrap();
    let scene = format!(
        "(part: (low_corner_m: (-0.6e-3, -0.6e-3), size_m: (1.2e-3, 1.2e-3, 0.5e-3), material: \"metal.ron\", \
         start_k: 600.0), laser: (beam: Gaussian(radius_1e2_m: 0.35e-3), absorption: Surface(absorptivity: 0.4), \
         path: Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 1.2e-3, power_w: 500.0))), \
         resolution: (spacing_m: {spacing}, levels: Uniform), physics: {physics}, time: (end_s: {end}, stop_when_solid: true))"
    );
    let path = folder.path().join("scene.ron");
    std::fs::write(&path, scene).unwrap();
    Simulation::new(Model::from_case(&load(&path, &[]).unwrap()).unwrap()).unwrap()
}

fn finished(physics: &str, slope: &str) -> Simulation {
    let mut simulation = spot(physics, slope);
    simulation.run_quietly().unwrap();
    simulation
}

const FLOW: &str = "[Heat(), Flow(viscosity_factor: 20.0)]";

/// Mean outward speed \[m/s\] of the melt's upper layer between a third and two thirds of the pool's radius.
fn outward(simulation: &Simulation) -> f64 {
    let columns = simulation.columns();
    let Some((_, Column::Vector(velocities))) = columns.iter().find(|(name, _)| *name == "velocity_m_s")
    else {
        panic!("no velocities")
    };
    let radius = 0.5 * simulation.records().now.liquidus.width;
    let positions = &simulation.particles().position;
    let upper = |&i: &usize| {
        let share = positions[i].xy().norm() / radius;
        positions[i].z > -60e-6 && share > 0.33 && share < 0.67
    };
    let chosen: Vec<usize> = (0..positions.len()).filter(upper).collect();
    let along = |&i: &usize| velocities[i].xy().dot(&positions[i].xy().normalize());
    chosen.iter().map(along).sum::<f64>() / chosen.len() as f64
}

#[test]
fn a_pool_that_nothing_drives_rests_and_has_the_size_of_conduction() {
    let (still, conducted) = (finished(FLOW, "0.0"), finished("[Heat(weights: Normalized)]", "0.0"));
    let unit = (0.9_f64 / (2500.0 * 0.35e-3)).sqrt();
    let speed = still.records().largest_speed / unit;
    println!("still pool: largest speed {speed:.1e} of the capillary speed");
    assert!(speed < 0.01, "{speed}");
    let (with, without) = (&still.records().liquidus, &conducted.records().liquidus);
    println!(
        "still pool: width {:.4}, depth {:.4} of conduction alone",
        with.width / without.width,
        with.depth / without.depth
    );
    assert!((with.width / without.width - 1.0).abs() < 0.01, "{} {}", with.width, without.width);
    assert!((with.depth / without.depth - 1.0).abs() < 0.01, "{} {}", with.depth, without.depth);
}

#[test]
fn marangoni_flow_goes_where_tension_grows_and_closes_the_ledger() {
    let (out, inwards) = (finished(FLOW, "-3.5e-4"), finished(FLOW, "3.5e-4"));
    let (outward_speed, inward_speed) = (outward(&out), outward(&inwards));
    println!(
        "driven pools: mean radial speed of the upper layer {outward_speed:.3} and {inward_speed:.3} m/s"
    );
    assert!(outward_speed > 0.02 && inward_speed < -0.02, "{outward_speed} {inward_speed}");
    for driven in [&out, &inwards] {
        let ledger = driven.ledger();
        assert_eq!(ledger.fault(), None);
        assert!(ledger.residual.abs() < 1e-12, "{}", ledger.residual);
        let mechanics = driven.mechanics().unwrap();
        let work = mechanics.work;
        println!(
            "driven pools: Marangoni work {:.3e} J, tension {:.3e} J, made heat {:.3e} J, kept {:.1e} J of {:.1e} J; sound {:.2} m/s, Mach {:.3}",
            work.marangoni,
            work.tension,
            ledger.made,
            ledger.moving,
            work.kept(),
            mechanics.sound_speed,
            driven.records().largest_mach
        );
        // What drives the melt is motion and heat of friction; the scheme itself adds or takes a part of it.
        let driving = work.marangoni + work.tension;
        let found = ledger.made + ledger.moving;
        assert!(work.marangoni > 0.0 && (found / driving - 1.0).abs() < 0.4, "{work:?}");
        assert!(driven.records().largest_mach < 0.12, "{}", driven.records().largest_mach);
        let inside = |x: &Vector3<f64>| x.z < 100e-6 && x.xy().amax() < 0.7e-3;
        assert!(driven.particles().position.iter().all(inside), "nothing is thrown out");
    }
    let shape = |simulation: &Simulation| {
        let pool = &simulation.records().liquidus;
        pool.depth / pool.width
    };
    let (wide, deep) = (shape(&out), shape(&inwards));
    println!("driven pools: depth over width {wide:.3} outwards, {deep:.3} inwards");
    assert!(deep > 1.1 * wide, "{wide} {deep}");
}

#[test]
fn a_still_melt_leaves_the_solid_the_stress_that_it_has_without_flow() {
    let coarse = |physics: &str| {
        let mut simulation = spot_of(physics, "0.0", "100e-6", "2.2e-3");
        simulation.run_quietly().unwrap();
        simulation
    };
    let (all, still) = (
        coarse("[Heat(), Flow(viscosity_factor: 20.0), Stress(crossings: 4.0)]"),
        coarse("[Heat(weights: Normalized, smoothing_ratio: 1.3), Stress(crossings: 4.0)]"),
    );
    assert!(all.records().largest_speed > 0.0);
    assert!(all.ledger().residual.abs() < 1e-12, "{}", all.ledger().residual);
    let (with, without) = (all.mechanics().unwrap(), still.mechanics().unwrap());
    println!(
        "all three: residual von Mises {:.1} MPa, displacement {:.2} um; without flow {:.1} MPa, {:.2} um",
        1e-6 * with.largest_von_mises,
        1e6 * with.largest_displacement,
        1e-6 * without.largest_von_mises,
        1e6 * without.largest_displacement
    );
    let stress =
        |simulation: &Simulation| match simulation.columns().into_iter().find(|c| c.0 == "von_mises_pa") {
            Some((_, Column::Scalar(values))) => values,
            _ => panic!("no stress"),
        };
    let (flowing, resting) = (stress(&all), stress(&still));
    let differences = flowing.iter().zip(&resting).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    let worst = (differences / resting.iter().map(|b| b * b).sum::<f64>()).sqrt();
    println!("all three: von Mises differs by {worst:.4} (root mean square over that of stress alone)");
    // What settles at other steps of heat, in a plate that bends, and yields where the pool was.
    assert!(worst < 0.08, "{worst}");
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 0.02;
    assert!(near(with.largest_displacement, without.largest_displacement));
    assert!(near(with.largest_von_mises, without.largest_von_mises));
}

#[test]
fn tension_and_viscosity_may_be_tables_over_temperature() {
    let line = "surface_tension_n_m: (value: 0.9, source: \"the same\"),\n    \
                surface_tension_slope_n_m_k: (value: -3.5e-4, source: \"the same\"),";
    let table = "surface_tension_n_m: (table: [(905.0, 0.9), (1905.0, 1.25)], source: \"test\"),";
    let viscosity = "viscosity_pa_s: (value: 1.3e-3,";
    let thinning = "viscosity_pa_s: (table: [(905.0, 1.3e-3), (1400.0, 0.9e-3)],";
    assert!(metal().contains(line) && metal().contains(viscosity));
    let run = |metal: &str| {
        let mut simulation = spot_in(metal, FLOW, "50e-6", "1.0e-3");
        simulation.run_quietly().unwrap();
        assert_eq!(simulation.ledger().fault(), None);
        (outward(&simulation), simulation.records().largest_speed)
    };
    let (rising, rising_fastest) = run(&metal().replace(line, table));
    let (thin, thin_fastest) = run(&metal().replace(line, table).replace(viscosity, thinning));
    println!(
        "tables: inward at {rising:.3} m/s (fastest {rising_fastest:.3}), thinner {thin:.3} m/s ({thin_fastest:.3})"
    );
    assert!(rising < -0.02, "{rising}");
    assert!(thin < 1.05 * rising, "a thinner melt flows faster: {thin} {rising}");
}

/// Melt that warms grows against the pressure of its hollow surface and of its weight: its heat pays for that, and no
/// energy is lost.
#[test]
fn a_driven_pool_that_expands_closes_both_ledgers() {
    let run = |metal: &str| {
        let mut pool = spot_in(metal, FLOW, "50e-6", "0.8e-3");
        pool.run_quietly().unwrap();
        pool
    };
    let (pool, rigid) = (run(&expanding(1.3e-4)), run(&metal()));
    let (ledger, work) = (pool.ledger(), pool.mechanics().unwrap().work);
    assert_eq!(ledger.fault(), None);
    assert!(ledger.residual.abs() < 1e-12, "{}", ledger.residual);
    println!(
        "expanding pool: work {work:?}, missing {:.1e}, without expansion {:.1e}; depth {:.4} of that without",
        ledger.mechanical_residual,
        rigid.ledger().mechanical_residual,
        pool.records().liquidus.depth / rigid.records().liquidus.depth
    );
    assert!(work.expansion != 0.0 && rigid.mechanics().unwrap().work.expansion == 0.0);
    assert!((pool.records().liquidus.depth / rigid.records().liquidus.depth - 1.0).abs() < 0.1);
}

/// The body and the particles that flow share the heat of deformation: its sum is that of the body, and the ledger of
/// all forms is as closed as without flow.
#[test]
fn a_melt_that_flows_gets_the_heat_of_deformation() {
    let run = |physics: &str| {
        let mut simulation = spot_of(physics, "-3.5e-4", "100e-6", "1.6e-3");
        simulation.run_quietly().unwrap();
        simulation
    };
    let stress = "Stress(crossings: 2.0, heat_of_deformation: true)";
    let flowing = run(&format!("[Heat(), Flow(viscosity_factor: 20.0), {stress}]"));
    let resting = run(&format!("[Heat(weights: Normalized, smoothing_ratio: 1.3), {stress}]"));
    let [with, without] = [&flowing, &resting].map(|run| (run.mechanics().unwrap(), run.ledger()));
    println!(
        "heat of deformation: {:.3e} J with flow, {:.3e} J without; ledger {:.1e} and {:.1e}, open by {:.1e} and {:.1e}; largest speed {:.2} m/s",
        with.0.deformed,
        without.0.deformed,
        with.1.residual,
        without.1.residual,
        with.1.deformation_residual,
        without.1.deformation_residual,
        flowing.records().largest_speed
    );
    assert!(flowing.records().largest_speed > 0.05);
    assert!(with.1.residual.abs() < 1e-12, "{}", with.1.residual);
    assert!(with.1.deformation_residual.abs() < 3.0 * without.1.deformation_residual.abs());
    assert!(with.0.deformed != 0.0);
}

/// A melt of little tension outruns the sound that it begins with; a run that takes up such a state goes on with the same bits.
#[test]
fn a_melt_that_has_raised_its_sound_goes_on_from_a_checkpoint_with_the_same_bits() {
    let slack = expanding(1e-4).replace("(value: 0.9,", "(value: 0.05,");
    assert_ne!(slack, expanding(1e-4));
    let start = || spot_in(&slack, FLOW, "50e-6", "0.8e-3");
    let (mut whole, mut resumed) = (start(), start());
    let first = whole.mechanics().unwrap().sound_speed;
    while whole.mechanics().unwrap().sound_speed < 1.2 * first {
        whole.step(0.8e-3).unwrap();
    }
    resumed.restore(&whole.save(1, 0.0).unwrap()).unwrap();
    assert_eq!(whole.mechanics(), resumed.mechanics());
    for simulation in [&mut whole, &mut resumed] {
        simulation.run_quietly().unwrap();
    }
    assert_eq!(whole.mechanics(), resumed.mechanics());
    assert_eq!(whole.particles().position, resumed.particles().position);
}
