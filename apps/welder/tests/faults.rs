//! Runs that die: killed at any time, out of room, in folders that refuse. Nothing is lost silently, and what goes on
//! afterwards has the bits of a run that never stopped.

use rand::Rng;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use welder::observe::{Checkpoint, Status, Summary, WeldOutcome};

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");
const SPOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/spot-aluminium");

/// A coarse run with many checkpoints, that takes a fraction of a second.
struct Short {
    case: &'static str,
    threads: &'static str,
    settings: &'static [&'static str],
}

const HEAT: Short = Short {
    case: "spot-aluminium",
    threads: "1",
    settings: &["resolution.spacing_m=100e-6", "output.checkpoint_interval_s=1e-3"],
};

/// Melt flows after the first half.
const FLOW: Short = Short {
    case: "flow-spot-aluminium",
    threads: "1",
    settings: &[
        "resolution.spacing_m=100e-6",
        "part.start_k=800",
        "time.end_s=3e-4",
        "output.frame_interval_s=3e-5",
        "output.checkpoint_interval_s=3e-5",
    ],
};

/// Bodies in the total-Lagrangian form that are heated and yield.
const SOLID: Short = Short {
    case: "solid/hot-spot",
    threads: "1",
    settings: &["time.end_s=2e-5", "output.checkpoint_interval_s=2e-6"],
};

const FLUID: Short = Short {
    case: "fluid/dam-break",
    threads: "2",
    settings: &["spacing_m=5.715e-3", "time.end_s=0.1", "output.checkpoint_interval_s=0.01"],
};

impl Short {
    fn command(&self, out: &Path) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
        command.arg("run").arg(Path::new(CASES).join(self.case)).args(["--quiet", "--threads", self.threads]);
        self.settings.iter().for_each(|setting| {
            command.args(["--set", setting]);
        });
        command.args(["--set", "output.pictures=false"]).arg("--out").arg(out);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    }

    /// Starts the run of a folder, or goes on with it where there is something to go on from.
    fn start(&self, folder: &Path) -> Child {
        let mut command = self.command(folder);
        if has_checkpoint(folder) {
            command.arg("--resume");
        }
        command.spawn().expect("the program starts")
    }

    /// Kills it so many times at random; whenever it comes to its end, its results have the bits of a run that was not.
    fn survives(&self, wanted: usize) {
        let folder = tempfile::tempdir().unwrap();
        let [whole, killed] = ["whole", "killed"].map(|name| folder.path().join(name));
        let clock = Instant::now();
        assert!(self.command(&whole).status().unwrap().success());
        let span = clock.elapsed();
        let expected = results(&whole);
        assert!(expected.len() > 10);
        let mut random = Pcg64Mcg::seed_from_u64(50);
        let (mut kills, mut ends) = (0, 0);
        while kills < wanted || ends == 0 {
            let mut child = self.start(&killed);
            // Many kills come soon after the start, so that starting and resuming are hit as often as running.
            let longest = if kills < wanted { span.mul_f64(1.2) } else { Duration::from_secs(600) };
            std::thread::sleep(longest.mul_f64(random.random_range(0.0..1.0_f64).powi(2)).min(span * 2));
            if kills < wanted && child.try_wait().unwrap().is_none() {
                child.kill().unwrap();
                child.wait().unwrap();
                kills += 1;
                continue;
            }
            assert!(child.wait().unwrap().success(), "{} after {kills} kills", self.case);
            assert_eq!(results(&killed), expected, "{} after {kills} kills", self.case);
            ends += 1;
            std::fs::remove_dir_all(&killed).unwrap();
        }
        println!("{}: {kills} kills, {ends} runs came to their end", self.case);
    }
}

/// The short run of heat, whose files the tests below damage.
fn welder(out: &Path) -> Command {
    HEAT.command(out)
}

fn has_checkpoint(folder: &Path) -> bool {
    let Ok(entries) = std::fs::read_dir(folder.join("checkpoint")) else { return false };
    entries.filter_map(Result::ok).any(|entry| entry.path().extension().is_some_and(|end| end == "bin"))
}

/// History and frames: the names with the bytes.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let frames = std::fs::read_dir(folder.join("frames")).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = frames.filter(|path| path.extension().is_some_and(|end| end == "vtu")).collect();
    files.extend(["history.csv", "frames.pvd"].map(|name| folder.join(name)));
    files.sort();
    let named = |path: std::path::PathBuf| {
        (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(path).unwrap())
    };
    files.into_iter().map(named).collect()
}

/// Fifty kills in all, of each kind of state that a checkpoint can hold.
#[test]
fn runs_killed_fifty_times_end_with_the_bits_of_runs_that_were_not() {
    for (run, kills) in [(HEAT, 14), (FLOW, 12), (SOLID, 12), (FLUID, 12)] {
        run.survives(kills);
    }
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("the program ends by itself")
}

