//! `welder run` as its user meets it: exit codes, files, stop and resume, threads.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use welder::observe::{HistoryRow, Status, Summary, WeldOutcome, read_history};

/// A coarse spot that runs in a fraction of a second.
fn welder(out: &Path, arguments: &[&str]) -> Output {
    let spot = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/spot-aluminium");
    Command::new(env!("CARGO_BIN_EXE_welder"))
        .args(["run", spot, "--quiet", "--set", "resolution.spacing_m=100e-6", "--out"])
        .arg(out)
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("the program ends by itself")
}

fn read(path: PathBuf) -> Vec<u8> {
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The summary without what depends on the clock and the machine.
fn result(folder: &Path) -> Summary<WeldOutcome> {
    let summary = Summary::read(&folder.join("summary.json")).unwrap();
    let (wall_s, setup_s, particle_steps_per_s) = (0.0, 0.0, 0.0);
    Summary {
        wall_s,
        setup_s,
        particle_steps_per_s,
        cpu_s: None,
        threads: 0,
        peak_memory_bytes: None,
        ..summary
    }
}

fn same_results(one: &Path, other: &Path) {
    assert_eq!(result(one), result(other));
    assert_eq!(read(one.join("history.csv")), read(other.join("history.csv")));
    assert_eq!(read(one.join("frames.pvd")), read(other.join("frames.pvd")));
    let frames = |folder: &Path| {
        let mut names: Vec<_> =
            std::fs::read_dir(folder.join("frames")).unwrap().map(|f| f.unwrap().path()).collect();
        names.sort();
        names
    };
    let (first, second) = (frames(one), frames(other));
    assert!(first.len() > 5 && first.len() == second.len());
    for (first, second) in first.into_iter().zip(second) {
        assert_eq!(read(first), read(second));
    }
}

/// Runs a small spot with `settings` on one thread and on two, and with a stop at each of two times: all the same. Looks at what
/// came out.
fn the_same_however_it_is_run(settings: &[&str], stops: [&str; 2], look: impl Fn(&Path)) {
    let folder = tempfile::tempdir().unwrap();
    let [whole, two, halves] = ["whole", "two", "halves"].map(|name| folder.path().join(name));
    let small = ["part.size_m=(1.2e-3,1.2e-3,0.6e-3)"];
    let settings: Vec<&str> = small.iter().chain(settings).flat_map(|setting| ["--set", setting]).collect();
    let run = |out: &Path, more: &[&str]| code(&welder(out, &[settings.as_slice(), more].concat()));
    assert_eq!(run(&whole, &["--threads", "1"]), 0);
    assert_eq!(run(&two, &["--threads", "2"]), 0);
    same_results(&whole, &two);
    for until in stops {
        assert_eq!(run(&halves, &["--until", until]), 0);
        assert_eq!(run(&halves, &["--resume"]), 0);
        same_results(&whole, &halves);
    }
    look(&whole);
}

#[test]
fn stress_is_the_same_on_two_threads_and_after_a_stop() {
    let settings =
        ["laser.path.pulse.duration_s=0.002", "time.end_s=0.003", "physics=[Heat(),Stress(crossings: 0.3)]"];
    the_same_however_it_is_run(&settings, ["0.0011", "0.0023"], |whole| {
        let stress = result(whole).outcome.stress.expect("it is computed");
        assert!(stress.max_von_mises_pa > 1e7 && stress.max_plastic_strain > 1e-3, "{stress:?}");
        assert!(stress.max_principal_stress_pa > 1e7 && stress.min_principal_stress_pa < 0.0, "{stress:?}");
        let pictures =
            ["stress_x", "residual_stress_y", "principal_stress_x", "displacement_y", "plastic_strain_x"];
        pictures.iter().for_each(|name| assert!(whole.join(format!("{name}.png")).exists(), "{name}"));
        let last = read_history::<HistoryRow>(&whole.join("history.csv")).unwrap().pop().unwrap();
        assert_eq!(last.max_principal_stress_pa, Some(stress.max_principal_stress_pa));
        assert_eq!(last.min_principal_stress_pa, Some(stress.min_principal_stress_pa));
        assert_eq!(last.max_displacement_m, Some(stress.max_displacement_m));
    });
}

#[test]
fn flow_is_the_same_on_two_threads_and_after_a_stop() {
    let settings = [
        "part.low_corner_m=(-0.6e-3,-0.6e-3)",
        "part.start_k=700.0",
        "part.faces=()",
        "laser.path.pulse.duration_s=0.0008",
        "time.end_s=0.0012",
        "physics=[Heat(),Flow(viscosity_factor: 20.0)]",
    ];
    the_same_however_it_is_run(&settings, ["0.0005", "0.0009"], |whole| {
        let numbers = result(whole).numbers;
        assert!(numbers["reynolds"] > 0.1 && numbers["mach"] < 0.2, "{numbers:?}");
    });
}

#[test]
fn threads_and_interruptions_leave_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, two, halves] = ["whole", "two", "halves"].map(|name| folder.path().join(name));
    assert_eq!(code(&welder(&whole, &["--threads", "1"])), 0);
    assert_eq!(code(&welder(&two, &["--threads", "2"])), 0);
    same_results(&whole, &two);
    for until in ["0.004", "0.0123", "0.0161"] {
        assert_eq!(code(&welder(&halves, &["--until", until])), 0);
        assert_eq!(result(&halves).status, Status::Interrupted);
        assert_eq!(code(&welder(&halves, &["--resume"])), 0);
        same_results(&whole, &halves);
    }
    // A run that was stopped several times is no other run either.
    for until in ["0.002", "0.006", "0.0151"] {
        let resume: &[&str] = if until == "0.002" { &[] } else { &["--resume"] };
        assert_eq!(code(&welder(&halves, &[&["--until", until], resume].concat())), 0);
    }
    assert_eq!(code(&welder(&halves, &["--resume"])), 0);
    same_results(&whole, &halves);
}

