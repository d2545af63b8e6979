//! Wrong cases end with code 2 and a message that names place, field, finding and remedy; good ones pass.

mod support;

use std::path::Path;
use std::process::Command;

use support::good::{MATERIAL, SCENE, spoken};
use support::{Edit, Row, check, check_path, flow, fluid, stress};
use support::{flow_rows, fluid_rows, geometry_rows, material_rows, path_rows, scene_rows, stress_rows};

#[track_caller]
fn assert_refused(code: Option<i32>, message: &str, words: &[&str]) {
    assert_eq!(code, Some(2), "{message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is not in:\n{message}");
    }
}

fn each_scene_is_refused(rows: &[Row]) {
    for &(from, to, at, words) in rows {
        let edit = Edit { from, to, at };
        let scene = edit.apply(SCENE);
        let (code, message) = check(&scene, MATERIAL, &[]);
        assert_refused(code, &message, words);
        assert_refused(code, &message, &[&edit.place(&scene, "scene.ron")]);
    }
}

fn each_material_is_refused(rows: &[Row]) {
    for &(from, to, at, words) in rows {
        let edit = Edit { from, to, at };
        let material = edit.apply(MATERIAL);
        let (code, message) = check(SCENE, &material, &[]);
        assert_refused(code, &message, words);
        assert_refused(code, &message, &[&edit.place(&material, "metal.ron")]);
    }
}

#[test]
fn wrong_stress() {
    let (good, metal) = (stress::scene(), stress::material());
    let (code, message) = check(&good, &metal, &[]);
    assert_eq!(code, Some(0), "{message}");
    for &(from, to, at, words) in stress_rows::SCENES {
        let edit = Edit { from, to, at };
        let scene = edit.apply(&good);
        let (code, message) = check(&scene, &metal, &[]);
        assert_refused(code, &message, words);
        assert_refused(code, &message, &[&edit.place(&scene, "scene.ron")]);
    }
    for &(from, to, at, words) in stress_rows::MATERIALS {
        let edit = Edit { from, to, at };
        let material = edit.apply(&metal);
        let (code, message) = check(&good, &material, &[]);
        assert_refused(code, &message, words);
        assert_refused(code, &message, &[&edit.place(&material, "metal.ron")]);
    }
    let fields = "output.fields=[\"von_mises_pa\"]";
    let (code, message) = check(SCENE, MATERIAL, &[fields]);
    assert_refused(code, &message, &["a field of Stress, which the scene does not list"]);
}

#[test]
fn wrong_flow() {
    let (scene, metal) = (flow::scene(), flow::material());
    for &(from, to, at, words) in flow_rows::FLOWS {
        let edit = Edit { from, to, at };
        let scene = edit.apply(&scene);
        let (code, message) = check(&scene, &metal, &[]);
        assert_refused(code, &message, words);
        assert_refused(code, &message, &[&edit.place(&scene, "scene.ron")]);
    }
    let (code, message) = check(&scene, &metal, &[]);
    assert_eq!(code, Some(0), "{message}");
    let (code, message) = check(&scene, &metal.replace("value: 1.3e-3", "value: 1.3"), &[]);
    assert_refused(code, &message, &["viscosity_pa_s.value", "mPa s (then write 1.3e-3)"]);
    let (code, message) = check(&scene, MATERIAL, &[]);
    assert_refused(code, &message, &["Flow needs viscosity_pa_s of metal", "leave out Flow"]);
    let expanding = "    volume_expansion_liquid_1_k: (value: 1e-4, source: \"test\"),\n    viscosity_pa_s";
    let expanding = metal.replace("    viscosity_pa_s", expanding);
    let (code, message) = check(&scene, &expanding, &["part.regions.0.start_k=1505.0"]);
    let words = ["part.regions.0.start_k", "6.0 % more volume than room", "up to 1005 K"];
    assert_refused(code, &message, &words);
    let (code, message) = check(&scene, &expanding, &[]);
    assert_eq!(code, Some(0), "{message}");
    let (code, message) = check(SCENE, MATERIAL, &["part.faces.top=Losses(evaporation: true)"]);
    let words =
        ["evaporation needs heat_of_evaporation_j_kg of metal", "molar_mass_kg_mol", "evaporation: false"];
    assert_refused(code, &message, &words);
}

