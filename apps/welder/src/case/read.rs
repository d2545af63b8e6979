//! From the text of a file to its values; every failure names place, field, finding and remedy.

use std::ops::Range;

use ron::Options;
use ron::error::{Error, SpannedError};
use ron::extensions::Extensions;
use serde::de::DeserializeOwned;

use super::locate::{all_fields, path_at};
use super::nearest::suggestion;
use super::problem::Problem;
use super::source::{Source, offset_of};

/// How scenes and materials are read and written: optional values without `Some`, variants without double brackets.
pub fn ron_options() -> Options {
    Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME)
        .with_default_extension(Extensions::UNWRAP_NEWTYPES)
        .with_default_extension(Extensions::UNWRAP_VARIANT_NEWTYPES)
}

/// Parses a file that was read.
pub fn parse<T: DeserializeOwned>(source: &Source) -> Result<T, Problem> {
    ron_options().from_str(&source.text).map_err(|error| explain(source, &error))
}

/// Turns an error of the parser into a problem with place, field, finding and remedy.
fn explain(source: &Source, error: &SpannedError) -> Problem {
    let end = offset_of(&source.text, error.span.end.line, error.span.end.col);
    match &error.code {
        Error::NoSuchStructField { expected, found, .. } => unknown_field(source, end, found, expected),
        Error::NoSuchEnumVariant { expected, found, .. } => unknown_variant(source, end, found, expected),
        Error::MissingStructField { field, .. } => missing_field(source, end, field),
        Error::DuplicateStructField { field, .. } => {
            let (span, path) = key_before(source, end, field);
            let remedy = "give each field once".to_string();
            source.problem_at(span, &path, format!("{path}: found a second time"), remedy)
        }
        other => {
            wrong_value(source, offset_of(&source.text, error.span.start.line, error.span.start.col), other)
        }
    }
}

fn unknown_field(source: &Source, end: usize, found: &str, expected: &[&str]) -> Problem {
    let (span, path) = key_before(source, end, found);
    let message = format!("{path}: found an unknown field `{found}`");
    source.problem_at(span, &path, message, suggestion(found, expected))
}

fn unknown_variant(source: &Source, end: usize, found: &str, expected: &[&str]) -> Problem {
    let start = source.text[..end].rfind(found).unwrap_or(end);
    let path = path_at(&source.root, start);
    let message = format!("{path}: found an unknown choice `{found}`");
    source.problem_at(start..start + found.len(), &path, message, suggestion(found, expected))
}

fn missing_field(source: &Source, end: usize, field: &str) -> Problem {
    // The parser stops at the bracket that closes the section, or right behind it.
    let at_bracket = source.text[end..].starts_with([')', '}']);
    let closing = if at_bracket { end } else { source.text[..end].rfind([')', '}']).unwrap_or(end) };
    let section = path_at(&source.root, closing);
    let path = if section.is_empty() { field.to_string() } else { format!("{section}.{field}") };
    let what = if section.is_empty() { "the scene or material".to_string() } else { format!("`{section}`") };
    let span = source.locate(&section).key.unwrap_or(source.root.span.start..source.root.span.start + 1);
    let remedy = format!("add `{field}: ...` to {what}");
    source.problem_at(span, &path, format!("{path}: found nothing, but it is needed"), remedy)
}

/// The key of this name nearest before (or around) a byte, and its path.
fn key_before(source: &Source, end: usize, name: &str) -> (Range<usize>, String) {
    let fields = all_fields(&source.root);
    let near = fields
        .iter()
        .filter(|(_, field)| field.name == name)
        .min_by_key(|(_, field)| field.key.end.abs_diff(end));
    match near {
        Some((path, field)) => (field.key.clone(), path.clone()),
        None => (end..end, path_at(&source.root, end)),
    }
}

/// A value of the wrong type or form. The parser stops before it, or right behind it where a separator stands.
fn wrong_value(source: &Source, stop: usize, error: &Error) -> Problem {
    let rest = source.text[stop..].trim_start();
    let too_few = matches!(error, Error::ExpectedDifferentLength { .. });
    let inside = match rest.starts_with([',', ')', ']', '}']) {
        true if !too_few => source.text[..stop].trim_end().len().saturating_sub(1),
        _ => source.text.len() - rest.len(),
    };
    let path = path_at(&source.root, inside);
    let located = source.locate(&path);
    let remedy = format!("accepted: {}", accepted(error));
    let field = if path.is_empty() { "the file" } else { &path };
    let found = source.quote(located.node.span.clone());
    source.problem_at(located.node.span.clone(), &path, format!("{field}: found {found}"), remedy)
}

