//! From a path and the overrides of the command line to a checked case.

use std::path::{Path, PathBuf};

use serde::Serialize;

use super::card::{self, CardSource};
use super::fluid::FluidScene;
use super::material::Material;
use super::nearest::{nearest, suggestion};
use super::problem::{CaseError, Problem};
use super::read::{parse, ron_options};
use super::scene::Scene;
use super::solid::SolidScene;
use super::source::Source;
use super::{library, set, validate};
use crate::version;

/// A weld that was read and checked.
#[derive(Debug, Clone)]
pub struct Case {
    /// Short name: that of its folder, or of its file when that is not a scene.ron or case.ron; never a path.
    pub name: String,
    /// The folder of the scene file.
    pub folder: PathBuf,
    /// The scene file.
    pub path: PathBuf,
    /// What the scene says.
    pub scene: Scene,
    /// The materials of the scene, each once; the first is that of the part.
    pub materials: Vec<Material>,
    /// For each entry of `scene.part.regions`, which of `materials` fills it.
    pub region_materials: Vec<usize>,
    /// Text of the scene file, with the overrides put in.
    pub source_text: String,
}

/// A scene of pure fluid that was read and checked.
#[derive(Debug, Clone)]
pub struct FluidCase {
    /// Short name, as that of a [`Case`].
    pub name: String,
    /// What the scene says.
    pub scene: FluidScene,
}

/// A scene of elastic bodies that was read and checked.
#[derive(Debug, Clone)]
pub struct SolidCase {
    /// Short name, as that of a [`Case`].
    pub name: String,
    /// What the scene says.
    pub scene: SolidScene,
}

/// A case of any kind; the name before the outer bracket of its file tells which.
#[derive(Debug, Clone)]
pub enum Loaded {
    /// `( ... )` or `Weld( ... )`.
    Weld(Box<Case>),
    /// `Fluid( ... )`.
    Fluid(Box<FluidCase>),
    /// `Solid( ... )`.
    Solid(Box<SolidCase>),
}

impl Loaded {
    /// What the case is, in words.
    pub fn title(&self) -> &str {
        match self {
            Loaded::Weld(case) => &case.scene.title,
            Loaded::Fluid(case) => &case.scene.title,
            Loaded::Solid(case) => &case.scene.title,
        }
    }
}

/// Reads the case at `path` (a folder with a scene.ron, or a .ron file), puts the overrides (`field=value`) into it and
/// checks everything that can be checked before particles are placed.
///
/// # Errors
/// All findings at once, each with its place, or the first one when the text cannot be parsed at all.
pub fn load_any(path: &Path, overrides: &[String]) -> Result<Loaded, CaseError> {
    let path = scene_path(path)?;
    let source = set::apply(Source::read(&path)?, overrides)?;
    match source.outer_name() {
        "" | "Weld" => Ok(Loaded::Weld(Box::new(weld(path, source)?))),
        "Fluid" => Ok(Loaded::Fluid(Box::new(fluid(&path, &source)?))),
        "Solid" => Ok(Loaded::Solid(Box::new(solid(&path, &source)?))),
        other => {
            let start = source.root.span.start;
            let message = format!("the file: found an unknown kind of scene `{other}`");
            let remedy = suggestion(other, &["Weld", "Fluid", "Solid"]);
            Err(source.problem_at(start..start + other.len(), "", message, remedy).into())
        }
    }
}

/// The same of a weld; for what only a weld can be asked.
///
/// # Errors
/// As [`load_any`], and a case of another kind.
pub fn load(path: &Path, overrides: &[String]) -> Result<Case, CaseError> {
    match load_any(path, overrides)? {
        Loaded::Weld(case) => Ok(*case),
        Loaded::Fluid(_) | Loaded::Solid(_) => {
            let reason = "the case is no weld: there is no pool and no seam to measure".to_string();
            let remedy = "accepted: a case of a weld; `welder run` and `welder check` take this one";
            Err(Problem::without_text(&path.display().to_string(), reason, remedy.into()).into())
        }
    }
}

