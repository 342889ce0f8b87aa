//! Names as far as they tell quantities apart.

/// The letters and digits of a name, by which it is told apart.
pub(crate) fn letters(name: &str) -> String {
    name.chars().filter(|sign| sign.is_alphanumeric() || *sign == '\'').collect()
}

/// Commands that only set a name, and the bars of a size.
const SETTING: [(&str, &str); 9] = [
    ("\\lvert", "|"),
    ("\\rvert", "|"),
    ("\\left|", "|"),
    ("\\right|", "|"),
    ("\\mathrm", ""),
    ("\\text", ""),
    ("\\left", ""),
    ("\\right", ""),
    ("\\frac", ""),
];

/// The letters of a name as it is printed, between bars where it is a size.
pub(crate) fn printed(name: &str) -> String {
    let name = SETTING.iter().fold(name.to_owned(), |name, (command, sign)| name.replace(command, sign));
    name.chars().filter(|sign| sign.is_alphanumeric() || matches!(sign, '\'' | '|')).collect()
}
