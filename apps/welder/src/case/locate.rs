//! From a field path to its bytes, and from a byte to the field path around it.
//!
//! A path is written with dots: `part.size_m.2`, `laser.path.power_w`, `physics.0.weights`.

use std::ops::Range;

use super::scan::{Content, Field, Node};

/// What a path leads to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Located<'a> {
    /// The deepest value on the path that the text has.
    pub node: &'a Node,
    /// Bytes of the name of that value, when it has one.
    pub key: Option<Range<usize>>,
    /// The segments of the path that the text does not have; empty when the value itself was found.
    pub missing: Vec<String>,
}

/// Follows a path as far as the text has it.
pub fn locate<'a>(root: &'a Node, path: &str) -> Located<'a> {
    let segments: Vec<&str> = path.split('.').filter(|segment| !segment.is_empty()).collect();
    let mut found = Located { node: root, key: None, missing: Vec::new() };
    for (depth, segment) in segments.iter().enumerate() {
        let Some((key, node)) = step(found.node, segment) else {
            found.missing = segments[depth..].iter().map(|segment| (*segment).to_string()).collect();
            break;
        };
        found.node = node;
        found.key = key.or(found.key);
    }
    found
}

fn step<'a>(node: &'a Node, segment: &str) -> Option<(Option<Range<usize>>, &'a Node)> {
    match &node.content {
        Content::Scalar => None,
        Content::Fields(fields) => fields
            .iter()
            .find(|field| field.name == segment)
            .map(|field| (Some(field.key.clone()), &field.value)),
        Content::Items(items) => Some((None, items.get(segment.parse::<usize>().ok()?)?)),
    }
}

/// The path of the deepest value whose bytes, key included, hold the given byte.
pub fn path_at(root: &Node, offset: usize) -> String {
    let mut segments = Vec::new();
    let mut node = root;
    while let Some((segment, child)) = child_at(node, offset) {
        segments.push(segment);
        node = child;
    }
    segments.join(".")
}

fn child_at(node: &Node, offset: usize) -> Option<(String, &Node)> {
    match &node.content {
        Content::Scalar => None,
        Content::Items(items) => {
            let index = items.iter().position(|item| item.span.start <= offset && offset < item.span.end)?;
            Some((index.to_string(), &items[index]))
        }
        Content::Fields(fields) => fields
            .iter()
            .find(|field| field.key.start <= offset && offset < field.value.span.end)
            .map(|field| (field.name.clone(), &field.value)),
    }
}

/// All named values of the tree with their paths, outermost first.
pub fn all_fields(root: &Node) -> Vec<(String, &Field)> {
    let mut found = Vec::new();
    collect(root, "", &mut found);
    found
}

