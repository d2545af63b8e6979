//! A good scene with its material, edits of both, and what the program says of the result.

pub mod flow_rows;
pub mod geometry_rows;
pub mod material_rows;
pub mod path_rows;
pub mod scene_rows;
pub mod stress_rows;

use std::path::Path;
use std::process::{Command, Output};

/// A scene without fault.
pub const SCENE: &str = r#"(
    title: "a test",
    part: (
        size_m: (6.0e-3, 4.0e-3, 3.0e-3),
        material: "metal",
        start_k: 293.0,
        faces: (x_min: Symmetry, y_min: Symmetry),
        regions: [(low_m: (0.0, 0.0, -1.0e-3), high_m: (1.0e-3, 1.0e-3, 0.0), start_k: 400.0)],
    ),
    resolution: (spacing_m: 50.0e-6, disorder: 0.1),
    laser: (
        beam: Gaussian(radius_1e2_m: 0.6e-3),
        absorption: Surface(absorptivity: 0.4),
        path: Spot(position_m: (0.0, 0.0), pulse: Constant(start_s: 0.0, duration_s: 0.015, power_w: 1250.0)),
    ),
    physics: [Heat()],
    time: (end_s: 0.03),
    output: (frame_interval_s: 1.0e-3, fields: ["temperature_k"]),
    budget: (max_particles: 20000000),
)
"#;

/// Its material, as `materials/metal.ron` beside it.
pub const MATERIAL: &str = r#"(
    density_kg_m3: (value: 2500.0, source: "test"),
    solidus_k: (value: 847.0, source: "test"),
    liquidus_k: (value: 905.0, source: "test"),
    latent_heat_j_kg: (value: 3.97e5, source: "test"),
    boiling_k: (value: 2790.0, source: "test"),
    heat_capacity_solid_j_kg_k: (table: [(300.0, 900.0), (847.0, 1050.0)], source: "test"),
    heat_capacity_liquid_j_kg_k: (value: 1180.0, source: "test"),
    conductivity_solid_w_m_k: (value: 200.0, source: "test"),
    conductivity_liquid_w_m_k: (value: 95.0, source: "test"),
)
"#;

/// A change of a good text: `from` (once in it) becomes `to`, and the fault stands at `at` in the changed text.
pub struct Edit {
    pub from: &'static str,
    pub to: &'static str,
    pub at: &'static str,
}

impl Edit {
    /// The changed text.
    pub fn apply(&self, text: &str) -> String {
        assert_eq!(text.matches(self.from).count(), 1, "`{}` must stand once in the good text", self.from);
        text.replace(self.from, self.to)
    }

    /// `file:line:column` of `at` in the changed text.
    pub fn place(&self, changed: &str, file: &str) -> String {
        let offset = changed.find(self.at).unwrap_or_else(|| panic!("`{}` is not in the text", self.at));
        let line = changed[..offset].matches('\n').count() + 1;
        let column = offset - changed[..offset].rfind('\n').map_or(0, |at| at + 1) + 1;
        format!("{file}:{line}:{column}")
    }
}

/// An edit (`from`, `to`), where its fault stands, and words that the message must hold.
pub type Row = (&'static str, &'static str, &'static str, &'static [&'static str]);

/// Runs `welder check` on a scene and its material; gives the exit code and what came out on both channels.
pub fn check(scene: &str, material: &str, overrides: &[&str]) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("materials")).expect("a folder for materials");
    std::fs::write(folder.path().join("scene.ron"), scene).expect("the scene is written");
    std::fs::write(folder.path().join("materials/metal.ron"), material).expect("the material is written");
    check_path(folder.path(), overrides)
}

/// Runs `welder check` on a path.
pub fn check_path(path: &Path, overrides: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_welder"));
    command.arg("check").arg(path);
    overrides.iter().for_each(|change| {
        command.args(["--set", change]);
    });
    spoken(&command.output().expect("welder starts"))
}

/// Exit code and both channels of a finished program.
pub fn spoken(output: &Output) -> (Option<i32>, String) {
    let text =
        [&output.stdout[..], &output.stderr[..]].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    (output.status.code(), text.concat())
}
