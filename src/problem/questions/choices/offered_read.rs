//! Reading the author's own options.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;

use super::super::super::language::ask;
use super::super::super::language::form::Question;
use super::super::super::language::text::Filter;
use super::super::super::language::text::Text;
use super::super::super::reading::load::Loaded;
use super::super::super::reading::mentions;
use super::super::super::reading::numerals::alike;
use super::super::part::PartKind;
use super::super::to_solve::to_solve_unrevealed;
use super::choice::ChoicePart;
use super::comparing;
use super::offered::Offer;
use super::offered::Offered;
use super::offered::Truth;

/// The number of options that may be offered, the last one included.
const OFFERED: std::ops::RangeInclusive<usize> = 2..=8;

/// A choice between the author's own options, asked as the part of that letter.
pub(crate) fn read(
    loaded: &Loaded,
    question: &Question,
    ask: &ask::Choose,
    letter: &str,
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<PartKind> {
    let of_pictures = [("stage", ask.stage.is_some()), ("of", ask.of.is_some()), ("along", ask.along.is_some())];
    if let Some((key, _)) = of_pictures.into_iter().find(|(_, is_written)| *is_written) {
        let is = if key == "stage" { "only `pictures` are of a stage" } else { "this key is for pictures" };
        let help = format!("remove `{key}`, or ask for pictures: `pictures: impulse-momentum`");
        builder.fault(Fault::new(Code::Value, is).help(help).at_path(path.key(key)));
        return None;
    }
    let faults = misfits(ask, path);
    if !faults.is_empty() {
        for fault in faults {
            builder.fault(fault);
        }
        return None;
    }
    let mut reader = Reader { builder, printed: BTreeSet::new() };
    // What only wrong options print is no step of the solution.
    let mut by_right = BTreeSet::new();
    let mut options = Vec::new();
    for (index, option) in ask.options.iter().enumerate() {
        let path = path.key("options").index(index);
        let truth = match &option.holds {
            Some(holds) => Truth::When(comparing::claim(loaded, holds, reader.builder, &path.key("holds"))?.1),
            None if option.right => Truth::Always,
            None => Truth::Never,
        };
        let text = reader.text(&option.text, &path.key("text"))?;
        if !matches!(truth, Truth::Never) {
            by_right.extend(text.placeholders().filter_map(|placeholder| reader.builder.mention(&placeholder.name)));
        }
        options.push(Offered {
            text,
            truth,
            because: reader.any(option.because.as_ref(), &path.key("because")),
            feedback: reader.any(option.feedback.as_ref(), &path.key("feedback")),
        });
    }
    if let Some(last) = &ask.last {
        let path = path.key("last");
        options.push(Offered {
            text: reader.text(&last.text, &path.key("text"))?,
            truth: Truth::Otherwise,
            because: reader.any(last.because.as_ref(), &path.key("because")),
            feedback: reader.any(last.feedback.as_ref(), &path.key("feedback")),
        });
    }
    let printed = reader.printed;
    let solved = to_solve_unrevealed(loaded, question, builder, &by_right);
    let stream = question.stream(letter);
    Some(PartKind::Choice(ChoicePart::Offered(Box::new(Offer { stream, options, printed, solved }))))
}

/// Reads texts, and notes what they print.
struct Reader<'r, 'b> {
    builder: &'r mut Builder<'b>,
    printed: BTreeSet<Symbol>,
}

impl Reader<'_, '_> {
    /// Reads a text that may be left out; its fault is noted.
    fn any(&mut self, text: Option<&String>, path: &Path) -> Option<Text> {
        self.plain(text?, path)
    }

    /// A text that goes where there is no mathematics.
    fn plain(&mut self, text: &str, path: &Path) -> Option<Text> {
        let read = self.text(text, path)?;
        let is_math = |filter| matches!(filter, Filter::Symbol | Filter::Named);
        if text.contains('$') || read.placeholders().any(|placeholder| is_math(placeholder.filter)) {
            let fault = Fault::new(Code::Text, "what is said of an option is plain text, without mathematics");
            self.builder.fault(fault.help("write it in words").at_path(path.clone()));
            return None;
        }
        Some(read)
    }

    /// A text that may hold mathematics.
    fn text(&mut self, text: &str, path: &Path) -> Option<Text> {
        let read = match Text::read(text) {
            Ok(read) => read,
            Err(faults) => {
                for fault in faults {
                    self.builder.fault(fault.at_path(path.clone()));
                }
                return None;
            }
        };
        for placeholder in read.placeholders() {
            if let Some(fault) = mentions::unsayable(placeholder, self.builder) {
                self.builder.fault(fault.at_path(path.clone()).within(placeholder.span));
                return None;
            }
            self.printed.extend(self.builder.mention(&placeholder.name));
        }
        Some(read)
    }
}

/// The faults of the options by themselves.
fn misfits(ask: &ask::Choose, path: &Path) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut add = |code, path: Path, message: String, help: &str| {
        faults.push(Fault::new(code, message).help(help).at_path(path));
    };
    let at = path.key("options");
    let texts: Vec<&str> = ask
        .options
        .iter()
        .map(|option| &option.text)
        .chain(ask.last.as_ref().map(|last_offered| &last_offered.text))
        .map(|text| text.trim())
        .collect();
    if !OFFERED.contains(&texts.len()) {
        let message = format!("the number of options offered here is {}", texts.len());
        add(Code::Value, at.clone(), message, "write 2 to 8 options, `last` included");
    }
    for (index, text) in texts.iter().enumerate() {
        let place = if index < ask.options.len() { at.index(index) } else { path.key("last") };
        if texts.iter().take(index).any(|other| alike(other, text)) {
            add(
                Code::Duplicate,
                place.key("text"),
                format!("two options print `{text}`"),
                "let each option say something else",
            );
        } else if text.chars().nth(1).is_none() {
            let message = format!("the option `{text}` could be taken for the letter of another");
            add(Code::Value, place.key("text"), message, "write a word or more: `body A`");
        }
    }
    let right: Vec<usize> = (0..ask.options.len()).filter(|index| ask.options[*index].right).collect();
    let depends = ask.options.iter().any(|option| option.holds.is_some());
    for (index, option) in ask.options.iter().enumerate() {
        let place = at.index(index);
        let can_be = option.right || option.holds.is_some();
        if option.right && (depends || right.first() != Some(&index)) {
            let message = "more than one option can be right".to_owned();
            add(
                Code::Value,
                place.key("right"),
                message,
                "mark one as `right`, or say of each that can be right when it `holds`",
            );
        } else if option.right && option.because.is_none() {
            let message = "the worked solution cannot say why this option is right".to_owned();
            add(Code::MissingKey, place.clone(), message, "add `because:` with the reason as a sentence");
        } else if option.right && option.feedback.is_some() {
            let message = "the right option has no feedback on a mistake".to_owned();
            add(Code::Value, place.key("feedback"), message, "write why it is right under `because`");
        }
        if option.because.is_some() && !can_be {
            let message = "`because` says why an option is right, and this one never is".to_owned();
            add(
                Code::Value,
                place.key("because"),
                message,
                "write `feedback` for students who choose it, or mark it as `right: true`",
            );
        }
    }
    if right.is_empty() && !depends && ask.last.is_none() {
        add(
            Code::MissingKey,
            at,
            "no option is right".to_owned(),
            "mark one with `right: true`, or say when it `holds`",
        );
    }
    faults
}
