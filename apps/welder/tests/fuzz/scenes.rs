//! The scene reader.

use crate::fluid;
use crate::good::{MATERIAL, SCENE};
use crate::memory::assert_bounded;
use crate::mutation::{mutated, mutations};
use crate::{solid, stress};
use proptest::prelude::*;
use std::path::Path;
use welder::case::{Loaded, load, load_any, resolved_fluid_ron, resolved_ron, resolved_solid_ron};
use welder::fluid::FluidModel;
use welder::model::Model;
use welder::solid::SolidModel;

/// Reads a scene beside a good card; a refusal must name a file, and a case must read back as it was written.
fn read(scene: &[u8]) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("materials")).unwrap();
    std::fs::write(folder.path().join("materials/metal.ron"), MATERIAL).unwrap();
    std::fs::write(folder.path().join("scene.ron"), scene).unwrap();
    read_in(folder.path());
    assert_bounded();
}

pub fn read_in(folder: &Path) {
    match load_any(folder, &[]) {
        Err(error) => {
            assert!(!error.problems.is_empty());
            for text in [error.report(false), error.to_string()] {
                assert!(text.contains("scene.ron") || text.contains("metal.ron"), "{text}");
            }
        }
        Ok(Loaded::Weld(case)) => {
            let _ = Model::from_case(&case);
            let again = folder.join("case.ron");
            std::fs::write(&again, resolved_ron(&case)).unwrap();
            let again = load(&again, &[]).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(again.scene.resolution, case.scene.resolution);
        }
        Ok(Loaded::Solid(case)) => {
            match case.scene.dimension() {
                2 => drop(SolidModel::<2>::from_case(&case)),
                _ => drop(SolidModel::<3>::from_case(&case)),
            }
            let again = folder.join("case.ron");
            std::fs::write(&again, resolved_solid_ron(&case)).unwrap();
            let Loaded::Solid(again) = load_any(&again, &[]).unwrap_or_else(|error| panic!("{error}")) else {
                panic!("another kind")
            };
            assert_eq!(again.scene.bodies, case.scene.bodies);
        }
        Ok(Loaded::Fluid(case)) => {
            match case.scene.dimension() {
                2 => drop(FluidModel::<2>::from_case(&case)),
                _ => drop(FluidModel::<3>::from_case(&case)),
            }
            let again = folder.join("case.ron");
            std::fs::write(&again, resolved_fluid_ron(&case)).unwrap();
            let Loaded::Fluid(again) = load_any(&again, &[]).unwrap_or_else(|error| panic!("{error}")) else {
                panic!("another kind")
            };
            assert_eq!(again.scene.domain, case.scene.domain);
        }
    }
}

/// A fault in the middle of a good scene.
fn with(from: &str, to: &str) -> Vec<u8> {
    assert!(SCENE.contains(from), "{from}");
    SCENE.replacen(from, to, 1).into_bytes()
}

#[test]
fn deep_nesting_is_refused() {
    for (open, close) in
        [("(", ")"), ("[", "]"), ("Some(", ")"), ("{\"a\":", "}"), ("(a:", ")"), ("/*", "*/")]
    {
        for depth in [63, 64, 65, 1_000, 300_000] {
            read(&with("400.0", &format!("{}1{}", open.repeat(depth), close.repeat(depth))));
            read(open.repeat(depth).as_bytes());
        }
    }
}

const NUMBERS: [&str; 9] =
    ["1e308", "-1e308", "1e999", "5e-324", "inf", "NaN", "18446744073709551616", "-0.0", "4e18"];

#[test]
fn huge_numbers_are_refused() {
    for number in NUMBERS {
        for value in
            ["6.0e-3", "293.0", "50.0e-6", "0.1", "0.6e-3", "0.015", "1250.0", "0.03", "1.0e-3", "20000000"]
        {
            read(&with(value, number));
        }
    }
    let solid =
        ["7.0e10", "0.33", "1.0e8", "1.2e-2", "-0.016", "250.0", "-9.81", "6.0e5", "2.0e-3", "0.9", "7.0e-5"];
    let fluid = ["1000.0", "0.1", "40.0", "0.3", "0.25", "-9.81", "0.02", "0.5"];
    for (scene, values) in [(solid::GOOD, solid.as_slice()), (fluid::GOOD, &fluid)] {
        for (number, value) in
            NUMBERS.iter().flat_map(|number| values.iter().map(move |value| (number, value)))
        {
            assert!(scene.contains(value), "{value}");
            read(scene.replacen(value, number, 1).as_bytes());
        }
    }
    read(&with(
        "(max_particles: 20000000)",
        "(max_particles: 18446744073709551615, max_memory_bytes: 18446744073709551615)",
    ));
}

#[test]
fn long_files_are_bounded() {
    // Thousands of findings, each with its excerpt; and a file beyond the limit.
    let point = "(time_s: 0, x_m: 1e9, y_m: 1e9, power_w: 1e99),";
    let spot =
        "Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0))";
    read(&with(spot, &format!("Polyline(points: [{}])", point.repeat(3_000))));
    read(&with("400.0", &format!("[{}]", "1,".repeat(1 << 19))));
    read(&with("a test", &"x".repeat(5 << 20)));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 400, ..Default::default() })]

    #[test]
    fn any_bytes_have_an_answer(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read(&bytes);
    }

    #[test]
    fn any_text_has_an_answer(text in "[(){}\\[\\],:/*\"'#!_+a-zA-Z0-9.\\-é \n]{0,200}") {
        read(text.as_bytes());
    }

    #[test]
    fn mutated_scenes_have_an_answer(changes in mutations()) {
        read(&mutated(SCENE.as_bytes(), &changes));
    }

    #[test]
    fn mutated_scenes_of_fluid_have_an_answer(changes in mutations()) {
        read(&mutated(fluid::GOOD.as_bytes(), &changes));
    }

    #[test]
    fn mutated_scenes_of_solids_have_an_answer(changes in mutations()) {
        read(&mutated(solid::GOOD.as_bytes(), &changes));
    }

    #[test]
    fn mutated_scenes_with_stress_have_an_answer(changes in mutations()) {
        read(&mutated(stress::scene().as_bytes(), &changes));
    }
}
