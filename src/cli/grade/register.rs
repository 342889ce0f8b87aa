//! Checks before a submission is marked: the sheet that it answers, whose sheet that is, and which attempt it is.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use crate::cli::failure::tell;
use crate::cli::open;
use crate::exercise::HandedOut;
use crate::exercise::Key;
use crate::exercise::NotIssued;
use crate::exercise::Place;
use crate::exercise::SheetSeed;
use crate::exercise::Sheets;
use crate::exercise::SpoiltSeed;
use crate::exercise::Standing;
use crate::exercise::Submission;
use crate::exercise::Together;
use crate::exercise::VariantRef;
use crate::exercise::WORK;
use crate::exercise::excerpt;
use crate::exercise::is_beside;
use crate::grade::HintsSeen;
use crate::grade::PartReport;
use crate::problem::Scheme;
use crate::render::SeedWord;

use super::problems::{OpenProblem, Problems};
use super::worth::{Earned, Worth, Worths};

/// A submission, or what is wrong where one should be.
pub(super) type Next = Result<Submission, (Place, String)>;

/// The entry of a submission, or its fault.
pub(super) type Entered = Result<Entry, (Place, String)>;

/// A submission that can be marked.
pub(super) struct Entry {
    pub submission: Submission,
    pub facts: Facts,
}

/// The facts about a submission before it is marked.
#[derive(Clone, Debug)]
pub(super) struct Facts {
    pub question: Question,
    pub handed_out: HandedOut,
    /// Why the sheet is not the student's, where it is known not to be.
    pub not_issued: Option<NotIssued>,
    /// Whether it is a further attempt at the sheet of the one before it.
    pub is_beside: bool,
    /// The number that the attempt says it has.
    pub attempt: Option<u32>,
    /// The hints that were seen.
    pub seen: HintsSeen,
    /// The points of the parts in a homework.
    pub worth: Option<Arc<Worth>>,
}

impl Facts {
    /// The points that a part earned.
    pub(super) fn earned(&self, part: &PartReport) -> Earned {
        Earned::of(part, self.worth.as_deref())
    }
}

/// The variant that is answered: the position of the problem among those that are open, that of its form, and the seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Question {
    pub problem: usize,
    pub form: usize,
    pub seed: u64,
}

/// The facts about the class so far.
pub(super) struct Register {
    problems: Problems,
    sheets: Option<Sheets>,
    /// The points of sheets in a homework.
    worths: Worths,
    /// Whether every row is an attempt at a quiz of another program, of which each begins anew.
    begins_anew: bool,
    /// How the numbers of sheets were drawn of which nobody says it.
    scheme: Scheme,
    together: Together,
    /// The rows whose problem is known; those of them that name another secret than the one given, and what is said of one.
    looked_at: u64,
    of_other_secrets: u64,
    other_secret: Option<String>,
    /// The places of the numbered attempts of the student whose sheet was looked at last.
    numbered: BTreeMap<u32, u64>,
    /// Problems that were changed after their sheets were made, by their positions; each is told once.
    changed: BTreeSet<usize>,
}

impl Register {
    pub(super) fn new(problems: Problems, sheets: Option<Sheets>, scheme: Scheme) -> Self {
        Self {
            problems,
            sheets,
            worths: Worths::new(),
            begins_anew: false,
            scheme,
            together: Together::default(),
            looked_at: 0,
            of_other_secrets: 0,
            other_secret: None,
            numbered: BTreeMap::new(),
            changed: BTreeSet::new(),
        }
    }

    /// The same with sheets of a homework, which are worth so much.
    pub(super) fn with_worths(mut self, worths: Worths) -> Self {
        self.worths = worths;
        self
    }

    /// The same with rows that are attempts at a quiz of another program, where that is so: nothing is carried from one to the next.
    pub(super) fn of_responses(mut self, begins_anew: bool) -> Self {
        self.begins_anew = begins_anew;
        self
    }

    /// Whether the secret is that of most sheets so far: a few rows with another may be slips, or come of ill will.
    ///
    /// # Errors
    /// What is said of the others.
    pub(super) fn check_secret(&self) -> Result<(), String> {
        match &self.other_secret {
            Some(message) if 2 * self.of_other_secrets > self.looked_at => Err(message.clone()),
            _ => Ok(()),
        }
    }

    /// The problems that are open, by their positions.
    pub(super) fn open(&self) -> &[Arc<OpenProblem>] {
        self.problems.open()
    }

    /// Lets no further attempt join those so far.
    pub(super) fn part(&mut self) {
        self.together.part();
    }

    /// The number of a student and a sheet; none where the row names none.
    pub(super) fn sheet(&mut self, submission: &Submission) -> Option<u64> {
        let student = submission.key(Key::Student);
        let opened = self.problems.find(submission.key(Key::Problem)).ok().filter(|_| !student.is_empty())?;
        let question = opened.question(submission).ok()?;
        Some(Together::sheet(student, opened.variant(question)))
    }

