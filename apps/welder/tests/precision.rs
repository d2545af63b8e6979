//! The ladder of `welder precision`, from the command line to its files.

#[path = "support/good.rs"]
mod good;

use good::{MATERIAL, SCENE, spoken};
use std::path::Path;
use std::process::Command;

/// A block of 12 spacings with a wide beam, so that half as many divide it; it melts within a millisecond.
fn small_case(folder: &Path) {
    let scene = SCENE
        .replace("6.0e-3, 4.0e-3, 3.0e-3", "1.2e-3, 1.2e-3, 1.2e-3")
        .replace(
            "regions: [(low_m: (0.0, 0.0, -1.0e-3), high_m: (1.0e-3, 1.0e-3, 0.0), start_k: 400.0)],",
            "",
        )
        .replace("spacing_m: 50.0e-6, disorder: 0.1", "spacing_m: 100.0e-6")
        .replace("duration_s: 0.015, power_w: 1250.0", "duration_s: 0.002, power_w: 2500.0")
        .replace("end_s: 0.03", "end_s: 0.003")
        .replace("frame_interval_s: 1.0e-3, ", "");
    std::fs::create_dir(folder.join("materials")).unwrap();
    std::fs::write(folder.join("scene.ron"), scene).unwrap();
    std::fs::write(folder.join("materials/metal.ron"), MATERIAL).unwrap();
}

fn precision(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
    command.arg("precision").arg(folder).args(arguments).arg("--out").arg(folder.join("out"));
    spoken(&command.output().unwrap())
}

#[test]
fn the_ladder_estimates_its_error_and_finds_the_cheapest_run() {
    let folder = tempfile::tempdir().unwrap();
    small_case(folder.path());
    let (code, text) = precision(folder.path(), &["--wanted-error", "0.5"]);
    assert_eq!(code, Some(0), "{text}");
    for words in [
        "tight steps, spacings alone (index: safety factor 1.25",
        "width, um",
        "peak, K rise",
        "weld, mm3",
        "cheapest within the wanted error of 0.5: `",
    ] {
        assert!(text.contains(words), "`{words}` is not in:\n{text}");
    }
    let out = folder.path().join("out");
    let table = std::fs::read_to_string(out.join("precision_convergence.csv")).unwrap();
    for row in table.lines().filter(|line| line.starts_with("tight steps,")) {
        let cells: Vec<_> = row.split(',').collect();
        assert!(cells[4].parse::<f64>().unwrap() > 0.0, "nothing melted: {row}");
        // Without an order there is no estimate, and the verdict says so.
        assert_eq!(cells[5].is_empty(), cells[8].is_empty(), "{row}");
        assert!(!cells[5].is_empty() || cells[9] == "not in the asymptotic range", "{row}");
    }
    assert_eq!(table.lines().filter(|line| line.starts_with("tight steps,")).count(), 5);
    for picture in ["convergence", "width_cpu", "length_particles", "weld_cpu"] {
        assert!(out.join(format!("precision_{picture}.png")).is_file(), "{picture}");
    }
}

#[test]
fn a_wish_beyond_every_run_ends_with_4() {
    let folder = tempfile::tempdir().unwrap();
    small_case(folder.path());
    let (code, text) = precision(folder.path(), &["--wanted-error", "1e-9"]);
    assert_eq!(code, Some(4), "{text}");
    assert!(text.contains("no run is within the wanted error of 0.000000001; the most exact: `"), "{text}");
}

