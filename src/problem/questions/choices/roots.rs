//! Which of two roots is possible, as a question.

use momentous_fault::Path;
use momentous_model::Builder;

use super::super::super::language::ask::WhichRoot;
use super::super::part::PartKind;
use super::super::part::Question;
use super::choice::ChoicePart;

/// Which of two roots is possible.
pub(crate) fn physical(ask: &WhichRoot, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let Some(symbol) = builder.mention(&ask.physical) else {
        let fault = builder.unknown(&ask.physical).at_path(path.key("physical"));
        builder.fault(fault);
        return None;
    };
    let entry = builder.symbols().entry(symbol);
    let what = if entry.meaning.is_empty() { &entry.name } else { &entry.meaning };
    let label = format!("Which of the two values that the equations give for {what} is possible, and why?");
    Some((label, PartKind::Choice(ChoicePart::Physical(symbol))))
}
