//! Usual slips with a direction: the supplement, the complement, the other axis, the other sense.

use super::super::number::Number;
use super::super::verdict::Verdict;
use super::closeness::Target;

/// The slip that leads to the number, where there is one.
pub(super) fn slip(target: &Target, number: &Number) -> Option<Verdict> {
    let turn = target.turn()?;
    let (right, given) = (target.value(), number.to_f64());
    let tables = [
        (Verdict::AngleOtherSense, -right),
        (Verdict::AngleSupplement, turn / 2.0 - right),
        (Verdict::AngleComplement, turn / 4.0 - right),
        (Verdict::AngleReversed, right + turn / 2.0),
        (Verdict::AngleOtherAxis, right + turn / 4.0),
        (Verdict::AngleOtherAxis, right - turn / 4.0),
    ];
    let is_near = |wrong: f64| {
        let difference = given - wrong;
        (difference - libm::round(difference / turn) * turn).abs() <= target.tolerance()
    };
    tables.into_iter().find(|(_, wrong)| is_near(*wrong)).map(|(verdict, _)| verdict)
}
