//! Reading what is asked: each entry of `ask` becomes a part.

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::QuantityKind;
use momentous_quantity::Unit;
use momentous_quantity::with_minus_signs;
use momentous_solve::Condition;
use momentous_solve::Equation;

use super::super::language::ask::Answered;
use super::super::language::ask::Ask;
use super::super::language::ask::Find;
use super::super::language::ask::Turn;
use super::super::language::entries::Entries;
use super::super::language::expression;
use super::super::language::form::Question;
use super::super::reading::load::Loaded;
use super::choices::comparing;
use super::choices::impact_kind;
use super::choices::impulsive;
use super::choices::offered_read;
use super::choices::roots;
use super::conservation::conserved;
use super::counted::counted;
use super::enough;
use super::enough::Sought;
use super::number::number_part;
use super::part::FormulaPart;
use super::part::Named;
use super::part::Part;
use super::part::PartKind;
use super::part::part_letter;
use super::pictures::pictured_read;
use super::range;
use super::rubric;
use super::vector;

/// The result of reading the parts of a form.
#[derive(Default)]
pub(crate) struct ReadParts {
    pub parts: Vec<Part>,
    /// The quantities to be solved.
    pub wanted: Vec<Symbol>,
    /// The equations of parts that are found by counting, and of the boundary of an interval.
    pub counts: Vec<Equation>,
    /// The conditions under which the questions have their answers.
    pub conditions: Vec<Condition>,
    /// The quantities that the planner has to find.
    pub sought: Vec<Sought>,
}

/// Reads the parts of a form; faults are noted in the builder.
pub(crate) fn read(loaded: &Loaded, question: &Question, builder: &mut Builder<'_>) -> ReadParts {
    let mut read = ReadParts::default();
    for (index, ask) in question.ask.iter().enumerate() {
        let path = question.path.key("ask").index(index);
        let letter = part_letter(index);
        let part = match ask {
            Ask::Enough(ask) => {
                let points = loaded.draft.points_of(ask.points);
                let at = read.parts.len() + read.sought.len();
                read.sought.extend(enough::read(ask, at, (&letter, points), builder, &path));
                None
            }
            Ask::Find(find) => number(loaded, find, builder, &path),
            Ask::Count(count) => counted(count, builder, &path, &mut read.counts),
            Ask::Choose(ask) => match ask.pictures {
                Some(pictures) => pictured_read::read(loaded, question, ask, pictures, &letter, builder, &path)
                    .map(|(label, kind)| (letter, label, kind)),
                None => offered_read::read(loaded, question, ask, &letter, builder, &path)
                    .map(|kind| (letter, ask.choose.clone(), kind)),
            },
            Ask::Conserved(ask) => {
                conserved::conserved(loaded, ask, builder, &path).map(|kind| (letter, kind.0, kind.1))
            }
            Ask::Classify(ask) => {
                impact_kind::classify(loaded, ask, builder, &path).map(|kind| (letter, kind.0, kind.1))
            }
            Ask::Impulsive(ask) => {
                impulsive::impulsive(ask, builder, &path, &mut read.conditions).map(|kind| (letter, kind.0, kind.1))
            }
            Ask::Holds(ask) => comparing::holds(loaded, ask, builder, &path).map(|kind| (letter, kind.0, kind.1)),
            Ask::Range(ask) => range::read(loaded, ask, builder, &path).map(|(label, kind, boundary)| {
                read.counts.push(boundary);
                (ask.range.clone(), label, kind)
            }),
            Ask::Physical(ask) => roots::physical(ask, builder, &path).map(|kind| (letter, kind.0, kind.1)),
            Ask::Order(ask) => comparing::order(ask, builder, &path).map(|kind| (letter, kind.0, kind.1)),
        };
        let Some((id, label, kind)) = part else { continue };
        if read.parts.iter().any(|part| part.id == id) {
            let fault = Fault::new(Code::Duplicate, format!("`{id}` is asked for twice"));
            builder.fault(fault.help("ask for it once: answers are identified by their names").at_path(path));
            continue;
        }
        read.wanted.extend(kind.wanted());
        let (points, own_label) = points_and_label(ask);
        let label = own_label.unwrap_or_else(|| loaded.draft.scene.in_agreement(&label));
        let points = loaded.draft.points_of(points);
        let expected = match ask {
            Ask::Find(find) => find.expect.clone(),
            Ask::Range(range) => range.expect.clone(),
            _ => Entries::default(),
        };
        read.parts.push(Part { id, label, points, expected, kind });
    }
    tell_apart(&mut read.parts, builder);
    check_alone(&read, question, builder);
    rubric::check(&loaded.draft.rubric, builder);
    read
}

/// Tells questions with the same words apart: each says in which stage its quantity is.
fn tell_apart(parts: &mut [Part], builder: &Builder<'_>) {
    let phrase = |part: &Part| match part.kind.wanted()[..] {
        [only] if !matches!(part.kind, PartKind::Choice(_)) => builder.stage_phrase_of(only),
        _ => None,
    };
    let phrases: Vec<(String, Option<String>)> = parts.iter().map(|part| (part.label.clone(), phrase(part))).collect();
    for (part, (label, stage)) in parts.iter_mut().zip(&phrases) {
        let differs = |(other, its): &(String, Option<String>)| other == label && its != stage;
        if let Some(stage) = stage.as_ref().filter(|_| phrases.iter().any(differs)) {
            part.label = format!("{label} during {stage}");
        }
    }
}

