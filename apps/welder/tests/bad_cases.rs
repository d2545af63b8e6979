//! Wrong cases end with code 2 and a message that names place, field, finding and remedy; good ones pass.

mod support;

use std::path::Path;
use std::process::Command;

use support::{Edit, MATERIAL, SCENE, check, check_path, spoken};

/// An edit of the scene, where its fault stands, and words that the message must hold.
type Row = (&'static str, &'static str, &'static str, &'static [&'static str]);

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
fn wrong_form() {
    each_scene_is_refused(&[
        (
            "spacing_m:",
            "spacing:",
            "spacing:",
            &["resolution.spacing", "unknown field", "did you mean `spacing_m`"],
        ),
        ("title:", "Title:", "Title:", &["Title", "did you mean `title`"]),
        (
            "Symmetry, y_min",
            "Symetry, y_min",
            "Symetry",
            &["part.faces.x_min", "did you mean `Symmetry`", "Adiabatic"],
        ),
        ("Heat()", "Flow()", "Flow", &["physics.0", "`Flow`", "accepted: Heat"]),
        ("Heat()", "Heat", "Heat", &["physics.0", "found `Heat`", "Name()"]),
        ("Heat()", "Heat(kernel: Wendland)", "Wendland", &["physics.0.kernel", "did you mean `WendlandC2`"]),
        ("Heat()", "Heat(stepping: Euler(facto: 0.5))", "facto:", &["physics.0.stepping.facto", "`factor`"]),
        ("293.0", "\"warm\"", "\"warm\"", &["part.start_k", "found `\"warm\"`", "a number"]),
        ("\"metal\"", "metal", "metal,", &["part.material", "found `metal`", "double quotes"]),
        (
            "max_particles: 20000000",
            "max_particles: 1e9",
            "1e9",
            &["budget.max_particles", "1e9", "whole number"],
        ),
        (
            "max_particles: 20000000",
            "max_particles: -5",
            "-5",
            &["budget.max_particles", "-5", "whole number"],
        ),
        ("(6.0e-3, 4.0e-3, 3.0e-3)", "(6.0e-3, 4.0e-3)", "(6.0e-3, 4", &["part.size_m", "length 3"]),
        ("[Heat()]", "Heat()", "Heat()", &["physics", "square brackets"]),
        ("        start_k: 293.0,\n", "", "part: (", &["part.start_k", "found nothing", "add `start_k"]),
        ("    time: (end_s: 0.03),\n", "", "(", &["time", "found nothing", "add `time"]),
        (
            "start_k: 293.0",
            "start_k: 293.0, start_k: 300.0",
            "start_k: 300",
            &["part.start_k", "second time"],
        ),
        ("disorder: 0.1),", "disorder: 0.1", "laser:", &["resolution", "expected `,` or `)`"]),
        ("disorder: 0.1),", "disorder: 0.1,", "(", &["the file", "`(` is never closed"]),
        ("start_k: 293.0,", "start_k: 293.0", "faces:", &["part.start_k", "expected `,`"]),
        ("\"a test\"", "\"a test", "\"a test", &["title", "never closed"]),
        (
            "radius_1e2_m: 0.6e-3",
            "",
            "Gaussian()",
            &["laser.beam", "exactly one of radius_1e_m and radius_1e2_m"],
        ),
        ("radius_1e2_m", "radius_m", "radius_m", &["laser.beam.radius_m", "unknown field", "radius_1e2_m"]),
    ]);
}

#[test]
fn wrong_values() {
    each_scene_is_refused(&[
        ("(6.0e-3, 4", "(-6.0e-3, 4", "-6.0e-3", &["part.size_m.0", "found `-6.0e-3`", "negative"]),
        ("(6.0e-3, 4", "(6.0, 4", "6.0, 4", &["part.size_m.0", "found `6.0`", "mm (then write 6e-3)"]),
        ("(6.0e-3, 4", "(NaN, 4", "NaN", &["part.size_m.0", "found `NaN`", "not a finite number"]),
        ("(6.0e-3, 4", "(inf, 4", "inf", &["part.size_m.0", "not a finite number"]),
        ("(6.0e-3, 4", "(0.0, 4", "0.0, 4", &["part.size_m.0", "zero"]),
        ("50.0e-6", "50", "50,", &["resolution.spacing_m", "found `50`", "um (then write 5e-5)"]),
        ("50.0e-6", "0.05", "0.05", &["resolution.spacing_m", "mm (then write 5e-5)"]),
        ("50.0e-6", "0", "0, dis", &["resolution.spacing_m", "zero"]),
        ("disorder: 0.1", "disorder: 0.5", "0.5", &["resolution.disorder", "0 to 0.3"]),
        ("293.0", "20", "20,", &["part.start_k", "found `20`", "Celsius (then write 293.15)"]),
        ("293.0", "0.5", "0.5,", &["part.start_k", "found `0.5`"]),
        ("293.0", "3000.0", "3000.0", &["part.start_k", "boiling", "below 2790 K"]),
        ("power_w: 1250.0", "power_w: 0.5", "0.5)", &["laser.path.pulse.power_w", "kW (then write 500)"]),
        ("power_w: 1250.0", "power_w: -1250.0", "-1250", &["laser.path.pulse.power_w", "negative"]),
        ("0.6e-3", "600", "600", &["laser.beam.radius_1e2_m", "found `600`", "um (then write 6e-4)"]),
        ("absorptivity: 0.4", "absorptivity: 1.2", "1.2", &["laser.absorption.absorptivity", "0 to 1"]),
        (
            "absorptivity: 0.4",
            "absorptivity: 40",
            "40)",
            &["laser.absorption.absorptivity", "per cent (then write 0.4)"],
        ),
        ("duration_s: 0.015", "duration_s: 0", "0, power", &["laser.path.pulse.duration_s", "zero"]),
        ("end_s: 0.03", "end_s: -0.03", "-0.03", &["time.end_s", "negative"]),
        ("end_s: 0.03", "end_s: 1.0e6", "1.0e6", &["time.end_s", "ms"]),
        ("[Heat()]", "[]", "[],", &["physics", "found `[]`", "Heat()"]),
        ("[Heat()]", "[Heat(), Heat()]", "Heat()]", &["physics.1", "listed before"]),
        ("Heat()", "Heat(smoothing_ratio: 12)", "12)", &["physics.0.smoothing_ratio", "0.5 to 3"]),
        ("Heat()", "Heat(stepping: Euler(factor: 1.5))", "1.5", &["physics.0.stepping.factor", "to 1"]),
        (
            "frame_interval_s: 1.0e-3",
            "frame_interval_s: 0",
            "0, fields",
            &["output.frame_interval_s", "zero"],
        ),
        (
            "frame_interval_s: 1.0e-3",
            "history_interval_s: 1e-8",
            "1e-8",
            &["output.history_interval_s", "at least"],
        ),
        (
            "[\"temperature_k\"]",
            "[\"temperature\"]",
            "\"temperature\"",
            &["output.fields.0", "did you mean `temperature_k`"],
        ),
        ("max_particles: 20000000", "max_particles: 0", "0),\n)", &["budget.max_particles", "1 or more"]),
    ]);
}

#[test]
fn wrong_faces() {
    each_scene_is_refused(&[
        ("y_min: Symmetry", "bottom: Symmetry", "Symmetry)", &["part.faces.bottom", "mirror", "Adiabatic"]),
        (
            "y_min: Symmetry",
            "bottom: FixedTemperature(temperature_k: 1e5)",
            "1e5",
            &["part.faces.bottom.temperature_k"],
        ),
        (
            "y_min: Symmetry",
            "top: FixedTemperature(temperature_k: 300)",
            "FixedT",
            &["part.faces.top", "laser"],
        ),
        ("y_min: Symmetry", "top: Losses(emissivity: 2)", "2)", &["part.faces.top.emissivity", "0 to 1"]),
        ("y_min: Symmetry", "top: Losses(ambient_k: 20)", "20)", &["part.faces.top.ambient_k", "Celsius"]),
        ("y_min: Symmetry", "top: Flux(flux_w_m2: NaN)", "NaN", &["part.faces.top.flux_w_m2", "finite"]),
    ]);
}

#[test]
fn wrong_geometry() {
    each_scene_is_refused(&[
        (
            "50.0e-6",
            "70.0e-6",
            "6.0e-3, 4",
            &["part.size_m.0", "85.7143 spacings", "5.95e-3 or 6.02e-3", "resolution.spacing_m: "],
        ),
        ("3.0e-3)", "50.0e-6)", "50.0e-6)", &["part.size_m.2", "two spacings", "at least 1e-4 m"]),
        ("3.0e-3)", "20.0e-6)", "20.0e-6)", &["part.size_m.2", "two spacings"]),
        (
            "0.6e-3",
            "0.12e-3",
            "0.12e-3",
            &["laser.beam.radius_1e2_m", "two spacings", "spacing_m at most 4.24264e-5"],
        ),
        (
            "Gaussian(radius_1e2_m: 0.6e-3)",
            "TopHat(radius_m: 90e-6)",
            "90e-6",
            &["laser.beam.radius_m", "at most 4.5e-5"],
        ),
        (
            "(position_m: (0.0, 0.0)",
            "(position_m: (9.0e-3, 0.0)",
            "(9.0e-3",
            &["laser.path.position_m", "off the part", "x from 0 to 6e-3 m"],
        ),
        (
            "(position_m: (0.0, 0.0)",
            "(position_m: (1.0e-3, 0.0)",
            "(1.0e-3, 0.0), pulse",
            &["laser.path.position_m", "second laser", "x = 0"],
        ),
        (
            "Surface(absorptivity: 0.4)",
            "BeerLambert(absorptivity: 0.4, absorption_coefficient_per_m: 1e5)",
            "1e5",
            &["laser.absorption.absorption_coefficient_per_m", "two spacings", "Surface(", "at most 5e-6"],
        ),
        (
            "high_m: (1.0e-3, 1.0e-3, 0.0)",
            "high_m: (1.0e-3, 1.0e-3, 1.0e-3)",
            "1.0e-3), start",
            &["part.regions.0.high_m.2", "outside the part"],
        ),
        (
            "high_m: (1.0e-3, 1.0e-3, 0.0)",
            "high_m: (1.02e-3, 1.0e-3, 0.0)",
            "1.02e-3",
            &["part.regions.0.high_m.0", "cuts through particles", "1e-3 or 1.05e-3"],
        ),
        (
            "high_m: (1.0e-3, 1.0e-3, 0.0)",
            "high_m: (1.0e-3, 1.0e-3, -2.0e-3)",
            "-2.0e-3",
            &["part.regions.0.high_m.2", "low_m"],
        ),
        (", start_k: 400.0", "", "(low_m", &["part.regions.0", "changes nothing"]),
        (
            "disorder: 0.1",
            "levels: FineBox(low_m: (0, 0, 0), high_m: (1e-3, 1e-3, 1e-3))",
            "FineBox",
            &["resolution.levels", "outside the part"],
        ),
    ]);
}

#[test]
fn wrong_sizes() {
    each_scene_is_refused(&[
        ("50.0e-6", "1.0e-6", "1.0e-6", &["resolution.spacing_m", "particles", "max_particles"]),
        (
            "50.0e-6, disorder: 0.1",
            "4.0e-6, levels: Uniform",
            "4.0e-6",
            &["resolution.spacing_m", "1.13e9 particles", "max_particles"],
        ),
        (
            "max_particles: 20000000",
            "max_memory_bytes: 1000",
            "50.0e-6",
            &["resolution.spacing_m", "budget.max_memory_bytes", "smaller part"],
        ),
    ]);
}

#[test]
fn wrong_paths() {
    let pulse = "Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0)";
    let spot =
        "Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0))";
    each_scene_is_refused(&[
        (
            pulse,
            "Table(start_s: 0, points: [(time_s: 0, power_w: 900), (time_s: -1e-3, power_w: 900)])",
            "-1e-3",
            &["laser.path.pulse.points.1.time_s", "before"],
        ),
        (
            pulse,
            "Table(start_s: 0, points: [(time_s: 0, power_w: 0), (time_s: 1e-3, power_w: 0)])",
            "[(time_s",
            &["laser.path.pulse.points", "never on"],
        ),
        (
            pulse,
            "Constant(start_s: 1.0, duration_s: 0.015, power_w: 1250.0)",
            "0.03",
            &["time.end_s", "before the laser starts"],
        ),
        (
            spot,
            "Straight(from_m: (0, 0), to_m: (0, 3e-3), speed_m_s: 1000, power_w: 1250, start_s: 0)",
            "1000",
            &["laser.path.speed_m_s", "mm/min (then write 0.0166667)"],
        ),
        (
            spot,
            "Straight(from_m: (0, 0), to_m: (0, 3e-3), speed_m_s: 0.01, power_w: 1250, start_s: 0)",
            "(0, 0)",
            &["laser.path.from_m", "mirror plane at y = 0"],
        ),
        (
            spot,
            "Straight(from_m: (0, 0), to_m: (0, 0), speed_m_s: 0.01, power_w: 1250, start_s: 0)",
            "(0, 0), speed",
            &["laser.path.to_m", "distance"],
        ),
        (
            spot,
            "Straight(from_m: (0, 9e-3), to_m: (0, 8e-3), speed_m_s: 0.01, power_w: 1250, start_s: 0)",
            "(0, 9e-3)",
            &["laser.path.from_m", "beside the part"],
        ),
        (
            spot,
            "Polyline(points: [(time_s: 0, x_m: 0, y_m: 0, power_w: 900), (time_s: -1, x_m: 0, y_m: 0, power_w: 900)])",
            "-1,",
            &["laser.path.points.1.time_s"],
        ),
        (
            spot,
            "Polyline(points: [(time_s: 0, x_m: 0, y_m: 0, power_w: 900)])",
            "[(time_s",
            &["laser.path.points", "at least 2"],
        ),
    ]);
}

#[test]
fn wrong_materials() {
    each_material_is_refused(&[
        ("2500.0", "-2500.0", "-2500.0", &["density_kg_m3.value", "negative"]),
        ("2500.0", "2.5", "2.5,", &["density_kg_m3.value", "g/cm3 (then write 2500)"]),
        (
            "(value: 2500.0, source: \"test\")",
            "2500.0",
            "2500.0",
            &["density_kg_m3", "found `2500.0`", "round brackets"],
        ),
        ("(value: 847.0", "(value: 950.0", "950.0", &["solidus_k.value", "not below the liquidus, 905 K"]),
        ("(value: 847.0", "(value: 905.0", "905.0", &["solidus_k.value", "1 K"]),
        ("3.97e5", "-3.97e5", "-3.97e5", &["latent_heat_j_kg.value", "negative"]),
        ("3.97e5", "397", "397", &["latent_heat_j_kg.value", "kJ/kg or J/g (then write 3.97e5)"]),
        ("2790.0", "880.0", "880.0", &["boiling_k.value", "liquidus"]),
        (
            "value: 200.0",
            "value: 0.2",
            "0.2",
            &["conductivity_solid_w_m_k.value", "W/(mm K) (then write 200)"],
        ),
        (
            "value: 200.0",
            "value: 200.0, table: [(1, 2)]",
            "(value: 200.0",
            &["conductivity_solid_w_m_k", "both given"],
        ),
        ("(value: 200.0, ", "(", "(source", &["conductivity_solid_w_m_k", "table:"]),
        ("(847.0, 1050.0)", "(250.0, 1050.0)", "250.0", &["heat_capacity_solid_j_kg_k.table.1.0", "ascend"]),
        ("(847.0, 1050.0)", "(847.0, inf)", "inf", &["heat_capacity_solid_j_kg_k.table.1.1", "finite"]),
        (", (847.0, 1050.0)", "", "[(300", &["heat_capacity_solid_j_kg_k.table", "two points"]),
        (
            "value: 1180.0, source: \"test\"",
            "value: 1180.0, source: \" \"",
            "\" \"",
            &["heat_capacity_liquid_j_kg_k.source", "source"],
        ),
        (
            "value: 1180.0, source: \"test\"",
            "value: 1180.0",
            "heat_capacity_liquid",
            &["heat_capacity_liquid_j_kg_k.source", "add `source"],
        ),
        (
            "latent_heat_j_kg",
            "latent_heat",
            "latent_heat",
            &["unknown field `latent_heat`", "did you mean `latent_heat_j_kg`"],
        ),
    ]);
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