#[test]
fn every_file_of_the_contract_is_there_and_the_ledger_is_closed() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(code(&welder(folder.path(), &[])), 0);
    for name in
        ["summary.json", "history.csv", "frames.pvd", "case.ron", "history.png", "top.png", "section_x.png"]
    {
        assert!(folder.path().join(name).exists(), "{name}");
    }
    let summary = result(folder.path());
    assert_eq!(summary.status, Status::Done);
    let weld = &summary.outcome;
    assert!(weld.energy.residual_rel.abs() < 1e-12, "{}", weld.energy.residual_rel);
    assert!((weld.energy.absorbed_j - 7.5).abs() < 1e-9 && (weld.energy.emitted_j - 18.75).abs() < 1e-9);
    assert!((weld.weld.width_m / weld.pool.max_width_m - 1.0).abs() < 0.01);
    assert!(weld.weld.volume_m3 > 1.5e-10 && weld.weld.volume_m3 < 2.5e-10, "{}", weld.weld.volume_m3);
    let rows: Vec<HistoryRow> = read_history(&folder.path().join("history.csv")).unwrap();
    assert!(rows.windows(2).all(|w| w[1].time_s > w[0].time_s && w[1].energy_in_j >= w[0].energy_in_j));
    assert!(rows.iter().any(|row| row.melt_volume_m3 > 1.5e-10));
    // The resolved case runs again, from anywhere, to the same end.
    let again = folder.path().join("again");
    let output = Command::new(env!("CARGO_BIN_EXE_welder"))
        .current_dir(folder.path())
        .args(["run", "case.ron", "--quiet", "--out", "again"])
        .output()
        .unwrap();
    assert_eq!(code(&output), 0, "{}", String::from_utf8_lossy(&output.stderr));
    let (first, second) = (result(folder.path()), result(&again));
    assert_eq!((first.outcome, first.steps), (second.outcome, second.steps));
}

#[test]
fn a_spent_step_budget_ends_with_3_and_a_dossier() {
    let folder = tempfile::tempdir().unwrap();
    let output = welder(folder.path(), &["--set", "budget.max_steps=20"]);
    assert_eq!(code(&output), 3);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("step budget of 20") && message.contains("budget.max_steps"), "{message}");
    assert!(folder.path().join("dossier.json").exists());
    assert_eq!(result(folder.path()).status, Status::Failed);
    assert_eq!(result(folder.path()).steps, 20);
}

#[test]
fn melt_beyond_a_fine_box_of_the_scene_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let small = "resolution.levels=FineBox(low_m: (0, 0, -4e-4), high_m: (4e-4, 4e-4, 0))";
    let output = welder(folder.path(), &["--set", small]);
    assert_eq!(code(&output), 3);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("coarser level") && message.contains("resolution.levels"), "{message}");
}

#[test]
fn resuming_needs_a_checkpoint_of_the_same_case() {
    let folder = tempfile::tempdir().unwrap();
    let none = welder(folder.path(), &["--resume"]);
    assert_eq!(code(&none), 2);
    assert!(String::from_utf8_lossy(&none.stderr).contains("no checkpoint"));
    assert_eq!(code(&welder(folder.path(), &["--until", "0.004"])), 0);
    let other = welder(folder.path(), &["--resume", "--set", "part.start_k=300"]);
    assert_eq!(code(&other), 2);
    assert!(
        String::from_utf8_lossy(&other.stderr).contains("case"),
        "{}",
        String::from_utf8_lossy(&other.stderr)
    );
}

#[test]
fn too_many_particles_end_with_2_before_anything_is_built() {
    let folder = tempfile::tempdir().unwrap();
    let output = welder(folder.path(), &["--set", "budget.max_particles=1000"]);
    assert_eq!(code(&output), 2);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("max_particles") && message.contains("spacing_m"), "{message}");
}

#[test]
fn a_keyhole_ends_the_run_with_a_status_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let power = "laser.path=Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 5.0e-3, power_w: 5000.0))";
    let arguments = ["--set", "part.material=\"aluminium\"", "--set", power];
    let output = welder(folder.path(), &arguments);
    let summary = result(folder.path());
    assert_eq!((code(&output), summary.status), (3, Status::DeepPenetration));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("deep penetration") && said.contains("boiling point of 2790 K"), "{said}");
    assert!(summary.numbers["recoil_over_tension"] > 1.0);
    let peak = summary.outcome.peak_temperature_k;
    assert!(peak > 2790.0 && peak < 3500.0, "it ends where it happens: {peak}");
    assert!(folder.path().join("history.csv").is_file());
}

#[test]
fn evaporation_takes_heat_that_the_ledger_knows() {
    let run = |top: &str| {
        let folder = tempfile::tempdir().unwrap();
        let top = format!("part.faces.top={top}");
        let output = welder(folder.path(), &["--set", "part.material=\"aluminium\"", "--set", &top]);
        assert_eq!(code(&output), 0, "{}", String::from_utf8_lossy(&output.stderr));
        result(folder.path()).outcome
    };
    let (dry, steaming) = (run("Adiabatic"), run("Losses(evaporation: true)"));
    println!(
        "evaporation: peak {:.0} K without, {:.0} K with",
        dry.peak_temperature_k, steaming.peak_temperature_k
    );
    assert_eq!(dry.energy.lost_j, 0.0);
    assert!(steaming.energy.lost_j > 0.0 && steaming.energy.residual_rel.abs() < 1e-12);
    assert!(steaming.peak_temperature_k < dry.peak_temperature_k - 1.0);
}
