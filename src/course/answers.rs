//! Answers as they lie in a form: whether two forms say the same, what a new answer could earn, and when what was only saved is handed in.

use std::collections::BTreeMap;

use momentous_grade::HintsSeen;
use momentous_grade::PartHistory;
use momentous_quantity::Rational;

use super::handed_in::{Draft, HintShown};
use super::moment::Moment;
use super::policy::{Policy, Unsubmitted};
use super::window::{Phase, Window};

/// Whether two forms say the same: spaces around answers, and fields in which nothing is typed, make no difference.
///
/// ```
/// use std::collections::BTreeMap;
/// use momentous_course::alike;
/// let form = |texts: &[(&str, &str)]| -> BTreeMap<String, String> {
///     texts.iter().map(|(part, text)| (part.to_string(), text.to_string())).collect()
/// };
/// assert!(alike(&form(&[("v", "3 m/s"), ("T", "")]), &form(&[("v", " 3 m/s")])));
/// assert!(!alike(&form(&[("v", "3 m/s")]), &form(&[("v", "4 m/s")])));
/// ```
#[must_use]
pub fn alike(one: &BTreeMap<String, String>, other: &BTreeMap<String, String>) -> bool {
    fn typed(form: &BTreeMap<String, String>) -> impl Iterator<Item = (&str, &str)> {
        form.iter().map(|(part, text)| (part.as_str(), text.trim())).filter(|(_, text)| !text.is_empty())
    }
    typed(one).eq(typed(other))
}

/// The share of its points that a new answer to a part can earn in a phase; nothing where it would not be marked.
///
/// `history` is what was handed in at the part, `hints` those that were shown on the sheet.
#[must_use]
pub fn worth(
    policy: &Policy,
    (part, history): (&str, Option<&PartHistory>),
    hints: &[HintShown],
    phase: &Phase,
) -> Option<Rational> {
    let rules = policy.rules();
    if history.is_some_and(|history| !history.is_open(&rules)) {
        return None;
    }
    let factor = match phase {
        Phase::Open => Rational::ONE,
        Phase::Late(late) => late.factor.clone(),
        Phase::NotOpen | Phase::Over | Phase::Closed => return None,
    };
    let shown = |part_of_hint: Option<&str>| hints.iter().filter(|hint| hint.part.as_deref() == part_of_hint).count();
    let [hints, further] =
        [None, Some(part)].map(|part_of_hint| u32::try_from(shown(part_of_hint)).unwrap_or(u32::MAX));
    Some(rules.left(history.map_or(0, PartHistory::made), HintsSeen { hints, further }) * factor)
}

/// Whether what a student saved is to be handed in at a moment by itself: the policy says so, no more is taken from the student, and it was
/// saved in time, after what was handed in last.
#[must_use]
pub fn is_due_at_close(policy: &Policy, window: &Window, draft: &Draft, last: Option<Moment>, at: Moment) -> bool {
    policy.unsubmitted == Unsubmitted::HandIn
        && draft.settled.is_none()
        && matches!(window.phase(at), Phase::Over | Phase::Closed)
        && matches!(window.phase(draft.saved), Phase::Open | Phase::Late(_))
        && last.is_none_or(|last| draft.saved > last)
}
