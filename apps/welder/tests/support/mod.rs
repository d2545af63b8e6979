//! Edits of a good scene and its material, and what the program says of the result.

pub mod flow;
pub mod flow_rows;
pub mod fluid;
pub mod fluid_rows;
pub mod geometry_rows;
pub mod good;
pub mod material_rows;
pub mod path_rows;
pub mod scene_rows;
pub mod stress;
pub mod stress_rows;

use std::path::Path;
use std::process::Command;

use good::spoken;

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