/// On the boundary of an interval other quantities have the values that belong to it, and no others can be asked.
fn check_alone(read: &ReadParts, question: &Question, builder: &mut Builder<'_>) {
    let ranges = read.parts.iter().filter(|part| matches!(part.kind, PartKind::Range(_))).count();
    if ranges > 0 && read.wanted.len() > 1 {
        let fault =
            Fault::new(Code::Value, "a range is asked for together with other quantities, whose values it leaves open");
        let help = "give the range a form of its own";
        builder.fault(fault.help(help).at_path(question.path.key("ask")));
    }
}

fn points_and_label(ask: &Ask) -> (Option<u32>, Option<String>) {
    match ask {
        Ask::Find(ask) => (ask.points, ask.label.clone()),
        Ask::Count(ask) => (ask.points, ask.label.clone()),
        Ask::Conserved(ask) => (ask.points, ask.label.clone()),
        Ask::Classify(ask) => (ask.points, ask.label.clone()),
        Ask::Impulsive(ask) => (ask.points, ask.label.clone()),
        Ask::Holds(ask) => (ask.points, ask.label.clone()),
        Ask::Order(ask) => (ask.points, ask.label.clone()),
        Ask::Range(ask) => (ask.points, ask.label.clone()),
        Ask::Physical(ask) => (ask.points, ask.label.clone()),
        Ask::Choose(ask) => (ask.points, None),
        Ask::Enough(ask) => (ask.points, ask.label.clone()),
    }
}

fn number(loaded: &Loaded, find: &Find, builder: &mut Builder<'_>, path: &Path) -> Option<Named> {
    let named = expression::named(find, builder);
    let find = named.as_ref().unwrap_or(find);
    let symbol = match &find.id {
        Some(id) => Some(expression::asked(find, id, builder, path)?),
        None => builder.mention(&find.find),
    };
    let Some(symbol) = symbol else {
        if let Some(symbols) = vector::components(&find.find, builder) {
            if find.answered == Answered::Formula {
                let fault =
                    Fault::new(Code::Value, format!("`{}` is a vector, which has no single formula", find.find));
                let help = format!("ask for its components: `{}.x`", find.find);
                builder.fault(fault.help(help).at_path(path.key("find")));
                return None;
            }
            return vector::read(loaded, find, &symbols, builder, path);
        }
        let fault = builder.unknown(&find.find);
        builder.fault(fault.at_path(path.key("find")));
        return None;
    };
    let (symbol, reference) = reference(find, symbol, builder, path)?;
    let entry = builder.symbols().entry(symbol).clone();
    let kind = match find.answered {
        Answered::Number => PartKind::Number(number_part(loaded, find, symbol, builder, path)?),
        Answered::Formula => PartKind::Formula(formula_part(find, symbol, builder, path)?),
    };
    let meaning = if entry.meaning.is_empty() { format!("the value of {}", find.name()) } else { entry.meaning };
    let label = format!("{meaning}{reference}");
    Some((find.name().to_owned(), label, kind))
}

/// A formula has no unit and no figures; it may be a multiple of a quantity.
fn formula_part(find: &Find, symbol: Symbol, builder: &mut Builder<'_>, path: &Path) -> Option<FormulaPart> {
    let keys = [("figures", find.figures.is_some()), ("tolerance", find.tolerance.is_some())];
    if let Some((key, _)) = keys.into_iter().find(|(_, written)| *written) {
        let fault = Fault::new(Code::Value, format!("a formula has no {key}"));
        builder.fault(fault.help("remove it, or ask for a number").at_path(path.key(key)));
        return None;
    }
    let Some(unit) = &find.unit else { return Some(FormulaPart { symbol, in_terms_of: None }) };
    let Some(other) = builder.mention(unit).filter(|_| Unit::parse(unit).is_err()) else {
        let fault = Fault::new(Code::Value, "a formula has no unit");
        let help = "remove it, or name a quantity in terms of which it is asked for: `unit: v_A1`";
        builder.fault(fault.help(help).at_path(path.key("unit")));
        return None;
    };
    Some(FormulaPart { symbol, in_terms_of: Some(other) })
}

/// A direction is asked from a stated axis and in a stated sense; the symbol that is counted so, and the words for it.
fn reference(find: &Find, symbol: Symbol, builder: &mut Builder<'_>, path: &Path) -> Option<(Symbol, String)> {
    if find.id.is_some() {
        return Some((symbol, String::new()));
    }
    // Along one axis there are no directions to count: an angle is one between a cord and the vertical.
    let is_direction =
        matches!(builder.name(symbol).kind, QuantityKind::Direction(_)) && builder.axis_letters().len() > 1;
    let (Some(from), Some(sense)) = (&find.from, find.sense) else {
        if is_direction {
            let message = format!("the axis and the sense from which `{}` is measured are missing", find.find);
            let fault = Fault::new(Code::MissingKey, message).help("write `from: +x` and `sense: counter-clockwise`");
            builder.fault(fault.at_path(path.key("find")));
            return None;
        }
        return Some((symbol, String::new()));
    };
    let clockwise = sense == Turn::Clockwise;
    let Some(counted) = builder.counted_from(symbol, from, clockwise) else {
        let fault = Fault::new(Code::Value, format!("`{from}` is not an axis of this scene"));
        builder.fault(fault.help("write an axis with its sign, such as `+x`").at_path(path.key("from")));
        return None;
    };
    let words = if clockwise { "clockwise" } else { "counter-clockwise" };
    Some((counted, format!(", measured {words} from {}", with_minus_signs(from))))
}
