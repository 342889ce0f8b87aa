//! A student's attempts at one variant, one after the other: what is carried forward, what is locked, what each attempt costs,
//! and which of them counts.

use serde::{Deserialize, Serialize};

use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::messages::Message;
use super::report::{Entry, PartReport, Report};
use super::rubric::{Attempts, FeedbackTime, HintsSeen, Keep};
use super::sitting::Sitting;
use super::verdict::Verdict;

/// The history of a student at one variant so far. With it the next attempt is marked without marking those before it again.
///
/// An attempt is a whole sheet. Parts that are left empty keep the answer that was given before, so that each sheet is marked as
/// a whole, follow-through included. A right part is locked.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct History {
    /// How many sheets were handed in.
    handed_in: u32,
    /// The sheet that counts.
    counting: Option<Counting>,
    parts: Vec<PartHistory>,
}

/// The sheet that counts, and what it is compared with others by.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Counting {
    /// Its number, from 1.
    number: u32,
    #[serde(with = "exact")]
    points: Rational,
    /// How many of its parts have an answer.
    answered: usize,
}

/// The history of a student at one part so far.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PartHistory {
    /// The answer that stands; empty where there is none.
    text: String,
    /// The attempts that were counted.
    made: u32,
    /// Whether the answer is right, so that later ones are not looked at.
    locked: bool,
    /// Under which conditions the answer was entered.
    entered: Entered,
}

/// Under which conditions an answer was entered.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Entered {
    /// Attempts that were counted at the part before.
    made: u32,
    /// The hints seen by then.
    seen: HintsSeen,
    /// The share of the points that the time of the attempt leaves.
    #[serde(with = "exact")]
    factor: Rational,
}

/// The text typed at one part in an attempt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Typed<'a> {
    /// The text; empty where nothing is typed.
    pub text: &'a str,
    /// The hints seen by then.
    pub seen: HintsSeen,
    /// Whether the text can be read, where that is known; else marking tells.
    pub readable: Option<bool>,
}

/// Marks a whole sheet: the texts and sittings of its parts, in their order.
pub type Mark<'a> = dyn FnMut(&[&str], &[Sitting]) -> Report + 'a;

impl Default for Entered {
    fn default() -> Self {
        Self { made: 0, seen: HintsSeen::default(), factor: Rational::ONE }
    }
}

impl History {
    /// The history of a student who has made so many attempts at each part which are not known any more.
    #[must_use]
    pub fn after(made: u32, parts: usize) -> Self {
        Self { parts: vec![PartHistory { made, ..PartHistory::default() }; parts], ..Self::default() }
    }

    /// How many sheets were handed in.
    #[must_use]
    pub fn handed_in(&self) -> u32 {
        self.handed_in
    }

    /// The number of the sheet that counts, from 1; nothing where none was handed in.
    #[must_use]
    pub fn counting(&self) -> Option<u32> {
        self.counting.as_ref().map(|counting| counting.number)
    }

    /// The points of the sheet that counts; nothing where none was handed in.
    #[must_use]
    pub fn points(&self) -> Option<&Rational> {
        self.counting.as_ref().map(|counting| &counting.points)
    }

    /// The parts, in the order of the sheet; none before the first attempt.
    #[must_use]
    pub fn parts(&self) -> &[PartHistory] {
        &self.parts
    }

