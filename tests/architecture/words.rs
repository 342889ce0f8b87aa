//! Rust read as words: enough to see what a file mentions, without its comments and literals.

/// A path as it stands in code: `crate::solve::Plan`, or a single word.
pub struct Mention {
    /// Its line, from 1.
    pub line: usize,
    /// Its words.
    pub path: Vec<String>,
    /// Whether `::` follows: a group or a star.
    pub open: bool,
    /// How many modules written out in this file enclose it.
    pub modules: usize,
}

/// Every path and word of a code without comments and literals.
pub fn mentions(code: &str) -> Vec<Mention> {
    let mut found: Vec<Mention> = Vec::new();
    let mut braces: Vec<bool> = Vec::new();
    let mut statement: Vec<String> = Vec::new();
    let (mut rest, mut line) = (code, 1);
    while let Some(first) = rest.chars().next() {
        let word = rest.len() - rest.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_').len();
        if word == 0 {
            match first {
                '\n' => line += 1,
                '{' => braces.push(statement.iter().rev().nth(1).is_some_and(|word| word == "mod")),
                '}' => drop(braces.pop()),
                _ => {}
            }
            if "{};".contains(first) {
                statement.clear();
            }
            rest = &rest[first.len_utf8()..];
            continue;
        }
        let name = rest[..word].to_owned();
        rest = &rest[word..];
        let open = rest.starts_with("::");
        match found.last_mut() {
            Some(last) if last.open && code[..code.len() - rest.len() - word].ends_with("::") => {
                last.path.push(name.clone());
                last.open = open;
            }
            _ => {
                let modules = braces.iter().filter(|module| **module).count();
                found.push(Mention { line, path: vec![name.clone()], open, modules });
            }
        }
        statement.push(name);
    }
    found
}

/// The text line for line, with comments and literals blanked out.
pub fn code_of(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let hidden = hidden(rest);
        let taken = if hidden == 0 { first.len_utf8() } else { hidden };
        let blank = |c: char| if c == '\n' || hidden == 0 { c } else { ' ' };
        code.extend(rest[..taken].chars().map(blank));
        rest = &rest[taken..];
    }
    code
}

/// How many bytes of comment or literal a text starts with.
fn hidden(rest: &str) -> usize {
    let until = |from: usize, end: &str| {
        rest.get(from..).and_then(|tail| tail.find(end)).map_or(rest.len(), |at| from + at + end.len())
    };
    let hashes = rest.strip_prefix('r').map_or(0, |tail| tail.len() - tail.trim_start_matches('#').len());
    if rest.starts_with("//") {
        rest.find('\n').unwrap_or(rest.len())
    } else if rest.starts_with("/*") {
        until(2, "*/")
    } else if rest.starts_with('r') && rest[1 + hashes..].starts_with('"') {
        until(2 + hashes, &format!("\"{}", "#".repeat(hashes)))
    } else if let Some(tail) = rest.strip_prefix('"') {
        let mut escaped = false;
        let closes = |c: char| {
            let closes = c == '"' && !escaped;
            escaped = c == '\\' && !escaped;
            closes
        };
        tail.find(closes).map_or(rest.len(), |at| at + 2)
    } else if rest.starts_with("'\\") {
        until(3, "'")
    } else if rest.starts_with('\'') && rest.chars().nth(2) == Some('\'') {
        rest.chars().take(3).map(char::len_utf8).sum()
    } else {
        0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_literals_are_blank_and_lines_stay() {
        for (text, code) in [
            ("a // b\nc", "a     \nc"),
            ("a /* b\n */ c", "a     \n    c"),
            ("a \"\\\"b\" c", "a       c"),
            ("a \"\\\\\" c", "a      c"),
            ("a br#\"b\"c\"# d", "a b         d"),
            ("a '\"' '\\'' '\\u{e9}' 'é' c", "a                       c"),
            ("f<'a>(r: &'a str)", "f<'a>(r: &'a str)"),
            ("a \"never closed", "a              "),
        ] {
            assert_eq!(code_of(text), code, "{text}");
        }
    }

    #[test]
    fn a_path_is_one_mention_with_its_surroundings() {
        let code = "use crate::expr::Expr;\nmod tests { use super::*; }\nuse ::tera::{Tera};";
        let found = mentions(code);
        let expr = &found[1];
        assert_eq!((expr.line, expr.path.join("::").as_str()), (1, "crate::expr::Expr"));
        let star = found.iter().find(|mention| mention.path == ["super"]).unwrap();
        assert_eq!((star.line, star.open, star.modules), (2, true, 1));
        let group = found.iter().find(|mention| mention.path == ["tera"]).unwrap();
        assert_eq!((group.line, group.open, group.modules), (3, true, 0));
    }
}
