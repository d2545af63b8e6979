//! Frames are read back by an independent reader: Python's meshio, by way of `read_frames.py`.

use nalgebra::SVector;
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use welder::observe::{Field, FrameWriter, HistoryRow, Measures, Observer, Precision, Values, View};

const INTERVAL_S: f64 = 0.1;
const PARTICLES: usize = 1000;

/// A field of numbers without pattern, so that a swapped byte or component shows.
struct Cloud<const D: usize> {
    positions_m: Vec<SVector<f64, D>>,
    temperatures_k: Vec<f64>,
    velocities_m_s: Vec<SVector<f64, D>>,
    phases: Vec<u8>,
}

impl<const D: usize> Cloud<D> {
    fn at(time_s: f64) -> Self {
        let wave = |index: usize, axis: usize| (1.7 * index as f64 + 0.3 * axis as f64 + time_s).sin();
        let vector =
            |scale: f64| move |index: usize| SVector::from_fn(|axis: usize, _| scale * wave(index, axis));
        Cloud {
            positions_m: (0..PARTICLES).map(vector(1e-3)).collect(),
            temperatures_k: (0..PARTICLES).map(|index| 900.0 + 600.0 * wave(index, 5)).collect(),
            velocities_m_s: (0..PARTICLES).map(vector(0.2)).collect(),
            phases: (0..PARTICLES).map(|index| (index % 3) as u8).collect(),
        }
    }

    fn view(&self, time_s: f64, step: u64) -> View<'_, D> {
        let fields = vec![
            Field { name: "temperature_k", values: Values::Scalar(&self.temperatures_k) },
            Field { name: "not_asked_for", values: Values::Scalar(&self.temperatures_k) },
            Field { name: "phase", values: Values::Byte(&self.phases) },
            Field { name: "velocity_m_s", values: Values::Vector(&self.velocities_m_s) },
        ];
        View {
            time_s,
            end_s: 1.0,
            step,
            dt_s: INTERVAL_S,
            dt_limit: "conduction",
            positions_m: &self.positions_m,
            spacing_m: &self.temperatures_k,
            fields,
            history: Measures::Weld(HistoryRow::default()),
            pictures: None,
        }
    }
}

/// Writes three frames, has them read back, and compares every number.
fn frames_come_back<const D: usize>(precision: Precision) {
    let Some(python) = python_with_meshio() else { return };
    let folder = tempfile::tempdir().unwrap();
    let names = ["temperature_k", "velocity_m_s", "phase"].map(String::from).to_vec();
    let mut writer = FrameWriter::new(folder.path(), INTERVAL_S, names, precision);
    let times_s = [0.0, INTERVAL_S, 0.123];
    writer.init(&Cloud::<D>::at(times_s[0]).view(times_s[0], 0)).unwrap();
    writer.every(&Cloud::<D>::at(times_s[1]).view(times_s[1], 1)).unwrap();
    writer.finish(&Cloud::<D>::at(times_s[2]).view(times_s[2], 2)).unwrap();

    let frames = read_back(python, &folder.path().join("frames.pvd"));
    assert_eq!(frames.as_array().unwrap().len(), times_s.len());
    for (frame, time_s) in frames.as_array().unwrap().iter().zip(times_s) {
        assert_eq!(hexadecimal_float(frame["time_s"].as_str().unwrap()), time_s);
        compare(frame, &Cloud::<D>::at(time_s), precision);
    }
}

fn compare<const D: usize>(frame: &Value, cloud: &Cloud<D>, precision: Precision) {
    let float = if precision == Precision::Float32 { "float32" } else { "float64" };
    let kept = |number: f64| if precision == Precision::Float32 { f64::from(number as f32) } else { number };
    let spread = |vectors: &[SVector<f64, D>]| {
        let component = |vector: &SVector<f64, D>, axis: usize| vector.get(axis).copied().map_or(0.0, kept);
        vectors.iter().flat_map(|vector| [0, 1, 2].map(|axis| component(vector, axis))).collect::<Vec<_>>()
    };
    let temperatures_k: Vec<f64> = cloud.temperatures_k.iter().copied().map(kept).collect();
    let phases: Vec<f64> = cloud.phases.iter().copied().map(f64::from).collect();
    assert_array(&frame["points"], float, 3, &spread(&cloud.positions_m));
    assert_array(&frame["fields"]["velocity_m_s"], float, 3, &spread(&cloud.velocities_m_s));
    assert_array(&frame["fields"]["temperature_k"], float, 1, &temperatures_k);
    assert_array(&frame["fields"]["phase"], "uint8", 1, &phases);
    assert_eq!(frame["fields"].as_object().unwrap().len(), 3);
    let every_point: Vec<usize> = (0..PARTICLES).collect();
    assert_eq!(frame["cells"], serde_json::json!({ "vertex": every_point }));
}

fn assert_array(found: &Value, kind: &str, components: usize, expected: &[f64]) {
    assert_eq!(found["type"], kind);
    assert_eq!(found["shape"][0], PARTICLES);
    assert_eq!(found["shape"].get(1).map_or(1, |count| count.as_u64().unwrap() as usize), components);
    let bytes = expected.iter().flat_map(|number| number.to_le_bytes());
    let text: String = bytes.map(|byte| format!("{byte:02x}")).collect();
    assert!(found["bytes"] == text, "the values differ");
}

/// The number behind Python's `float.hex()`.
fn hexadecimal_float(text: &str) -> f64 {
    let (mantissa, exponent) = text.strip_prefix("0x").unwrap().split_once('p').unwrap();
    let digits = mantissa.replacen('.', "", 1);
    let places = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i32);
    let exponent: i32 = exponent.parse().unwrap();
    u64::from_str_radix(&digits, 16).unwrap() as f64 * 2.0_f64.powi(exponent - 4 * places)
}

fn read_back(python: &Path, series: &Path) -> Value {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/read_frames.py");
    let output = Command::new(python).arg(script).arg(series).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A Python that has meshio: the system's own, or one in a folder under `target`, made when needed. `None`, said
/// aloud, only on a machine without pip.
fn python_with_meshio() -> Option<&'static Path> {
    static PYTHON: OnceLock<Option<PathBuf>> = OnceLock::new();
    PYTHON.get_or_init(find_python).as_deref()
}

fn find_python() -> Option<PathBuf> {
    let system = PathBuf::from("python3");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("python");
    let own = folder.join("bin/python3");
    for python in [&system, &own] {
        if succeeds(Command::new(python).args(["-c", "import meshio"])) {
            return Some(python.clone());
        }
    }
    let has_pip = succeeds(Command::new(&system).args(["-m", "pip", "--version"]))
        && succeeds(Command::new(&system).args(["-m", "venv", "--clear"]).arg(&folder));
    if !has_pip {
        // Written past the test harness, which would swallow it.
        let message = b"\nSKIPPED: no pip on this machine, so no independent reader checks the frames\n";
        std::io::stderr().write_all(message).unwrap();
        return None;
    }
    let installed =
        Command::new(&own).args(["-m", "pip", "install", "--quiet", "meshio==5.3.5"]).output().unwrap();
    assert!(installed.status.success(), "{}", String::from_utf8_lossy(&installed.stderr));
    Some(own)
}

fn succeeds(command: &mut Command) -> bool {
    command.output().is_ok_and(|output| output.status.success())
}

#[test]
fn frames_in_space_come_back_bit_for_bit() {
    frames_come_back::<3>(Precision::Float64);
}

#[test]
fn frames_in_the_plane_come_back_as_singles() {
    frames_come_back::<2>(Precision::Float32);
}
