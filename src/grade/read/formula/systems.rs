//! Other systems' syntax, in characters of the same places: `math.exp`, `%e`, `np.sqrt`.

use super::signs::NOTHING;

/// The prefixes of functions of libraries.
const LIBRARIES: [&str; 5] = ["math.", "Math.", "np.", "numpy.", "cmath."];
/// Euler's number as letters of its own.
const EULER: [char; 2] = ['\u{212f}', '\u{2147}'];
/// Before the constants of Maxima.
const CONSTANT: char = '%';

/// The characters without what only names a library or marks a constant. With `own_e` some quantity is called `e`, and Euler's number stays
/// as it is.
pub(super) fn without_libraries(signs: &mut [char], own_e: bool) {
    if !signs.iter().any(|sign| *sign == '.' || *sign == CONSTANT || EULER.contains(sign)) {
        return;
    }
    let mut before = ' ';
    for at in 0..signs.len() {
        let rest: String = signs[at..].iter().take(7).collect();
        let library = LIBRARIES.iter().find(|library| rest.starts_with(**library));
        let is_called = |library: &&&str| rest.chars().nth(library.len()).is_some_and(char::is_alphabetic);
        if let Some(library) = library.filter(is_called).filter(|_| !before.is_alphanumeric() && before != '_') {
            signs[at..at + library.len()].fill(NOTHING);
        } else if EULER.contains(&signs[at]) && !own_e {
            signs[at] = 'e';
        } else if signs[at] == CONSTANT && (rest.starts_with("%e^") && !own_e || rest.starts_with("%pi")) {
            signs[at] = NOTHING;
        }
        before = signs[at];
    }
}
