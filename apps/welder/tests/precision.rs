//! The ladder of `welder precision`, from the command line to its files.

#[path = "support/good.rs"]
mod good;

use good::{MATERIAL, SCENE, spoken};
use std::path::Path;
use std::process::Command;

/// A block of 12 spacings with a wide beam, so that 1, 1.5 and 2 spacings divide it; it melts within a millisecond.
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
        "safety factor 1.25",
        "width, um",
        "peak, K rise",
        "weld, mm3",
        "cheapest within the wanted error of 0.5: `",
    ] {
        assert!(text.contains(words), "`{words}` is not in:\n{text}");
    }
    let out = folder.path().join("out");
    let table = std::fs::read_to_string(out.join("precision_convergence.csv")).unwrap();
    for row in table.lines().filter(|line| line.starts_with("default,")) {
        let cells: Vec<_> = row.split(',').collect();
        assert!(cells[4].parse::<f64>().unwrap() > 0.0, "nothing melted: {row}");
        // Without an order there is no estimate, and the verdict says so.
        assert_eq!(cells[5].is_empty(), cells[8].is_empty(), "{row}");
        assert!(!cells[5].is_empty() || cells[9] == "not in the asymptotic range", "{row}");
    }
    assert_eq!(table.lines().filter(|line| line.starts_with("default,")).count(), 5);
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
