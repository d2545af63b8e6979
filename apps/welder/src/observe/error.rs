//! Why an output could not be made; every message names the file.

use super::CheckpointError;
use std::path::{Path, PathBuf};

/// Why an output could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ObserveError {
    /// The file system refused.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// What was tried.
        action: &'static str,
        /// On which file or folder.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A table could not be written or read.
    #[error("the table {} cannot be used: {source}", path.display())]
    Table {
        /// The table.
        path: PathBuf,
        /// What the library said.
        source: csv::Error,
    },
    /// A value could not be turned into JSON.
    #[error("cannot encode {}: {source}", path.display())]
    Json {
        /// The file that was to be written.
        path: PathBuf,
        /// What the library said.
        source: serde_json::Error,
    },
    /// The scene asks for a field that this run does not have.
    #[error("the frames ask for the field `{name}`, which this run does not have; it has: {known}")]
    UnknownField {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A list of frames could not be read back.
    #[error("the list of frames {} cannot be continued: {reason}", path.display())]
    FrameList {
        /// The list.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A picture could not be drawn.
    #[error("cannot draw {}: {reason}", path.display())]
    Picture {
        /// The picture.
        path: PathBuf,
        /// What the library said.
        reason: String,
    },
    /// A checkpoint could not be written or read.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

impl ObserveError {
    /// An error of the file system, for use with `map_err`.
    pub fn file(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> ObserveError {
        let path = path.to_path_buf();
        move |source| ObserveError::File { action, path, source }
    }
}