#[test]
fn wrong_fluid() {
    let (code, message) = check(fluid::GOOD, MATERIAL, &[]);
    assert_eq!(code, Some(0), "{message}");
    for &(from, to, at, words) in fluid_rows::FLUIDS {
        let edit = Edit { from, to, at };
        let scene = edit.apply(fluid::GOOD);
        let (code, message) = check(&scene, MATERIAL, &[]);
        assert_refused(code, &message, words);
        assert_refused(code, &message, &[&edit.place(&scene, "scene.ron")]);
    }
}

#[test]
fn wrong_form() {
    each_scene_is_refused(scene_rows::FORM);
}

#[test]
fn wrong_values() {
    each_scene_is_refused(scene_rows::VALUES);
}

#[test]
fn wrong_faces() {
    each_scene_is_refused(geometry_rows::FACES);
}

#[test]
fn wrong_geometry() {
    each_scene_is_refused(geometry_rows::GEOMETRY);
}

#[test]
fn wrong_sizes() {
    each_scene_is_refused(geometry_rows::SIZES);
}

#[test]
fn wrong_paths() {
    each_scene_is_refused(path_rows::PATHS);
}

#[test]
fn wrong_materials() {
    each_material_is_refused(material_rows::MATERIALS);
}

#[test]
fn missing_materials_name_the_nearest() {
    let edit = Edit { from: "\"metal\"", to: "\"mettal\"", at: "\"mettal\"" };
    let scene = edit.apply(SCENE);
    let (code, message) = check(&scene, MATERIAL, &[]);
    assert_refused(
        code,
        &message,
        &[&edit.place(&scene, "scene.ron"), "part.material", "did you mean `metal`", "in625"],
    );
    let scene = SCENE.replace("\"metal\"", "\"lost/metal.ron\"");
    let (code, message) = check(&scene, MATERIAL, &[]);
    assert_refused(code, &message, &["part.material", "no such file"]);
}

#[test]
fn unreadable_files_are_named() {
    let (code, message) = check(" \n// nothing\n", MATERIAL, &[]);
    assert_refused(code, &message, &["scene.ron:3:1", "expected a value"]);
    let (code, message) = check("", MATERIAL, &[]);
    assert_refused(code, &message, &["scene.ron:1:1", "empty file"]);
    let folder = tempfile::tempdir().unwrap();
    let (code, message) = check_path(folder.path(), &[]);
    assert_refused(code, &message, &["holds no scene.ron", "accepted: a folder"]);
    let (code, message) = check_path(Path::new("cases/spot-alumnium"), &[]);
    assert_refused(code, &message, &["no such file", "did you mean", "spot-aluminium"]);
    std::fs::write(folder.path().join("scene.ron"), [0xff, 0xfe, 0x00]).unwrap();
    let (code, message) = check_path(folder.path(), &[]);
    assert_refused(code, &message, &["scene.ron", "cannot be read", "UTF-8"]);
}

#[test]
fn wrong_overrides_name_the_argument() {
    let rows: [(&str, &[&str]); 7] = [
        ("part.start_k=20", &["scene.ron:6:18", "part.start_k", "--set part.start_k=20", "Celsius"]),
        ("resolution.spacing=1e-5", &["resolution.spacing", "--set resolution.spacing=1e-5", "`spacing_m`"]),
        ("physics.0.weights=Fited", &["physics.0.weights", "--set physics.0.weights=Fited", "`Fitted`"]),
        ("part.start_k", &["--set part.start_k", "path=value"]),
        ("part.size_m.5=1e-3", &["--set part.size_m.5=1e-3", "there is no `5`"]),
        ("part.start_k=(", &["--set part.start_k=(", "not readable"]),
        ("part.material=lead", &["part.material", "--set part.material=lead", "no material of this name"]),
    ];
    for (change, words) in rows {
        let (code, message) = check(SCENE, MATERIAL, &[change]);
        assert_refused(code, &message, words);
    }
}

