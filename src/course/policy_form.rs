//! A policy as an instructor types it.

use serde::{Deserialize, Serialize};

use super::fields::{Faults, FieldFault};
use super::moment::Moment;
use super::policy::{Policy, Release, SolutionRelease, Solvers, Unsubmitted};
use super::share::Share;

/// The most attempts that can be asked for; no number at all allows any number.
const MOST_ATTEMPTS: u32 = 100;

/// The fields of a policy: times are local, shares are written `10 %`, and what is empty has its usual meaning.
///
/// ```
/// use momentous_course::{Policy, PolicyForm, Moment};
/// let form = PolicyForm {
///     opens: "2026-11-23T08:00".into(),
///     due: "2026-11-30T18:00".into(),
///     closes: "2026-12-02T18:00".into(),
///     attempts: "3".into(),
///     attempt_penalty: "10 %".into(),
///     ..PolicyForm::default()
/// };
/// let policy = Policy::read(&form, "Europe/Berlin").unwrap();
/// assert_eq!(policy.due, Moment::local("2026-11-30T18:00", "Europe/Berlin")?);
/// assert_eq!(policy.form("Europe/Berlin").attempt_penalty, "10 %");
///
/// let faults = Policy::read(&PolicyForm { due: "2026-11-20T18:00".into(), ..form }, "Europe/Berlin").unwrap_err();
/// assert_eq!((faults[0].field, faults[0].message.as_str()), ("due", "this is before the assignment opens"));
/// # Ok::<(), momentous_course::NoMoment>(())
/// ```
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(default)]
pub struct PolicyForm {
    /// How many attempts at a part count; any number where it is empty.
    pub attempts: String,
    /// The share that each attempt before costs; none where it is empty, as with the shares below.
    pub attempt_penalty: String,
    /// The share that each of the author's hints costs.
    pub hint_penalty: String,
    /// The share that each hint on a wrong answer costs.
    pub further_penalty: String,
    /// When students see it.
    pub opens: String,
    /// When answers are due.
    pub due: String,
    /// Until when they are taken late; not at all where it is empty.
    pub late_until: String,
    /// The share that each started day after `due` costs.
    pub late_penalty: String,
    /// When nothing more is taken.
    pub closes: String,
    /// `at_once` or `at_close`; at once where it is empty.
    pub verdicts: String,
    /// `at_close` or `never`; at close where it is empty.
    pub solutions: String,
    /// `leave` or `hand_in`; left where it is empty.
    pub unsubmitted: String,
    /// `shown` or `hidden`; shown where it is empty.
    pub solvers: String,
}

/// The instants that an instructor types for a policy or an extension.
pub(super) struct Instants {
    pub(super) due: Moment,
    pub(super) late_until: Option<Moment>,
    pub(super) closes: Moment,
}

impl Policy {
    /// The policy that the fields say, in a course with this time zone.
    ///
    /// # Errors
    /// Every fault, with its field.
    pub fn read(form: &PolicyForm, zone: &str) -> Result<Self, Vec<FieldFault>> {
        let mut faults = Faults::default();
        let attempts = faults.take("attempts", attempts(&form.attempts));
        let mut share = |field, text: &str| match text.trim() {
            "" => Some(Share::default()),
            text => faults.take(field, text.parse::<Share>()),
        };
        let attempt_penalty = share("attempt_penalty", &form.attempt_penalty);
        let hint_penalty = share("hint_penalty", &form.hint_penalty);
        let further_penalty = share("further_penalty", &form.further_penalty);
        let late_penalty = share("late_penalty", &form.late_penalty);
        let opens = faults.take("opens", Moment::local(&form.opens, zone));
        let instants = Instants::read([&form.due, &form.late_until, &form.closes], opens, zone, &mut faults);
        if form.late_until.trim().is_empty() && late_penalty.as_ref().is_some_and(|share| *share != Share::default()) {
            let help = "help: say until when answers are taken late, or leave the price of a day empty";
            faults.say("late_until", format!("being late has a price, but nothing is taken late\n{help}"));
        }
        let release = |text: &str, names: &[&str; 2]| match text.trim() {
            "" => Ok(0),
            text => names.iter().position(|name| *name == text).ok_or_else(|| choose(names)),
        };
        let verdicts =
            faults.take("verdicts", release(&form.verdicts, &Release::NAMES)).and_then(|at| Release::ALL.get(at));
        let solutions = faults.take("solutions", release(&form.solutions, &SolutionRelease::NAMES));
        let solutions = solutions.and_then(|at| SolutionRelease::ALL.get(at));
        let unsubmitted = faults.take("unsubmitted", release(&form.unsubmitted, &Unsubmitted::NAMES));
        let unsubmitted = unsubmitted.and_then(|at| Unsubmitted::ALL.get(at));
        let solvers =
            faults.take("solvers", release(&form.solvers, &Solvers::NAMES)).and_then(|at| Solvers::ALL.get(at));
        let policy = || {
            let Instants { due, late_until, closes } = instants?;
            Some(Self {
                attempts: attempts?,
                attempt_penalty: attempt_penalty?,
                hint_penalty: hint_penalty?,
                further_penalty: further_penalty?,
                opens: opens?,
                due,
                late_until,
                late_penalty: late_penalty?,
                closes,
                verdicts: *verdicts?,
                solutions: *solutions?,
                unsubmitted: *unsubmitted?,
                solvers: *solvers?,
            })
        };
        faults.or(policy())
    }