    /// Forgets what was told, before the submissions are read once more.
    pub(super) fn begin_again(&mut self) {
        self.problems.begin_again();
    }

    /// Looks at the next submission; its number says where it stands, in the words of `place`.
    pub(super) fn enter(&mut self, next: Next, number: u64, place: impl Fn(u64) -> Place) -> Entered {
        let submission = next?;
        match self.facts(&submission, number, place) {
            Ok(facts) => Ok(Entry { submission, facts }),
            Err(message) => Err((submission.place, message)),
        }
    }

    fn facts(&mut self, submission: &Submission, number: u64, place: impl Fn(u64) -> Place) -> Result<Facts, String> {
        let opened = self.problems.find(submission.key(Key::Problem))?;
        self.looked_at += 1;
        // Where it is known whose sheet is whose, a number says enough.
        let drawn = if self.sheets.is_some() { SheetSeed::of } else { SheetSeed::of_a_sheet };
        if let Some(Err(message)) = seed_of(submission).ok().map(|seed| drawn(&seed, &opened.problem)) {
            self.of_other_secrets += 1;
            self.other_secret = Some(message.clone());
            return Err(message);
        }
        self.check_spoilt(submission, &opened)?;
        let question = opened.question(submission)?;
        let attempt = submission.number(Key::Attempt, 1)?;
        let [hints, further] = [submission.number(Key::Hints, 0)?, submission.number(Key::FurtherHints, 0)?];
        let seen = HintsSeen { hints: hints.unwrap_or(0), further: further.unwrap_or(0) };
        opened.asks(submission, question)?;
        let (student, variant) = (submission.key(Key::Student), opened.variant(question));
        let said = self.said(submission)?;
        let (handed_out, not_issued) = match &self.sheets {
            None => (said, None),
            Some(sheets) => match handed_out(sheets, student, variant, &opened, question.form == 0) {
                Ok(listed) => (HandedOut { given: listed.given.or(said.given), ..listed }, None),
                Err(reason) => (said, Some(reason)),
            },
        };
        opened.check_digest(submission, &handed_out)?;
        self.note_a_change(&opened);
        let is_beside = match self.together.add(student, variant, number) {
            Standing::First => false,
            Standing::Beside => !self.begins_anew,
            Standing::OneTooMany => {
                return Err("the student has more attempts at this sheet than can be marked together".to_owned());
            }
            Standing::Apart(first) => {
                let (student, problem, first) = (excerpt(student), variant.problem, place(first));
                return Err(format!(
                    "this attempt of `{student}` at {problem} is separated from the one before it, at {first}\n\
                     help: sort the rows by student, problem and seed, or give --any-order"
                ));
            }
        };
        if !is_beside {
            self.numbered.clear();
        }
        if let Some(claimed) = attempt {
            let first = *self.numbered.entry(claimed).or_insert(number);
            if first != number {
                let (student, problem, first) = (excerpt(student), variant.problem, place(first));
                return Err(format!(
                    "`{student}` already has an attempt {claimed} at this sheet of {problem}, at {first}\n\
                     help: give each attempt a different number"
                ));
            }
        }
        let keys = [Key::Student, Key::Problem, Key::Form, Key::Seed].map(|key| submission.key(key).to_owned());
        let worth = self.worths.get(&keys).cloned();
        Ok(Facts { question, handed_out, not_issued, is_beside, attempt, seen, worth })
    }

    /// Whether a spreadsheet has left the whole seed.
    fn check_spoilt(&self, submission: &Submission, opened: &OpenProblem) -> Result<(), String> {
        let (student, cell) = (submission.key(Key::Student), submission.key(Key::Seed));
        let Some(spoilt) = SpoiltSeed::read(cell) else { return Ok(()) };
        let name = Some(submission.key(Key::Form)).filter(|form| !form.is_empty());
        let form = open::form(&opened.problem, name).ok().and_then(|place| opened.problem.forms().get(place));
        let form = form.and_then(|form| form.question.name.as_deref()).unwrap_or_default();
        let issued = self.sheets.as_ref().and_then(|sheets| sheets.seed(student, opened.problem.id(), form));
        if issued.is_some_and(|seed| seed.to_string() == cell) {
            return Ok(());
        }
        let what = format!("`{}` is what a spreadsheet leaves of a seed", excerpt(cell));
        Err(match issued.filter(|seed| spoilt.is_of(*seed)) {
            Some(seed) => format!(
                "{what}: that of the sheet of `{}` is {word}\nhelp: write {word} into the cell; with its letter it stays as it is",
                excerpt(student),
                word = SeedWord(seed)
            ),
            None => format!(
                "{what}: its last digits are lost\n\
                 help: copy the seed from the sheet; --sheets or --roster tells it for each student"
            ),
        })
    }

