//! Heat and stress together, through the program's library: exact thermal stress, mirror planes, spots that melt.

use nalgebra::Vector3;
use std::path::Path;
use welder::case::load;
use welder::model::Model;
use welder::physics::Column;
use welder::run::Simulation;

const YOUNG_PA: f64 = 7.0e10;
const POISSON: f64 = 0.33;
const EXPANSION: f64 = 2.31e-5;
const WARMED_K: f64 = 30.0;

/// A scene in a folder of its own: the given `fields` of the root, aluminium of 90 MPa.
fn simulation(fields: &str) -> Simulation {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.ron");
    std::fs::write(&path, format!("({fields})")).unwrap();
    let materials = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/materials/aluminium-model.ron");
    std::fs::copy(Path::new(materials), folder.path().join("metal.ron")).unwrap();
    let case = load(&path, &[]).unwrap();
    Simulation::new(Model::from_case(&case).unwrap()).unwrap()
}

/// The same at its end.
fn finished(fields: &str) -> Simulation {
    let mut simulation = simulation(fields);
    simulation.run_quietly().unwrap();
    simulation
}

/// A bar along x of 1 x 1 mm across that is warmed by 30 K, at one temperature
/// but for 1e-3 of that in a second and less in longer.
fn warm_bar(seconds: f64, length_m: f64, faces: &str, stress: &str) -> Simulation {
    let flux = WARMED_K * 2500.0 * 1050.0 * 1e-3 / seconds;
    finished(&format!(
        "part: (size_m: ({length_m}, 1e-3, 1e-3), material: \"metal.ron\", start_k: 293.0, \
         faces: (bottom: Flux(flux_w_m2: {flux:.6e}), {faces})), \
         resolution: (spacing_m: 2e-4), physics: [Heat(), Stress({stress})], time: (end_s: {seconds})"
    ))
}

fn scalars(simulation: &Simulation, wanted: &str) -> Vec<f64> {
    match simulation.columns().into_iter().find(|(name, _)| *name == wanted) {
        Some((_, Column::Scalar(values))) => values,
        other => panic!("{wanted} is {other:?}"),
    }
}

fn vectors(simulation: &Simulation, wanted: &str) -> Vec<Vector3<f64>> {
    match simulation.columns().into_iter().find(|(name, _)| *name == wanted) {
        Some((_, Column::Vector(values))) => values,
        other => panic!("{wanted} is {other:?}"),
    }
}

fn principals(simulation: &Simulation) -> Vec<[f64; 3]> {
    match simulation.columns().into_iter().find(|(name, _)| *name == "principal_stress_pa") {
        Some((_, Column::Triple(values))) => values,
        other => panic!("principal stress is {other:?}"),
    }
}

/// Mean of a value over the particles with x in the given range \[m\].
fn mean(simulation: &Simulation, range: std::ops::Range<f64>, value: impl Fn(usize) -> f64) -> f64 {
    let positions = &simulation.particles().position;
    let inside: Vec<usize> = (0..positions.len()).filter(|&i| range.contains(&positions[i].x)).collect();
    inside.iter().map(|&i| value(i)).sum::<f64>() / inside.len() as f64
}

#[test]
fn a_free_bar_grows_without_stress() {
    let bar = warm_bar(10.0, 4e-3, "", "crossings: 2.0");
    let displacements = vectors(&bar, "displacement_m");
    let along = |range| mean(&bar, range, |i| displacements[i].x);
    // Centres of the first and the last layer of particles.
    let growth = along(3.8e-3..4e-3) - along(0.0..0.2e-3);
    let exact = EXPANSION * WARMED_K * 3.8e-3;
    println!("free bar: {:.4} of the exact growth", growth / exact);
    assert!((growth / exact - 1.0).abs() < 3e-3, "{growth} against {exact}");
    // What is left is the drag of the damping, and falls as the body gets longer to settle.
    let stress =
        |bar: &Simulation| bar.mechanics().unwrap().largest_von_mises / (YOUNG_PA * EXPANSION * WARMED_K);
    let (shorter, longer) = (stress(&bar), stress(&warm_bar(10.0, 4e-3, "", "crossings: 4.0")));
    println!(
        "free bar: von Mises stress {shorter:.1e} and {longer:.1e} of E alpha dT with 2 and 4 crossings"
    );
    assert!(longer < 1e-3 && longer < 0.75 * shorter, "{shorter} {longer}");
}

