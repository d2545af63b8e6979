//! What the program says about its own exactness: pages of the book from a run, and advice before one.

use std::path::Path;
use std::process::{Command, Output};

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");

fn welder(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_welder")).args(arguments).output().expect("welder starts")
}

fn told(arguments: &[&str]) -> String {
    let output = welder(arguments);
    let text = [output.stdout, output.stderr].concat();
    let text = String::from_utf8(text).unwrap();
    assert!(output.status.success(), "{text}");
    text
}

#[test]
fn the_pages_of_the_book_hold_what_the_run_found() {
    let folder = tempfile::tempdir().unwrap();
    let [book, json] = ["validation", "verify.json"].map(|name| folder.path().join(name));
    let path = |path: &Path| path.to_str().unwrap().to_string();
    told(&[
        "verify",
        "heat/cosine-decay",
        "solid/gough-joule",
        "--level",
        "full",
        "--book",
        &path(&book),
        "--json",
        &path(&json),
    ]);
    let report: serde_json::Value = serde_json::from_slice(&std::fs::read(json).unwrap()).unwrap();
    let entries = report["entries"].as_array().unwrap();
    assert_eq!(entries.len(), 3);
    for entry in entries {
        let name = entry["name"].as_str().unwrap();
        let group = name.split('/').next().unwrap();
        let page = std::fs::read_to_string(book.join(format!("{group}.md"))).unwrap();
        for level in entry["levels"].as_array().unwrap() {
            let number = format!(
                "{}: {:.2e}",
                level["resolution"].as_f64().unwrap(),
                level["error"].as_f64().unwrap()
            );
            assert!(page.contains(&number), "{name}: {number} is not in:\n{page}");
        }
        assert!(page.contains("`welder verify heat/cosine-decay solid/gough-joule --level full`"), "{page}");
        assert!(page.contains(&format!("welder {}", welder::version::PROGRAM)), "{page}");
        assert_eq!(report["commit"], welder::version::COMMIT);
        assert!(book.join(format!("{group}-1.png")).is_file());
    }
}

#[test]
fn a_spot_is_advised() {
    let text = told(&["check", &format!("{CASES}/spot-aluminium")]);
    for words in [
        "matters        latent heat: Stefan",
        "bottom face: Fourier",
        "losses: Biot",
        "matters        flow: Marangoni flow outwards",
        "leave out      buoyancy: ",
        "which a card without volume_expansion_liquid_1_k leaves out",
    ] {
        assert!(text.contains(words), "`{words}` is not in:\n{text}");
    }
    assert!(!text.contains("movement: Peclet"), "a spot does not move:\n{text}");
}

#[test]
fn a_seam_moves_and_a_body_held_yields() {
    let text = told(&["check", &format!("{CASES}/seam-aluminium")]);
    assert!(text.contains("matters        movement: Peclet"), "{text}");
    let text = told(&["check", &format!("{CASES}/stress-spot-aluminium")]);
    assert!(text.contains("matters        stress: E alpha dT / yield"), "{text}");
    let weak = ["--set", "laser.path.pulse.power_w=20", "--set", "part.material=aluminium"];
    let text = told(&[&["check", &format!("{CASES}/spot-aluminium")], &weak[..]].concat());
    assert!(text.contains("leave out      evaporation"), "{text}");
    assert!(!text.contains("latent heat: Stefan"), "nothing melts:\n{text}");
}

#[test]
fn the_advice_is_proven_by_runs_with_and_without() {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("proof.json");
    let text = told(&[
        "check",
        &format!("{CASES}/spot-aluminium"),
        "--prove",
        "--json",
        json.to_str().unwrap(),
        "--set",
        "resolution.spacing_m=100e-6",
        "--set",
        "part.faces.top=Losses(convection_w_m2_k: 2000.0, emissivity: 1.0)",
    ]);
    assert!(
        text.contains("without: top convection_w_m2_k 0, emissivity 0")
            && text.contains("not run: the case does not list Flow()"),
        "{text}"
    );
    let report: serde_json::Value = serde_json::from_slice(&std::fs::read(json).unwrap()).unwrap();
    let change = |effect: &str, what: &str| {
        let findings = report["findings"].as_array().unwrap();
        let finding = findings.iter().find(|finding| finding["effect"] == effect).expect(effect);
        finding["compared"]["changes"][what].as_f64().unwrap_or_else(|| panic!("{effect} {what}: {finding}"))
    };
    // Without losses the surface is hotter, by less than the whole face as hot would lose; without latent heat more melts.
    let losses = change("losses", "peak_error");
    assert!(losses > 2e-3 && losses < 0.05, "{losses}");
    assert!(change("latent heat", "weld_error") > 0.03);
    assert!(
        change("levels", "width_error").abs() < 0.01 && change("bottom face", "depth_error").abs() < 0.01
    );
}

