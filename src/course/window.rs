//! The rights of a moment: whether answers are taken, what being late costs, and what a student may see.

use jiff::{Span, Zoned};
use serde::{Deserialize, Serialize};

use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::assignment::{Assignment, Extension};
use super::fields::{Faults, FieldFault};
use super::key::Key;
use super::local_time;
use super::moment::Moment;
use super::people::Member;
use super::policy::{Policy, Release, SolutionRelease};
use super::policy_form::Instants;

/// The milliseconds between the close and what is released by it. An answer whose headers came before the close has thirty seconds for
/// the rest; whoever sends it has seen nothing of what is released.
pub(super) const RELEASED_AFTER: i64 = 60_000;
/// The milliseconds of most days.
const DAY: i64 = 86_400_000;

/// The times of an assignment as they are for one student.
///
/// ```
/// use momentous_course::{Moment, Phase, Policy, PolicyForm, Window};
/// let zone = "Europe/Berlin";
/// let policy = Policy::read(&PolicyForm {
///     opens: "2026-11-23T08:00".into(), due: "2026-11-30T18:00".into(), late_until: "2026-12-02T18:00".into(),
///     late_penalty: "10 %".into(), closes: "2026-12-02T18:00".into(), ..PolicyForm::default()
/// }, zone).unwrap();
/// let window = Window::of(&policy, None, zone);
/// let phase = |text| Moment::local(text, zone).map(|moment| window.phase(moment));
/// assert_eq!(phase("2026-11-30T18:00")?, Phase::Open);
/// let Phase::Late(late) = phase("2026-12-01T18:01")? else { panic!() };
/// assert_eq!((late.days, late.factor.to_string().as_str()), (2, "4/5"));
/// assert_eq!(phase("2026-12-02T18:01")?, Phase::Closed);
/// # Ok::<(), momentous_course::NoMoment>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// When students see the assignment.
    pub opens: Moment,
    /// When answers are due.
    pub due: Moment,
    /// Until when they are taken late, where they are.
    pub late_until: Option<Moment>,
    /// When nothing more is taken.
    pub closes: Moment,
    late_penalty: Rational,
    verdicts: Release,
    solutions: SolutionRelease,
    zone: jiff::tz::TimeZone,
}

/// In which phase an assignment is for a student. Each ends with its last millisecond: an answer that comes at `due` is in time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It is not open yet.
    NotOpen,
    /// Answers are taken.
    Open,
    /// Answers are taken and lose a share of their points.
    Late(Late),
    /// Answers are no longer taken; others may have more time.
    Over,
    /// It has closed: what is released at close is shown a minute later.
    Closed,
}

/// How late an answer is.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Late {
    /// The days that have started since it was due. They are days of the calendar, even where the clocks are changed.
    pub days: u32,
    /// The share of the points that is left.
    #[serde(with = "exact")]
    pub factor: Rational,
}

impl Window {
    /// The times that a policy and perhaps an extension say, in a course with this time zone (UTC where it is not known).
    #[must_use]
    pub fn of(policy: &Policy, extension: Option<&Extension>, zone: &str) -> Self {
        let Policy { opens, due, late_until, closes, .. } = *policy;
        let (due, late_until, closes) = extension
            .map_or((due, late_until, closes), |extension| (extension.due, extension.late_until, extension.closes));
        Self {
            opens,
            due,
            late_until,
            closes,
            late_penalty: policy.late_penalty.fraction().clone(),
            verdicts: policy.verdicts,
            solutions: policy.solutions,
            zone: local_time::zone(zone).unwrap_or(jiff::tz::TimeZone::UTC),
        }
    }

    /// The phase at a moment.
    #[must_use]
    pub fn phase(&self, at: Moment) -> Phase {
        if at < self.opens {
            Phase::NotOpen
        } else if at > self.closes {
            Phase::Closed
        } else if at <= self.due {
            Phase::Open
        } else if self.late_until.is_some_and(|until| at <= until) {
            Phase::Late(self.late(at))
        } else {
            Phase::Over
        }
    }

    /// Whether the student may see verdicts at a moment.
    #[must_use]
    pub fn shows_verdicts(&self, at: Moment) -> bool {
        at >= self.opens && (self.verdicts == Release::AtOnce || self.is_released(at))
    }

