//! Energy of random scenes, and the maximum principle.

use proptest::prelude::*;
use sph_thermal::phase::{EnthalpyCurve, ThermalMaterial};
use std::sync::Arc;
use welder::case::scene::{Face, Levels, Stepping, Weights};
use welder::model::Model;
use welder::run::Simulation;
use welder::verify::{block, never_melting, reference_aluminium, spot};

const SPACING: f64 = 100e-6;

fn face() -> impl Strategy<Value = Face> {
    prop_oneof![
        Just(Face::Adiabatic),
        (300.0..2000.0f64).prop_map(|temperature_k| Face::FixedTemperature { temperature_k }),
        (-1e7..1e8f64).prop_map(|flux_w_m2| Face::Flux { flux_w_m2 }),
        (0.0..1e4f64, 0.0..1.0f64).prop_map(|(convection_w_m2_k, emissivity)| Face::Losses {
            convection_w_m2_k,
            emissivity,
            ambient_k: 293.0,
            evaporation: false,
        }),
    ]
}

#[derive(Debug, Clone, Copy)]
struct Scene {
    counts: [usize; 3],
    disorder: f64,
    levels: bool,
    normalized: bool,
    joint: bool,
    power: f64,
}

fn scene() -> impl Strategy<Value = Scene> {
    let counts = [6usize..14, 6usize..14, 6usize..14];
    let disorder = prop_oneof![Just(0.0), 0.05..0.2f64];
    (counts, disorder, any::<bool>(), any::<bool>(), any::<bool>(), 0.0..300.0f64).prop_map(
        |(counts, disorder, levels, normalized, joint, power)| Scene {
            counts,
            disorder,
            levels,
            normalized,
            joint,
            power,
        },
    )
}

fn other_material() -> ThermalMaterial {
    ThermalMaterial {
        latent_heat: 2e5,
        solidus: 1400.0,
        liquidus: 1450.0,
        ..never_melting(7500.0, 600.0, 25.0)
    }
}

fn model(scene: &Scene) -> Model {
    let mut model = block(scene.counts, SPACING, vec![reference_aluminium(), other_material()]).unwrap();
    model.resolution.disorder = scene.disorder;
    if scene.levels {
        let edge = 4.0 * SPACING;
        model.resolution.levels = Levels::FineBox { low_m: [0.0, 0.0, -edge], high_m: [edge, edge, 0.0] };
    }
    if scene.normalized {
        model.heat.weights = Weights::Normalized;
    }
    let (joint, joint_at) = (scene.joint, 0.5 * model.size[0]);
    model.start = Arc::new(move |[x, ..]| (u8::from(joint && x > joint_at), 300.0));
    let beam = laser_source::Beam::Gaussian(laser_source::Gaussian { radius_1e_m: 4.0 * SPACING });
    model.laser = Some(spot(beam, scene.power, 1e-3).unwrap());
    model.end = 1.5e-3;
    model
}

fn residual(model: Model) -> f64 {
    let mut simulation = Simulation::new(model).unwrap();
    simulation.run_quietly().unwrap();
    let ledger = simulation.ledger();
    assert!(ledger.absorbed.is_finite() && ledger.sensible.is_finite());
    ledger.residual.abs()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn closed_scenes_keep_their_energy(scene in scene()) {
        let open = residual(model(&scene));
        prop_assert!(open < 1e-12, "{open:e}");
    }

    #[test]
    fn scenes_with_faces_keep_their_books(
        scene in scene(), top in face(), bottom in face(), side in face(), mirror in any::<bool>(),
    ) {
        let mut model = model(&scene);
        (model.faces.top, model.faces.bottom, model.faces.x_max) = (top, bottom, side);
        model.faces.y_min = if mirror { Face::Symmetry } else { Face::Adiabatic };
        let open = residual(model);
        prop_assert!(open < 1e-10, "{open:e}");
    }

    #[test]
    fn without_sources_nothing_leaves_the_bounds(
        counts in [2usize..10, 2usize..10, 2usize..10], cold in 300.0..800.0f64, rise in 1.0..1500.0f64,
        wall in 0.0..1.0f64, seed in any::<u32>(),
    ) {
        let mut model = block(counts, SPACING, vec![reference_aluminium()]).unwrap();
        let noise = move |x: f64| ((x * 1e6 + f64::from(seed)).sin() * 43758.5453).rem_euclid(1.0);
        model.start = Arc::new(move |[x, y, z]| (0, cold + rise * noise(x + 7.0 * y - 31.0 * z)));
        model.faces.x_min = Face::FixedTemperature { temperature_k: cold + wall * rise };
        // One Euler step is a mean with positive weights of the neighbours' potentials.
        model.heat.stepping = Stepping::Euler { factor: 0.49 };
        model.end = 2e-3;
        let curve = EnthalpyCurve::continuous(&reference_aluminium()).unwrap();
        let mut simulation = Simulation::new(model).unwrap();
        simulation.run_quietly().unwrap();
        for &enthalpy in &simulation.particles().enthalpy {
            let temperature = curve.temperature(enthalpy);
            prop_assert!(temperature > cold - 1e-9 && temperature < cold + rise + 1e-9, "{temperature}");
        }
    }
}
