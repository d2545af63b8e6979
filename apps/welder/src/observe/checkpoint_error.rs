//! What can be wrong with a checkpoint; every message names the file and the reason.

use std::path::{Path, PathBuf};

/// Why a checkpoint could not be written or used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckpointError {
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
    /// The file is not what was once written.
    #[error("the checkpoint {} is damaged: {reason}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What gives the damage away.
        reason: String,
    },
    /// The file is whole, but of another layout.
    #[error("the checkpoint {} has format {found}; this program reads format {expected}", path.display())]
    OtherFormat {
        /// The file.
        path: PathBuf,
        /// Its format.
        found: u32,
        /// The format that this program reads.
        expected: u32,
    },
    /// The file was written by another version of the program.
    #[error(
        "the checkpoint {} was written by version {found}; version {expected} cannot continue it bit for bit",
        path.display()
    )]
    OtherVersion {
        /// The file.
        path: PathBuf,
        /// The version that wrote it.
        found: String,
        /// The version that reads it.
        expected: String,
    },
    /// The file belongs to another case.
    #[error("the checkpoint {} belongs to another case: the resolved case has changed since", path.display())]
    OtherCase {
        /// The file.
        path: PathBuf,
    },
    /// A value does not encode, or a column is missing or of another type.
    #[error("the checkpoint has no usable `{name}`: {reason}")]
    Content {
        /// The column or part.
        name: String,
        /// What is wrong with it.
        reason: String,
    },
}

impl CheckpointError {
    /// The same error of a checkpoint that was read from `path`: content that cannot be used is damage of that file.
    pub fn in_file(self, path: &Path) -> Self {
        match self {
            CheckpointError::Content { name, reason } => CheckpointError::Damaged {
                path: path.to_path_buf(),
                reason: format!("no usable `{name}`, {reason}"),
            },
            other => other,
        }
    }
}