/// A limit on the size of files stands for a full disk: the write fails in the middle.
#[cfg(unix)]
#[test]
fn a_write_that_fails_ends_the_run_with_3_names_the_file_and_loses_no_checkpoint() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, full] = ["whole", "full"].map(|name| folder.path().join(name));
    assert!(welder(&whole).status().unwrap().success());
    assert!(welder(&full).args(["--until", "0.004"]).status().unwrap().success());
    let line = format!(
        "trap '' XFSZ; ulimit -f 20; exec '{}' run '{SPOT}' --quiet --threads 1 --set resolution.spacing_m=100e-6 \
         --set output.checkpoint_interval_s=1e-3 --set output.pictures=false --out '{}' --resume",
        env!("CARGO_BIN_EXE_welder"),
        full.display()
    );
    let output = Command::new("sh").args(["-c", &line]).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(code(&output), 3, "{message}");
    assert!(message.contains("cannot write") && message.contains(full.to_str().unwrap()), "{message}");
    assert_eq!(Summary::<WeldOutcome>::read(&full.join("summary.json")).unwrap().status, Status::Failed);
    assert!(welder(&full).arg("--resume").status().unwrap().success());
    assert_eq!(results(&full), results(&whole));
}

#[test]
fn a_folder_that_refuses_is_named() {
    let folder = tempfile::tempdir().unwrap();
    // A file in the folder's place refuses even the superuser.
    std::fs::write(folder.path().join("file"), b"").unwrap();
    let out = folder.path().join("file/out");
    let output = welder(&out).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(code(&output), 3);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("cannot create") && message.contains(out.to_str().unwrap()), "{message}");
}

#[test]
fn damaged_checkpoints_are_passed_over_or_refused_and_stay() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, out] = ["whole", "out"].map(|name| folder.path().join(name));
    assert!(welder(&whole).status().unwrap().success());
    assert!(welder(&out).args(["--until", "0.006"]).status().unwrap().success());
    let files = checkpoints(&out);
    assert_eq!(files.len(), 2);
    let original: Vec<Vec<u8>> = files.iter().map(|file| std::fs::read(file).unwrap()).collect();
    for (file, bytes) in files.iter().zip(&original) {
        std::fs::write(file, &bytes[..bytes.len() / 2]).unwrap();
    }
    let output = welder(&out).arg("--resume").stderr(Stdio::piped()).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(code(&output), 3, "{message}");
    assert!(message.contains("is damaged: trunc"), "{message}");
    assert!(files.iter().all(|file| file.exists()), "a damaged checkpoint is evidence, and stays");
    // One of the two whole: the run goes on from it.
    std::fs::write(&files[0], &original[0]).unwrap();
    assert!(welder(&out).arg("--resume").status().unwrap().success());
    assert_eq!(results(&out), results(&whole));
}

/// The checkpoints of a stopped run, oldest first: by their step, which is the number in the name.
fn checkpoints(folder: &Path) -> Vec<std::path::PathBuf> {
    let entries = std::fs::read_dir(folder.join("checkpoint")).unwrap();
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort_by_key(|path| Checkpoint::read(path).unwrap().step);
    files
}

#[test]
fn a_flipped_bit_is_found_and_the_older_checkpoint_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, out] = ["whole", "out"].map(|name| folder.path().join(name));
    assert!(welder(&whole).status().unwrap().success());
    assert!(welder(&out).args(["--until", "0.006"]).status().unwrap().success());
    let files = checkpoints(&out);
    let newest = files.last().unwrap();
    let mut bytes = std::fs::read(newest).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 4;
    std::fs::write(newest, &bytes).unwrap();
    let output = welder(&out).arg("--resume").stderr(Stdio::piped()).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(code(&output), 0, "{message}");
    assert!(message.contains("damaged") && message.contains(newest.to_str().unwrap()), "{message}");
    assert_eq!(results(&out), results(&whole));
}

/// Another version, or another commit of this one, may compute other bits, so that it must not go on; what it wrote stays for the
/// program that can.
#[test]
fn a_checkpoint_of_another_program_ends_with_2_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    assert!(welder(folder.path()).args(["--until", "0.006"]).status().unwrap().success());
    let files = checkpoints(folder.path());
    let other_commit = format!("{} (commit 0123456789ab)", welder::version::NUMBER);
    for program in ["999.0.1 (commit unknown)", other_commit.as_str()] {
        for file in &files {
            let mut other = Checkpoint::read(file).unwrap();
            other.version = program.into();
            std::fs::write(file, other.to_bytes().unwrap()).unwrap();
        }
        let output = welder(folder.path()).arg("--resume").stderr(Stdio::piped()).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(code(&output), 2, "{message}");
        let newest = files.last().unwrap().to_str().unwrap();
        for words in [program, welder::version::PROGRAM, newest] {
            assert!(message.contains(words), "`{words}` is not in: {message}");
        }
        assert!(files.iter().all(|file| file.exists()));
    }
}
