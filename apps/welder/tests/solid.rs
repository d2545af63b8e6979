//! Scenes of elastic bodies from case files through the program: rings that collide, a beam that swings, the same bits on threads and
//! after a stop, failures with a name.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use welder::observe::{SolidOutcome, SolidRow, Status, Summary, read_history};

fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/solid").join(name)
}

fn welder(case: &Path, out: &Path, settings: &[&str], more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
    command.arg("run").arg(case).args(["--quiet", "--out"]).arg(out).args(more);
    settings.iter().for_each(|setting| {
        command.args(["--set", setting]);
    });
    command.output().expect("the program starts")
}

fn summary(out: &Path) -> Summary<SolidOutcome> {
    Summary::read(&out.join("summary.json")).unwrap()
}

fn done(case: &Path, settings: &[&str]) -> (Vec<SolidRow>, Summary<SolidOutcome>) {
    let folder = tempfile::tempdir().unwrap();
    let output = welder(case, folder.path(), settings, &[]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    (read_history(&folder.path().join("history.csv")).unwrap(), summary(folder.path()))
}

#[test]
fn rings_collide_part_and_stay_whole_with_artificial_stress_only() {
    let (rows, summary) = done(&case("rings"), &["spacing_m=2e-3"]);
    let (first, outcome) = (&rows[0], &summary.outcome);
    assert_eq!((first.pieces, outcome.pieces), (2, 2));
    // Each ring is pi (R^2 - r^2) rho, and starts with half m v^2.
    let mass = 1200.0 * std::f64::consts::PI * (0.04_f64.powi(2) - 0.03_f64.powi(2));
    assert!((outcome.mass_kg / (2.0 * mass) - 1.0).abs() < 0.01, "{}", outcome.mass_kg);
    assert!((first.kinetic_j / (0.5 * outcome.mass_kg * 49.0) - 1.0).abs() < 1e-12);
    let momentum = outcome.momentum_kg_m_s.iter().map(|p| p * p).sum::<f64>().sqrt() / (mass * 7.0);
    println!("rings: momentum {momentum:.1e} of one ring's, {:?}", outcome.energy);
    assert!(momentum < 1e-12, "{momentum}");
    // They meet, and have less kinetic energy when they are gone.
    let deepest = rows.iter().map(|row| row.x_max_m - row.x_min_m).fold(f64::INFINITY, f64::min);
    assert!(deepest < 0.145 && rows.last().unwrap().x_max_m > 0.08, "{deepest}");
    assert!(outcome.energy.residual_rel > 0.0 && outcome.energy.residual_rel < 0.7, "{:?}", outcome.energy);
    let (_, broken) = done(&case("rings"), &["spacing_m=2e-3", "scheme.artificial_stress=0"]);
    println!("rings without artificial stress: {} pieces", broken.outcome.pieces);
    assert!(broken.outcome.pieces > 2);
}

#[test]
fn a_plate_swings_with_a_period_near_timoshenkos() {
    let settings = ["time.end_s=0.16", "output.history_interval_s=2e-4"];
    let (rows, summary) = done(&case("plate"), &settings);
    let lowest = rows.iter().min_by(|a, b| a.y_min_m.total_cmp(&b.y_min_m)).unwrap();
    let period = 2.0 * lowest.time_s / (1.0096 * 0.254_13);
    // Twice the sag of a thin plate.
    let modulus = 1.99845e6 / (1.0 - 0.3975_f64.powi(2));
    let sag = 3.0 * 1000.0 * 0.2_f64.powi(4) / (modulus * 0.02_f64.powi(2));
    let depth = (-0.01 - lowest.y_min_m) / sag;
    println!(
        "plate, 10 across: half a period over Timoshenko's {period:.3}, depth over twice the sag {depth:.3}"
    );
    // Too soft at this resolution, as the crate's own benchmark of this form (1.08): 3 % is wanted, a known miss of the book's page on
    // validation. Both numbers are held where they are.
    assert!((period - 1.0).abs() < 0.09, "{period}");
    assert!((depth - 1.0).abs() < 0.2, "{depth}");
    assert!(summary.outcome.energy.residual_rel.abs() < 0.02, "{:?}", summary.outcome.energy);
    assert_eq!(summary.outcome.low_m[0], -0.008);
}

/// The same on one thread, on two, and after a stop.
#[test]
fn rings_are_the_same_on_two_threads_and_after_a_stop() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, two, halves] = ["whole", "two", "halves"].map(|name| folder.path().join(name));
    let settings = ["spacing_m=2e-3", "time.end_s=0.006"];
    let run = |out: &Path, more: &[&str]| {
        let output = welder(&case("rings"), out, &settings, more);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    };
    run(&whole, &["--threads", "1"]);
    run(&two, &["--threads", "2"]);
    run(&halves, &["--until", "0.0031", "--threads", "2"]);
    assert_eq!(summary(&halves).status, Status::Interrupted);
    run(&halves, &["--resume", "--threads", "1"]);
    for other in [&two, &halves] {
        assert_eq!(summary(&whole).outcome, summary(other).outcome);
        assert_eq!(summary(&whole).pair_visits, summary(other).pair_visits);
        let frames = std::fs::read_dir(whole.join("frames")).unwrap().map(|entry| entry.unwrap().path());
        for file in frames.chain([whole.join("history.csv")]) {
            let there = other.join(file.strip_prefix(&whole).unwrap());
            assert_eq!(std::fs::read(&file).unwrap(), std::fs::read(&there).unwrap(), "{}", file.display());
        }
    }
}

