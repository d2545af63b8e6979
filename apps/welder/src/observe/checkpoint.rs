//! The folder of checkpoints: the newest two are kept, and the newest that is whole is the one to go on from.

use super::checkpoint_error::CheckpointError;
use super::checkpoint_format::Checkpoint;
use super::whole_file;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How many are kept.
pub(crate) const KEPT: usize = 2;

/// The folder `checkpoint` of a run.
#[derive(Clone, Debug)]
pub struct CheckpointFolder {
    path: PathBuf,
}

/// A checkpoint to go on from.
#[derive(Debug)]
pub struct Found {
    /// Its content.
    pub checkpoint: Checkpoint,
    /// Its file.
    pub path: PathBuf,
    /// Newer checkpoints that are damaged, newest first; each was also logged as a warning.
    pub skipped: Vec<CheckpointError>,
}

impl CheckpointFolder {
    /// The checkpoints of the run whose outputs are in `run_folder`.
    pub fn of_run(run_folder: &Path) -> Self {
        CheckpointFolder { path: run_folder.join("checkpoint") }
    }

    /// Writes a checkpoint, whole or not at all, then drops all but the newest two.
    ///
    /// Checkpoints of a later step are dropped as well: they belong to an earlier run in the same folder.
    pub fn write(&self, checkpoint: &Checkpoint) -> Result<PathBuf, CheckpointError> {
        fs::create_dir_all(&self.path).map_err(file_error("create", &self.path))?;
        let path = self.path.join(format!("checkpoint_{}.bin", checkpoint.step));
        let bytes = checkpoint.to_bytes()?;
        whole_file::replace_durably(&path, &bytes).map_err(file_error("write", &path))?;
        self.prune(checkpoint.step)?;
        Ok(path)
    }

    /// The newest checkpoint that is whole, or `None` if there is no checkpoint.
    ///
    /// A damaged one is passed over with a warning. One of another program version or of another case is an error:
    /// an older one would be no better.
    pub fn latest(&self, version: &str, case_digest: u32) -> Result<Option<Found>, CheckpointError> {
        let mut skipped = Vec::new();
        for (_, path) in self.files()? {
            match read(&path, version, case_digest) {
                Ok(checkpoint) => return Ok(Some(Found { checkpoint, path, skipped })),
                Err(error @ (CheckpointError::Damaged { .. } | CheckpointError::File { .. })) => {
                    tracing::warn!("{error}; trying the one before");
                    skipped.push(error);
                }
                Err(error) => return Err(error),
            }
        }
        // All are damaged: the newest is the one that the user expects to hear of.
        skipped.into_iter().next().map_or(Ok(None), Err)
    }

    /// Removes every checkpoint, for a run that starts anew.
    pub fn clear(&self) -> Result<(), CheckpointError> {
        self.files()?
            .iter()
            .try_for_each(|(_, path)| fs::remove_file(path).map_err(file_error("remove", path)))
    }

    fn prune(&self, newest_step: u64) -> Result<(), CheckpointError> {
        let (later, earlier): (Vec<_>, Vec<_>) =
            self.files()?.into_iter().partition(|(step, _)| *step > newest_step);
        for (_, path) in later.iter().chain(earlier.iter().skip(KEPT)) {
            fs::remove_file(path).map_err(file_error("remove", path))?;
        }
        for path in self.entries()?.iter().filter(|path| whole_file::is_leftover(path)) {
            fs::remove_file(path).map_err(file_error("remove", path))?;
        }
        Ok(())
    }

    /// The checkpoints by step, newest first.
    fn files(&self) -> Result<Vec<(u64, PathBuf)>, CheckpointError> {
        let mut files: Vec<_> =
            self.entries()?.into_iter().filter_map(|path| step_of(&path).map(|step| (step, path))).collect();
        files.sort_by(|one, other| other.cmp(one));
        Ok(files)
    }

    fn entries(&self) -> Result<Vec<PathBuf>, CheckpointError> {
        match fs::read_dir(&self.path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
            listed => listed
                .and_then(|entries| entries.map(|entry| entry.map(|entry| entry.path())).collect())
                .map_err(file_error("list", &self.path)),
        }
    }
}

