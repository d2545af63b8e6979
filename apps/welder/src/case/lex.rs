//! The words of RON: blanks and comments, strings, names and numbers.

/// Why the text cannot be read on, and at which byte.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LexError {
    /// The byte.
    pub offset: usize,
    /// What was found, and what is accepted.
    pub message: String,
}

/// A text and how far it was read.
pub struct Lexer<'a> {
    /// The whole text.
    pub text: &'a str,
    /// The next byte.
    pub at: usize,
}

impl<'a> Lexer<'a> {
    /// Starts at the beginning.
    pub fn new(text: &'a str) -> Self {
        Lexer { text, at: 0 }
    }

    /// What was not read yet.
    pub fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// The error that something else was expected here.
    pub fn unexpected(&self, expected: &str) -> LexError {
        let found = match self.rest().chars().next() {
            Some(character) => format!("found `{character}`"),
            None => "the file ends here".to_string(),
        };
        LexError { offset: self.at, message: format!("{found}, expected {expected}") }
    }

    fn unclosed(&self, what: &str) -> LexError {
        LexError { offset: self.at, message: format!("found no end: {what} is never closed") }
    }

    /// Takes a token if it comes next.
    pub fn take(&mut self, token: &str) -> bool {
        let hit = self.rest().starts_with(token);
        self.at += if hit { token.len() } else { 0 };
        hit
    }

    /// Goes over blanks and comments.
    pub fn skip_blank(&mut self) -> Result<(), LexError> {
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

    fn block_comment(&mut self) -> Result<(), LexError> {
        let unclosed = self.unclosed("this comment `/*`");
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

    /// Goes over `#![enable(..)]` at the head of a file.
    pub fn skip_attributes(&mut self) -> Result<(), LexError> {
        self.skip_blank()?;
        while self.rest().starts_with("#![") {
            let end = self.rest().find(']').ok_or_else(|| self.unclosed("`#![`"))?;
            self.at += end + 1;
            self.skip_blank()?;
        }
        Ok(())
    }

    /// Takes a name or number; empty when there is none.
    pub fn take_word(&mut self) -> &'a str {
        let rest = self.rest();
        let part_of_word = |character: char| character.is_alphanumeric() || "_.+-#".contains(character);
        let length = rest.find(|character| !part_of_word(character)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// Takes a string, raw string, byte string or character; says whether there was one.
    pub fn take_string(&mut self) -> Result<bool, LexError> {
        let rest = self.rest();
        let prefix = ["br", "b", "r", ""].into_iter().find(|prefix| rest.starts_with(prefix)).unwrap_or("");
        let body = &rest[prefix.len()..];
        let length = if prefix.ends_with('r') { raw_length(body) } else { quoted_length(body) };
        match length {
            None => Ok(false),
            Some(None) => Err(self.unclosed("this string")),
            Some(Some(length)) => {
                self.at += prefix.len() + length;
                Ok(true)
            }
        }
    }
}

/// Length of a quoted text with its quotes: none when it is no such text, none inside when it is not closed on its
/// line (RON would go on to the next quote of the file and find the fault there). A backslash takes the next
/// character with it.
fn quoted_length(text: &str) -> Option<Option<usize>> {
    let quote = text.chars().next().filter(|first| ['"', '\''].contains(first))?;
    let mut escaped = false;
    for (at, character) in text.char_indices().skip(1) {
        if !escaped && character == quote {
            return Some(Some(at + 1));
        }
        if quote == '"' && character == '\n' {
            break;
        }
        escaped = !escaped && character == '\\';
    }
    Some(None)
}

/// As [`quoted_length`], for the hashes and quotes of a raw string.
fn raw_length(text: &str) -> Option<Option<usize>> {
    let hashes = text.bytes().take_while(|&byte| byte == b'#').count();
    let body = text[hashes..].strip_prefix('"')?;
    let close = format!("\"{}", "#".repeat(hashes));
    Some(body.find(&close).map(|length| hashes + 1 + length + close.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn assert_string(text: &str, length: usize) {
        let mut lexer = Lexer::new(text);
        assert!(lexer.take_string().unwrap(), "{text}");
        assert_eq!(lexer.at, length, "{text}");
    }

    #[test]
    fn strings_end_where_they_end() {
        assert_string(r#""a\"b" c"#, 6);
        assert_string(r#""a\\" c"#, 5);
        assert_string("r\"a\\\" c", 5);
        assert_string("r##\"a\"# \"## c", 11);
        assert_string("br#\"a\"# c", 7);
        assert_string("b'a' c", 4);
        assert_string("'\\'' c", 4);
    }

    #[test]
    fn names_are_no_strings() {
        for text in ["r", "b", "bright", "r#type", "br#x", "rate_m_s", "é"] {
            assert_eq!(Lexer::new(text).take_string(), Ok(false), "{text}");
        }
    }

    #[test]
    fn a_forgotten_quote_is_found_on_its_line() {
        assert!(Lexer::new("\"a,\n b: \"c\"").take_string().unwrap_err().message.contains("never closed"));
        assert_string("r\"a\n b\"", 7);
    }

    #[test]
    fn comments_nest() {
        let mut lexer = Lexer::new(" /* a /* b */ c */ // d\n  e");
        lexer.skip_blank().unwrap();
        assert_eq!(lexer.rest(), "e");
    }
}
