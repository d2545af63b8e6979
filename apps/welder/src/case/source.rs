//! A RON file that was read, with the places of its values, so that every finding can be pinned to one.

use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use miette::NamedSource;

use super::locate::{Located, locate};
use super::problem::Problem;
use super::scan::{Node, ScanError, scan};

/// The text of a scene or material file and where each value stands in it.
#[derive(Debug, Clone)]
pub struct Source {
    /// The file.
    pub path: PathBuf,
    /// Its text, with the values of the command line put in.
    pub text: String,
    /// The places of its values.
    pub root: Node,
    /// What the command line changed.
    pub overrides: Vec<Override>,
    /// The text under the name of its file, shared by all findings.
    excerpt: Arc<NamedSource<String>>,
    /// Whether excerpts can be shown: no line is too long for them.
    has_excerpts: bool,
}

/// A `--set path=value` of the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Override {
    /// The field path before the `=`.
    pub field: String,
    /// The argument as it was given.
    pub argument: String,
}

/// Longest scene or card that is read, in bytes: the tree of places takes up to a hundred times as much memory.
const LARGEST_FILE_BYTES: u64 = 4 << 20;

/// Longest line of which excerpts are shown, in bytes: they hold the whole line, and miette panics beyond column 65535.
const LONGEST_LINE_BYTES: usize = 4096;

/// Longest piece of the file that a message repeats.
const LONGEST_QUOTE: usize = 60;

impl Source {
    /// Reads a file; refuses what cannot be read, is too long, is empty, or is not RON in shape.
    pub fn read(path: &Path) -> Result<Source, Problem> {
        let refuse = |reason: String, remedy: &str| {
            Problem::without_text(&path.display().to_string(), reason, remedy.to_string())
        };
        let mut text = String::new();
        File::open(path)
            .and_then(|file| file.take(LARGEST_FILE_BYTES + 1).read_to_string(&mut text))
            .map_err(|error| {
                let remedy = "give the path of a readable UTF-8 text file";
                refuse(format!("the file cannot be read: {error}"), remedy)
            })?;
        if text.len() as u64 > LARGEST_FILE_BYTES {
            let remedy = format!("accepted: at most {LARGEST_FILE_BYTES} bytes");
            return Err(refuse("the file is too long for a scene or a material card".into(), &remedy));
        }
        Source::of_text(path, text)
    }

    /// Takes a text as if it had been read from `path`.
    pub fn of_text(path: &Path, text: String) -> Result<Source, Problem> {
        let overrides = Vec::new();
        if text.trim().is_empty() {
            let remedy = "a scene needs at least part, resolution, physics and time; see `welder list` for cases to copy";
            let place = format!("{}:1:1", path.display());
            return Err(Problem::without_text(&place, "found an empty file".into(), remedy.into()));
        }
        let whole = 0..text.len();
        let blank = Node { span: whole.clone(), inside: whole, content: super::scan::Content::Scalar };
        let excerpt = Arc::new(NamedSource::new(path.display().to_string(), text.clone()));
        let has_excerpts = text.lines().all(|line| line.len() <= LONGEST_LINE_BYTES);
        let mut source =
            Source { path: path.to_path_buf(), text, root: blank, overrides, excerpt, has_excerpts };
        source.root = scan(&source.text).map_err(|error| source.shape_problem(&error))?;
        Ok(source)
    }

    fn shape_problem(&self, error: &ScanError) -> Problem {
        let remedy = "close every bracket and string, and separate values by commas: `field: value,`";
        let width = self.text[error.offset..].chars().next().map_or(0, char::len_utf8);
        let field = if error.path.is_empty() { "the file" } else { &error.path };
        let message = format!("{field}: {}", error.message);
        self.problem_at(error.offset..error.offset + width, &error.path, message, remedy.to_string())
    }

    /// The name before the outer bracket, or nothing.
    pub fn outer_name(&self) -> &str {
        let name = &self.text[self.root.span.start..self.root.inside.start];
        let is_word = |character: char| character.is_alphanumeric() || character == '_';
        &name[..name.find(|character| !is_word(character)).unwrap_or(name.len())]
    }

