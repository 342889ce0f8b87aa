//! Givens that cannot be meant: those that go in circles, and values that a quantity cannot have.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_quantity::Dimension;

use super::super::language::given::Given;
use super::super::language::known::Origin;
use super::load::Loaded;

/// A fault for each given that is an expression of itself, at once or by way of others.
pub(crate) fn circles(loaded: &Loaded, builder: &mut Builder<'_>) {
    let mut speaks_of: BTreeMap<Symbol, BTreeSet<Symbol>> = BTreeMap::new();
    let mut places = Vec::new();
    for (name, given) in loaded.given.iter() {
        let Given::Expression(text) = given else { continue };
        let path = Path::root().key("given").key(name);
        if let Some(symbol) = builder.mention(name) {
            speaks_of.insert(symbol, builder.term(text, &path).symbols());
            places.push((name, symbol, path));
        }
    }
    for (name, symbol, path) in places {
        let (mut reached, mut open) = (BTreeSet::new(), vec![symbol]);
        while let Some(symbol) = open.pop() {
            let next = speaks_of.get(&symbol).into_iter().flatten().copied();
            open.extend(next.filter(|other| reached.insert(*other)));
        }
        if reached.contains(&symbol) {
            let fault = Fault::new(Code::OverDetermined, format!("`{name}` is given in terms of itself"));
            builder.fault(fault.help("give one of the names in this cycle a value").at_path(path));
        }
    }
}

/// A fault where a quantity has a value, or may be drawn with one, that it cannot have.
pub(crate) fn value(builder: &Builder<'_>, name: &str, symbol: Symbol, origin: &Origin) -> Option<Fault> {
    too_small(builder, name, symbol, origin).or_else(|| not_whole(builder, name, symbol, origin))
}

/// A fault where a number of bounces may lie between two of them.
fn not_whole(builder: &Builder<'_>, name: &str, symbol: Symbol, origin: &Origin) -> Option<Fault> {
    if origin.is_whole() || !builder.is_count(symbol) {
        return None;
    }
    let fault = Fault::new(Code::Unphysical, format!("`{name}` counts, and must be a whole number"));
    Some(fault.help("give it a whole number, or a range of whole numbers with a whole step"))
}

/// A fault where a mass, a duration or a length may be drawn that is none.
fn too_small(builder: &Builder<'_>, name: &str, symbol: Symbol, origin: &Origin) -> Option<Fault> {
    if matches!(origin, Origin::Any) || origin.is_positive() || !builder.is_positive(symbol) {
        return None;
    }
    let kind = builder.symbols().entry(symbol).dimension;
    let may_be_zero = kind != Dimension::MASS && kind != Dimension::TIME;
    let message = match (origin, may_be_zero) {
        (Origin::Fixed(value), true) if !value.is_negative() => return None,
        (Origin::Drawn(_), true) => return None,
        (_, true) => format!("`{name}` cannot be negative"),
        (_, false) => format!("`{name}` must be greater than zero"),
    };
    Some(Fault::new(Code::Unphysical, message).help("give it a positive value, or a range of positive values"))
}