    /// How the sheet was handed out, as the row says it.
    fn said(&self, submission: &Submission) -> Result<HandedOut, String> {
        let [scheme, given] = [Key::Scheme, Key::Given].map(|key| submission.key(key));
        let scheme = match scheme {
            "" => self.scheme,
            number => number.parse().map_err(|fault| format!("`{}` is no scheme: {fault}", excerpt(number)))?,
        };
        let given = if given.is_empty() { None } else { Some(Arc::new(given.parse()?)) };
        Ok(HandedOut { scheme, given })
    }

    /// Says where the sheets were drawn from another version of a problem, once for each.
    fn note_a_change(&mut self, opened: &OpenProblem) {
        let id = opened.problem.id();
        let Some(then) = self.sheets.as_ref().and_then(|sheets| sheets.digest(id)) else { return };
        if !opened.is_drawn_from(then) && self.changed.insert(opened.place) {
            tell(&format!(
                "note: the sheets of {id} were made from another version of it, which may draw other numbers: its digest was {then}, \
                 and is {}; each sheet is marked by the numbers that `given` says",
                opened.problem.loaded().digests.draw
            ));
        }
    }
}

/// How a sheet was handed out, under the identity that the problem has or had.
fn handed_out(
    sheets: &Sheets,
    student: &str,
    variant: VariantRef<'_>,
    opened: &OpenProblem,
    is_first: bool,
) -> Result<HandedOut, NotIssued> {
    let before = VariantRef { problem: opened.problem.drawn_as(), ..variant };
    sheets.handed_out(student, variant, is_first).or_else(|reason| {
        if before.problem == variant.problem { Err(reason) } else { sheets.handed_out(student, before, is_first) }
    })
}

impl OpenProblem {
    /// The variant that a submission says that it answers.
    fn question(&self, submission: &Submission) -> Result<Question, String> {
        let name = Some(submission.key(Key::Form)).filter(|form| !form.is_empty());
        let form = open::form(&self.problem, name).map_err(|failure| failure.message())?;
        let seed = seed_of(submission)?.of(&self.problem)?;
        Ok(Question { problem: self.place, form, seed })
    }

    /// Whether a digest is that of what the numbers are drawn from. Earlier programs wrote that of the whole file.
    fn is_drawn_from(&self, digest: &str) -> bool {
        let loaded = self.problem.loaded();
        digest == loaded.digests.draw || digest == loaded.digest
    }

    /// Whether the numbers of a sheet are known that was drawn from another version of the problem.
    fn check_digest(&self, submission: &Submission, handed_out: &HandedOut) -> Result<(), String> {
        let said = submission.key(Key::Digest);
        if said.is_empty() || handed_out.given.is_some() || self.is_drawn_from(said) {
            return Ok(());
        }
        Err(format!(
            "the sheet was made from another version of {}, which may draw other numbers: its digest is {}\n\
             help: give --sheets, the table of seeds that says the numbers of each sheet",
            self.problem.id(),
            self.problem.loaded().digests.draw
        ))
    }

    /// The variant that is answered, by its names.
    pub(super) fn variant(&self, question: Question) -> VariantRef<'_> {
        let form = self.problem.forms().get(question.form).and_then(|form| form.question.name.as_deref());
        VariantRef { problem: self.problem.id(), form: form.unwrap_or_default(), seed: question.seed }
    }

    /// Whether each answer belongs to a part that is asked, and each part has one answer.
    fn asks(&self, submission: &Submission, question: Question) -> Result<(), String> {
        let marker = self.markers.get(question.form).ok_or("the problem has no such form")?;
        let mut answered: Vec<usize> = Vec::new();
        // The work is no answer, unless a part is called so.
        let names = submission.answers().map(|(name, _)| name);
        for name in names.filter(|name| *name != WORK || marker.part(WORK).is_some()) {
            let id = self.problem.id();
            let Some(part) = marker.part(name) else {
                if is_beside(name) {
                    continue;
                }
                return Err(format!("`{}` has an answer, but {id} does not ask for it in this form", excerpt(name)));
            };
            if answered.contains(&part) {
                return Err(format!("`{}` is answered twice", excerpt(name)));
            }
            answered.push(part);
        }
        Ok(())
    }
}

/// The seed, with the mark of a secret where that stands there.
fn seed_of(submission: &Submission) -> Result<SheetSeed, String> {
    let seed = submission.key(Key::Seed);
    if seed.is_empty() {
        return Err("the row has no seed".to_owned());
    }
    seed.parse().map_err(|why| format!("`{}` is not a seed: {why}", excerpt(seed)))
}
