//! `--set path=value`: puts a value of the command line into the text of a scene, so that later checks find its place.

use super::problem::Problem;
use super::scan::{Content, Node, scan};
use super::source::{Override, Source};

/// Applies the arguments in their order.
pub fn apply(mut source: Source, arguments: &[String]) -> Result<Source, Problem> {
    for argument in arguments {
        source = apply_one(&source, argument)?;
    }
    Ok(source)
}

fn apply_one(source: &Source, argument: &str) -> Result<Source, Problem> {
    let (field, value) = split(argument)?;
    let located = source.locate(field);
    let value = quoted_like(&source.text[located.node.span.clone()], located.missing.is_empty(), value);
    if let Err(error) = scan(&value) {
        let remedy = "give one RON value, as in --set resolution.spacing_m=25e-6".to_string();
        return Err(refuse(argument, &format!("the value is not readable: {}", error.message), remedy));
    }
    let text = match located.missing.is_empty() {
        true => splice(&source.text, located.node.span.clone(), &value),
        false => insert(source, located.node, &located.missing, &value, argument)?,
    };
    let mut changed = Source::of_text(&source.path, text)?;
    changed.overrides = source.overrides.clone();
    changed.overrides.push(Override { field: field.to_string(), argument: argument.to_string() });
    Ok(changed)
}

fn split(argument: &str) -> Result<(&str, &str), Problem> {
    let parts = argument.split_once('=').map(|(field, value)| (field.trim(), value.trim()));
    parts.filter(|(field, value)| !field.is_empty() && !value.is_empty()).ok_or_else(|| {
        let remedy = "accepted: --set path=value, as in --set resolution.spacing_m=25e-6".to_string();
        refuse(argument, "found no `path=value`", remedy)
    })
}

fn refuse(argument: &str, reason: &str, remedy: String) -> Problem {
    Problem::without_text(&format!("--set {argument}"), reason.to_string(), remedy)
}

/// Shells eat quotes: a bare word that replaces a quoted text is quoted.
fn quoted_like(old: &str, replaces: bool, value: &str) -> String {
    let quote = replaces && old.starts_with('"') && !value.starts_with(['"', 'r']);
    if quote { format!("\"{value}\"") } else { value.to_string() }
}

fn splice(text: &str, span: std::ops::Range<usize>, piece: &str) -> String {
    format!("{}{piece}{}", &text[..span.start], &text[span.end..])
}

/// Puts the missing fields at the front of the deepest section that the text has.
fn insert(
    source: &Source,
    node: &Node,
    missing: &[String],
    value: &str,
    argument: &str,
) -> Result<String, Problem> {
    let has_room = match &node.content {
        Content::Fields(_) => true,
        Content::Items(items) => items.is_empty() && source.text[node.span.clone()].ends_with(')'),
        Content::Scalar => false,
    };
    let numbered = missing.iter().any(|segment| segment.parse::<usize>().is_ok());
    if !has_room || numbered {
        let found = source.quote(node.span.clone());
        let remedy =
            format!("the value around it is {found}: set that one as a whole, or name a field that it has");
        return Err(refuse(argument, &format!("there is no `{}`", missing.join(".")), remedy));
    }
    let (first, inner) = missing.split_first().expect("something is missing");
    let nested = inner.iter().rev().fold(value.to_string(), |inside, name| format!("({name}: {inside})"));
    Ok(splice(&source.text, node.inside.start..node.inside.start, &format!("{first}: {nested}, ")))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    const TEXT: &str =
        "(\n  part: (start_k: 293.0, material: \"a\", size_m: (1, 2, 3)),\n  physics: [Heat()],\n)";

    fn set(argument: &str) -> Result<String, Problem> {
        let source = Source::of_text(Path::new("scene.ron"), TEXT.to_string()).unwrap();
        apply(source, &[argument.to_string()]).map(|source| source.text)
    }

    #[test]
    fn present_values_are_replaced() {
        assert_eq!(set("part.start_k=400").unwrap(), TEXT.replace("293.0", "400"));
        assert_eq!(set("part.size_m.1 = 5").unwrap(), TEXT.replace("1, 2, 3", "1, 5, 3"));
        assert_eq!(set("part.material=b").unwrap(), TEXT.replace("\"a\"", "\"b\""));
        assert_eq!(set("part.material=\"b\"").unwrap(), TEXT.replace("\"a\"", "\"b\""));
    }

    #[test]
    fn absent_values_are_put_in() {
        assert_eq!(
            set("part.faces.top=Symmetry").unwrap(),
            TEXT.replace("(start_k", "(faces: (top: Symmetry), start_k")
        );
        assert_eq!(set("physics.0.weights=Plain").unwrap(), TEXT.replace("Heat()", "Heat(weights: Plain, )"));
        assert_eq!(set("time=(end_s: 1)").unwrap(), TEXT.replace("(\n  part", "(time: (end_s: 1), \n  part"));
    }

    #[test]
    fn lines_stay_where_they_are() {
        let source = Source::of_text(Path::new("scene.ron"), TEXT.to_string()).unwrap();
        let source = apply(source, &["part.start_k=20".into()]).unwrap();
        let problem = source.problem("part.start_k", "too cold", "");
        assert_eq!(problem.place, "scene.ron:2:19");
        assert!(problem.message.contains("`--set part.start_k=20`"));
    }

    #[test]
    fn unusable_arguments_are_refused() {
        for argument in [
            "part.start_k",
            "=4",
            "part.start_k=",
            "part.start_k=(1",
            "part.start_k=1) (",
            "part.size_m.7=1",
            "part.start_k.deeper=1",
            "physics.1.weights=Plain",
        ] {
            let problem = set(argument).expect_err(argument);
            assert!(problem.to_string().contains(&format!("--set {argument}")), "{problem}");
        }
    }
}