fn read(path: &Path, version: &str, case_digest: u32) -> Result<Checkpoint, CheckpointError> {
    let checkpoint = Checkpoint::read(path)?;
    if checkpoint.version != version {
        let (found, expected) = (checkpoint.version, version.to_string());
        return Err(CheckpointError::OtherVersion { path: path.to_path_buf(), found, expected });
    }
    if checkpoint.case_digest != case_digest {
        return Err(CheckpointError::OtherCase { path: path.to_path_buf() });
    }
    Ok(checkpoint)
}

fn step_of(path: &Path) -> Option<u64> {
    path.file_name()?.to_str()?.strip_prefix("checkpoint_")?.strip_suffix(".bin")?.parse().ok()
}

fn file_error(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> CheckpointError {
    let path = path.to_path_buf();
    move |source| CheckpointError::File { action, path, source }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VERSION: &str = "0.1.0";

    fn at_step(step: u64) -> Checkpoint {
        let (version, time_s) = (VERSION.into(), 0.1 * step as f64);
        Checkpoint { version, case_digest: 5, time_s, step, state: vec![1, 2, 3], columns: Vec::new() }
    }

    fn names(folder: &CheckpointFolder) -> Vec<String> {
        let name = |path: &PathBuf| path.file_name().unwrap().to_str().unwrap().to_string();
        let mut names: Vec<_> = folder.entries().unwrap().iter().map(name).collect();
        names.sort();
        names
    }

    fn filled(steps: &[u64]) -> (tempfile::TempDir, CheckpointFolder) {
        let run = tempfile::tempdir().unwrap();
        let folder = CheckpointFolder::of_run(run.path());
        for &step in steps {
            folder.write(&at_step(step)).unwrap();
        }
        (run, folder)
    }

    #[test]
    fn the_newest_two_by_number_are_kept() {
        let (_run, folder) = filled(&[8, 9, 10]);
        assert_eq!(names(&folder), ["checkpoint_10.bin", "checkpoint_9.bin"]);
        assert_eq!(folder.latest(VERSION, 5).unwrap().unwrap().checkpoint, at_step(10));
    }

    #[test]
    fn a_new_run_supersedes_later_steps_and_leftovers_of_an_old_one() {
        let (_run, folder) = filled(&[1000, 2000]);
        fs::write(folder.path.join("checkpoint_3000.bin.partial"), b"half").unwrap();
        folder.write(&at_step(10)).unwrap();
        assert_eq!(names(&folder), ["checkpoint_10.bin"]);
        folder.clear().unwrap();
        assert!(folder.latest(VERSION, 5).unwrap().is_none());
    }

    #[test]
    fn a_damaged_one_is_passed_over_and_named() {
        let (_run, folder) = filled(&[9, 10]);
        let newest = folder.path.join("checkpoint_10.bin");
        let mut bytes = fs::read(&newest).unwrap();
        bytes[30] ^= 1;
        fs::write(&newest, bytes).unwrap();
        let found = folder.latest(VERSION, 5).unwrap().unwrap();
        assert_eq!(found.checkpoint, at_step(9));
        assert!(found.skipped[0].to_string().contains("checkpoint_10.bin is damaged"), "{:?}", found.skipped);
        fs::write(&found.path, b"").unwrap();
        let error = folder.latest(VERSION, 5).unwrap_err();
        assert!(error.to_string().contains("checkpoint_10.bin is damaged"), "{error}");
    }

    #[test]
    fn another_version_or_case_is_refused() {
        let (_run, folder) = filled(&[9]);
        let error = folder.latest("0.2.0", 5).unwrap_err();
        assert!(error.to_string().contains("written by version 0.1.0; version 0.2.0"), "{error}");
        let error = folder.latest(VERSION, 6).unwrap_err();
        assert!(error.to_string().contains("checkpoint_9.bin belongs to another case"), "{error}");
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_named() {
        let run = tempfile::tempdir().unwrap();
        // A file in the folder's place refuses even the superuser.
        fs::write(run.path().join("checkpoint"), b"").unwrap();
        let folder = CheckpointFolder::of_run(run.path());
        for error in [folder.write(&at_step(1)).unwrap_err(), folder.latest(VERSION, 5).unwrap_err()] {
            assert!(error.to_string().contains(run.path().join("checkpoint").to_str().unwrap()), "{error}");
        }
    }
}
