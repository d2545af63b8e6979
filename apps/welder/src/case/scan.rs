//! Where each value stands in a RON text: a tree of byte ranges, without the values themselves.
//!
//! The `ron` crate parses values but forgets their places; later checks need them. This scanner knows the shape of
//! RON only: structs, enum variants, tuples, lists, maps, strings, raw strings, comments.

use std::ops::Range;

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
    let mut scanner = Scanner { text, at: 0, path: Vec::new() };
    scanner.skip_attributes()?;
    let root = scanner.value()?;
    scanner.skip_blank()?;
    if scanner.at < text.len() {
        let found = scanner.found();
        return Err(scanner.error(format!("{found} after the end of the value; nothing more is accepted")));
    }
    Ok(root)
}

struct Scanner<'a> {
    text: &'a str,
    at: usize,
    path: Vec<String>,
}

impl Scanner<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn error(&self, message: String) -> ScanError {
        ScanError { offset: self.at, path: self.path.join("."), message }
    }

    fn found(&self) -> String {
        match self.rest().chars().next() {
            Some(character) => format!("found `{character}`"),
            None => "the file ends here".to_string(),
        }
    }

    fn take(&mut self, token: &str) -> bool {
        let hit = self.rest().starts_with(token);
        if hit {
            self.at += token.len();
        }
        hit
    }

    fn skip_blank(&mut self) -> Result<(), ScanError> {
        loop {
            let rest = self.rest();
            self.at += rest.len() - rest.trim_start().len();
            if self.rest().starts_with("//") {
                self.at += self.rest().find('\n').unwrap_or(self.rest().len());
            } else if self.rest().starts_with("/*") {
                self.block_comment()?;
            } else {
                return Ok(());
            }
        }
    }

    fn block_comment(&mut self) -> Result<(), ScanError> {
        let unclosed = self.error("this comment `/*` is never closed by `*/`".to_string());
        let mut depth = 0;
        loop {
            if self.take("/*") {
                depth += 1;
            } else if self.take("*/") {
                depth -= 1;
                if depth == 0 {
                    return Ok(());
                }
            } else {
                self.at += self.rest().chars().next().ok_or_else(|| unclosed.clone())?.len_utf8();
            }
        }
    }

    fn skip_attributes(&mut self) -> Result<(), ScanError> {
        self.skip_blank()?;
        while self.rest().starts_with("#![") {
            let end = self.rest().find(']').ok_or_else(|| self.error("`#![` is never closed".to_string()))?;
            self.at += end + 1;
            self.skip_blank()?;
        }
        Ok(())
    }

    fn value(&mut self) -> Result<Node, ScanError> {
        self.skip_blank()?;
        if self.path.len() > MAX_DEPTH {
            return Err(self.error(format!("nested deeper than {MAX_DEPTH} levels")));
        }
        let start = self.at;
        match self.rest().chars().next() {
            Some('(') => self.bracketed(start, ')'),
            Some('[') => self.bracketed(start, ']'),
            Some('{') => self.bracketed(start, '}'),
            _ => self.scalar_or_named(start),
        }
    }

    fn scalar_or_named(&mut self, start: usize) -> Result<Node, ScanError> {
        if !self.take_string()? && self.take_word().is_empty() {
            let found = self.found();
            return Err(self.error(format!("{found}, expected a value")));
        }
        let end = self.at;
        let name = &self.text[start..end];
        let can_have_brackets = name.starts_with(|first: char| first.is_alphabetic() || first == '_');
        if can_have_brackets && !name.contains('"') {
            let some = name == "Some";
            self.skip_blank()?;
            if self.rest().starts_with('(') {
                let mut node = self.bracketed(start, ')')?;
                return Ok(if some { unwrap_some(&mut node) } else { node });
            }
            self.at = end;
        }
        Ok(Node { span: start..end, inside: start..end, content: Content::Scalar })
    }

    fn take_word(&mut self) -> String {
        let word = |character: char| character.is_alphanumeric() || "_.+-#".contains(character);
        let length = self.rest().find(|character| !word(character)).unwrap_or(self.rest().len());
        let taken = self.rest()[..length].to_string();
        self.at += length;
        taken
    }

    /// Takes a string, raw string, byte string or character; says whether there was one.
    fn take_string(&mut self) -> Result<bool, ScanError> {
        let unclosed = self.error("this string is never closed".to_string());
        let prefix = self.rest().len() - self.rest().trim_start_matches(['b', 'r']).len();
        let raw = self.rest()[..prefix.min(2)].contains('r');
        let hashes = self.rest()[prefix..].bytes().take_while(|&byte| byte == b'#').count();
        let body = &self.rest()[prefix.min(2)..];
        if prefix <= 2 && raw && body[hashes..].starts_with('"') {
            let close = format!("\"{}", "#".repeat(hashes));
            let length = body[hashes + 1..].find(&close).ok_or(unclosed)?;
            self.at += prefix + hashes + 1 + length + close.len();
            return Ok(true);
        }
        if prefix <= 1 && !raw && body.starts_with(['"', '\'']) {
            let length = closing_quote(body).ok_or(unclosed)?;
            self.at += prefix + length;
            return Ok(true);
        }
        Ok(false)
    }

    fn bracketed(&mut self, start: usize, close: char) -> Result<Node, ScanError> {
        let open_at = self.at;
        self.at += 1;
        let mut fields = Vec::new();
        let mut items = Vec::new();
        loop {
            self.skip_blank()?;
            if self.rest().starts_with(close) {
                break;
            }
            if self.rest().is_empty() {
                let bracket = &self.text[open_at..=open_at];
                let message = format!("the bracket `{bracket}` is never closed by `{close}`");
                return Err(ScanError { offset: open_at, path: self.path.join("."), message });
            }
            match self.key(close)? {
                Some((name, key)) => fields.push(self.field(name, key)?),
                None => items.push(self.item(items.len())?),
            }
            self.separator(close)?;
        }
        let inside = open_at + 1..self.at;
        self.at += 1;
        let content = if fields.is_empty() { Content::Items(items) } else { Content::Fields(fields) };
        Ok(Node { span: start..self.at, inside, content })
    }

    fn separator(&mut self, close: char) -> Result<(), ScanError> {
        self.skip_blank()?;
        if self.take(",") || self.rest().starts_with(close) || self.rest().is_empty() {
            return Ok(());
        }
        let found = self.found();
        Err(self.error(format!("{found}, expected `,` or `{close}`")))
    }

    fn field(&mut self, name: String, key: Range<usize>) -> Result<Field, ScanError> {
        self.path.push(name.clone());
        let value = self.value()?;
        self.path.pop();
        Ok(Field { name, key, value })
    }

    fn item(&mut self, index: usize) -> Result<Node, ScanError> {
        self.path.push(index.to_string());
        let value = self.value()?;
        self.path.pop();
        Ok(value)
    }

    /// The key before a value, up to and with its colon; in `( )` and `[ ]` there may be none.
    fn key(&mut self, close: char) -> Result<Option<(String, Range<usize>)>, ScanError> {
        let start = self.at;
        if !self.take_string()? {
            self.take_word();
        }
        let key = start..self.at;
        self.skip_blank()?;
        let is_key = !key.is_empty() && close != ']' && self.take(":");
        if !is_key {
            if close == '}' {
                let found = self.found();
                return Err(self.error(format!("{found}, expected `key: value`")));
            }
            self.at = start;
            return Ok(None);
        }
        let name = self.text[key.clone()].trim_start_matches("r#").trim_matches('"').to_string();
        Ok(Some((name, key)))
    }
}

/// `Some(value)` is `value`, with the span of the whole.
fn unwrap_some(node: &mut Node) -> Node {
    match &mut node.content {
        Content::Items(items) if items.len() == 1 => items.remove(0),
        _ => node.clone(),
    }
}

/// Length of a quoted text with its quotes; a backslash takes the next character with it.
fn closing_quote(text: &str) -> Option<usize> {
    let quote = text.chars().next()?;
    let mut escaped = false;
    for (at, character) in text.char_indices().skip(1) {
        if !escaped && character == quote {
            return Some(at + 1);
        }
        escaped = !escaped && character == '\\';
    }
    None
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