#[test]
fn bars_and_plates_that_cannot_grow_are_pressed_by_their_exact_stress() {
    let ends = "x_min: Symmetry, x_max: Symmetry";
    let bar = warm_bar(1.0, 2e-3, ends, "crossings: 2.0");
    let plate = warm_bar(1.0, 2e-3, &format!("{ends}, y_min: Symmetry, y_max: Symmetry"), "crossings: 2.0");
    let held = YOUNG_PA * EXPANSION * WARMED_K;
    for (name, part, exact) in [("bar", bar, held), ("plate", plate, held / (1.0 - POISSON))] {
        let stress = scalars(&part, "von_mises_pa");
        let least = principals(&part);
        let wrong = |i: usize| (stress[i] / exact - 1.0).abs().max((-least[i][2] / exact - 1.0).abs());
        let worst = (0..stress.len()).map(wrong).fold(0.0, f64::max);
        println!("constrained {name}: {worst:.1e} from exact at its worst particle");
        assert!(worst < 1e-2, "{name}: {worst}");
        let [pulled, pressed] = part.mechanics().unwrap().principal_stresses.unwrap();
        assert!(pulled.abs() < 1e-2 * exact && (-pressed / exact - 1.0).abs() < 1e-2, "{pulled} {pressed}");
    }
}

#[test]
fn clamped_ends_hold_and_their_grip_fades_along_the_bar() {
    let held = YOUNG_PA * EXPANSION * WARMED_K;
    let excess = |length_m: f64| {
        let bar = warm_bar(1.0, length_m, "", "crossings: 2.0, clamped: (x_min: true, x_max: true)");
        let displacements = vectors(&bar, "displacement_m");
        let at_end = mean(&bar, 0.0..0.2e-3, |i| displacements[i].norm());
        let beside = mean(&bar, 0.4e-3..0.6e-3, |i| displacements[i].norm());
        println!("clamped bar: {at_end:.2e} m at the end, {beside:.2e} m beside");
        assert!(at_end < 0.75 * beside, "{at_end} {beside}");
        let stress = principals(&bar);
        mean(&bar, 0.4 * length_m..0.6 * length_m, |i| -stress[i][2]) / held - 1.0
    };
    let (short, long) = (excess(4e-3), excess(8e-3));
    println!("clamped bars of 4 and 8 mm: {short:.4} and {long:.4} above E alpha dT");
    // Ends that cannot grow sideways push more: by an amount that belongs to the ends, so by half in twice the length.
    assert!(short > 0.0 && (long / short - 0.5).abs() < 0.1, "{short} {long}");
}

/// A spot on a small plate: the whole, or the quarter between two mirror planes.
fn spot(quarter: bool, crossings: f64) -> Simulation {
    let (low, size, faces) = if quarter {
        ("0.0, 0.0", "1e-3, 1e-3, 0.6e-3", "(x_min: Symmetry, y_min: Symmetry)")
    } else {
        ("-1e-3, -1e-3", "2e-3, 2e-3, 0.6e-3", "()")
    };
    simulation(&format!(
        "part: (low_corner_m: ({low}), size_m: ({size}), material: \"metal.ron\", start_k: 293.0, faces: {faces}), \
         laser: (beam: Gaussian(radius_1e2_m: 0.4e-3), absorption: Surface(absorptivity: 0.4), path: Spot( \
         position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 2e-3, power_w: 900.0))), \
         resolution: (spacing_m: 1e-4), physics: [Heat(), Stress(crossings: {crossings})], time: (end_s: 4e-3)"
    ))
}

