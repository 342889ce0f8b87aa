//! Reading what is asked: each entry of `ask` becomes a part.

use crate::expr::Symbol;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::model::Builder;
use crate::model::Name;
use crate::model::QuantityKind;
use crate::model::VectorName;
use crate::quantity::Decimal;
use crate::quantity::Dimension;
use crate::quantity::Tolerance;
use crate::quantity::Unit;
use crate::quantity::coherent_unit;
use crate::quantity::dimension_name;
use crate::quantity::with_minus_signs;
use crate::scene::Term;
use crate::solve::Condition;
use crate::solve::Equation;

use super::super::compiling::compile::unit_system;
use super::super::language::ask::Answered;
use super::super::language::ask::Ask;
use super::super::language::ask::Find;
use super::super::language::ask::Turn;
use super::super::language::expression;
use super::super::language::form::Question;
use super::super::language::given::Given;
use super::super::language::literal::unit_fault;
use super::super::language::rubric::fraction;
use super::super::reading::load::Loaded;
use super::comparing;
use super::concept;
use super::conserved;
use super::counted::counted;
use super::enough;
use super::enough::Sought;
use super::formula::FormulaPart;
use super::impact_kind;
use super::offered_read;
use super::part::AskedUnit;
use super::part::NumberPart;
use super::part::Part;
use super::part::PartKind;
use super::pictured_read;
use super::range;
use super::roots;
use super::vector;

/// What reading the parts of a form gives.
#[derive(Default)]
pub(in crate::problem) struct Read {
    pub parts: Vec<Part>,
    /// The quantities to be solved.
    pub wanted: Vec<Symbol>,
    /// The equations of parts that are found by counting, and of the boundary of an interval.
    pub counts: Vec<Equation>,
    /// What must hold for the questions to have their answers.
    pub conditions: Vec<Condition>,
    /// What the planner has to answer.
    pub sought: Vec<Sought>,
}

/// Reads the parts of a form; faults are noted in the builder.
pub(in crate::problem) fn read(loaded: &Loaded, question: &Question, builder: &mut Builder<'_>) -> Read {
    let mut read = Read::default();
    check_rubric(loaded, builder);
    for ((index, ask), letter) in question.ask.iter().enumerate().zip(('a'..='z').cycle()) {
        let path = question.path.key("ask").index(index);
        let letter = letter.to_string();
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
                concept::impulsive(ask, builder, &path, &mut read.conditions).map(|kind| (letter, kind.0, kind.1))
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
        let points = loaded.draft.points_of(points);
        read.parts.push(Part { id, label: own_label.unwrap_or(label), points, kind });
    }
    tell_apart(&mut read.parts, builder);
    check_alone(&read, question, builder);
    read
}

/// Where two questions have the same words, each says in which stage its quantity is.
fn tell_apart(parts: &mut [Part], builder: &Builder<'_>) {
    let phrase = |part: &Part| match part.kind.wanted()[..] {
        [only] if !matches!(part.kind, PartKind::Choice(_)) => builder.stage_phrase_of(only),
        _ => None,
    };
    let own: Vec<(String, Option<String>)> = parts.iter().map(|part| (part.label.clone(), phrase(part))).collect();
    for (part, (label, stage)) in parts.iter_mut().zip(&own) {
        let differs = |(other, its): &(String, Option<String>)| other == label && its != stage;
        if let Some(stage) = stage.as_ref().filter(|_| own.iter().any(differs)) {
            part.label = format!("{label} during {stage}");
        }
    }
}

/// On the boundary of an interval other quantities have the values that belong to it, and no others can be asked.
fn check_alone(read: &Read, question: &Question, builder: &mut Builder<'_>) {
    let ranges = read.parts.iter().filter(|part| matches!(part.kind, PartKind::Range(_))).count();
    if ranges > 0 && read.wanted.len() > 1 {
        let fault =
            Fault::new(Code::Value, "a range is asked for together with other quantities, whose values it leaves open");
        let help = "give the range a form of its own";
        builder.fault(fault.help(help).at_path(question.path.key("ask")));
    }
}

