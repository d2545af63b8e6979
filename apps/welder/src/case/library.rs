//! The folders of cases and materials that come with the program, and what is in them.

use std::path::{Path, PathBuf};

/// The folder `cases` that comes with the program: in the current folder, else in the workspace that built it.
pub fn cases_folder() -> Option<PathBuf> {
    let here = PathBuf::from("cases");
    let workspace = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").canonicalize().ok();
    if here.is_dir() { Some(here) } else { workspace() }
}

/// The folders in which a material is looked up, nearest first: beside the case, beside its folder, then the program's.
pub fn material_folders(case_folder: &Path) -> Vec<PathBuf> {
    let mut folders = vec![case_folder.join("materials"), case_folder.join("../materials")];
    folders.extend(cases_folder().map(|cases| cases.join("materials")));
    folders.retain(|folder| folder.is_dir());
    folders
}

/// Names of the material cards in a folder, in alphabetical order.
pub fn material_names(folder: &Path) -> Vec<String> {
    let is_card = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "ron");
    let stem = |path: PathBuf| path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    entries(folder).into_iter().filter(is_card).filter_map(stem).collect()
}

/// Folders below `cases`, and below the folders in it, that hold a scene.ron, in alphabetical order.
pub fn case_folders(cases: &Path) -> Vec<PathBuf> {
    let is_case = |path: &PathBuf| path.join("scene.ron").is_file();
    let with_inner = |path: PathBuf| if is_case(&path) { vec![path] } else { entries(&path) };
    entries(cases).into_iter().flat_map(with_inner).filter(is_case).collect()
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let Ok(listing) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = listing.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    paths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_brings_its_cases_and_materials() {
        let cases = cases_folder().expect("cases come with the program");
        let names: Vec<_> =
            case_folders(&cases).iter().map(|path| path.file_name().unwrap().to_owned()).collect();
        assert!(names.contains(&"spot-aluminium".into()), "{names:?}");
        assert!(names.contains(&"two-spots".into()), "in the group `hard`: {names:?}");
        assert!(names.contains(&"dam-break".into()), "folders in folders: {names:?}");
        assert!(material_names(&cases.join("materials")).contains(&"aluminium-model".to_string()));
    }

    #[test]
    fn materials_beside_the_case_come_first() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("materials")).unwrap();
        assert_eq!(material_folders(folder.path())[0], folder.path().join("materials"));
    }
}