/// The sum of the files below a folder whose names end so \[bytes\].
fn bytes_below(folder: &Path, ending: &str) -> f64 {
    let of = |path: &Path| match path.is_dir() {
        true => bytes_below(path, ending),
        false if path.to_string_lossy().ends_with(ending) => path.metadata().unwrap().len() as f64,
        false => 0.0,
    };
    std::fs::read_dir(folder).unwrap().map(|entry| of(&entry.unwrap().path())).sum()
}

/// The numbers of the line that begins with a word.
fn numbers(text: &str, line: &str) -> Vec<f64> {
    let line = text.lines().find(|told| told.trim_start().starts_with(line)).expect(line);
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn disk_and_memory_are_forecast_within_a_factor_of_two() {
    let rows: [(&str, &[&str]); 5] = [
        ("spot-aluminium", &["resolution.spacing_m=100e-6", "time.stop_when_solid=false"]),
        ("flow-spot-aluminium", &["resolution.spacing_m=100e-6", "part.start_k=800", "time.end_s=2e-4"]),
        (
            "stress-spot-aluminium",
            &["resolution.spacing_m=200e-6", "time.end_s=5e-5", "output.frame_interval_s=1e-5"],
        ),
        ("fluid/dam-break", &["spacing_m=5.715e-3"]),
        ("solid/hot-spot", &["time.end_s=3e-5"]),
    ];
    for (case, settings) in rows {
        let case = format!("{CASES}/{case}");
        let settings: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
        let text = told(&[&["check", case.as_str()], settings.as_slice()].concat());
        let folder = tempfile::tempdir().unwrap();
        let out = ["--quiet", "--threads", "1", "--out", folder.path().to_str().unwrap()];
        told(&[&["run", case.as_str()], settings.as_slice(), &out].concat());
        let summary: serde_json::Value =
            serde_json::from_slice(&std::fs::read(folder.path().join("summary.json")).unwrap()).unwrap();
        let disk = numbers(&text, "disk");
        let [total, frames, frame, kept, checkpoint] = disk[..5] else { panic!("{disk:?}") };
        let memory = text.split(" MB of memory").next().unwrap().rsplit(' ').next().unwrap();
        let written = |ending: &str| 1e-6 * bytes_below(folder.path(), ending);
        for (what, forecast, found) in [
            ("disk", total, written("")),
            ("frames", frames * frame, written(".vtu")),
            ("checkpoints", kept * checkpoint, written(".bin")),
            ("memory", memory.parse().unwrap(), 1e-6 * summary["peak_memory_bytes"].as_f64().unwrap()),
        ] {
            println!(
                "{case}: {what} {forecast:.3} MB forecast, {found:.3} MB found: {:.2}",
                forecast / found
            );
            assert!(forecast / found > 0.5 && forecast / found < 2.0, "{case}, {what}:\n{text}");
        }
    }
}

#[test]
fn every_result_names_the_commit_of_its_program() {
    let text = told(&["--version"]);
    assert_eq!(text.trim(), format!("welder {}", welder::version::PROGRAM));
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let case = format!("{CASES}/spot-aluminium");
    told(&["run", &case, "--quiet", "--set", "resolution.spacing_m=200e-6", "--out", out]);
    let summary = std::fs::read(folder.path().join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_slice(&summary).unwrap();
    assert_eq!(summary["commit"], welder::version::COMMIT);
    assert!(summary["rejected_steps"].as_u64().is_some(), "{summary}");
}

#[test]
fn a_case_that_is_not_there_is_answered_with_a_short_list() {
    let output = welder(&["check", "spot-alumnium"]);
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("did you mean") && !text.contains(".."), "{text}");
    assert!(text.lines().any(|line| line.trim() == "hard/deep"), "{text}");
}