/// Runs that are refused before anything is built or written.
#[test]
fn hostile_wishes_end_with_2_and_say_what_is_accepted() {
    let folder = tempfile::tempdir().unwrap();
    small_case(folder.path());
    let many = format!("physics.0.smoothing_ratio={}", vec!["1.0"; 3000].join(","));
    let rows: [(&[&str], &[&str]); 12] = [
        (&["--wanted-error", "0"], &["--wanted-error", "above 0 and below 1"]),
        (&["--wanted-error", "NaN"], &["--wanted-error", "above 0 and below 1"]),
        (&["--wanted-error", "1e300"], &["--wanted-error", "above 0 and below 1"]),
        (&["--set", "budget.max_particles=0"], &["budget.max_particles", "1 or more"]),
        (
            &["--set", "budget.max_particles=2000"],
            &["the run at 50.00 um takes", "max_particles = 2000", "half of its"],
        ),
        (
            &["--set", "budget.max_memory_bytes=2000000"],
            &["the run at 50.00 um takes", "bytes, beyond budget.max_memory"],
        ),
        (&["--set", "resolution.spacing_m=1e-6"], &["resolution.spacing_m", "particles"]),
        (&["--set", "resolution.spacing_m=NaN"], &["resolution.spacing_m", "accepted"]),
        (&["--set", "resolution.spacing_m=200e-6"], &["scene.ron:10:29", "twice this spacing"]),
        (&["--vary", many.as_str()], &["found 3000 values", "1 to 32"]),
        (&["--vary", "physics.0.smoothing_ratio=0.7,99"], &["physics.0.smoothing_ratio", "`99`", "0.5 to 3"]),
        (&["--vary", "laser.path.pulse.power_w=1,2"], &["changes the weld", "a field of physics"]),
    ];
    for (arguments, words) in rows {
        let (code, text) = precision(folder.path(), arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {text}");
        words
            .iter()
            .for_each(|word| assert!(text.contains(word), "{arguments:?}: `{word}` is not in:\n{text}"));
    }
    assert!(!folder.path().join("out/precision.csv").exists());
}

#[test]
fn a_ladder_over_a_field_takes_the_place_of_the_settings() {
    let folder = tempfile::tempdir().unwrap();
    small_case(folder.path());
    for (vary, names) in [
        ("physics.0.smoothing_ratio=0.7,1.0", ["smoothing_ratio 0.7", "smoothing_ratio 1.0"]),
        (
            "physics.0.stepping=Euler(factor: 0.5),SuperSteps(tolerance: 0.1, max_stages: 9)",
            ["stepping Euler(factor: 0.5)", "stepping SuperSteps(tolerance: 0.1, max_stages: 9)"],
        ),
    ] {
        let (code, text) = precision(folder.path(), &["--vary", vary]);
        assert_eq!(code, Some(0), "{text}");
        let mut table = csv::Reader::from_path(folder.path().join("out/precision.csv")).unwrap();
        let rows: Vec<_> = table.records().map(|row| row.unwrap()).collect();
        let of = |name: &str| rows.iter().filter(|row| &row[0] == name).count();
        assert_eq!([of("default"), of("tight steps"), of(names[0]), of(names[1])], [2, 3, 2, 2], "{rows:?}");
        assert_eq!(rows.len(), 9);
    }
}

#[test]
fn steps_beyond_the_budget_end_with_3() {
    let folder = tempfile::tempdir().unwrap();
    small_case(folder.path());
    let (code, text) = precision(folder.path(), &["--set", "budget.max_steps=3"]);
    assert_eq!(code, Some(3), "{text}");
    assert!(text.contains("step budget of 3") && text.contains("budget.max_steps"), "{text}");
}

/// The ladder of a scene that is no weld: its table and its numbers.
fn plain(case: &str, settings: &[&str]) -> (String, serde_json::Value) {
    let folder = tempfile::tempdir().unwrap();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case);
    let json = folder.path().join("precision.json");
    let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
    command.arg("precision").arg(case).arg("--out").arg(folder.path()).arg("--json").arg(&json);
    settings.iter().for_each(|setting| {
        command.args(["--set", setting]);
    });
    let (code, text) = spoken(&command.output().unwrap());
    assert_eq!(code, Some(0), "{text}");
    for file in ["precision.csv", "precision_convergence.csv", "precision_convergence.png"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
    let table = std::fs::read_to_string(folder.path().join("precision.csv")).unwrap();
    assert_eq!(table.lines().count(), 4, "{table}");
    (text, serde_json::from_slice(&std::fs::read(json).unwrap()).unwrap())
}

fn quantity<'a>(report: &'a serde_json::Value, name: &str) -> &'a serde_json::Value {
    let found = report["quantities"].as_array().unwrap().iter().find(|one| one["quantity"] == name);
    found.unwrap_or_else(|| panic!("no {name} in {report}"))
}

/// The speed of the surface of a film, tau_T G H/eta when it is steady, less the half spacing that the upper row lies below it.
#[test]
fn the_surface_of_a_film_converges_to_the_speed_that_tension_drives() {
    let wide = ["domain.size_m=(3e-3,1.5e-3)", "bodies.0.high_m=(3e-3,1e-3)", "time.end_s=0.2"];
    let (text, report) = plain("fluid/film", &wide);
    let speed = quantity(&report, "max_speed_m_s");
    let exact = 6e-5 * 1000.0 * 1e-3 / 0.019;
    let extrapolated = speed["extrapolated"].as_f64().unwrap();
    assert!((extrapolated / exact - 1.0).abs() < 0.02, "{extrapolated} {exact}\n{text}");
    let order = speed["order"].as_f64().unwrap();
    assert!(order > 0.7 && order < 2.5, "{text}");
    assert!(speed["own_error"].as_f64().unwrap() > 0.02, "half a row of eight: {text}");
}

#[test]
fn a_ladder_of_elastic_bodies_tells_what_changes_with_the_spacing() {
    let (text, report) = plain("solid/hot-spot", &["spacing_m=2e-3", "time.end_s=2e-5"]);
    let strain = quantity(&report, "max_plastic_strain");
    // 250 K stretch by (1 + nu) alpha dT in plane strain; no more can yield.
    let values = [0, 1, 2].map(|k| strain["values"][k].as_f64().unwrap());
    assert!(values.iter().all(|&value| value > 1e-3 && value < 1.33 * 23.1e-6 * 250.0), "{text}");
    assert!(quantity(&report, "energy.plastic_j")["own_error"].as_f64().unwrap() < 0.2, "{text}");
    // All runs yield at 100 MPa.
    assert!(!text.contains("max_von_mises_pa") && !text.contains("mass_kg"), "{text}");
    assert_eq!(report["commit"], welder::version::COMMIT);
}
