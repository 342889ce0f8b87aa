//! Judgements of an answer: a verdict, and what is told of it.

use std::borrow::Cow;

use super::super::catalogue::{Catalogue, English};
use super::super::messages::Message;
use super::super::verdict::Verdict;

/// The judgement of an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Judgement {
    /// The verdict that is reported.
    pub verdict: Verdict,
    /// A second finding that costs points too: a missing unit beside a missing sign.
    pub also: Option<Verdict>,
    /// The messages to the student, the most important first.
    pub messages: Vec<Message>,
}

impl Judgement {
    /// Whether no allowance for rounding, and no larger scale, can change it: the answer is plainly right.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.verdict == Verdict::Right && !self.messages.contains(&Message::LastFigure)
    }

    /// The message to the student, in words.
    #[must_use]
    pub fn feedback(&self) -> Cow<'static, str> {
        match self.messages.as_slice() {
            [one] => English.message(one),
            all => all.iter().map(|one| English.message(one)).collect::<Vec<_>>().join(" ").into(),
        }
    }

    pub(super) fn of(verdict: Verdict, message: Message) -> Self {
        Self { verdict, also: None, messages: vec![message] }
    }

    /// With a finding about the unit: it is the verdict of a right number, and comes beside any other.
    pub(super) fn with_unit(mut self, verdict: Verdict, message: Message) -> Self {
        if self.verdict.is_right() {
            self.messages.retain(|message| !message.is_verdict());
            self.messages.splice(0..0, [Message::NumberRight, message]);
            return Self { verdict, ..self };
        }
        self.messages.push(message);
        self.also = (self.verdict != Verdict::Wrong).then_some(verdict);
        self
    }

    /// With a note; what was simply right is now right with a note.
    pub(super) fn noted(mut self, message: Message) -> Self {
        if self.verdict == Verdict::Right {
            self.verdict = Verdict::RightWithNote;
        }
        self.messages.push(message);
        self
    }

    pub(super) fn with(mut self, message: Message) -> Self {
        self.messages.push(message);
        self
    }
}
