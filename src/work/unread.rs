//! Why a side of a line cannot be read.

use momentous_grade::Unreadable;
use momentous_grade::UnreadableKind;

/// The most letters that are named where one is meant.
const MOST_NAMED: usize = 4;

/// Why a side cannot be read, as a clause; `names` are those of the problem.
pub(crate) fn said(fault: &Unreadable, names: &[String]) -> String {
    let UnreadableKind::UnknownName { name, .. } = &fault.kind else { return fault.to_string() };
    let begins = |unread: &&String| unread.starts_with(&format!("{name}_")) && !unread.contains(['(', ' ']);
    let longer: Vec<&str> = names.iter().filter(begins).take(MOST_NAMED).map(String::as_str).collect();
    match longer.as_slice() {
        [] => format!("`{name}` is no letter of this problem"),
        [only] => format!("`{name}` is no letter of this problem; did you mean {only}?"),
        [first @ .., last] => format!("which one is `{name}`: {} or {last}?", first.join(", ")),
    }
}
