//! The material cards that a scene names: in the scene itself, in a file beside it, or in cases/materials.

use std::path::{Path, PathBuf};

use super::library;
use super::material::{Material, MaterialCard};
use super::nearest::suggestion;
use super::problem::Problem;
use super::read::parse;
use super::scene::Scene;
use super::source::Source;

/// A card with the text it was read from, so that findings have a place.
#[derive(Debug, Clone)]
pub struct CardSource {
    /// The name the material goes by.
    pub name: String,
    /// The values.
    pub card: MaterialCard,
    /// The file that holds the card.
    pub source: Source,
    /// The path of the card in that file: empty, or `materials.NAME.` in a scene.
    pub prefix: String,
}

impl CardSource {
    /// A finding about a field of the card.
    pub fn problem(&self, field: &str, reason: &str, remedy: impl Into<String>) -> Problem {
        self.source.problem(&format!("{}{field}", self.prefix), reason, remedy)
    }

    /// The card without its text.
    pub fn into_material(self) -> Material {
        Material { name: self.name, path: self.source.path, card: self.card }
    }
}

/// The cards of the part (first) and of its regions, each once, and for each region the index of its card.
pub fn collect(
    source: &Source,
    scene: &Scene,
    folder: &Path,
) -> Result<(Vec<CardSource>, Vec<usize>), Problem> {
    let part = find(source, scene, folder, "part.material", &scene.part.material)?;
    let mut cards = vec![(scene.part.material.clone(), part)];
    let mut indices = Vec::new();
    for (number, region) in scene.part.regions.iter().enumerate() {
        let Some(wanted) = &region.material else {
            indices.push(0);
            continue;
        };
        let known = cards.iter().position(|(name, _)| name == wanted);
        let index = match known {
            Some(index) => index,
            None => {
                let field = format!("part.regions.{number}.material");
                let mut card = find(source, scene, folder, &field, wanted)?;
                // Two files of one name in two folders must stay apart when the case is written out.
                if cards.iter().any(|(_, other)| other.name == card.name) {
                    card.name = format!("{}-{}", card.name, cards.len() + 1);
                }
                cards.push((wanted.clone(), card));
                cards.len() - 1
            }
        };
        indices.push(index);
    }
    Ok((cards.into_iter().map(|(_, card)| card).collect(), indices))
}

fn find(
    source: &Source,
    scene: &Scene,
    folder: &Path,
    field: &str,
    wanted: &str,
) -> Result<CardSource, Problem> {
    if let Some(card) = scene.materials.get(wanted) {
        let prefix = format!("materials.{wanted}.");
        return Ok(CardSource {
            name: wanted.to_string(),
            card: card.clone(),
            source: source.clone(),
            prefix,
        });
    }
    let path = match Path::new(wanted).extension() {
        Some(ending) if ending == "ron" => Some(folder.join(wanted)),
        _ => in_library(folder, wanted),
    };
    match path {
        Some(path) if path.is_file() => read_card(&path),
        Some(_) => {
            let remedy =
                format!("accepted: a path relative to {}, or a name without `.ron`", folder.display());
            Err(source.problem(field, "there is no such file", remedy))
        }
        None => Err(unknown(source, scene, folder, field, wanted)),
    }
}

fn in_library(folder: &Path, wanted: &str) -> Option<PathBuf> {
    let paths = library::material_folders(folder)
        .into_iter()
        .map(|materials| materials.join(format!("{wanted}.ron")));
    paths.into_iter().find(|path| path.is_file())
}

/// Reads one card from its file.
pub fn read_card(path: &Path) -> Result<CardSource, Problem> {
    let source = Source::read(path)?;
    let card = parse(&source)?;
    let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(CardSource { name, card, source, prefix: String::new() })
}

fn unknown(source: &Source, scene: &Scene, folder: &Path, field: &str, wanted: &str) -> Problem {
    let mut names: Vec<String> = scene.materials.keys().cloned().collect();
    names.extend(
        library::material_folders(folder).iter().flat_map(|materials| library::material_names(materials)),
    );
    names.sort();
    names.dedup();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let remedy = format!("{}, or a path to a card that ends in .ron", suggestion(wanted, &names));
    source.problem(field, "there is no material of this name", remedy)
}