    /// Whether the student may see worked solutions at a moment.
    #[must_use]
    pub fn shows_solutions(&self, at: Moment) -> bool {
        self.solutions == SolutionRelease::AtClose && at >= self.opens && self.is_released(at)
    }

    /// Whether what is released at close is shown.
    fn is_released(&self, at: Moment) -> bool {
        at > self.closes.after(RELEASED_AFTER)
    }

    /// How late an answer is that comes after it was due.
    fn late(&self, at: Moment) -> Late {
        let due = self.due.timestamp().to_zoned(self.zone.clone());
        // Days may be shorter or longer than most: by an hour or, where a date was left out, by a whole one.
        let most = at.millis().saturating_sub(self.due.millis()).div_euclid(DAY).max(0);
        let near = most.saturating_sub(2).max(0)..=most.saturating_add(3);
        let days = near.into_iter().find(|days| at <= days_after(&due, *days)).unwrap_or(most);
        let days = u32::try_from(days).unwrap_or(u32::MAX);
        let left = Rational::ONE - &self.late_penalty * Rational::from(days);
        Late { days, factor: left.max(Rational::ZERO) }
    }
}

/// The same local time so many days later; the end of the calendar where there is none.
fn days_after(start: &Zoned, days: i64) -> Moment {
    let later = Span::new().try_days(days).ok().and_then(|span| start.checked_add(span).ok());
    later.map_or(Moment::from_millis(i64::MAX), |later| later.timestamp().into())
}

/// The fields of an extension.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(default)]
pub struct ExtensionForm {
    /// When answers are due.
    pub due: String,
    /// Until when they are taken late; not at all where it is empty.
    pub late_until: String,
    /// When nothing more is taken.
    pub closes: String,
    /// Why it is given.
    pub reason: String,
}

