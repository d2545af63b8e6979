//! Where each value stands in a RON text: a tree of byte ranges, without the values themselves.
//!
//! The `ron` crate parses values but forgets their places; later checks need them. This scanner knows the shape of
//! RON only: structs, enum variants, tuples, lists, maps.

use std::ops::Range;

use super::lex::{LexError, Lexer};

/// A value and the bytes it fills, the name of its struct or variant included.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Node {
    /// Bytes of the value.
    pub span: Range<usize>,
    /// Bytes between the brackets; the whole value when it has none.
    pub inside: Range<usize>,
    /// What the value holds.
    pub content: Content,
}

/// What a value holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// A number, string, bare name.
    Scalar,
    /// A tuple or list; also a struct or variant with empty brackets.
    Items(Vec<Node>),
    /// A struct, a variant with fields, or a map.
    Fields(Vec<Field>),
}

/// A named value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Field {
    /// The name; for maps the text of the key without quotes.
    pub name: String,
    /// Bytes of the name.
    pub key: Range<usize>,
    /// The value.
    pub value: Node,
}

/// Why the text is not RON, where, and in which field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScanError {
    /// Byte at which the scan stopped.
    pub offset: usize,
    /// The field in which it stopped, as in `part.size_m.0`; empty at the root.
    pub path: String,
    /// What was found there, and what is accepted.
    pub message: String,
}

/// Deepest nesting accepted; scenes need about six levels.
const MAX_DEPTH: usize = 64;

/// Scans a whole text: one value with comments around it.
pub fn scan(text: &str) -> Result<Node, ScanError> {
    let mut scanner = Scanner { lexer: Lexer::new(text), path: Vec::new() };
    scanner.document().map_err(|error| ScanError {
        offset: error.offset,
        path: scanner.path.join("."),
        message: error.message,
    })
}

/// Reads values; `path` is left as it is when an error ends the scan, so that the error can name its field.
struct Scanner<'a> {
    lexer: Lexer<'a>,
    path: Vec<String>,
}

impl Scanner<'_> {
    fn document(&mut self) -> Result<Node, LexError> {
        self.lexer.skip_attributes()?;
        let root = self.value()?;
        self.lexer.skip_blank()?;
        match self.lexer.rest().is_empty() {
            true => Ok(root),
            false => Err(self.lexer.unexpected("nothing more after the end of the value")),
        }
    }

    fn value(&mut self) -> Result<Node, LexError> {
        self.lexer.skip_blank()?;
        if self.path.len() > MAX_DEPTH {
            return Err(self.lexer.unexpected(&format!("at most {MAX_DEPTH} nested levels")));
        }
        let start = self.lexer.at;
        match self.lexer.rest().chars().next() {
            Some('(') => self.bracketed(start, ')'),
            Some('[') => self.bracketed(start, ']'),
            Some('{') => self.bracketed(start, '}'),
            _ => self.scalar_or_named(start),
        }
    }

    fn scalar_or_named(&mut self, start: usize) -> Result<Node, LexError> {
        let is_string = self.lexer.take_string()?;
        if !is_string && self.lexer.take_word().is_empty() {
            return Err(self.lexer.unexpected("a value"));
        }
        let end = self.lexer.at;
        let name = self.lexer.text[start..end].to_string();
        let is_name = !is_string && name.starts_with(|first: char| first.is_alphabetic() || first == '_');
        if is_name {
            self.lexer.skip_blank()?;
            if self.lexer.rest().starts_with('(') {
                let node = self.bracketed(start, ')')?;
                return Ok(if name == "Some" { unwrap_some(node) } else { node });
            }
            self.lexer.at = end;
        }
        Ok(Node { span: start..end, inside: start..end, content: Content::Scalar })
    }

    fn bracketed(&mut self, start: usize, close: char) -> Result<Node, LexError> {
        let open_at = self.lexer.at;
        self.lexer.at += 1;
        let (mut fields, mut items) = (Vec::new(), Vec::new());
        loop {
            self.lexer.skip_blank()?;
            if self.lexer.rest().starts_with(close) {
                break;
            }
            if self.lexer.rest().is_empty() {
                let bracket = &self.lexer.text[open_at..=open_at];
                let message = format!("the bracket `{bracket}` is never closed by `{close}`");
                return Err(LexError { offset: open_at, message });
            }
            match self.key(close)? {
                Some((name, key)) => fields.push(Field { value: self.at_segment(name.clone())?, name, key }),
                None => items.push(self.at_segment(items.len().to_string())?),
            }
            self.separator(close)?;
        }
        let inside = open_at + 1..self.lexer.at;
        self.lexer.at += 1;
        let content = if fields.is_empty() { Content::Items(items) } else { Content::Fields(fields) };
        Ok(Node { span: start..self.lexer.at, inside, content })
    }

    fn separator(&mut self, close: char) -> Result<(), LexError> {
        self.lexer.skip_blank()?;
        let rest = self.lexer.rest();
        if rest.starts_with(close) || rest.is_empty() || self.lexer.take(",") {
            return Ok(());
        }
        Err(self.lexer.unexpected(&format!("`,` or `{close}`")))
    }

    fn at_segment(&mut self, segment: String) -> Result<Node, LexError> {
        self.path.push(segment);
        let value = self.value()?;
        self.path.pop();
        Ok(value)
    }

    /// The key before a value, up to and with its colon; in `( )` and `[ ]` there may be none.
    fn key(&mut self, close: char) -> Result<Option<(String, Range<usize>)>, LexError> {
        let start = self.lexer.at;
        if !self.lexer.take_string()? {
            self.lexer.take_word();
        }
        let key = start..self.lexer.at;
        self.lexer.skip_blank()?;
        let is_key = !key.is_empty() && close != ']' && self.lexer.take(":");
        if !is_key && close == '}' {
            return Err(self.lexer.unexpected("`key: value`"));
        }
        if !is_key {
            self.lexer.at = start;
            return Ok(None);
        }
        let name = self.lexer.text[key.clone()].trim_start_matches("r#").trim_matches('"').to_string();
        Ok(Some((name, key)))
    }
}

/// `Some(value)` is `value`.
fn unwrap_some(mut node: Node) -> Node {
    match &mut node.content {
        Content::Items(items) if items.len() == 1 => items.remove(0),
        _ => node,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(text: &str) -> (usize, String) {
        let error = scan(text).expect_err(text);
        (error.offset, error.message)
    }

    #[test]
    fn broken_texts_name_the_place() {
        assert_eq!(message("(a: 1, b: (2, 3)").0, 0);
        assert!(message("(a: 1, b: (2, 3)").1.contains("never closed"));
        assert_eq!(message("(a: 1 b: 2)").0, 6);
        assert_eq!(message("(a: )").0, 4);
        assert_eq!(message("(a: \"text)").0, 4);
        assert_eq!(message("(a: 1) x").0, 7);
        assert_eq!(message("/* /* */ (a: 1)").0, 0);
        assert!(message("").1.contains("ends"));
        assert!(message("{1, 2}").1.contains("key: value"));
    }

    #[test]
    fn errors_name_the_field() {
        assert_eq!(scan("(part: (size: (1, ;)))").unwrap_err().path, "part.size.1");
    }

    #[test]
    fn deep_nesting_is_refused_not_a_crash() {
        assert!(message(&"(".repeat(100_000)).1.contains("nested"));
    }

    #[test]
    fn any_text_is_scanned_without_panic() {
        for text in ["r", "b", "br", "r#", "r#\"", "b'", "rr\"a\"", "é(", "(é: 1)", "'\\", "#![", "brb\"x\""]
        {
            let _ = scan(text);
        }
    }
}