    /// The fields in which the policy is typed, in a course with this time zone.
    #[must_use]
    pub fn form(&self, zone: &str) -> PolicyForm {
        let share = |share: &Share| if *share == Share::default() { String::new() } else { share.typed() };
        PolicyForm {
            attempts: self.attempts.map(|most| most.to_string()).unwrap_or_default(),
            attempt_penalty: share(&self.attempt_penalty),
            hint_penalty: share(&self.hint_penalty),
            further_penalty: share(&self.further_penalty),
            opens: self.opens.typed(zone),
            due: self.due.typed(zone),
            late_until: self.late_until.map(|until| until.typed(zone)).unwrap_or_default(),
            late_penalty: share(&self.late_penalty),
            closes: self.closes.typed(zone),
            verdicts: self.verdicts.name().to_owned(),
            solutions: self.solutions.name().to_owned(),
            unsubmitted: self.unsubmitted.name().to_owned(),
            solvers: self.solvers.name().to_owned(),
        }
    }
}

impl Instants {
    /// Reads when answers are due, until when they are taken late, and when the assignment closes: in this order, after it opens.
    pub(super) fn read(
        [due, late_until, closes]: [&str; 3],
        opens: Option<Moment>,
        zone: &str,
        faults: &mut Faults,
    ) -> Option<Self> {
        let due = faults.take("due", Moment::local(due, zone));
        let late_until = match late_until.trim() {
            "" => Some(None),
            text => faults.take("late_until", Moment::local(text, zone)).map(Some),
        };
        let closes = faults.take("closes", Moment::local(closes, zone));
        let mut last = opens.map(|opens| (opens, "the assignment opens"));
        for (field, moment, name) in [
            ("due", due, "answers are due"),
            ("late_until", late_until.flatten(), "late answers are no longer taken"),
            ("closes", closes, "the assignment closes"),
        ] {
            let Some(moment) = moment else { continue };
            if let Some((_, before)) = last.filter(|(earlier, _)| moment < *earlier) {
                faults.say(field, format!("this is before {before}"));
            }
            last = Some((moment, name));
        }
        Some(Self { due: due?, late_until: late_until?, closes: closes? })
    }
}

fn attempts(text: &str) -> Result<Option<u32>, String> {
    let text = text.trim();
    if text.is_empty() {
        return Ok(None);
    }
    let number = text.parse().ok().filter(|number| (1..=MOST_ATTEMPTS).contains(number));
    let wrong = || format!("write a number from 1 to {MOST_ATTEMPTS}, or nothing for any number of attempts");
    number.ok_or_else(wrong).map(Some)
}

