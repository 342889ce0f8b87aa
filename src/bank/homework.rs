//! Homework: problems that are handed out together on one sheet, as a file says it.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous_exercise::SeedSource;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Path;
use momentous_fault::Source;
use momentous_fault::did_you_mean;
use momentous_problem::HomeworkDraft;
use momentous_problem::Index;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;
use momentous_problem::SlotDraft;
use momentous_problem::compile;
use momentous_quantity::Rational;

use super::collection::Bank;
use super::course::load_in_course;

/// The folder in which a course keeps its homework.
pub const HOMEWORK_FOLDER: &str = "homework";

/// The greatest number by which points are multiplied to be whole.
const MOST_TIMES: u32 = 1000;

/// A homework all of whose problems are there; made only by [`Homework::of`].
#[derive(Clone, Debug)]
pub struct Homework {
    /// The title on the sheet.
    pub title: String,
    /// The course that the sheet names.
    pub course: Option<String>,
    /// The number of ruled lines that the sheet has for each answer.
    pub room: usize,
    /// The words of the sheet about its date.
    pub date: Option<String>,
    /// The problems in the order of the sheet.
    pub slots: Vec<Slot>,
}

/// A problem of a homework.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The problem.
    pub problem: Arc<Problem>,
    /// The position of the form in which it is asked.
    pub form: usize,
    /// The points of each part, by the part's name.
    pub worth: BTreeMap<String, Rational>,
    /// How many slots before it ask the same problem in the same form.
    pub repeat: usize,
}

impl Homework {
    /// Whether a file says that it is one: problem files have no list of problems.
    #[must_use]
    pub fn is(source: &Source) -> bool {
        source.text.lines().any(|line| line.starts_with("problems:"))
    }

    /// The homework that a file describes, with problems of a bank.
    ///
    /// # Errors
    /// Every fault of the file; those of a problem that does not load are told where the homework names it.
    ///
    /// ```
    /// use momentous_bank::{Bank, Homework};
    /// use momentous_fault::Source;
    /// let text = "title: Week 3\nproblems:\n  - { problem: impact/two-carts, form: find-e, points: 4 }\n";
    /// let homework = Homework::of(&Source::new("week-3.yaml", text), &Bank::built_in(), None).unwrap();
    /// assert_eq!(homework.slots[0].points(), 4.into());
    /// let text = text.replace("find-e", "find-f");
    /// let faults = Homework::of(&Source::new("week-3.yaml", &text), &Bank::built_in(), None).unwrap_err();
    /// assert_eq!(faults.list[0].help.as_deref(), Some("did you mean `find-e`?"));
    /// ```
    pub fn of(source: &Source, bank: &Bank, secret: Option<&[u8]>) -> Result<Self, Faults> {
        let HomeworkDraft { title, course, room, date, problems } = HomeworkDraft::read(source)?;
        let room = room.map_or(0, usize::from);
        let mut slots: Vec<Slot> = Vec::new();
        let mut faults = Vec::new();
        let list = Path::root().key("problems");
        if problems.is_empty() {
            let fault = Fault::new(Code::Value, "the homework has no problems");
            faults.push(fault.help("add one as `- problem: impact/two-carts`").at_path(list.clone()));
        }
        let mut compiled: BTreeMap<&str, Result<Arc<Problem>, Fault>> = BTreeMap::new();
        for (index, draft) in problems.iter().enumerate() {
            let at = list.index(index);
            let problem = compiled.entry(&draft.problem).or_insert_with(|| open(bank, &draft.problem, secret));
            match problem {
                Ok(problem) => match Slot::of(problem, draft, &at, &slots) {
                    Ok(slot) => slots.push(slot),
                    Err(more) => faults.extend(more),
                },
                Err(fault) => faults.push(fault.clone().at_path(at.key("problem"))),
            }
        }
        if faults.is_empty() {
            Ok(Self { title, course, room, date, slots })
        } else {
            Err(Index::of(source).locate_all(faults))
        }
    }

    /// The points of all problems together.
    #[must_use]
    pub fn points(&self) -> Rational {
        self.slots.iter().fold(Rational::ZERO, |sum, slot| sum + slot.points())
    }
}