impl Extension {
    /// The extension that the fields say, for a student and an assignment in a course with this time zone.
    ///
    /// # Errors
    /// Every fault, with its field.
    pub fn read(
        form: &ExtensionForm,
        assignment: &Assignment,
        member: Key<Member>,
        zone: &str,
    ) -> Result<Self, Vec<FieldFault>> {
        let mut faults = Faults::default();
        let typed = [&*form.due, &form.late_until, &form.closes];
        let instants = Instants::read(typed, Some(assignment.policy.opens), zone, &mut faults);
        let reason = form.reason.trim();
        if reason.is_empty() {
            faults.say("reason", "say why: it is kept with the marks");
        }
        let window = instants.map(|Instants { due, late_until, closes }| Self {
            assignment: assignment.key,
            member,
            due,
            late_until,
            closes,
            reason: reason.to_owned(),
        });
        faults.or(window)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::PolicyForm;

    const ZONE: &str = "Europe/Berlin";

    /// Opens on 1 October 2026, with a tenth for each day: when answers are due, until when they are taken late, when it closes, the
    /// moment, and what is found. The clocks go back on 25 October.
    const CASES: &str = include_str!("../../tests/fixtures/course/windows.txt");

    fn window([due, late_until, closes]: [&str; 3]) -> Window {
        let form = PolicyForm {
            opens: "2026-10-01T08:00".into(),
            due: due.into(),
            late_until: late_until.into(),
            late_penalty: if late_until.is_empty() { "" } else { "10 %" }.into(),
            closes: closes.into(),
            verdicts: "at_close".into(),
            ..PolicyForm::default()
        };
        Window::of(&Policy::read(&form, ZONE).unwrap(), None, ZONE)
    }

    fn said(window: &Window, at: Moment) -> String {
        let phase = match window.phase(at) {
            Phase::NotOpen => "not open".to_owned(),
            Phase::Open => "open".to_owned(),
            Phase::Late(Late { days, factor }) => format!("late {days}: {factor}"),
            Phase::Over => "over".to_owned(),
            Phase::Closed => "closed".to_owned(),
        };
        let shown = if window.shows_verdicts(at) { "verdicts" } else { "nothing" };
        assert_eq!(window.shows_verdicts(at), window.shows_solutions(at));
        format!("{phase}, {shown}")
    }

    #[test]
    fn phases_are_those_of_the_table() {
        for case in CASES.lines().filter(|line| !line.starts_with('#')) {
            let cells: Vec<&str> = case.split('|').map(str::trim).collect();
            let [due, late_until, closes, at, expected] = cells[..] else { panic!("{case}") };
            let at = Moment::local(at, ZONE).unwrap();
            assert_eq!(said(&window([due, late_until, closes]), at), expected, "{case}");
        }
    }

    #[test]
    fn a_phase_ends_with_its_last_millisecond() {
        let window = window(["2026-10-10T18:00", "2026-10-12T18:00", "2026-10-14T18:00"]);
        for (edge, before, after) in [
            (window.opens.after(-1), "not open, nothing", "open, nothing"),
            (window.due, "open, nothing", "late 1: 9/10, nothing"),
            (window.due.after(DAY), "late 1: 9/10, nothing", "late 2: 4/5, nothing"),
            (window.due.after(2 * DAY), "late 2: 4/5, nothing", "over, nothing"),
            (window.closes, "over, nothing", "closed, nothing"),
            (window.closes.after(RELEASED_AFTER), "closed, nothing", "closed, verdicts"),
        ] {
            assert_eq!([said(&window, edge).as_str(), &said(&window, edge.after(1))], [before, after]);
        }
    }

    #[test]
    fn an_extension_replaces_the_times_of_one_student() {
        let form = PolicyForm {
            opens: "2026-10-01T08:00".into(),
            due: "2026-10-10T18:00".into(),
            closes: "2026-10-10T18:00".into(),
            ..PolicyForm::default()
        };
        let policy = Policy::read(&form, ZONE).unwrap();
        let [assignment, course] = [[1; 16], [2; 16]];
        let assignment = Assignment {
            key: Key::new(assignment),
            course: Key::new(course),
            title: String::new(),
            policy: policy.clone(),
            pinned: None,
        };
        let form = ExtensionForm {
            due: "2026-10-12T18:00".into(),
            closes: "2026-10-13T18:00".into(),
            reason: " ill ".into(),
            ..ExtensionForm::default()
        };
        let own_window = Extension::read(&form, &assignment, Key::new([3; 16]), ZONE).unwrap();
        assert_eq!(own_window.reason, "ill");
        let [all, own_window] = [Window::of(&policy, None, ZONE), Window::of(&policy, Some(&own_window), ZONE)];
        let at = Moment::local("2026-10-12T17:00", ZONE).unwrap();
        assert_eq!((all.phase(at), own_window.phase(at)), (Phase::Closed, Phase::Open));
        assert_eq!([all.shows_solutions(at), own_window.shows_solutions(at)], [true, false]);
        let wrong = ExtensionForm { due: "2026-09-12T18:00".into(), reason: "  ".into(), ..form };
        let faults = Extension::read(&wrong, &assignment, Key::new([3; 16]), ZONE).unwrap_err();
        assert_eq!(faults.iter().map(|fault| fault.field).collect::<Vec<_>>(), ["due", "reason"]);
    }

    proptest! {
        #[test]
        fn time_only_takes_away(minutes in prop::collection::vec(-60_i64..60 * 24 * 40, 2..20)) {
            let window = window(["2026-10-20T18:00", "2026-11-05T18:00", "2026-11-06T18:00"]);
            let order = |phase: &Phase| match phase {
                Phase::NotOpen => 0,
                Phase::Open => 1,
                Phase::Late(_) => 2,
                Phase::Over => 3,
                Phase::Closed => 4,
            };
            let mut moments: Vec<Moment> = minutes.iter().map(|minute| window.opens.after(minute * 60_000)).collect();
            moments.sort();
            for pair in moments.windows(2) {
                let [before, after] = [window.phase(pair[0]), window.phase(pair[1])];
                prop_assert!(order(&before) <= order(&after));
                if let (Phase::Late(before), Phase::Late(after)) = (&before, &after) {
                    prop_assert!(before.days <= after.days && before.factor >= after.factor && before.days > 0);
                }
                prop_assert!(!window.shows_verdicts(pair[0]) || window.shows_verdicts(pair[1]));
            }
        }
    }
}