fn weld(path: PathBuf, source: Source) -> Result<Case, CaseError> {
    let scene: Scene = parse(&source)?;
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let (cards, region_materials) = card::collect(&source, &scene, &folder)?;
    let problems = validate::validate(&source, &scene, &cards, &region_materials);
    if !problems.is_empty() {
        return Err(CaseError { problems });
    }
    let materials = cards.into_iter().map(CardSource::into_material).collect();
    Ok(Case {
        name: name_of(&path),
        folder,
        path,
        scene,
        materials,
        region_materials,
        source_text: source.text,
    })
}

fn fluid(path: &Path, source: &Source) -> Result<FluidCase, CaseError> {
    let scene: FluidScene = parse(source)?;
    let problems = validate::validate_fluid(source, &scene);
    if !problems.is_empty() {
        return Err(CaseError { problems });
    }
    Ok(FluidCase { name: name_of(path), scene })
}

fn solid(path: &Path, source: &Source) -> Result<SolidCase, CaseError> {
    let scene: SolidScene = parse(source)?;
    let problems = validate::validate_solid(source, &scene);
    if !problems.is_empty() {
        return Err(CaseError { problems });
    }
    Ok(SolidCase { name: name_of(path), scene })
}

impl Case {
    /// Index in `materials` and start temperature in kelvin at a point (x, y, z) in metres.
    pub fn fill_at(&self, point_m: [f64; 3]) -> (usize, f64) {
        let part = &self.scene.part;
        let hit = part
            .regions
            .iter()
            .zip(&self.region_materials)
            .rev()
            .find(|(region, _)| region.contains(point_m));
        match hit {
            Some((region, &material)) => (material, region.start_k.unwrap_or(part.start_k)),
            None => (0, part.start_k),
        }
    }
}

/// The case as it was understood, as a scene of its own: overrides put in, defaults and intervals filled in, materials
/// inside. [`load`] reads it back to the same case wherever it lies.
pub fn resolved_ron(case: &Case) -> String {
    let mut scene = case.scene.clone();
    scene.output = scene.output().into();
    scene.part.material = case.materials[0].name.clone();
    for (region, &material) in scene.part.regions.iter_mut().zip(&case.region_materials) {
        region.material = Some(case.materials[material].name.clone());
    }
    scene.materials =
        case.materials.iter().map(|material| (material.name.clone(), material.card.clone())).collect();
    resolved_text(&case.name, "", &scene)
}

/// The same of a scene of fluid.
pub fn resolved_fluid_ron(case: &FluidCase) -> String {
    let mut scene = case.scene.clone();
    scene.output = scene.output().into();
    resolved_text(&case.name, "Fluid", &scene)
}

/// The same of a scene of elastic bodies.
pub fn resolved_solid_ron(case: &SolidCase) -> String {
    let mut scene = case.scene.clone();
    scene.output = scene.output().into();
    resolved_text(&case.name, "Solid", &scene)
}

fn resolved_text(name: &str, kind: &str, scene: &impl Serialize) -> String {
    let pretty = ron::ser::PrettyConfig::default().compact_arrays(true);
    let body = ron_options().to_string_pretty(scene, pretty).expect("a scene can be written as text");
    format!("// The case {name} as welder {} resolved it.\n{kind}{body}\n", version::NUMBER)
}

/// The scene file that the argument CASE means.
fn scene_path(path: &Path) -> Result<PathBuf, Problem> {
    if path.is_file() {
        return Ok(path.to_path_buf());
    }
    if path.is_dir() {
        let scene = path.join("scene.ron");
        return if scene.is_file() { Ok(scene) } else { Err(missing(path, "the folder holds no scene.ron")) };
    }
    Err(missing(path, "there is no such file or folder"))
}

fn missing(path: &Path, reason: &str) -> Problem {
    let accepted = "accepted: a folder with a scene.ron, or a .ron file";
    let remedy = match library::cases_folder() {
        Some(cases) => format!("{}{accepted}; {}", guess(path, &cases), cases_in(&cases)),
        None => accepted.to_string(),
    };
    Problem::without_text(&path.display().to_string(), reason.to_string(), remedy)
}

/// The case whose name is nearest to that of a path.
fn guess(path: &Path, cases: &Path) -> String {
    let last =
        |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let folders = library::case_folders(cases);
    let names: Vec<String> = folders.iter().map(|folder| last(folder)).collect();
    let found = nearest(&last(path), names.iter().map(String::as_str));
    let folder = found.and_then(|found| folders.iter().find(|folder| last(folder) == found));
    folder.map_or_else(String::new, |folder| format!("did you mean `{}`? ", folder.display()))
}

