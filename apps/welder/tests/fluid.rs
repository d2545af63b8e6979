//! Scenes of pure fluid from case files through the program: against exact solutions and experiments, the same bits on threads and
//! after a stop, failures with a name, wrong scenes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use welder::case::{Loaded, load_any};
use welder::fluid::{FluidFlow, FluidModel};
use welder::observe::{FluidOutcome, FluidRow, Status, Summary, read_history};

fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/fluid").join(name)
}

fn welder(case: &Path, out: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_welder"))
        .arg("run")
        .arg(case)
        .args(["--quiet", "--out"])
        .arg(out)
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn summary(out: &Path) -> Summary<FluidOutcome> {
    Summary::read(&out.join("summary.json")).unwrap()
}

/// Runs a case to its end; its history and summary.
fn done(case: &Path, arguments: &[&str]) -> (Vec<FluidRow>, Summary<FluidOutcome>) {
    let folder = tempfile::tempdir().unwrap();
    let output = welder(case, folder.path(), arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let summary = summary(folder.path());
    assert_eq!(summary.status, Status::Done);
    (read_history(&folder.path().join("history.csv")).unwrap(), summary)
}

/// A scene of its own in a folder of its own.
fn scene(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.ron");
    std::fs::write(&path, text).unwrap();
    (folder, path)
}

#[test]
fn the_front_of_the_dam_break_is_that_of_martin_and_moyce() {
    let settings = ["--set", "spacing_m=5.715e-3", "--set", "output.history_interval_s=1e-3"];
    let (rows, summary) = done(&case("dam-break"), &settings);
    let (width, gravity) = (0.05715, 9.81_f64);
    let errors = sph_fluid::benchmarks::dam::FRONT.map(|(time, place)| {
        let time = time * (width / (2.0 * gravity)).sqrt();
        let after = rows.partition_point(|row| row.time_s < time).max(1);
        let (low, high) = (&rows[after - 1], &rows[after]);
        let share = (time - low.time_s) / (high.time_s - low.time_s);
        let front = low.x_max_m + share * (high.x_max_m - low.x_max_m);
        front / width / place - 1.0
    });
    let mean = errors.iter().map(|error| error.abs()).sum::<f64>() / 7.0;
    println!("dam break, 10 across: front over the experiment's, less one: {errors:.3?}, mean {mean:.3}");
    assert!(mean < 0.06, "{errors:?}");
    // The last is late by more than the 10 % of the others: friction by numerics, a known miss of the book's page on validation.
    assert!(errors[..6].iter().all(|error| error.abs() < 0.1) && errors[6].abs() < 0.12, "{errors:?}");
    // What falls is what moves and what friction takes.
    let (first, last, energy) = (&rows[0], rows.last().unwrap(), &summary.outcome.energy);
    let released = first.potential_j - last.potential_j;
    println!("  energy: released {released:.4}, {energy:?}");
    assert!((first.potential_j / (summary.outcome.mass_kg * gravity * width) - 1.0).abs() < 1e-3);
    assert!((released / (energy.kinetic_j + energy.friction_j) - 1.0).abs() < 0.05);
    assert!(energy.residual_rel.abs() < 0.05, "{}", energy.residual_rel);
}

#[test]
fn a_drop_has_the_pressure_of_its_surface() {
    let (rows, summary) = done(&case("drop"), &["--set", "time.end_s=0.4"]);
    let late: Vec<f64> = rows.iter().filter(|row| row.time_s > 0.2).map(|row| row.mean_pressure_pa).collect();
    let pressure = late.iter().sum::<f64>() / late.len() as f64 / (0.0206 / 5e-3);
    let capillary = 0.019 * rows.last().unwrap().max_speed_m_s / 0.0206;
    println!("drop, R/dx 10: pressure over tau/R {pressure:.4}, eta u/tau {capillary:.1e}");
    assert!((pressure - 1.0).abs() < 0.02, "{pressure}");
    assert!(capillary < 1e-3, "{capillary}");
    let volume = summary.outcome.mass_kg / 950.0;
    assert!((volume / (std::f64::consts::PI * 25e-6) - 1.0).abs() < 0.011, "{volume}");
}

/// Birikh's (1966) flow between plates of a slope of temperature along them, u(y) = U (2 y^3 - 3 y^2 + y)/12 with U =
/// g beta G H^3/nu, in the middle of a closed trough.
#[test]
fn a_layer_that_is_warm_at_one_end_flows_as_birikh_says() {
    let Loaded::Fluid(case) = load_any(&case("warm-layer"), &[]).unwrap() else { panic!("a fluid") };
    let mut layer = FluidFlow::<2>::new(FluidModel::from_case(&case).unwrap()).unwrap();
    let (fluid, depth, rows) = (&case.scene.fluid, 10e-3, 8);
    let unit = 9.81 * fluid.volume_expansion_1_k * 200.0 * depth * depth * depth * fluid.density_kg_m3
        / fluid.viscosity_pa_s;
    let exact = |y: f64| unit / 12.0 * (2.0 * y * y * y - 3.0 * y * y + y);
    let mut sums = vec![[0.0; 3]; rows];
    while layer.time() < 0.4 {
        layer.stride(0.4).unwrap();
        // From 0.12 H^2/nu on the slowest part of the start has fallen below a hundredth.
        let late = layer.time() > 0.2;
        for (place, velocity) in layer.positions().iter().zip(layer.velocities()) {
            let y = place.y / depth;
            if late && (place.x - 25e-3).abs() < 5e-3 {
                let row = &mut sums[((y * rows as f64) as usize).min(rows - 1)];
                *row = [row[0] + 1.0, row[1] + velocity.x, row[2] + exact(y)];
            }
        }
    }
    let profile: Vec<[f64; 2]> =
        sums.iter().map(|[count, found, exact]| [found / count, exact / count]).collect();
    let sum = |of: fn(&[f64; 2]) -> f64| profile.iter().map(of).sum::<f64>();
    let square = sum(|[_, exact]| exact * exact);
    let strength = sum(|[found, exact]| found * exact) / square;
    let shape = (sum(|[found, exact]| (found - exact) * (found - exact)) / square).sqrt();
    let ledger = layer.ledger();
    println!("warm layer, 8 rows: {strength:.3} of Birikh's flow, off by {shape:.3} of it; {ledger:?}");
    assert!((strength - 1.0).abs() < 0.2 && shape < 0.3, "{profile:?}");
    // Expansion deep down and contraction high up drive the layer: friction has what they gave.
    assert!(((ledger.friction + ledger.kinetic) / ledger.expansion - 1.0).abs() < 0.1, "{ledger:?}");
}

/// A ball of R = rho = tau = 1, six spacings to the radius.
const BALL: &str = "Fluid(domain: (low_m: (-1.5, -1.5, -1.5), size_m: (3, 3, 3)), \
    fluid: (density_kg_m3: 1.0, viscosity_pa_s: 0.05, surface_tension_n_m: 1.0, sound_speed_m_s: 15.0), \
    bodies: [Ball(centre_m: (0, 0, 0), radius_m: 1)], spacing_m: 0.16666666666666666, \
    scheme: (artificial_viscosity: 0.1), time: (end_s: 4.0))";

#[test]
fn a_ball_in_space_has_twice_the_pressure_of_its_curvature() {
    let (_folder, path) = scene(BALL);
    let (rows, summary) = done(&path, &[]);
    let late: Vec<f64> = rows.iter().filter(|row| row.time_s > 2.0).map(|row| row.mean_pressure_pa).collect();
    let pressure = late.iter().sum::<f64>() / late.len() as f64 / 2.0;
    println!("ball, R/dx 6: pressure over 2 tau/R {pressure:.4}");
    assert_eq!(summary.dimension, 3);
    assert!((pressure - 1.0).abs() < 0.04, "{pressure}");
}

/// u(z, t) over tau_T G H/eta of a film that a steady shear stress starts at t = 0, for z over H and t over H^2/nu (Carslaw and
/// Jaeger 1959, section 3.8, for heat).
fn started_film(z: f64, t: f64) -> f64 {
    let term = |n: i32| {
        let odd = f64::from(2 * n + 1) * std::f64::consts::FRAC_PI_2;
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        2.0 * sign / (odd * odd) * (odd * z).sin() * (-odd * odd * t).exp()
    };
    z - (0..40).map(term).sum::<f64>()
}

#[test]
fn the_surface_of_a_film_runs_with_the_speed_that_its_tension_drives() {
    let (rows, summary) = done(&case("film"), &[]);
    let (depth, viscosity, density) = (1e-3, 0.019, 950.0);
    let unit = 6e-5 * 1000.0 * depth / viscosity;
    // The fastest particles are those of the upper row, half a spacing below the surface.
    let exact = started_film(1.0 - 0.5 / 8.0, 0.1 * viscosity / density / (depth * depth));
    let speed = rows.last().unwrap().max_speed_m_s / unit / exact;
    println!("film of 8 rows: speed of the upper row over the exact one {speed:.4}");
    assert!((speed - 1.0).abs() < 0.02, "{speed}");
    let energy = &summary.outcome.energy;
    println!("  energy: {energy:?}");
    assert!(((energy.kinetic_j + energy.friction_j) / energy.driven_j - 1.0).abs() < 0.01, "{energy:?}");
}

/// The summary without what depends on the clock and the machine.
fn result(out: &Path) -> Summary<FluidOutcome> {
    let (wall_s, setup_s, particle_steps_per_s) = (0.0, 0.0, 0.0);
    Summary {
        wall_s,
        setup_s,
        particle_steps_per_s,
        cpu_s: None,
        threads: 0,
        peak_memory_bytes: None,
        ..summary(out)
    }
}

/// Names and bytes of history and frames.
fn files(out: &Path) -> Vec<(String, Vec<u8>)> {
    let frames = std::fs::read_dir(out.join("frames")).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = frames.chain(["history.csv", "frames.pvd"].map(|name| out.join(name))).collect();
    files.sort();
    let named =
        |path: &PathBuf| (path.file_name().unwrap().to_string_lossy().into(), std::fs::read(path).unwrap());
    files.iter().map(named).collect()
}

fn the_same_however_it_is_run(case: &Path, settings: &[&str], stops: [&str; 2]) {
    let folder = tempfile::tempdir().unwrap();
    let [whole, two, halves] = ["whole", "two", "halves"].map(|name| folder.path().join(name));
    let settings: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
    let run = |out: &Path, more: &[&str]| {
        let output = welder(case, out, &[settings.as_slice(), more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    };
    run(&whole, &["--threads", "1"]);
    run(&two, &["--threads", "2"]);
    assert_eq!(result(&whole), result(&two));
    assert_eq!(files(&whole), files(&two));
    assert!(files(&whole).len() > 10);
    for until in stops {
        run(&halves, &["--until", until, "--threads", "2"]);
        assert_eq!(result(&halves).status, Status::Interrupted);
        run(&halves, &["--resume", "--threads", "1"]);
        assert_eq!(result(&whole), result(&halves));
        assert_eq!(files(&whole), files(&halves));
    }
}

#[test]
fn a_dam_break_is_the_same_on_two_threads_and_after_a_stop() {
    let settings = ["spacing_m=5.715e-3", "time.end_s=0.12", "scheme.shifting=1"];
    the_same_however_it_is_run(&case("dam-break"), &settings, ["0.031", "0.0777"]);
}

#[test]
fn a_film_that_repeats_is_the_same_on_two_threads_and_after_a_stop() {
    // Off the origin, so that wrapping rounds.
    let settings = [
        "time.end_s=0.05",
        "domain.low_m=(-0.5e-3,0)",
        "bodies.0.low_m=(-0.5e-3,0)",
        "bodies.0.high_m=(1e-3,1e-3)",
    ];
    the_same_however_it_is_run(&case("film"), &settings, ["0.0123", "0.04"]);
}

#[test]
fn a_ball_is_the_same_on_two_threads_and_after_a_stop() {
    let (_folder, path) = scene(BALL);
    the_same_however_it_is_run(&path, &["time.end_s=0.5"], ["0.1", "0.37"]);
}

/// Runs a scene that must fail; what it said, and its dossier.
fn failed(case: &Path, settings: &[&str]) -> (String, serde_json::Value, bool) {
    let folder = tempfile::tempdir().unwrap();
    let settings: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
    let output = welder(case, folder.path(), &settings);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(3), "{message}");
    assert_eq!(summary(folder.path()).status, Status::Failed);
    let dossier = std::fs::read(folder.path().join("dossier.json")).unwrap();
    (message, serde_json::from_slice(&dossier).unwrap(), folder.path().join("dossier.vtu").exists())
}

#[test]
fn fluid_that_leaves_by_an_open_side_ends_with_3_and_a_dossier() {
    let settings = ["spacing_m=5.715e-3", "domain.size_m=(0.1143,0.17145)", "domain.sides.x_max=Open"];
    let (message, dossier, neighbourhood) = failed(&case("dam-break"), &settings);
    assert!(message.contains("open side x_max") && message.contains("larger domain"), "{message}");
    let place = dossier["position_m"][0].as_f64().unwrap();
    assert!((place - 0.1143).abs() < 0.01 && neighbourhood, "{dossier}");
    assert!(dossier["time_s"].as_f64().unwrap() > 0.03 && dossier["dt_limit"] == "sound", "{dossier}");
    assert!(dossier["particles_in_neighbourhood"].as_u64().unwrap() > 10, "{dossier}");
    assert!(dossier["values"]["velocity_m_s"][0].as_f64().unwrap() > 0.5, "{dossier}");
}

#[test]
fn fluid_that_leaks_through_a_wall_ends_with_3_and_names_it() {
    // A film of one row forgets where its wall is, without the pull of densities and all that calms it.
    let bare = ["scheme.density_pull=0", "scheme.artificial_viscosity=0", "scheme.density_diffusion=0"];
    let (message, dossier, neighbourhood) =
        failed(&case("dam-break"), &[["spacing_m=5.715e-3"].as_slice(), &bare].concat());
    assert!(message.contains("through the wall y_min"), "{message}");
    let depth = -dossier["position_m"][1].as_f64().unwrap() / 5.715e-3;
    assert!(depth > 0.5 && depth < 0.7 && neighbourhood, "{dossier}");
    assert!(dossier["try_next"][0].as_str().unwrap().contains("density_pull"), "{dossier}");
}

#[test]
fn a_check_tells_what_the_scene_will_be() {
    let output =
        Command::new(env!("CARGO_BIN_EXE_welder")).arg("check").arg(case("dam-break")).output().unwrap();
    let told = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{told}");
    // 20 x 40 cells; 1.498 = sqrt(2 g H) m/s, and ten times that.
    let words =
        ["800 of fluid", "1.498e0 m/s expected", "sound 1.498e1", "sound rules", "forecast", "mach 0.100"];
    words.iter().for_each(|word| assert!(told.contains(word), "`{word}` is not in:\n{told}"));
}

#[test]
fn the_resolved_scene_gives_the_same_run() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
    let short = ["--set", "time.end_s=0.01"];
    assert_eq!(welder(&case("film"), &first, &short).status.code(), Some(0));
    assert_eq!(welder(&first.join("case.ron"), &second, &[]).status.code(), Some(0));
    assert_eq!(files(&first), files(&second));
}

#[test]
fn what_only_a_weld_has_is_refused() {
    for options in [["--vary", "scheme.shifting=0,1"], ["--wanted-error", "0.01"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
        let output = command.arg("precision").arg(case("film")).args(options).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains("for welds"), "{message}");
    }
}
