//! From a place in what a sheet says back to the place in the problem file where it was written.

use momentous_fault::Path;
use momentous_fault::Span;

use super::super::compiling::planned::Problem;
use super::super::language::text::Piece;
use super::super::language::text::Text;
use super::super::sampling::say;
use super::super::sampling::variant::Variant;

impl Variant {
    /// The place at which a part of its text was written: the path of the text, and the bytes in it. What a placeholder says was
    /// written as that placeholder.
    #[must_use]
    pub fn origin_in_text(&self, problem: &Problem, place: Span) -> (Path, Span) {
        let story = &problem.loaded().draft.text;
        let length = say::fill(story, problem, self).trim_end().len();
        let behind = problem.forms().get(self.form()).filter(|_| place.start >= length);
        let Some(form) = behind else {
            return (Path::root().key("text"), self.origin(story, problem, place));
        };
        let question = &form.question.text;
        let said = say::fill(question, problem, self);
        let blanks = said.len() - said.trim_start().len();
        // The story ends, and a blank line stands between.
        let shifted = |byte: usize| (byte + blanks).saturating_sub(length + 2);
        let place = Span { start: shifted(place.start), end: shifted(place.end) };
        (form.question.path.key("text"), self.origin(question, problem, place))
    }

    /// The same of a hint of its form.
    #[must_use]
    pub fn origin_in_hint(&self, problem: &Problem, (path, hint): &(Path, Text), place: Span) -> (Path, Span) {
        (path.clone(), self.origin(hint, problem, place))
    }

    fn origin(&self, text: &Text, problem: &Problem, place: Span) -> Span {
        let (_, ends) = say::fill_and_mark(text, problem, self);
        let mut written = 0;
        let mut said = 0;
        let mut origin = Span { start: 0, end: 0 };
        for (piece, end) in text.pieces().iter().zip(ends) {
            let span = match piece {
                Piece::Text(words) => Span { start: written, end: written + words.len() },
                Piece::Placeholder(placeholder) => placeholder.whole,
            };
            let inside = |byte: usize| match piece {
                Piece::Text(_) => span.start + (byte - said),
                Piece::Placeholder(_) => span.start,
            };
            if (said..end).contains(&place.start) {
                origin = Span { start: inside(place.start), end: span.end };
            }
            if place.end > said && place.end <= end {
                origin.end = if matches!(piece, Piece::Text(_)) { inside(place.end) } else { span.end };
            }
            (written, said) = (span.end, end);
        }
        origin
    }
}