/// Every fraction of the rubric can be read; it is the same for all forms, so its faults are told once.
fn check_rubric(loaded: &Loaded, builder: &mut Builder<'_>) {
    for (key, term) in loaded.draft.rubric.fractions().filter(|(_, term)| fraction(term).is_none()) {
        let fault = Fault::new(Code::Value, format!("`{}` is not a fraction of the points", term.0));
        let path = Path::root().key("rubric").key(key);
        builder.fault(fault.help("write a fraction from 0 to 1: `50 %`, `0.5` or `1/2`").at_path(path));
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

pub(in crate::problem) type Named = (String, String, PartKind);

fn number(loaded: &Loaded, find: &Find, builder: &mut Builder<'_>, path: &Path) -> Option<Named> {
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
        let fault = expression::without_id(find, builder).unwrap_or_else(|| builder.unknown(&find.find));
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

/// How a quantity is asked: in which unit, to how many figures, and how closely.
pub(super) fn number_part(
    loaded: &Loaded,
    find: &Find,
    symbol: Symbol,
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<NumberPart> {
    let entry = builder.symbols().entry(symbol).clone();
    let unit = match &find.unit {
        None => AskedUnit::Unit(unit_for(loaded, find.name(), entry.dimension)),
        Some(text) => match (Unit::parse(text), builder.mention(text)) {
            (Ok(unit), _) if unit.dimension() == entry.dimension => AskedUnit::Unit(unit),
            (_, Some(other)) if builder.symbols().entry(other).dimension == entry.dimension => {
                AskedUnit::InTermsOf(other, Unit::none())
            }
            // Of what the sheet tells by a number nobody asks for a multiple with a unit of its own.
            (_, Some(other)) if matches!(loaded.given.get(text), Some(Given::Any(_))) => {
                let multiple = entry.dimension / builder.symbols().entry(other).dimension;
                AskedUnit::InTermsOf(other, coherent_unit(multiple, unit_system(loaded.draft.units)))
            }
            (Ok(unit), _) => {
                let [expected, found] = [entry.dimension, unit.dimension()].map(dimension_name);
                let message = format!("`{}` is {expected}, but `{text}` is a unit of {found}", find.name());
                let help = match builder.mention(text) {
                    Some(_) => format!(
                        "write a unit of its own dimension; an answer in terms of `{text}` needs `{text}` given as `any`, with its unit"
                    ),
                    None => "write a unit of its own dimension".to_owned(),
                };
                builder.fault(Fault::new(Code::Dimension, message).help(help).at_path(path.key("unit")));
                return None;
            }
            (Err(fault), _) => {
                let fault = no_unit(text, unit_fault(fault, 0), builder);
                builder.fault(fault.at_path(path.key("unit")));
                return None;
            }
        },
    };
    if find.id.is_some()
        && matches!(&unit, AskedUnit::Unit(unit) if unit.is_percent())
        && builder.term(&find.find, &path.key("find")).is_a_hundredfold()
    {
        let message = format!("`{}` in % is a hundred times too large", find.find);
        let fault = Fault::new(Code::Value, message).help("`%` is already a hundredth: leave out `100*`");
        builder.fault(fault.at_path(path.key("find")));
        return None;
    }
    let tolerance = find.tolerance.as_ref().or(loaded.draft.tolerance.as_ref());
    let tolerance = match tolerance.map(|term| read_tolerance(term, entry.dimension)) {
        None => default_tolerance(&unit),
        Some(Some(tolerance)) => tolerance,
        Some(None) => {
            let fault = Fault::new(Code::Value, "a tolerance is a percentage or a value in the unit of the question");
            builder.fault(fault.help("write `2 %`, `0.05 m/s` or `to figures`").at_path(path.key("tolerance")));
            return None;
        }
    };
    let figures = find.figures.map_or_else(|| loaded.draft.significant_figures(), usize::from);
    let every_root = find.roots.is_some();
    Some(NumberPart { symbol, size: unit.size(), unit, figures, tolerance, whole: false, every_root })
}

/// The fault of what is no unit; a product of quantities is no unit either.
fn no_unit(text: &str, fault: Fault, builder: &mut Builder<'_>) -> Fault {
    let words = text.split(|sign: char| !sign.is_alphanumeric() && sign != '_');
    let mut names = words.filter(|word| Unit::parse(word).is_err());
    if !names.any(|word| builder.mention(word).is_some()) {
        return fault;
    }
    fault.help("in terms of several quantities an answer is a formula: remove `unit`, and write `as: formula`")
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

/// The unit in which a quantity is asked where the file does not say: that in which it is given, else the system's own.
pub(in crate::problem) fn unit_for(loaded: &Loaded, name: &str, dimension: Dimension) -> Unit {
    let given = match loaded.given.get(name) {
        Some(Given::Drawn { unit, .. }) => Some(unit.clone()),
        Some(Given::Literal(literal)) => Some(literal.unit.clone()),
        _ => asked_in(loaded, name),
    };
    let of_an_angle = || (dimension == Dimension::NONE && is_angle(name)).then(Unit::degree);
    let of_its_kind = || of_its_kind(loaded, name, dimension);
    let coherent = || coherent_unit(dimension, unit_system(loaded.draft.units));
    given.or_else(of_an_angle).or_else(of_its_kind).unwrap_or_else(coherent)
}

/// Whether a name is that of a direction or of an angle between two.
fn is_angle(name: &str) -> bool {
    matches!(VectorName::parse(name), Some(VectorName::AngleBetween(_)))
        || Name::parse(name).is_some_and(|own| matches!(own.kind, QuantityKind::Direction(_)))
}

/// The unit in which some form of the file asks for a quantity.
fn asked_in(loaded: &Loaded, name: &str) -> Option<Unit> {
    let mut asks = loaded.questions.iter().flat_map(|question| &question.ask);
    asks.find_map(|ask| match ask {
        Ask::Find(find) if find.name() == name => Unit::parse(find.unit.as_deref()?).ok(),
        _ => None,
    })
}

/// The unit of a given of the same kind: velocities of one story are told in one unit.
fn of_its_kind(loaded: &Loaded, name: &str, dimension: Dimension) -> Option<Unit> {
    let kind = |name: &str| Name::parse(name).map(|name| name.kind);
    let own = kind(name)?;
    let alike = |(other, given): (&str, &Given)| {
        let unit = match given {
            Given::Drawn { unit, .. } => unit,
            Given::Literal(literal) => &literal.unit,
            Given::Any(_) | Given::Expression(_) => return None,
        };
        let speed = |kind: &QuantityKind| matches!(kind, QuantityKind::Velocity | QuantityKind::Speed);
        let kin = kind(other).is_some_and(|kind| kind == own || speed(&kind) && speed(&own));
        (kin && unit.dimension() == dimension).then(|| unit.clone())
    };
    loaded.given.iter().find_map(alike)
}

/// One per cent; half a degree of an angle.
fn default_tolerance(unit: &AskedUnit) -> Tolerance {
    match unit {
        AskedUnit::Unit(unit) if unit.is_plain_angle() && unit.has_pi() => {
            Tolerance::Absolute(Decimal::from_scaled(5, 1))
        }
        _ => Tolerance::Relative(Decimal::from_scaled(1, 2)),
    }
}

fn read_tolerance(term: &Term, dimension: Dimension) -> Option<Tolerance> {
    let text = term.0.trim();
    if text == "to figures" {
        return Some(Tolerance::ToFigures);
    }
    if let Some(percent) = text.strip_suffix('%') {
        let percent = Decimal::parse(percent.trim()).ok()?;
        let scale = u32::try_from(percent.scale()).ok()?;
        return Some(Tolerance::Relative(Decimal::from_scaled(percent.to_scaled(scale)?, scale + 2)));
    }
    let quantity = crate::quantity::Quantity::parse(text).ok()?;
    let bare = quantity.unit.is_none() && dimension == Dimension::NONE;
    (bare || quantity.unit.dimension() == dimension).then_some(Tolerance::Absolute(quantity.value))
}