#[test]
fn all_findings_are_told_at_once() {
    let scene = SCENE.replace("293.0", "20").replace("absorptivity: 0.4", "absorptivity: 4");
    let (code, message) = check(&scene, &MATERIAL.replace("2500.0", "2.5"), &[]);
    assert_refused(code, &message, &["part.start_k", "absorptivity", "density_kg_m3"]);
}

#[test]
fn wrong_command_lines_end_with_the_same_code() {
    for arguments in
        [&["chek"][..], &["check"], &["run", "case", "--threads", "none"], &["check", "case", "--speed"], &[]]
    {
        let output = Command::new(env!("CARGO_BIN_EXE_welder")).args(arguments).output().unwrap();
        let (code, message) = spoken(&output);
        assert_refused(code, &message, &["--help"]);
    }
}

#[test]
fn good_cases_pass() {
    let straight = "Straight(from_m: (-1e-3, 0), to_m: (3e-3, 0), speed_m_s: 0.2, power_w: 1250, start_s: 0)";
    let spot =
        "Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0))";
    let variations = [
        ("title: \"a test\",", "/* no title */"),
        (
            "Heat()",
            "Heat(weights: Fitted, kernel: Gaussian, smoothing_ratio: 0.9, stepping: Euler(factor: 0.5))",
        ),
        ("Heat()", "Heat(smoothing_ratio: Some(0.9), stepping: SuperSteps())"),
        ("start_k: 400.0", "material: \"in625\""),
        ("x_min: Symmetry", "top: Losses(convection_w_m2_k: 20, emissivity: 0.2)"),
        ("x_min: Symmetry", "bottom: FixedTemperature(temperature_k: 300)"),
        ("disorder: 0.1", "levels: FineBox(low_m: (0, 0, -1e-3), high_m: (1e-3, 1e-3, 0))"),
        ("6.0e-3, 4.0e-3, 3.0e-3", "0.006, 4e-3, 3000e-6"),
        ("path: Spot(", "path: /* here */ Spot("),
        ("radius_1e2_m", "radius_1e_m"),
        ("\"metal\"", "\"materials/metal.ron\""),
        ("(x_min: Symmetry, y_min: Symmetry)", "()"),
    ];
    for (from, to) in variations {
        let scene = Edit { from, to, at: "" }.apply(SCENE);
        let (code, message) = check(&scene, MATERIAL, &[]);
        assert_eq!(code, Some(0), "{to}: {message}");
    }
    let scene = SCENE.replace(spot, straight).replace("x_min: Symmetry, ", "");
    let (code, message) = check(&scene, MATERIAL, &["resolution.seed=7", "part.material=aluminium-model"]);
    assert_eq!(code, Some(0), "{message}");
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig { failure_persistence: None, ..Default::default() })]

    /// Whatever is cut out of a good scene or put into it, the answer is a case or a finding, never a crash.
    #[test]
    fn damaged_scenes_never_crash(from in 0..SCENE.len(), length in 0..40_usize, piece in "[(){}\\[\\],:/*\"'#a-z0-9.\\-é ]{0,6}") {
        let to = (from + length).min(SCENE.len());
        let scene = [&SCENE[..from], &piece, &SCENE[to..]].concat();
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("scene.ron"), scene.replace("\"metal\"", "\"in625\"")).unwrap();
        if let Err(error) = welder::case::load(folder.path(), &[]) {
            proptest::prop_assert!(!error.problems.is_empty());
            proptest::prop_assert!(error.report(false).contains("scene.ron"));
        }
    }
}
