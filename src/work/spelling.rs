//! Names as far as they tell quantities apart.

/// The letters and digits of a name, by which it is told apart.
pub(crate) fn letters(name: &str) -> String {
    name.chars().filter(|sign| sign.is_alphanumeric() || *sign == '\'').collect()
}