/// The problem of that identity, or what is wrong with it.
fn open(bank: &Bank, id: &str, secret: Option<&[u8]>) -> Result<Arc<Problem>, Fault> {
    let renamed = bank.renamed(id).filter(|_| bank.ids().all(|known| known != id));
    let source = bank.find(renamed.unwrap_or(id)).map_err(|faults| {
        let help = faults.list.into_iter().next().and_then(|fault| fault.help);
        let fault = Fault::new(Code::UnknownName, format!("there is no problem `{id}`"));
        help.map_or(fault.clone(), |help| fault.help(help))
    })?;
    let problem = load_in_course(source.clone()).and_then(|loaded| compile(loaded, secret));
    problem.map(Arc::new).map_err(|faults| {
        let help = format!("`momentous check {}` says what is wrong with it", faults.source.name);
        Fault::new(Code::Unreadable, format!("the problem `{id}` does not load")).help(help)
    })
}

impl Slot {
    fn of(problem: &Arc<Problem>, draft: &SlotDraft, at: &Path, before: &[Self]) -> Result<Self, Vec<Fault>> {
        let form = match draft.form.as_deref() {
            None => 0,
            Some(name) => problem.form(Some(name)).ok_or_else(|| vec![no_form(problem, name, at)])?,
        };
        let parts = problem.forms().get(form).map_or(&[][..], |form| &form.parts);
        let mut faults = Vec::new();
        if draft.points == Some(0) {
            let fault = Fault::new(Code::Value, "a problem of a homework is worth at least 1 point");
            faults.push(fault.help("give it points, or remove it from the list").at_path(at.key("points")));
        }
        for name in draft.weights.names().filter(|name| parts.iter().all(|part| part.id != *name)) {
            let known: Vec<&str> = parts.iter().map(|part| part.id.as_str()).collect();
            let help = did_you_mean(name, known.iter().copied()).map_or_else(
                || format!("its parts are {}", known.join(", ")),
                |near| format!("did you mean `{near}`?"),
            );
            let fault = Fault::new(Code::UnknownName, format!("{} does not ask for `{name}`", draft.problem));
            faults.push(fault.help(help).at_path(at.key("weights").name(name)));
        }
        let weight = |part: &momentous_problem::Part| draft.weights.get(&part.id).copied().unwrap_or(part.points);
        let sum: u64 = parts.iter().map(|part| u64::from(weight(part))).sum();
        if sum == 0 {
            let fault = Fault::new(Code::Value, "all parts of this problem weigh nothing");
            faults.push(fault.help("give a part a weight of at least 1").at_path(at.key("weights")));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let whole = draft.points.map_or(Rational::from(sum), Rational::from);
        let worth = |part| &whole * Rational::from(weight(part)) / Rational::from(sum);
        Ok(Self {
            problem: Arc::clone(problem),
            form,
            worth: parts.iter().map(|part| (part.id.clone(), worth(part))).collect(),
            repeat: before.iter().filter(|slot| slot.problem.id() == problem.id() && slot.form == form).count(),
        })
    }

    /// The points of the whole problem.
    #[must_use]
    pub fn points(&self) -> Rational {
        self.worth.values().fold(Rational::ZERO, |sum, worth| sum + worth)
    }

    /// The points of its parts as whole numbers, for programs that know no others, and by what they are multiplied for that.
    #[must_use]
    pub fn whole_points(&self) -> (Vec<u32>, u32) {
        let parts = self.asked().map_or(&[][..], |form| &form.parts);
        let worth: Vec<&Rational> = parts.iter().filter_map(|part| self.worth.get(&part.id)).collect();
        let whole = |times: u32| {
            let points = worth.iter().map(|points| *points * Rational::from(times));
            let points =
                points.map(|points| if points.is_int() { u32::try_from(points.numerator()).ok() } else { None });
            points.collect::<Option<Vec<u32>>>().map(|points| (points, times))
        };
        let usual = || (parts.iter().map(|part| part.points).collect(), 1);
        (1..=MOST_TIMES).find_map(whole).unwrap_or_else(usual)
    }

    /// The form in which it is asked.
    #[must_use]
    pub fn asked(&self) -> Option<&PlannedForm> {
        self.problem.forms().get(self.form)
    }

    /// The name of the form; empty where the problem has one form without a name.
    #[must_use]
    pub fn form_name(&self) -> &str {
        match self.asked().map(|form| form.question.name.as_deref()) {
            Some(Some(name)) => name,
            Some(None) | None => "",
        }
    }

    /// The seed of a student's sheet. It is that of the problem alone, so that the numbers are the same in homework and without;
    /// where the same is asked again, the numbers are others.
    #[must_use]
    pub fn seed(&self, student: &str, seeds: SeedSource<'_>) -> u64 {
        let form = self.form_name();
        match self.repeat {
            0 => seeds.seed(student, self.problem.drawn_as(), form),
            again => {
                // Version 1 of the derivation knows nothing of the form.
                let seeds = SeedSource { derivation: momentous_exercise::Derivation::Question, ..seeds };
                seeds.seed(student, self.problem.drawn_as(), &format!("{form}#{}", again + 1))
            }
        }
    }

    /// The seed on the sheet with that number, which is nobody's in particular.
    #[must_use]
    pub fn numbered_seed(&self, number: u64) -> u64 {
        if self.repeat == 0 { number } else { self.seed(&number.to_string(), SeedSource::default()) }
    }
}

fn no_form(problem: &Problem, name: &str, at: &Path) -> Fault {
    let known: Vec<&str> = problem.forms().iter().filter_map(|form| form.question.name.as_deref()).collect();
    let help = match did_you_mean(name, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if known.is_empty() => "it has one form without a name: remove `form`".to_owned(),
        None => format!("its forms are {}", known.join(", ")),
    };
    Fault::new(Code::UnknownName, format!("{} has no form `{name}`", problem.id())).help(help).at_path(at.key("form"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    fn homework(problems: &str) -> Result<Homework, Faults> {
        let text = format!("title: Week 3\nproblems:\n{problems}");
        Homework::of(&Source::new("homework/week-3.yaml", &text), &Bank::built_in(), None)
    }

    #[test]
    fn points_are_divided_by_the_weights() {
        let weighted =
            homework("  - { problem: impact/two-carts, points: 10, weights: { v_A2: 3, v_B2: 1, T_lost: 1 } }\n");
        let slots = weighted.unwrap().slots;
        assert_eq!(slots[0].worth["v_A2"], Rational::from(6));
        assert_eq!(slots[0].points(), Rational::from(10));
        let homework = homework("  - problem: impact/two-carts\n").unwrap();
        let parts = &homework.slots[0].asked().unwrap().parts;
        assert!(parts.iter().all(|part| homework.slots[0].worth[&part.id] == Rational::from(part.points)));
    }

    #[test]
    fn points_are_whole_where_they_are_multiplied() {
        let homework =
            homework("  - { problem: impact/two-carts, points: 10, weights: { v_A2: 1, v_B2: 1, T_lost: 1 } }\n");
        assert_eq!(homework.unwrap().slots[0].whole_points(), (vec![10, 10, 10], 3));
    }

    #[test]
    fn the_same_problem_twice_has_other_numbers_and_the_first_those_of_the_problem_alone() {
        let homework = homework("  - problem: impact/two-carts\n  - problem: impact/two-carts\n").unwrap();
        let seeds = SeedSource::default();
        let [first, second] = [0, 1].map(|place| homework.slots[place].seed("s17", seeds));
        assert_eq!(first, seeds.seed("s17", "impact/two-carts", homework.slots[0].form_name()));
        assert_ne!(first, second);
        assert_eq!(homework.slots[0].numbered_seed(7), 7);
        assert_ne!(homework.slots[1].numbered_seed(7), 7);
    }

    #[test]
    fn every_fault_is_told_at_its_place() {
        let faults = homework(
            "  - { problem: impact/two-cart }\n  - { problem: impact/two-carts, form: forwards }\n  \
             - { problem: impact/two-carts, points: 0, weights: { v_A22: 1 } }\n",
        )
        .unwrap_err();
        let said: Vec<_> =
            faults.list.iter().map(|fault| (fault.message.as_str(), fault.help.as_deref().unwrap())).collect();
        let expected = [
            ("there is no problem `impact/two-cart`", "did you mean `impact/two-carts`?"),
            ("impact/two-carts has no form `forwards`", "did you mean `forward`?"),
            ("a problem of a homework is worth at least 1 point", "give it points, or remove it from the list"),
            ("impact/two-carts does not ask for `v_A22`", "did you mean `v_A2`?"),
        ];
        assert_eq!(said, expected);
        assert!(faults.list.iter().all(|fault| fault.span.is_some()));
    }
}
