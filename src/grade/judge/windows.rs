//! Which numbers get which verdict: the judge's decisions on a bare number, as intervals. Programs that know nothing of this judge
//! can mark by them.

use super::super::expected::ExpectedNumber;
use super::super::verdict::Verdict;
use super::closeness::Target;
use super::{angle, slip};

/// How far the window of a whole number reaches to both sides.
pub const BESIDE_A_WHOLE_NUMBER: f64 = 0.25;

/// Numbers in the unit of the question that get one verdict; both ends belong to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerdictWindow {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The verdict.
    pub verdict: Verdict,
}

impl VerdictWindow {
    fn around(middle: f64, reach: f64, verdict: Verdict) -> Self {
        Self { low: middle - reach, high: middle + reach, verdict }
    }

    /// Whether a number belongs to it.
    #[must_use]
    pub fn contains(&self, number: f64) -> bool {
        (self.low..=self.high).contains(&number)
    }
}

/// An interval of directions, brought by whole turns to within half a turn of a right one, and cut at the opposite direction:
/// so each direction is met once.
#[must_use]
pub fn brought_near([low, high]: [f64; 2], right: f64, turn: f64) -> Vec<[f64; 2]> {
    let away = low + (high - low) / 2.0 - right;
    let turns = libm::round(away / turn) * turn;
    let [low, high] = [low - turns, high - turns];
    let [first, last] = [right - turn / 2.0, right + turn / 2.0];
    if high > last {
        vec![[low, last], [first, high - turn]]
    } else if low < first {
        vec![[first, high], [low + turn, last]]
    } else {
        vec![[low, high]]
    }
}

/// The windows of a number, the more important first; where two overlap, the first decides. Directions are within half a turn of the
/// right one. Whatever lies in none of them is wrong.
///
/// What depends on how a number is written (its figures, its unit) is no window: these are for the number alone. Of a whole number
/// the windows reach a quarter to both sides, so that they have a width.
#[must_use]
pub fn windows(expected: &ExpectedNumber) -> Vec<VerdictWindow> {
    let target = Target::new(expected);
    let (right, tolerance, allowance) = (target.value(), target.reach(), target.allowance_reach());
    let mut all = vec![
        VerdictWindow::around(right, tolerance, Verdict::Right),
        VerdictWindow::around(right, allowance, Verdict::RightRounded),
    ];
    if let Some(turn) = target.turn() {
        // The opposite of a size is only written with a minus sign; what is found first decides.
        let opposite = expected.is_magnitude().then_some((Verdict::RightWithNote, -right));
        for (verdict, wrong) in opposite.into_iter().chain(angle::slips(&target)) {
            let reach = if verdict.is_right() { tolerance.max(allowance) } else { target.tolerance() };
            let near = brought_near([wrong - reach, wrong + reach], right, turn);
            all.extend(near.into_iter().map(|[low, high]| VerdictWindow { low, high, verdict }));
        }
        return all;
    }
    if expected.whole {
        return vec![VerdictWindow::around(right, BESIDE_A_WHOLE_NUMBER, Verdict::Right)];
    }
    let opposite = match (expected.is_magnitude(), right < 0.0) {
        (true, _) => Verdict::RightWithNote,
        // Without its sign, the number says nothing of the direction.
        (false, true) => Verdict::Sense,
        (false, false) => Verdict::SenseReversed,
    };
    all.push(VerdictWindow::around(-right, tolerance.max(allowance), opposite));
    all.extend(slip::shifted(&target).map(|(power, verdict)| {
        let scale = libm::pow(10.0, f64::from(power));
        VerdictWindow::around(right * scale, target.reach_of_digits() * scale, verdict)
    }));
    all
}

#[cfg(test)]
mod tests {
    use super::brought_near;

    /// An interval over the opposite direction lies at both ends and nowhere else: images by a whole turn do not overlap.
    #[test]
    fn an_interval_is_cut_at_the_opposite_direction() {
        assert_eq!(brought_near([400.0, 410.0], 30.0, 360.0), [[40.0, 50.0]]);
        assert_eq!(brought_near([205.0, 214.0], 30.0, 360.0), [[205.0, 210.0], [-150.0, -146.0]]);
        assert_eq!(brought_near([-152.0, -140.0], 30.0, 360.0), [[-150.0, -140.0], [208.0, 210.0]]);
    }
}
