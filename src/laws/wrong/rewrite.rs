//! How wrong equations are written from right ones: terms left out, signs lost, factors exchanged.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::Sides;
use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Taught;
use super::Wrong;

impl Taught<'_> {
    pub(super) fn left(&self) -> Expr {
        self.sides.0.clone()
    }

    pub(super) fn right(&self) -> Expr {
        self.sides.1.clone()
    }

    pub(super) fn is(&self, symbol: Symbol, dimension: Dimension) -> bool {
        self.symbols.entry(symbol).dimension == dimension
    }

    /// Whether a term is a velocity by itself.
    pub(super) fn is_velocity(&self, term: &Expr) -> bool {
        matches!(term, Expr::Symbol(symbol) if self.is(*symbol, Dimension::VELOCITY))
    }

    /// Whether a term contains a quantity of that dimension.
    pub(super) fn has(&self, term: &Expr, dimension: Dimension) -> bool {
        term.symbols().into_iter().any(|symbol| self.is(symbol, dimension))
    }

    /// Whether a term contains the acceleration of free fall.
    pub(super) fn has_gravity(&self, term: &Expr) -> bool {
        self.symbols.find("g").is_some_and(|gravity| term.contains(gravity))
    }

    /// The quantity of the sides whose meaning contains these words.
    pub(super) fn meaning(&self, words: &str) -> Option<Symbol> {
        let both = self.sides.0.symbols().into_iter().chain(self.sides.1.symbols());
        both.into_iter().find(|symbol| self.symbols.entry(*symbol).meaning.contains(words))
    }

    /// Both sides with quantities replaced; none where nothing was.
    pub(super) fn replaced(&self, value: &dyn Fn(Symbol) -> Option<Expr>) -> Vec<Wrong> {
        self.both(|side| side.substitute(value))
    }

    /// Both sides rewritten; none where that leaves them as they were.
    pub(super) fn both(&self, change: impl Fn(&Expr) -> Expr) -> Vec<Wrong> {
        let sides = (change(&self.sides.0), change(&self.sides.1));
        if sides == *self.sides { Vec::new() } else { one(sides) }
    }

    /// Both sides without the terms that are left out, within brackets too; none where that leaves nothing of a side.
    pub(super) fn without(&self, out: &dyn Fn(&Expr) -> bool) -> Vec<Wrong> {
        let emptied = |(left, right): &Sides| {
            left.is_zero() && !self.sides.0.is_zero() || right.is_zero() && !self.sides.1.is_zero()
        };
        let wrong = self.both(|side| thinned(side, out));
        wrong.into_iter().filter(|wrong| !wrong.equations.iter().any(emptied)).collect()
    }

    /// The same law with the mass of another body in the place of one of its own, in the terms that are chosen: each mass, each
    /// other body.
    pub(super) fn of_other_mass(&self, others: &[Symbol], is_chosen: &dyn Fn(&Expr) -> bool) -> Vec<Wrong> {
        fn within(term: &Expr, mass: Symbol, other: Symbol, is_chosen: &dyn Fn(&Expr) -> bool) -> Expr {
            match term {
                Expr::Product(_) if is_chosen(term) => {
                    term.substitute(&|symbol| (symbol == mass).then(|| Expr::from(other)))
                }
                part => part.map_children(|child| within(child, mass, other, is_chosen)),
            }
        }
        let masses = self.quantities(Dimension::MASS);
        let pairs = masses.iter().flat_map(|mass| others.iter().map(move |other| (*mass, *other)));
        let unlike = pairs.filter(|(mass, other)| mass != other);
        unlike.flat_map(|(mass, other)| self.both(|side| within(side, mass, other, is_chosen))).collect()
    }

    /// The right side of a law beside this one.
    pub(super) fn beside(&self, law: &str) -> impl Iterator<Item = &Sides> {
        self.beside.iter().filter(move |(id, _)| *id == law).map(|(_, sides)| sides)
    }

    /// The coefficient of restitution of the same stage.
    pub(super) fn restitution(&self) -> Option<Expr> {
        let laws = ["restitution", "restitution-at-a-surface"];
        let sides = laws.iter().flat_map(|law| self.beside(law)).next()?;
        self.coefficient(&sides.1)
    }

    /// The factor without dimension of a product: e of `e (v_A1 - v_B1)`.
    pub(super) fn coefficient(&self, product: &Expr) -> Option<Expr> {
        factors(product)
            .into_iter()
            .find(|factor| matches!(factor, Expr::Symbol(symbol) if self.is(*symbol, Dimension::NONE)))
    }

    /// The quantities of that dimension in both sides.
    pub(super) fn quantities(&self, dimension: Dimension) -> Vec<Symbol> {
        let mut all = self.sides.0.symbols();
        all.extend(self.sides.1.symbols());
        all.into_iter().filter(|symbol| self.is(*symbol, dimension)).collect()
    }
}