    /// Where a field stands, or the nearest value around it.
    pub fn locate(&self, field: &str) -> Located<'_> {
        locate(&self.root, field)
    }

    /// The text of a field, cut when long; `nothing` when the file does not have it.
    pub fn found(&self, field: &str) -> String {
        let located = self.locate(field);
        if !located.missing.is_empty() {
            return "nothing".to_string();
        }
        self.quote(located.node.span.clone())
    }

    /// A piece of the file in one line, cut when long.
    pub fn quote(&self, span: Range<usize>) -> String {
        let words: Vec<&str> = self.text[span].split_whitespace().collect();
        let line = words.join(" ");
        match line.char_indices().nth(LONGEST_QUOTE) {
            Some((end, _)) => format!("`{}...`", &line[..end]),
            None => format!("`{line}`"),
        }
    }

    /// A finding about a field: `field: found VALUE: reason`, at the value, or at what is nearest to it.
    pub fn problem(&self, field: &str, reason: &str, remedy: impl Into<String>) -> Problem {
        let located = self.locate(field);
        let span = match (&located.key, located.missing.is_empty()) {
            (Some(key), false) => key.clone(),
            (None, false) => self.root.span.start..self.root.span.start,
            _ => located.node.span.clone(),
        };
        let message = format!("{field}: found {}: {reason}", self.found(field));
        self.problem_at(span, field, message, remedy.into())
    }

    /// A finding about some bytes of the file.
    pub fn problem_at(&self, span: Range<usize>, field: &str, message: String, remedy: String) -> Problem {
        let (line, column) = line_and_column(&self.text, span.start);
        let name = self.path.display().to_string();
        let message = match self.blamed(field) {
            Some(blamed) => format!("{message} (set on the command line: `--set {}`)", blamed.argument),
            None => message,
        };
        Problem {
            place: format!("{name}:{line}:{column}"),
            message,
            remedy,
            text: Arc::clone(&self.excerpt),
            span: self.has_excerpts.then(|| span.into()),
        }
    }

    /// The argument of the command line that set this field or one inside it.
    fn blamed(&self, field: &str) -> Option<&Override> {
        let inside = |inner: &str, outer: &str| {
            !outer.is_empty()
                && inner.strip_prefix(outer).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let hit = |change: &&Override| inside(field, &change.field) || inside(&change.field, field);
        self.overrides.iter().rev().find(hit)
    }
}

/// Line and column of a byte, both counted from 1, columns in characters.
pub fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = &text[..offset];
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// The byte at a line and column, both counted from 1, columns in characters; the end of the text beyond it.
pub fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let line_start = match line {
        0 | 1 => 0,
        _ => text.match_indices('\n').nth(line - 2).map_or(text.len(), |(at, _)| at + 1),
    };
    let rest = &text[line_start..];
    line_start + rest.char_indices().nth(column.saturating_sub(1)).map_or(rest.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::super::problem::CaseError;
    use super::*;

    fn source(text: &str) -> Source {
        Source::of_text(Path::new("scene.ron"), text.to_string()).unwrap()
    }

    #[test]
    fn places_and_bytes_agree() {
        let text = "one\nzwö: (3)\n\nend";
        for (offset, _) in text.char_indices() {
            let (line, column) = line_and_column(text, offset);
            assert_eq!(offset_of(text, line, column), offset);
        }
        assert_eq!(line_and_column(text, text.find("(3").unwrap()), (2, 6));
        assert_eq!(offset_of(text, 9, 1), text.len());
    }

    #[test]
    fn a_problem_stands_at_the_value() {
        let problem = source("(\n  part: (start_k: 20),\n)").problem("part.start_k", "too cold", "");
        assert_eq!(problem.place, "scene.ron:2:19");
        assert_eq!(problem.message, "part.start_k: found `20`: too cold");
    }

    #[test]
    fn a_problem_of_an_absent_field_stands_at_its_section() {
        let problem = source("(\n  part: (start_k: 20),\n)").problem("part.faces.top", "odd", "");
        assert_eq!(problem.place, "scene.ron:2:3");
        assert!(problem.message.contains("found nothing"));
    }

    #[test]
    fn the_outer_name_tells_the_kind_of_scene() {
        for (text, name) in [("(a: 1)", ""), ("// x\nFluid(a: 1)", "Fluid"), ("Fluid /* */ (a: 1)", "Fluid")]
        {
            assert_eq!(source(text).outer_name(), name, "{text}");
        }
    }

    #[test]
    fn the_command_line_is_named() {
        let mut source = source("(a: (b: 1))");
        source.overrides.push(Override { field: "a.b".into(), argument: "a.b=1".into() });
        assert!(source.problem("a.b", "bad", "").message.contains("--set a.b=1"));
        assert!(source.problem("a", "bad", "").message.contains("--set a.b=1"));
        assert!(!source.problem("a.bc", "bad", "").message.contains("--set"));
    }

    #[test]
    fn a_line_beyond_all_terminals_has_no_excerpt() {
        let text = format!("(a: ({}), start_k: 20)", "1,".repeat(40_000));
        let problem = source(&text).problem("start_k", "too cold", "above 50");
        assert!(problem.place.ends_with(":1:80018"), "{}", problem.place);
        let report = CaseError::from(problem).report(false);
        assert!(report.contains("found `20`: too cold") && report.len() < 1000, "{report}");
    }

    #[test]
    fn empty_files_are_refused() {
        let problem = Source::of_text(Path::new("scene.ron"), " \n".into()).unwrap_err();
        assert!(problem.to_string().contains("empty"));
    }
}
