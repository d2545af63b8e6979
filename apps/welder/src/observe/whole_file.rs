//! Files that appear whole or not at all: written beside their place, then moved into it. A link in that place is replaced; what it
//! points to is never written.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Puts a file in place in one move, so that a reader, or a program that dies, never meets half of it.
pub fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    place(path, |file| file.write_all(bytes))
}

/// As [`replace`], and returns only when the bytes are on the disk: holds even when the power fails.
pub fn replace_durably(path: &Path, bytes: &[u8]) -> io::Result<()> {
    place(path, |file| file.write_all(bytes).and_then(|()| file.sync_all()))?;
    // The move itself is on the disk only when its folder is; not every system can open a folder.
    if let Some(Ok(folder)) = path.parent().map(File::open) {
        folder.sync_all()?;
    }
    Ok(())
}

/// Whether a name is one of the half-written files that [`replace`] leaves behind when the program dies in it.
pub fn is_leftover(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "partial")
}

fn place(path: &Path, write: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let partial = partial_path(path);
    // What a program that died left behind; and a link there must not lead elsewhere.
    let _ = fs::remove_file(&partial);
    let placed = OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(&partial)
        .and_then(|mut file| write(&mut file))
        .and_then(|()| fs::rename(&partial, path));
    if placed.is_err() {
        // The first failure is the one to report; the leftover may not even exist.
        let _ = fs::remove_file(&partial);
    }
    placed
}

fn partial_path(path: &Path) -> PathBuf {
    let mut name = path.file_name().map_or_else(OsString::new, OsString::from);
    name.push(".partial");
    path.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_new_content_replaces_the_old_and_nothing_is_left_behind() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        replace(&path, b"old and longer").unwrap();
        replace_durably(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_failed_write_keeps_the_old_content() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        replace(&path, b"old").unwrap();
        let failed =
            place(&path, |file| file.write_all(b"ha").and_then(|()| Err(io::Error::other("disk full"))));
        assert_eq!(failed.unwrap_err().to_string(), "disk full");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_replaced_and_not_written_through() {
        let folder = tempfile::tempdir().unwrap();
        let [path, mine] = ["summary.json", "mine"].map(|name| folder.path().join(name));
        fs::write(&mine, b"mine").unwrap();
        for link in [path.clone(), partial_path(&path)] {
            let _ = fs::remove_file(&link);
            std::os::unix::fs::symlink(&mine, &link).unwrap();
            replace(&path, b"new").unwrap();
            assert_eq!((fs::read(&path).unwrap(), fs::read(&mine).unwrap()), (b"new".into(), b"mine".into()));
        }
    }

    #[test]
    fn a_leftover_is_known_by_its_name() {
        assert!(is_leftover(&partial_path(Path::new("out/checkpoint_1.bin"))));
        assert!(!is_leftover(Path::new("out/checkpoint_1.bin")));
    }
}
