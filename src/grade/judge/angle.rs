//! Usual slips with a direction: the supplement, the complement, the other axis, the other sense.

use super::super::number::Number;
use super::super::verdict::Verdict;
use super::closeness::Target;

/// The values of a direction by each slip.
pub(super) fn slips(target: &Target) -> Vec<(Verdict, f64)> {
    let Some(turn) = target.turn() else { return Vec::new() };
    let right = target.value();
    vec![
        (Verdict::AngleOtherSense, -right),
        (Verdict::AngleSupplement, turn / 2.0 - right),
        (Verdict::AngleComplement, turn / 4.0 - right),
        (Verdict::AngleReversed, right + turn / 2.0),
        (Verdict::AngleOtherAxis, right + turn / 4.0),
        (Verdict::AngleOtherAxis, right - turn / 4.0),
    ]
}

/// The slip that leads to the number, where there is one.
pub(super) fn slip(target: &Target, number: &Number) -> Option<Verdict> {
    let turn = target.turn()?;
    let given = number.to_f64();
    let is_near = |wrong: f64| {
        let difference = given - wrong;
        (difference - libm::round(difference / turn) * turn).abs() <= target.tolerance()
    };
    slips(target).into_iter().find(|(_, wrong)| is_near(*wrong)).map(|(verdict, _)| verdict)
}