#[test]
fn a_ball_in_space_falls_as_galileo_says() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.ron");
    let text = "Solid(material: (density_kg_m3: 1000.0, young_pa: 1e6, poisson: 0.3), \
        bodies: [Ring(centre_m: (0, 0, 0), outer_radius_m: 0.05, velocity_m_s: (1, 0, 0))], \
        gravity_m_s2: (0, 0, -10), spacing_m: 0.0125, time: (end_s: 0.05))";
    std::fs::write(&path, text).unwrap();
    let (rows, summary) = done(&path, &[]);
    let (first, last) = (&rows[0], rows.last().unwrap());
    assert_eq!(summary.dimension, 3);
    assert!((last.x_max_m - first.x_max_m - 0.05).abs() < 1e-9);
    assert!((last.z_max_m.unwrap() - first.z_max_m.unwrap() + 0.0125).abs() < 1e-9);
    assert!(last.energy_residual_rel.abs() < 1e-9 && last.max_von_mises_pa < 1.0, "{last:?}");
}

#[test]
fn a_spent_step_budget_ends_with_3_and_a_dossier() {
    let folder = tempfile::tempdir().unwrap();
    let output = welder(&case("rings"), folder.path(), &["budget.max_steps=100"], &[]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{message}");
    assert!(message.contains("step budget") && folder.path().join("dossier.json").exists(), "{message}");
    assert_eq!(summary(folder.path()).status, Status::Failed);
}

#[test]
fn wrong_scenes_name_place_field_and_remedy() {
    let rows: [(&str, &str, &[&str]); 9] = [
        ("poisson: 0.3975", "poisson: 0.5", &["material.poisson", "0 to 0.495"]),
        ("young_pa: 1.0e7", "young_pa: -1.0e7", &["material.young_pa", "negative"]),
        ("density_kg_m3: 1200.0", "density: 1200.0", &["material.density", "did you mean `density_kg_m3`"]),
        ("centre_m: (0.0415, 0.0)", "centre_m: (0.0, 0.0)", &["bodies.1", "overlaps with bodies.0"]),
        ("(7.0, 0.0)", "(70.0, 0.0)", &["bodies.0.velocity_m_s", "sqrt(E/rho)", "at most 45.64"]),
        ("(7.0, 0.0)", "(7.0, 0.0, 0.0)", &["bodies.0.velocity_m_s", "3 numbers", "2 dimensions"]),
        ("spacing_m: 1.0e-3", "spacing_m: 3.0e-3", &["bodies.0.outer_radius_m", "spacings thick", "2.5e-3"]),
        ("form: Paper", "form: Papers", &["scheme.form", "`Paper`"]),
        (
            "spacing_m: 1.0e-3",
            "held: [(low_m: (1.0, 1.0), high_m: (2.0, 2.0))], spacing_m: 1.0e-3",
            &["held.0", "holds nothing"],
        ),
    ];
    let good = std::fs::read_to_string(case("rings").join("scene.ron")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.ron");
    for (from, to, words) in rows {
        assert!(good.contains(from), "{from}");
        std::fs::write(&path, good.replacen(from, to, 1)).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_welder")).arg("check").arg(&path).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{to}: {message}");
        for word in words.iter().copied().chain(["scene.ron:"]) {
            assert!(message.contains(word), "{to}: `{word}` is not in:\n{message}");
        }
    }
}