/// The cases in the folder that comes with the program, one a line.
fn cases_in(cases: &Path) -> String {
    let folders = library::case_folders(cases);
    let name = |folder: &PathBuf| format!("\n  {}", folder.strip_prefix(cases).unwrap_or(folder).display());
    format!("in {} there are:{}", cases.display(), folders.iter().map(name).collect::<String>())
}

fn name_of(path: &Path) -> String {
    let text = |part: Option<&std::ffi::OsStr>| part.map(|name| name.to_string_lossy().into_owned());
    let stem = text(path.file_stem()).unwrap_or_default();
    if stem == "scene" || stem == "case" {
        let absolute = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        return text(absolute.parent().and_then(Path::file_name)).unwrap_or(stem);
    }
    // The name is a folder below `out`: that of a file `...ron` would be the folder above.
    if Path::new(&stem).file_name().is_none() { "case".into() } else { stem }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spot() -> PathBuf {
        library::cases_folder().unwrap().join("spot-aluminium")
    }

    #[test]
    fn a_folder_and_its_scene_are_the_same_case() {
        let (by_folder, by_file) =
            (load(&spot(), &[]).unwrap(), load(&spot().join("scene.ron"), &[]).unwrap());
        assert_eq!(by_folder.scene, by_file.scene);
        assert_eq!(by_folder.name, "spot-aluminium");
        assert_eq!(by_folder.materials[0].name, "aluminium-model");
    }

    #[test]
    fn no_name_leads_out_of_the_folder_of_results() {
        for (file, name) in [("...ron", "case"), ("..ron", "case"), (".ron", ".ron"), ("a..ron", "a.")] {
            let found = name_of(Path::new(file));
            assert_eq!(found, name, "{file}");
            assert_eq!(Path::new("out").join(&found).parent(), Some(Path::new("out")), "{file}");
        }
    }

    #[test]
    fn the_resolved_case_reads_back_to_the_same_case() {
        let region = "part.regions=[(low_m: (0, 0, -1e-3), high_m: (1e-3, 1e-3, 0), material: \"in625\", start_k: 400)]";
        let case = load(&spot(), &["resolution.disorder=0.1".into(), region.into()]).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("case.ron");
        std::fs::write(&path, resolved_ron(&case)).unwrap();
        let again = load(&path, &[]).unwrap();
        assert_eq!(again.scene.resolution, case.scene.resolution);
        assert_eq!(again.region_materials, [1]);
        for (first, second) in case.materials.iter().zip(&again.materials) {
            assert_eq!((&first.name, &first.card), (&second.name, &second.card));
        }
        assert_eq!(
            resolved_ron(&again).lines().skip(1).collect::<String>(),
            resolved_ron(&case).lines().skip(1).collect::<String>()
        );
    }

    #[test]
    fn points_take_the_last_region_that_holds_them() {
        let regions = "part.regions=[(low_m: (0, 0, -1e-3), high_m: (2e-3, 2e-3, 0), material: \"in625\"), \
                       (low_m: (0, 0, -1e-3), high_m: (1e-3, 1e-3, 0), start_k: 400)]";
        let case = load(&spot(), &[regions.into()]).unwrap();
        assert_eq!(case.fill_at([1.5e-3, 0.5e-3, -0.5e-3]), (1, 293.0));
        assert_eq!(case.fill_at([0.5e-3, 0.5e-3, -0.5e-3]), (0, 400.0));
        assert_eq!(case.fill_at([3e-3, 3e-3, -2e-3]), (0, 293.0));
    }

    #[test]
    fn a_mistyped_case_names_the_nearest() {
        let error = load(Path::new("cases/spot-alumnium"), &[]).unwrap_err().to_string();
        assert!(
            error.contains("no such file")
                && error.contains("did you mean")
                && error.contains("spot-aluminium"),
            "{error}"
        );
        let list = error.split("there are:\n").nth(1).expect("a list of cases");
        assert!(list.lines().any(|line| line == "  hard/deep") && !list.contains(".."), "{list}");
    }
}
