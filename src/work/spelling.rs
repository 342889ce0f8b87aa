//! Names as far as they tell quantities apart.

/// What of a name tells it apart: its letters and digits.
pub(crate) fn letters(name: &str) -> String {
    name.chars().filter(|sign| sign.is_alphanumeric() || *sign == '\'').collect()
}
