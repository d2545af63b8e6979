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
