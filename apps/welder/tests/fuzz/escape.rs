//! Scenes that try to write where they should not.

use crate::good::{MATERIAL, SCENE, spoken};
use crate::{fluid, solid};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A scene of a few particles that runs in no time and writes everything.
fn scene() -> String {
    SCENE
        .replace("6.0e-3, 4.0e-3, 3.0e-3", "1.2e-3, 1.2e-3, 1.2e-3")
        .replace(
            "regions: [(low_m: (0.0, 0.0, -1.0e-3), high_m: (1.0e-3, 1.0e-3, 0.0), start_k: 400.0)],",
            "",
        )
        .replace("50.0e-6", "200.0e-6")
        .replace("duration_s: 0.015", "duration_s: 1e-4")
        .replace("end_s: 0.03", "end_s: 2e-4")
        .replace("frame_interval_s: 1.0e-3", "frame_interval_s: 1.0e-4")
}

/// A scene of each kind, so short that it runs in no time; all name the field `FIELD`.
fn scenes() -> [String; 3] {
    let with_field = |scene: &str, end: &str| {
        let changed = scene.replace(end, "time: (end_s: 1e-6), output: (fields: [\"FIELD\"]),");
        assert_ne!(scene, changed);
        changed
    };
    [
        scene().replace("temperature_k", "FIELD"),
        with_field(fluid::GOOD, "time: (end_s: 0.5),"),
        with_field(solid::GOOD, "time: (end_s: 7.0e-5),"),
    ]
}

/// The same with a field that they have.
fn good_scenes() -> [String; 3] {
    let [weld, fluid, solid] = scenes();
    let moving = |scene: String| scene.replace("FIELD", "velocity_m_s");
    [weld.replace("FIELD", "temperature_k"), moving(fluid), moving(solid)]
}

/// Every file and folder below a folder.
fn files(folder: &Path) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        }
        found.insert(path);
    }
    found
}

/// Runs a case from `box/work`; whatever is new in the whole box must lie in one folder below `box/work/out`.
#[track_caller]
fn stays_inside(case: &str, scene: &str) {
    let folder = tempfile::tempdir().unwrap();
    let work = folder.path().join("box/work");
    let path = work.join(case);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::create_dir_all(work.join("materials")).unwrap();
    for card in ["box/escape.ron", "box/work/materials/metal.ron"] {
        std::fs::write(folder.path().join(card), MATERIAL).unwrap();
    }
    std::fs::write(&path, scene).unwrap();
    let before = files(folder.path());
    let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
    command.current_dir(&work).args(["run", "--quiet", "--threads", "1", case]);
    let (code, message) = spoken(&command.output().unwrap());
    assert!(matches!(code, Some(0 | 2)), "{case}: {message}");
    let new: Vec<_> = files(folder.path()).difference(&before).cloned().collect();
    assert_eq!(code == Some(0), !new.is_empty(), "{case}: {message}");
    let out = work.join("out");
    let results: BTreeSet<_> = new
        .iter()
        .filter(|path| **path != out)
        .map(|path| path.strip_prefix(&out).unwrap_or_else(|_| panic!("{case}: {}", path.display())))
        .map(|path| path.components().next().unwrap().as_os_str().to_owned())
        .collect();
    assert!(results.len() <= 1, "{case}: {results:?}");
}

#[test]
fn names_of_files_cannot() {
    for case in [
        "a.ron",
        "...ron",
        "..ron",
        ".ron",
        "scene.ron",
        "deep/../b.ron",
        "-.ron",
        "é ü.ron",
        "a\nb.ron",
        "CON.ron",
    ] {
        good_scenes().iter().for_each(|scene| stays_inside(case, scene));
    }
    stays_inside(
        "deep/case/../case/scene.ron",
        &scene().replace("\"metal\"", "\"../../materials/metal.ron\""),
    );
}

#[test]
fn titles_cannot() {
    for title in ["../../escape", "/tmp/escape", "a/b\\\\c", "..", "<x>&amp;]]>\\u{0}\\u{7f}", "C:\\\\escape"]
    {
        good_scenes().iter().for_each(|scene| stays_inside("a.ron", &scene.replace("a test", title)));
    }
}

#[test]
fn names_of_materials_cannot() {
    for material in [
        "../escape.ron",
        "materials/../../escape.ron",
        "materials/../materials/metal.ron",
        "../../escape",
        "..",
    ] {
        stays_inside("a.ron", &scene().replace("\"metal\"", &format!("\"{material}\"")));
    }
    // A card inside the scene under a name that is a path.
    for name in ["../../escape", "/etc/escape", "..", "a\\\"b"] {
        let inside = scene()
            .replace("\"metal\"", &format!("\"{name}\""))
            .replace("budget:", &format!("materials: {{\"{name}\": {}}}, budget:", MATERIAL.trim_end()));
        stays_inside("a.ron", &inside);
    }
}

#[test]
fn names_of_fields_cannot() {
    for field in ["../../escape", "temperature_k/../../escape", "/escape"] {
        scenes().iter().for_each(|scene| stays_inside("a.ron", &scene.replace("FIELD", field)));
    }
}

/// A scene cannot make links, but the folder that it comes in may hold some. A link in the place of a file is replaced, and what it
/// points to stays; a folder that is a link was put there by who wants the results elsewhere: it is followed, and only frames and
/// checkpoints are written or removed in it.
#[cfg(unix)]
#[test]
fn links_in_the_folder_of_results_lead_no_file_outside() {
    use std::os::unix::fs::symlink;
    const FILES: [&str; 8] = [
        "history.csv",
        "summary.json",
        "summary.json.partial",
        "case.ron",
        "frames.pvd",
        "history.png",
        "section_x.png",
        "dossier.json",
    ];
    let [weld, ..] = good_scenes();
    let folder = tempfile::tempdir().unwrap();
    let [out, mine, elsewhere] = ["work/out/a", "mine", "elsewhere"].map(|name| folder.path().join(name));
    [&out, &elsewhere].into_iter().for_each(|folder| std::fs::create_dir_all(folder).unwrap());
    std::fs::write(&mine, b"mine").unwrap();
    std::fs::write(elsewhere.join("notes.txt"), b"mine").unwrap();
    FILES.iter().for_each(|file| symlink(&mine, out.join(file)).unwrap());
    symlink(&elsewhere, out.join("frames")).unwrap();
    let work = folder.path().join("work");
    std::fs::create_dir(work.join("materials")).unwrap();
    std::fs::write(work.join("materials/metal.ron"), MATERIAL).unwrap();
    std::fs::write(work.join("a.ron"), weld).unwrap();
    for more in [["--until", "1e-4"].as_slice(), &["--resume"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
        command.current_dir(&work).args(["run", "--quiet", "--threads", "1", "a.ron"]).args(more);
        let (code, message) = spoken(&command.output().unwrap());
        assert_eq!(code, Some(0), "{message}");
        assert_eq!(std::fs::read(&mine).unwrap(), b"mine");
        assert!(!out.join("history.csv").is_symlink() && !out.join("summary.json").is_symlink());
    }
    assert_eq!(std::fs::read(elsewhere.join("notes.txt")).unwrap(), b"mine");
    let names = |folder: &Path| files(folder).into_iter().map(|path| path.file_name().unwrap().to_owned());
    let frame = |name: &std::ffi::OsString| name.to_string_lossy().starts_with("frame_");
    assert!(names(&elsewhere).all(|name| name == "notes.txt" || frame(&name)));
    assert!(names(&elsewhere).filter(frame).count() > 1);
}
