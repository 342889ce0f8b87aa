//! The font in which HTML sets mathematics, for the many machines that have none.

/// The font as WOFF2, a subset of STIX Two Math (`templates/fonts/`).
pub const MATH_FONT: &[u8] = include_bytes!("../../templates/fonts/momentous-math.woff2");

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The rule of a style sheet that holds the font.
pub(super) fn rule() -> String {
    let font = base64(MATH_FONT);
    format!(
        "@font-face {{ font-family: \"Momentous Math\"; src: url(data:font/woff2;base64,{font}) format(\"woff2\"); }}\n"
    )
}

/// Bytes in the 64 digits of RFC 4648.
#[must_use]
pub fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let bits = (0..3).fold(0, |bits, index| bits << 8 | usize::from(group.get(index).copied().unwrap_or(0)));
        for place in 0..4 {
            let digit = char::from(DIGITS[bits >> (18 - 6 * place) & 63]);
            text.push(if place <= group.len() { digit } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;

    /// The test vectors of RFC 4648, section 10, and the highest digits.
    #[test]
    fn base64_is_that_of_its_standard() {
        for (bytes, expected) in [
            (&b""[..], ""),
            (b"f", "Zg=="),
            (b"fo", "Zm8="),
            (b"foo", "Zm9v"),
            (b"foob", "Zm9vYg=="),
            (b"fooba", "Zm9vYmE="),
            (b"foobar", "Zm9vYmFy"),
            (b"\xfb\xff\xfe", "+//+"),
        ] {
            assert_eq!(base64(bytes), expected);
        }
    }
}