#[test]
fn mirror_planes_leave_the_stress_of_the_whole_part() {
    let (mut whole, mut quarter) = (spot(false, 0.2), spot(true, 0.2));
    whole.run_quietly().unwrap();
    quarter.run_quietly().unwrap();
    assert!(quarter.records().solidus.depth > 1e-4, "it melts");
    let (in_whole, in_quarter) = (scalars(&whole, "von_mises_pa"), scalars(&quarter, "von_mises_pa"));
    let largest = in_whole.iter().fold(0.0, |largest: f64, stress| largest.max(*stress));
    let positions = &whole.particles().position;
    let mut farthest = 0.0f64;
    for (position, stress) in quarter.particles().position.iter().zip(&in_quarter) {
        let same = positions.iter().position(|other| (other - position).norm() < 1e-9).unwrap();
        farthest = farthest.max((in_whole[same] - stress).abs() / largest);
    }
    println!("quarter against whole: {farthest:.1e} of the largest stress");
    assert!(in_quarter.len() == 600 && farthest < 1e-9, "{farthest}");
    let energy = 4.0 * quarter.mechanics().unwrap().strain / whole.mechanics().unwrap().strain;
    assert!((energy - 1.0).abs() < 1e-9, "{energy}");
}

#[test]
fn melt_carries_no_shear_and_a_frozen_spot_is_torn() {
    let mut spot = spot(true, 2.0);
    while spot.time() < 2e-3 {
        spot.step(2e-3).unwrap();
    }
    let curve = &spot.model().curves[0];
    let molten: Vec<usize> = (0..spot.particles().len())
        .filter(|&i| curve.liquid_fraction(spot.particles().enthalpy[i]) >= 1.0)
        .collect();
    let stress = scalars(&spot, "von_mises_pa");
    assert!(molten.len() > 5 && molten.iter().all(|&i| stress[i] < 1e5), "the melt carries shear");
    spot.run_quietly().unwrap();
    let (stress, principal) = (scalars(&spot, "von_mises_pa"), principals(&spot));
    let of_molten =
        |value: &dyn Fn(usize) -> f64| molten.iter().map(|&i| value(i)).sum::<f64>() / molten.len() as f64;
    let (torn, pulled) = (of_molten(&|i| stress[i]), of_molten(&|i| principal[i][0]));
    println!("frozen spot: von Mises {:.1} MPa, largest principal {:.1} MPa", 1e-6 * torn, 1e-6 * pulled);
    assert!(torn > 2e7 && pulled > 2e7, "{torn} {pulled}");
    assert!(stress.iter().all(|&stress| stress < 1.001 * 9e7), "nothing is stronger than its yield stress");
    let unrest = spot.mechanics().unwrap().unrest;
    println!("frozen spot: unrest {unrest:.1e}");
    assert!(unrest < 1e-2, "{unrest}");
}

/// A part that cannot grow is pressed while it warms, and is warmer for it: dT (rho c_p + alpha T d tr(sigma)/dT) = Q.
#[test]
fn pressing_warms_by_its_exact_share_and_closes_the_ledger_of_all_forms() {
    let ends = "x_min: Symmetry, x_max: Symmetry";
    let plane = format!("{ends}, y_min: Symmetry, y_max: Symmetry");
    for (name, faces, stiffness) in
        [("bar", ends, YOUNG_PA), ("plate", &plane, 2.0 * YOUNG_PA / (1.0 - POISSON))]
    {
        let rise = |deformation: bool| {
            let stress = format!("crossings: 2.0, heat_of_deformation: {deformation}");
            let part = warm_bar(1.0, 2e-3, faces, &stress);
            let ledger = part.ledger();
            assert!(ledger.residual.abs() < 1e-12, "{}", ledger.residual);
            let curve = &part.model().curves[0];
            let mean = mean(&part, 0.0..1.0, |i| curve.temperature(part.particles().enthalpy[i]));
            (mean - 293.0, ledger.deformation_residual, part.mechanics().unwrap())
        };
        let ((with, open, mechanics), (without, _, _)) = (rise(true), rise(false));
        let share = stiffness * EXPANSION * EXPANSION * (293.0 + 0.5 * WARMED_K) / (2500.0 * 1050.0);
        let exact = share / (1.0 - share);
        let found = with / without - 1.0;
        println!(
            "{name}: warmer by {found:.5}, exact {exact:.5}; ledger open by {open:.1e}, strain {:.2e} J, heat of deformation {:.2e} J",
            mechanics.strain, mechanics.deformed
        );
        assert!((found / exact - 1.0).abs() < 0.03, "{name}: {found} {exact}");
        assert!(open.abs() < 1e-2 * mechanics.strain / (2500.0 * 1050.0 * WARMED_K * 2e-9), "{open}");
    }
}