    /// Marks the next attempt. `factor` is the share of the points that its time leaves to what is new in it.
    ///
    /// No part of the report counts yet: that follows from [`counting`](Self::counting) after the last attempt.
    pub fn mark(&mut self, typed: &[Typed<'_>], factor: &Rational, rules: &Attempts, mark: &mut Mark<'_>) -> Report {
        self.parts.resize_with(typed.len(), PartHistory::default);
        let mut entries: Vec<Entry> =
            self.parts.iter().zip(typed).map(|(part_history, typed)| part_history.entry(typed.text, rules)).collect();
        let mut report = self.sheet(&entries, typed, rules, mark);
        // What cannot be read leaves the answer from before in its place.
        let mut unread: Vec<PartReport> = Vec::new();
        for ((entry, typed), part) in entries.iter_mut().zip(typed).zip(&report.parts) {
            let by_verdict = || !matches!(part.verdict, Verdict::Unreadable | Verdict::Unanswered);
            if !typed.readable.unwrap_or_else(by_verdict) && *entry == Entry::Typed && !typed.text.trim().is_empty() {
                *entry = Entry::Unread;
                unread.push(part.clone());
            }
        }
        let stands = |(history, entry): (&PartHistory, &Entry)| *entry == Entry::Unread && history.is_answered();
        if self.parts.iter().zip(&entries).any(stands) {
            report = self.sheet(&entries, typed, rules, mark);
        }
        let mut unread = unread.into_iter();
        for ((part_history, part), (typed, entry)) in
            self.parts.iter_mut().zip(&mut report.parts).zip(typed.iter().zip(entries))
        {
            match entry {
                Entry::Typed => part_history.take(typed, factor),
                Entry::Unread => part_history.put_back(part, unread.next()),
                Entry::Carried | Entry::Locked | Entry::NoneLeft => {}
            }
            part.entry = entry;
            part_history.settle(part, typed.text.trim(), rules);
        }
        report.recount();
        self.handed_in = self.handed_in.saturating_add(1);
        self.compare(&report, rules.keep);
        report
    }

    /// The report on the sheet that these entries make.
    fn sheet(&self, entries: &[Entry], typed: &[Typed<'_>], rules: &Attempts, mark: &mut Mark<'_>) -> Report {
        let parts = || self.parts.iter().zip(typed).zip(entries);
        let texts: Vec<&str> = parts()
            .map(|((part_history, typed), entry)| if *entry == Entry::Typed { typed.text } else { &part_history.text })
            .collect();
        let sittings: Vec<Sitting> = parts()
            .map(|((part_history, _), entry)| {
                let made = part_history.made.saturating_add(u32::from(*entry == Entry::Typed));
                Sitting { hints: 0, closed: !rules.counts(made) }
            })
            .collect();
        mark(&texts, &sittings)
    }

    /// Lets this sheet count, where it is better than the one that did, or the last is to count. Of two with the same points the one
    /// with more answers counts, then the earlier one.
    fn compare(&mut self, report: &Report, keep: Keep) {
        let answered = self.parts.iter().filter(|part_history| part_history.is_answered()).count();
        let is_better = |best: &Counting| (&report.total.0, answered) > (&best.points, best.answered);
        if keep == Keep::Last || self.counting.as_ref().is_none_or(is_better) {
            self.counting = Some(Counting { number: self.handed_in, points: report.total.0.clone(), answered });
        }
    }
}

impl PartHistory {
    /// The answer that stands; empty where there is none.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The attempts that were counted.
    #[must_use]
    pub fn made(&self) -> u32 {
        self.made
    }

    /// Whether the answer is right, so that later ones are not looked at.
    #[must_use]
    pub fn is_locked(&self) -> bool {
        self.locked
    }

    /// Whether another answer would be marked.
    #[must_use]
    pub fn is_open(&self, rules: &Attempts) -> bool {
        !self.locked && rules.counts(self.made)
    }

    /// The entry of a typed text, before anybody reads it.
    #[must_use]
    pub fn entry(&self, text: &str, rules: &Attempts) -> Entry {
        let text = text.trim();
        if self.locked {
            Entry::Locked
        } else if self.is_answered() && (text.is_empty() || text == self.text) {
            Entry::Carried
        } else if !text.is_empty() && !rules.counts(self.made) {
            Entry::NoneLeft
        } else {
            Entry::Typed
        }
    }

    fn is_answered(&self) -> bool {
        !self.text.is_empty()
    }

    /// Takes a text that was read as the answer that stands.
    fn take(&mut self, typed: &Typed<'_>, factor: &Rational) {
        let text = typed.text.trim();
        if !text.is_empty() {
            text.clone_into(&mut self.text);
            self.entered = Entered { made: self.made, seen: typed.seen, factor: factor.clone() };
            self.made = self.made.saturating_add(1);
        }
    }

    /// Says in a report on the answer from before why the text that was typed cannot be read.
    fn put_back(&self, part: &mut PartReport, unread: Option<PartReport>) {
        let Some(unread) = unread else { return };
        if self.is_answered() {
            part.message = format!("{} {} {}", unread.message, Message::EarlierStands, part.message).into();
            part.fault = unread.fault;
        } else {
            *part = unread;
        }
    }

    /// Takes from a part what its answer lost when it was entered, and says so; a right one is locked.
    fn settle(&mut self, part: &mut PartReport, text: &str, rules: &Attempts) {
        self.locked = part.verdict.is_right() && rules.told == FeedbackTime::AtOnce;
        part.counts = false;
        part.cut(&rules.left(self.entered.made, self.entered.seen), Message::Reduced);
        part.cut(&self.entered.factor, Message::Late);
        match part.entry {
            Entry::NoneLeft => part.say(&Message::NoAttemptLeft),
            Entry::Locked if !text.is_empty() && text != self.text => part.say(&Message::RightBefore),
            _ => {}
        }
    }
}