/// What the parser wanted, in words.
fn accepted(error: &Error) -> String {
    match error {
        Error::ExpectedFloat => "a number, as in 6.0e-3".into(),
        Error::ExpectedInteger => "a whole number without point or exponent, as in 20_000_000".into(),
        Error::InvalidIntegerDigit { .. } | Error::IntegerOutOfBounds => "a whole number, not negative".into(),
        Error::ExpectedBoolean => "true or false".into(),
        Error::ExpectedString => "a text in double quotes, as in \"aluminium\"".into(),
        Error::ExpectedArray => "a list in square brackets, as in [1.0, 2.0]".into(),
        Error::ExpectedIdentifier => "a field name, as in (field: value)".into(),
        Error::ExpectedMap => "a map in braces, as in {\"name\": (...)}".into(),
        Error::ExpectedStructLike | Error::ExpectedNamedStructLike(_) => {
            "round brackets with fields, as in (field: value), or Name(field: value); Name() takes all defaults".into()
        }
        Error::ExpectedStructLikeEnd => "no more values than the field holds, then `)`".into(),
        Error::ExpectedDifferentLength { expected, found } => format!("{expected} ({found} given)"),
        Error::InvalidValueForType { expected, found } => format!("{expected} (not {found})"),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::scene::Scene;
    use super::*;

    const GOOD: &str = r#"(
    part: (size_m: (6.0e-3, 6.0e-3, 3.0e-3), material: "aluminium-model", start_k: 293.0),
    resolution: (spacing_m: 50.0e-6),
    physics: [Heat()],
    time: (end_s: 0.05),
)"#;

    fn read(text: &str) -> Result<Scene, Problem> {
        parse(&Source::of_text(Path::new("scene.ron"), text.to_string())?)
    }

    fn failure(from: &str, to: &str) -> String {
        assert!(GOOD.contains(from), "{from}");
        let problem = read(&GOOD.replacen(from, to, 1)).unwrap_err();
        format!("{problem} help: {}", problem.remedy)
    }

    #[track_caller]
    fn assert_says(from: &str, to: &str, words: &[&str]) {
        let message = failure(from, to);
        words.iter().for_each(|word| assert!(message.contains(word), "`{word}` is not in: {message}"));
    }

    #[test]
    fn a_short_scene_is_enough() {
        let scene = read(GOOD).unwrap();
        assert_eq!(scene.heat(), Some(&Default::default()));
        assert_eq!(scene.output().frame_interval_s, 0.05 / 25.0);
    }

    #[test]
    fn unknown_fields_name_the_nearest() {
        assert_says(
            "spacing_m:",
            "spacing:",
            &["scene.ron:3:18", "resolution.spacing", "did you mean `spacing_m`"],
        );
        assert_says("Heat()", "Heat(weight: Auto)", &["scene.ron:4:20", "physics.0.weight", "`weights`"]);
    }

    #[test]
    fn unknown_choices_name_the_nearest() {
        assert_says("Heat()", "Heet()", &["scene.ron:4:15", "physics.0", "`Heet`", "`Heat`"]);
        assert_says(
            "Heat()",
            "Heat(kernel: Wendland)",
            &["scene.ron:4:28", "physics.0.kernel", "`WendlandC2`"],
        );
    }

    #[test]
    fn missing_fields_name_their_section() {
        assert_says(", start_k: 293.0", "", &["scene.ron:2:5", "part.start_k", "add `start_k"]);
        assert_says("time: (end_s: 0.05),", "", &["scene.ron:1:1", "time: found nothing"]);
    }

    #[test]
    fn wrong_types_show_what_was_found() {
        assert_says("293.0", "\"hot\"", &["scene.ron:2:84", "part.start_k", "`\"hot\"`", "a number"]);
        assert_says("\"aluminium-model\"", "7", &["part.material", "`7`", "quotes"]);
        assert_says("(6.0e-3, 6.0e-3, 3.0e-3)", "(6.0e-3, 6.0e-3)", &["part.size_m", "(6.0e-3, 6.0e-3)"]);
        assert_says("(6.0e-3, 6.0e-3, 3.0e-3)", "6.0e-3", &["part.size_m", "`6.0e-3`"]);
        assert_says("[Heat()]", "Heat()", &["scene.ron:4:14", "physics", "square brackets"]);
        assert_says("[Heat()]", "[Heat]", &["scene.ron:4:15", "physics.0", "Name()"]);
    }

    #[test]
    fn doubled_fields_are_refused() {
        assert_says("start_k: 293.0", "start_k: 293.0, start_k: 300.0", &["part.start_k", "second time"]);
    }
}