fn collect<'a>(node: &'a Node, path: &str, found: &mut Vec<(String, &'a Field)>) {
    let join =
        |segment: &str| if path.is_empty() { segment.to_string() } else { format!("{path}.{segment}") };
    match &node.content {
        Content::Scalar => {}
        Content::Items(items) => {
            items
                .iter()
                .enumerate()
                .for_each(|(index, item)| collect(item, &join(&index.to_string()), found));
        }
        Content::Fields(fields) => fields.iter().for_each(|field| {
            found.push((join(&field.name), field));
            collect(&field.value, &join(&field.name), found);
        }),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use ron::value::{Map, Value};

    use super::super::scan::scan;
    use super::*;

    const TEXT: &str = r##"// a comment with (brackets: 1)
#![enable(implicit_some)]
Scene(
    title: "a \"quoted, (text): 1", /* block /* nested */ : 2 */
    raw: r#"un"closed ("#,
    part: (size_m: (6.0e-3, -1, 3.0e-3), faces: (x_min: Symmetry, top: Losses(emissivity: 0.3))),
    physics: [Heat(weights: Auto), Heat(weights: Plain), Heat()],
    some: Some(5), some_struct: Some((inner: 7)), r#type: 'c',
    map: {"key": (value: 1), "other": 2},
)"##;

    fn value_text(path: &str) -> Option<&'static str> {
        let root = scan(TEXT).unwrap();
        let found = locate(&root, path);
        found.missing.is_empty().then(|| &TEXT[found.node.span.clone()])
    }

    #[test]
    fn paths_lead_to_their_values() {
        for (path, expected) in [
            ("title", r#""a \"quoted, (text): 1""#),
            ("raw", r##"r#"un"closed ("#"##),
            ("part.size_m.1", "-1"),
            ("part.size_m", "(6.0e-3, -1, 3.0e-3)"),
            ("part.faces.x_min", "Symmetry"),
            ("part.faces.top.emissivity", "0.3"),
            ("physics.0", "Heat(weights: Auto)"),
            ("physics.0.weights", "Auto"),
            ("physics.1.weights", "Plain"),
            ("physics.2", "Heat()"),
            ("some", "5"),
            ("some_struct.inner", "7"),
            ("type", "'c'"),
            ("map.key.value", "1"),
            ("map.other", "2"),
        ] {
            assert_eq!(value_text(path), Some(expected), "{path}");
        }
    }

    #[test]
    fn missing_values_lead_to_what_is_there() {
        let root = scan(TEXT).unwrap();
        let found = locate(&root, "part.faces.y_min.ambient_k");
        assert_eq!(found.missing, ["y_min", "ambient_k"]);
        assert_eq!(&TEXT[found.key.unwrap()], "faces");
        assert_eq!(value_text("part.size_m.3"), None);
    }

    #[test]
    fn bytes_lead_to_their_paths() {
        let root = scan(TEXT).unwrap();
        for (needle, path) in
            [("-1", "part.size_m.1"), ("0.3", "part.faces.top.emissivity"), ("7)", "some_struct.inner")]
        {
            assert_eq!(path_at(&root, TEXT.find(needle).unwrap()), path);
        }
    }

    fn values() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            any::<f64>()
                .prop_filter("finite", |number| number.is_finite())
                .prop_map(|number| Value::Number(number.into())),
            ".*".prop_map(Value::String),
            any::<char>().prop_map(Value::Char),
            any::<bool>().prop_map(Value::Bool),
            Just(Value::Unit),
        ];
        leaf.prop_recursive(4, 24, 4, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..4).prop_map(Value::Seq),
                inner.clone().prop_map(|value| Value::Option(Some(Box::new(value)))),
                prop::collection::btree_map("[a-z]{1,6}", inner, 0..4).prop_map(|map| {
                    let pairs = map.into_iter().map(|(key, value)| (Value::String(key), value));
                    Value::Map(pairs.collect::<Map>())
                }),
            ]
        })
    }

    /// Every value of the tree, cut out of the text and parsed alone, is the value that the whole text has there.
    fn assert_places(text: &str, node: &Node, value: &Value) {
        let value = match value {
            Value::Option(Some(inner)) => return assert_places(text, node, inner),
            other => other,
        };
        let cut: Value = ron::from_str(&text[node.span.clone()]).expect("a cut value parses");
        assert_eq!(&cut, value);
        match (value, &node.content) {
            (Value::Seq(values), Content::Items(items)) => {
                values.iter().zip(items).for_each(|(value, item)| assert_places(text, item, value));
            }
            (Value::Map(map), Content::Fields(fields)) => {
                assert_eq!(map.len(), fields.len());
                map.values().zip(fields).for_each(|(value, field)| assert_places(text, &field.value, value));
            }
            _ => {}
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..Default::default() })]

        #[test]
        fn places_of_random_values_are_exact(value in values(), pretty in any::<bool>()) {
            let text = match pretty {
                true => ron::ser::to_string_pretty(&value, ron::ser::PrettyConfig::default()).unwrap(),
                false => ron::to_string(&value).unwrap(),
            };
            let parsed: Value = ron::from_str(&text).unwrap();
            assert_places(&text, &scan(&text).unwrap(), &parsed);
        }
    }
}
