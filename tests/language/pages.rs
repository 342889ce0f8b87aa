//! The pages on the problem language.

macro_rules! page {
    ($path:literal) => {
        ($path, include_str!(concat!("../../", $path)))
    };
}

/// Every page on the language: its path, and its text.
pub const PAGES: [(&str, &str); 8] = [
    page!("docs/language.md"),
    page!("docs/language/questions.md"),
    page!("docs/language/impacts.md"),
    page!("docs/language/forces.md"),
    page!("docs/language/circles.md"),
    page!("docs/language/flights.md"),
    page!("docs/language/streams.md"),
    page!("docs/language/reference.md"),
];

/// All of them as one text.
pub fn language() -> String {
    PAGES.iter().map(|(_, text)| *text).collect()
}