fn choose(names: &[&str; 2]) -> String {
    format!("choose `{}` or `{}`", names[0], names[1])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A policy that is well, with another text in one field.
    fn form(field: &str, text: &str) -> PolicyForm {
        let mut fields = serde_json::to_value(usual()).unwrap();
        fields[field] = text.into();
        serde_json::from_value(fields).unwrap()
    }

    fn usual() -> PolicyForm {
        PolicyForm {
            attempts: "3".into(),
            attempt_penalty: "10 %".into(),
            hint_penalty: "0.05".into(),
            further_penalty: "1/3".into(),
            opens: "2026-11-23T08:00".into(),
            due: "2026-11-30T18:00".into(),
            late_until: "2026-12-02T18:00".into(),
            late_penalty: "20 %".into(),
            closes: "2026-12-02T18:00".into(),
            verdicts: "at_close".into(),
            solutions: "never".into(),
            unsubmitted: "hand_in".into(),
            solvers: "hidden".into(),
        }
    }

    #[test]
    fn every_fault_is_named_with_its_field() {
        for (field, text, fault) in [
            ("attempts", "0", "attempts: write a number from 1 to 100"),
            ("attempts", "many", "attempts: write a number from 1 to 100"),
            ("attempt_penalty", "110 %", "attempt_penalty: a share is written"),
            ("hint_penalty", "-1 %", "hint_penalty: a share is written"),
            ("further_penalty", "x", "further_penalty: a share is written"),
            ("late_penalty", "1/0", "late_penalty: a share is written"),
            ("opens", "", "opens: `` is no date"),
            ("opens", "2026-12-01T08:00", "due: this is before the assignment opens"),
            ("due", "2026-12-02T18:01", "late_until: this is before answers are due"),
            ("late_until", "2026-12-02T18:01", "closes: this is before late answers are no longer taken"),
            ("late_until", "", "late_until: being late has a price"),
            ("closes", "2026-03-29T02:30", "closes: this time does not exist"),
            ("verdicts", "now", "verdicts: choose `at_once` or `at_close`"),
            ("solutions", "at_once", "solutions: choose `at_close` or `never`"),
            ("unsubmitted", "yes", "unsubmitted: choose `leave` or `hand_in`"),
            ("solvers", "no", "solvers: choose `shown` or `hidden`"),
        ] {
            let faults = Policy::read(&form(field, text), "Europe/Berlin").unwrap_err();
            let said: Vec<String> = faults.iter().map(|fault| format!("{}: {}", fault.field, fault.message)).collect();
            assert!(said.len() == 1 && said[0].starts_with(fault), "{field}: {text}: {said:?}");
        }
        let faults =
            Policy::read(&PolicyForm { attempts: "x".into(), verdicts: "y".into(), ..PolicyForm::default() }, "UTC");
        let fields: Vec<&str> = faults.unwrap_err().iter().map(|fault| fault.field).collect();
        assert_eq!(fields, ["attempts", "opens", "due", "closes", "verdicts"]);
    }

    #[test]
    fn the_fields_of_a_policy_say_it_again() {
        let policy = Policy::read(&usual(), "Europe/Berlin").unwrap();
        let form = policy.form("Europe/Berlin");
        assert_eq!(form, PolicyForm { hint_penalty: "5 %".into(), ..usual() });
        assert_eq!(serde_json::from_str::<Policy>(&serde_json::to_string(&policy).unwrap()).unwrap(), policy);
    }

    proptest! {
        #[test]
        fn what_is_read_is_in_order_and_is_typed_again(minutes in prop::array::uniform4(0_u32..200_000), late: bool, zone in 0..3_usize) {
            let zone = ["UTC", "Europe/Berlin", "Asia/Kathmandu"][zone];
            let start = Moment::from_millis(1_790_000_040_000);
            let typed = minutes.map(|number| start.after(i64::from(number) * 60_000).typed(zone));
            let [opens, due, late_until, closes] = typed;
            let late_until = if late { late_until } else { String::new() };
            let form = PolicyForm { opens, due, late_until, closes, ..PolicyForm::default() };
            match Policy::read(&form, zone) {
                Ok(policy) => {
                    let until = policy.late_until.unwrap_or(policy.due);
                    prop_assert!(policy.opens <= policy.due && policy.due <= until && until <= policy.closes);
                    let again = policy.form(zone);
                    prop_assert_eq!(Policy::read(&again, zone), Ok(policy));
                }
                Err(faults) => prop_assert!(!faults.is_empty()),
            }
        }
    }
}