/// One wrong equation.
pub(super) fn one(sides: Sides) -> Vec<Wrong> {
    vec![sides.into()]
}

/// The terms of a sum; the term itself where it is none.
pub(super) fn terms(term: &Expr) -> Vec<Expr> {
    match term {
        Expr::Sum(parts) => parts.to_vec(),
        other => vec![other.clone()],
    }
}

/// The factors of a product; the term itself where it is none.
pub(super) fn factors(term: &Expr) -> Vec<Expr> {
    match term {
        Expr::Product(parts) => parts.to_vec(),
        other => vec![other.clone()],
    }
}

/// A sum with each of its terms left out in turn; nothing where there is no sum.
pub(super) fn all_but_one(sum: &Expr) -> Vec<Expr> {
    let parts = terms(sum);
    let kept =
        |out: usize| parts.iter().enumerate().filter(move |(place, _)| *place != out).map(|(_, part)| part.clone());
    let places = if parts.len() > 1 { 0..parts.len() } else { 0..0 };
    places.map(|out| Expr::sum(kept(out))).collect()
}

fn thinned(term: &Expr, out: &dyn Fn(&Expr) -> bool) -> Expr {
    match term {
        Expr::Sum(parts) => Expr::sum(parts.iter().filter(|part| !out(part)).map(|part| thinned(part, out))),
        other => other.map_children(|part| thinned(part, out)),
    }
}

/// A velocity against the axis enters without its sign: each known one alone, each other one that stands alone, then all known ones.
pub(super) fn sign_lost(law: &Taught<'_>) -> Vec<Wrong> {
    let (signed, unknown): (Vec<Symbol>, Vec<Symbol>) =
        law.quantities(Dimension::VELOCITY).into_iter().partition(|symbol| law.known.contains(symbol));
    let bare = |of: &dyn Fn(Symbol) -> bool| {
        law.replaced(&|symbol| of(symbol).then(|| Expr::apply(Function::Abs, symbol.into())))
    };
    let one_by_one = signed.iter().chain(&unknown);
    let mut ways: Vec<Wrong> = one_by_one.flat_map(|own| bare(&|symbol| symbol == *own)).collect();
    if signed.len() > 1 {
        ways.extend(bare(&|symbol| signed.contains(&symbol)));
    }
    ways
}

/// Every sine becomes a cosine and every cosine a sine: of the angle as it is counted, or of its size, with the sign that the component
/// has on a drawing.
pub(super) fn sine_and_cosine(law: &Taught<'_>) -> Vec<Wrong> {
    let mut ways = law.both(turned);
    ways.extend(law.both(|side| turned_as_drawn(side, law.known)));
    ways
}

/// Every sine and cosine becomes one: the whole stands for a component.
pub(super) fn whole(law: &Taught<'_>) -> Vec<Wrong> {
    fn unturned(term: &Expr) -> Expr {
        match term {
            Expr::Apply(Function::Sin | Function::Cos, _) => Expr::one(),
            other => other.map_children(unturned),
        }
    }
    law.both(unturned)
}

fn turned(term: &Expr) -> Expr {
    match term {
        Expr::Apply(Function::Sin, parts) => Expr::Apply(Function::Cos, parts.clone()),
        Expr::Apply(Function::Cos, parts) => Expr::Apply(Function::Sin, parts.clone()),
        other => other.map_children(turned),
    }
}

/// The same with the size of each and the sign of what it stands for; an angle that is given is acute already.
fn turned_as_drawn(term: &Expr, given: &BTreeSet<Symbol>) -> Expr {
    let instead = |function: Function, parts: &Arc<[Expr]>| {
        let size = Expr::apply(Function::Abs, Expr::Apply(function, parts.clone()));
        let is_given = matches!(&parts[..], [Expr::Symbol(angle)] if given.contains(angle));
        let sign = term.clone() / Expr::apply(Function::Abs, term.clone());
        if is_given { Expr::Apply(function, parts.clone()) } else { sign * size }
    };
    match term {
        Expr::Apply(Function::Sin, parts) => instead(Function::Cos, parts),
        Expr::Apply(Function::Cos, parts) => instead(Function::Sin, parts),
        other => other.map_children(|part| turned_as_drawn(part, given)),
    }
}

/// What a body had at the start is left out: the first of the terms that `m v_1 + J` joins.
pub(super) fn start_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.0 {
        Expr::Sum(parts) if parts.len() > 1 => one((Expr::sum(parts.iter().skip(1).cloned()), law.right())),
        _ => Vec::new(),
    }
}

/// What is gained counts as lost: all terms but the first change their sign.
pub(super) fn gain_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.0 {
        Expr::Sum(parts) => {
            let signed =
                parts.iter().enumerate().map(|(place, part)| if place == 0 { part.clone() } else { -part.clone() });
            one((Expr::sum(signed), law.right()))
        }
        _ => Vec::new(),
    }
}
