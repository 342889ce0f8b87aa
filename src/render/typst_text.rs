//! Text that Typst prints as it is, whatever signs it holds.

/// The text as markup.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 8);
    let mut rest = text.chars().peekable();
    let mut before = None;
    while let Some(sign) = rest.next() {
        let after = rest.peek().copied();
        if sign.is_control() || matches!(sign, '\u{2028}' | '\u{2029}') {
            out.push(' ');
        } else {
            if is_read(sign, before, after) {
                out.push('\\');
            }
            out.push(sign);
        }
        before = Some(sign);
    }
    out
}

/// Whether Typst could read the sign as anything but itself. What stands around the whole text is not known.
fn is_read(sign: char, before: Option<char>, after: Option<char>) -> bool {
    let is_letter = |sign: Option<char>| sign.is_some_and(char::is_alphanumeric);
    match sign {
        // A number and a full stop begin a list, three of them are an ellipsis.
        '.' => !is_letter(after) && !before.is_some_and(char::is_alphabetic) || after == Some('.'),
        // Within a word it is a hyphen; before a digit it would become a minus sign.
        '-' => !(is_letter(before) && after.is_some_and(char::is_alphabetic)),
        ',' | ':' | '!' | '?' | '%' | '&' | '|' | '^' | '(' | ')' => false,
        // Behind a call it would be swallowed.
        ';' => before.is_none(),
        sign => sign.is_ascii_punctuation(),
    }
}

/// The language and the region of a BCP 47 tag, as Typst takes them.
pub(super) fn language(tag: &str) -> (String, Option<String>) {
    let is_word = |part: &str, lengths: &[usize]| {
        lengths.contains(&part.len()) && part.bytes().all(|letter| letter.is_ascii_alphabetic())
    };
    let mut parts = tag.split('-');
    let code = parts.next().filter(|part| is_word(part, &[2, 3])).unwrap_or("en");
    let region = parts.find(|part| is_word(part, &[2]));
    (code.to_lowercase(), region.map(str::to_uppercase))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_typst_would_read_is_escaped_and_words_are_not() {
        assert_eq!(escape("Cart A (2.5 kg) moves; a two-cart system."), "Cart A (2.5 kg) moves; a two-cart system.");
        assert_eq!(escape("#x $y$ *z* _a_ `b` <c> @d"), "\\#x \\$y\\$ \\*z\\* \\_a\\_ \\`b\\` \\<c\\> \\@d");
        assert_eq!(escape("= a"), "\\= a");
        assert_eq!(escape("1. May"), "1\\. May");
        assert_eq!(escape("a... -3 -- 4//5"), "a\\.\\.\\. \\-3 \\-\\- 4\\/\\/5");
        assert_eq!(escape("http://a.b\n\n\u{2028}c\\"), "http:\\/\\/a.b   c\\\\");
    }
}
