//! How a number is asked: in which unit, to how many figures, and how closely.

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_model::VectorName;
use momentous_quantity::Decimal;
use momentous_quantity::Dimension;
use momentous_quantity::Tolerance;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;
use momentous_quantity::dimension_name;
use momentous_scene::Term;

use super::super::language::ask::Ask;
use super::super::language::ask::Find;
use super::super::language::given::Given;
use super::super::language::literal::unit_fault;
use super::super::reading::load::Loaded;
use super::part::AskedUnit;
use super::part::NumberPart;

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
                AskedUnit::InTermsOf(other, coherent_unit(multiple, loaded.draft.units.system()))
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

/// The unit in which a quantity is asked where the file does not say: that in which it is given, else the system's own.
pub(crate) fn unit_for(loaded: &Loaded, name: &str, dimension: Dimension) -> Unit {
    let given = match loaded.given.get(name) {
        Some(Given::Drawn { unit, .. }) => Some(unit.clone()),
        Some(Given::Literal(literal)) => Some(literal.unit.clone()),
        _ => asked_in(loaded, name),
    };
    let of_an_angle = || (dimension == Dimension::NONE && is_angle(name)).then(Unit::degree);
    let of_its_kind = || of_its_kind(loaded, name, dimension);
    let coherent = || coherent_unit(dimension, loaded.draft.units.system());
    given.or_else(of_an_angle).or_else(of_its_kind).unwrap_or_else(coherent)
}

/// Whether a name is that of a direction or of an angle between two.
fn is_angle(name: &str) -> bool {
    matches!(VectorName::parse(name), Some(VectorName::AngleBetween(_)))
        || Name::parse(name).is_some_and(|name| matches!(name.kind, QuantityKind::Direction(_)))
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
    let kind_of_name = kind(name)?;
    let alike = |(other, given): (&str, &Given)| {
        let unit = match given {
            Given::Drawn { unit, .. } => unit,
            Given::Literal(literal) => &literal.unit,
            Given::Any(_) | Given::Expression(_) => return None,
        };
        let speed = |kind: &QuantityKind| matches!(kind, QuantityKind::Velocity | QuantityKind::Speed);
        let kin = kind(other).is_some_and(|kind| kind == kind_of_name || speed(&kind) && speed(&kind_of_name));
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
    let quantity = momentous_quantity::Quantity::parse(text).ok()?;
    let bare = quantity.unit.is_none() && dimension == Dimension::NONE;
    (bare || quantity.unit.dimension() == dimension).then_some(Tolerance::Absolute(quantity.value))
}
