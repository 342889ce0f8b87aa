//! The font in which HTML sets mathematics, for the many machines that have none.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// The font as WOFF2, a subset of STIX Two Math (`templates/fonts/`).
pub const MATH_FONT: &[u8] = include_bytes!("../../templates/fonts/momentous-math.woff2");

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
    STANDARD.encode(bytes)
}
