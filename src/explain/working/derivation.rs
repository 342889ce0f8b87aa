//! The equations of a step in the order in which a student writes them, and how each follows from those before it.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::Instance;
use momentous_model::Integral;
use momentous_model::Shown;
use momentous_solve::Closed;
use momentous_solve::Move;
use momentous_solve::Root;
use momentous_solve::Statement;
use momentous_solve::Step;
use momentous_solve::System;

use super::super::terms::algebra::positive_first;
use super::super::terms::algebra::without_common_minus;
use super::super::terms::display::Display;

/// One equation of a step.
#[derive(Debug)]
pub(crate) struct Line {
    /// Its number, where a sentence refers to it.
    pub number: Option<u32>,
    pub left: Expr,
    pub relation: Operator,
    pub right: Expr,
    pub origin: Origin,
    /// The step from which it follows, where that is shown with it.
    pub shown: Option<Shown>,
}

impl Line {
    /// The integral that its right side is the value of, where that is shown.
    pub(crate) fn integral(&self) -> Option<&Integral> {
        match &self.shown {
            Some(Shown::Integral { of: integral_of, integral }) if *integral_of == self.left => Some(integral),
            _ => None,
        }
    }
}

/// The equations of earlier steps by their places in the system, with the numbers of their lines.
pub(crate) type Stated = BTreeMap<usize, Option<u32>>;

/// The origin of a line. Other lines are named by their places in the step.
#[derive(Debug)]
pub(crate) enum Origin {
    /// It is the statement of a law; its place in the system.
    Law(usize),
    /// `times`, multiplied by `factor`, was added to `to`.
    Add { to: usize, times: usize, factor: Expr, drops: Symbol },
    /// `zero` is zero, so that a quantity drops out of `of`.
    Vanish { of: usize, zero: Expr, drops: Symbol },
    /// The value of a quantity from the line `what` was put into the line `into`.
    Put { what: usize, into: usize },
    /// The integral of a law was worked out, with what equations of earlier steps say of the ends of its range.
    Integrate { of: usize, ends: Stated },
    /// Both sides were squared.
    Square(usize),
    /// It was divided by a cosine.
    Tangent(usize),
    /// Two equations were solved for a component.
    Component([usize; 2]),
    /// `of` was multiplied by `factor`, and its terms were collected: a quadratic equation in this power of the unknown.
    Collect { of: usize, factor: Expr, unknown: Symbol, power: i64 },
    /// It was solved for a quantity.
    Solve { of: usize, unknown: Symbol },
}

/// How the equations of a step are solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Solving {
    /// In symbols, line by line; numbers are put into the formula that results.
    InSymbols,
    /// With the numbers put into the laws.
    InNumbers,
}

/// The lines of a step, and from which of them each unknown is found.
#[derive(Debug, Default)]
pub(crate) struct Derivation {
    pub lines: Vec<Line>,
    pub sources: BTreeMap<Symbol, Vec<usize>>,
    /// The last line that was made of each equation of the system.
    latest: BTreeMap<usize, usize>,
    /// Whether numbers are put into the laws at once, so that no line of algebra in symbols is written.
    is_of_numbers: bool,
}

impl Derivation {
    /// The lines of a step, in their order and not yet numbered: laws, and the algebra that follows from them unless numbers are
    /// put in at once.
    pub(crate) fn of(display: Display<'_>, step: &Step, before: &Stated, solving: Solving) -> Self {
        let system = &display.worked.leaf().system;
        let instances = &display.worked.problem.model().instances;
        let mut derivation = Self { is_of_numbers: solving == Solving::InNumbers, ..Self::default() };
        let is_alone = step.equations.len() == 1;
        for equation in &step.equations {
            let Some(stated) = system.equations.get(*equation) else { continue };
            let (left, relation, right) = match &stated.statement {
                Statement::Equal { left, right } if is_alone => {
                    // What says `x = u` of an unknown u is read as `u = x`, and needs no other line.
                    let is_backward = is_definition(step, right, left);
                    let [left, right] =
                        if is_backward { [right.clone(), left.clone()] } else { without_common_minus(left, right) };
                    (left, Operator::Equals, right)
                }
                Statement::Equal { left, right } => (left.clone(), Operator::Equals, right.clone()),
                Statement::FirstInteger { left, relation, right, .. } => {
                    (left.clone(), relation.operator(), right.clone())
                }
            };
            let place = derivation.lines.len();
            derivation.latest.insert(*equation, place);
            let gives = is_alone && step.unknowns.iter().any(|unknown| left == Expr::from(*unknown));
            let instance = instances.get(stated.tag);
            let step_before = instance.and_then(|instance| {
                shown_step(instance, &stated.statement, &right, gives)
                    .or_else(|| shown_integral(system, instance, &stated.statement, [&left, &right], before))
            });
            let (shown, ends) = step_before.unzip();
            let is_integral =
                |shown: &Shown| matches!(shown, Shown::Integral { of: integral_of, .. } if *integral_of == left);
            let says_it_all = gives && shown.as_ref().is_some_and(is_integral);
            let worked_out = ends
                .flatten()
                .filter(|ends| !says_it_all || !ends.is_empty())
                .map(|ends| (ends, [left.clone(), right.clone()]));
            derivation.lines.push(Line { number: None, left, relation, right, origin: Origin::Law(*equation), shown });
            if let Some((ends, [left, right])) = worked_out {
                let [left, right] = [left, right].map(|side| decided(system, &side));
                derivation.replace(*equation, &left, &right, Origin::Integrate { of: place, ends });
            }
        }
        for step_move in &step.moves {
            derivation.write(step_move);
        }
        if let [only] = step.equations[..] {
            let last = derivation.latest(only);
            for unknown in &step.unknowns {
                derivation.sources.entry(*unknown).or_insert_with(|| vec![last]);
            }
        }
        derivation
    }

    /// Numbers the lines that a sentence refers to, from `next` on. The law of a step with no other equation stands just
    /// above what is said of it.
    pub(crate) fn number(&mut self, next: &mut u32) {
        // With numbers, what is found follows at once from the one line above it, which nobody has to point at.
        let mut referred: BTreeSet<usize> =
            if self.is_of_numbers { BTreeSet::new() } else { self.sources.values().flatten().copied().collect() };
        referred.extend(self.lines.iter().flat_map(|line| line.origin.from()));
        let laws = self.lines.iter().filter(|line| matches!(line.origin, Origin::Law(_))).count();
        let all_laws = self.is_of_numbers && laws > 1;
        for (place, line) in self.lines.iter_mut().enumerate() {
            let is_law = matches!(line.origin, Origin::Law(_));
            let stands_alone = laws == 1 && is_law;
            if (referred.contains(&place) || all_laws && is_law) && !stands_alone {
                line.number = Some(*next);
                *next += 1;
            }
        }
    }

    /// The lines from which an unknown is found.
    pub(crate) fn sources_of(&self, unknown: Symbol) -> Vec<&Line> {
        let places = self.sources.get(&unknown).map(Vec::as_slice).unwrap_or_default();
        places.iter().filter_map(|place| self.lines.get(*place)).collect()
    }

    /// The laws that it states, as equations of the system, with their numbers.
    pub(crate) fn stated(&self) -> impl Iterator<Item = (usize, Option<u32>)> {
        self.lines.iter().filter_map(|line| match line.origin {
            Origin::Law(equation) => Some((equation, line.number)),
            _ => None,
        })
    }

    fn latest(&self, equation: usize) -> usize {
        self.latest.get(&equation).copied().unwrap_or(0)
    }

    /// Writes a line of algebra.
    fn push(&mut self, left: &Expr, right: &Expr, origin: Origin) -> usize {
        let [left, right] = [left, right].map(positive_first);
        self.lines.push(Line { number: None, left, relation: Operator::Equals, right, origin, shown: None });
        self.lines.len() - 1
    }

    /// An equation as a quadratic one in a power of the unknown, all terms on one side.
    fn collect(&mut self, (equation, factor): (usize, &Expr), (unknown, power): (Symbol, i64), [a, b, c]: [&Expr; 3]) {
        let sign = Expr::integer(if a.begins_with_minus() { -1 } else { 1 });
        let [a, b, c, factor] = [a, b, c, factor].map(|term| (sign.clone() * term.clone()).simplify());
        let x = Expr::from(unknown).powi(power);
        let left = Expr::sum([a * x.clone().powi(2), b * x, c]);
        let origin = Origin::Collect { of: self.latest(equation), factor, unknown, power };
        self.replace(equation, &left, &Expr::zero(), origin);
        self.sources.insert(unknown, vec![self.latest(equation)]);
    }

    /// Writes the line that takes the place of an equation.
    fn replace(&mut self, equation: usize, left: &Expr, right: &Expr, origin: Origin) {
        if self.is_of_numbers && !matches!(origin, Origin::Integrate { .. }) {
            return;
        }
        let place = self.push(left, right, origin);
        self.latest.insert(equation, place);
    }

    fn write(&mut self, step_move: &Move) {
        match step_move {
            Move::Combine { equation, times, factor, drops, left, right } => {
                let (to, times) = (self.latest(*equation), self.latest(*times));
                let origin = Origin::Add { to, times, factor: positive_first(factor), drops: *drops };
                self.replace(*equation, left, right, origin);
            }
            Move::Vanish { equation, zero, drops, left, right } => {
                let origin = Origin::Vanish { of: self.latest(*equation), zero: zero.clone(), drops: *drops };
                self.replace(*equation, left, right, origin);
            }
            Move::Isolate { equation, unknown, .. } => {
                self.sources.insert(*unknown, vec![self.latest(*equation)]);
            }
            Move::Substitute { equation, unknown, value, left, right } => {
                let what = self.solved(*unknown, value);
                let origin = Origin::Put { what, into: self.latest(*equation) };
                self.replace(*equation, left, right, origin);
            }
            Move::Square { equation, left, right } => {
                let origin = Origin::Square(self.latest(*equation));
                self.replace(*equation, left, right, origin);
            }
            Move::Tangent { equation, left, right } => {
                let origin = Origin::Tangent(self.latest(*equation));
                self.replace(*equation, left, right, origin);
            }
            Move::Quadratic { equation, factor, unknown, a, b, c } => {
                self.collect((*equation, factor), (*unknown, 1), [a, b, c]);
            }
            Move::Biquadratic { equation, factor, unknown, coefficients } => {
                self.collect((*equation, factor), (*unknown, 2), coefficients.each_ref());
            }
            Move::Polar { equations, magnitude, angle, x, y } => {
                let both = equations.map(|equation| self.latest(equation));
                let parts = [(Function::Cos, x, both[0]), (Function::Sin, y, both[1])];
                let lines = parts.map(|(function, value, line)| {
                    let part = Expr::from(*magnitude) * Expr::apply(function, Expr::from(*angle));
                    let is_stated = self.lines.get(line).is_some_and(|line| {
                        line.left == part && line.right == *value || line.right == part && line.left == *value
                    });
                    if is_stated || self.is_of_numbers {
                        line
                    } else {
                        self.push(&part, value, Origin::Component(both))
                    }
                });
                self.sources.extend([*magnitude, *angle].map(|unknown| (unknown, lines.to_vec())));
            }
            Move::Count { .. } | Move::Numeric { .. } => {}
        }
    }

    /// The line that says what an unknown equals.
    fn solved(&mut self, unknown: Symbol, value: &Expr) -> usize {
        let source = self.sources.get(&unknown).and_then(|lines| lines.first()).copied().unwrap_or(0);
        let left = Expr::from(unknown);
        let is_stated = self.lines.get(source).is_some_and(|line| line.left == left && line.right == *value);
        if is_stated || self.is_of_numbers {
            return source;
        }
        let place = self.push(&left, value, Origin::Solve { of: source, unknown });
        self.sources.insert(unknown, vec![place]);
        place
    }
}

impl Origin {
    /// The lines that it names.
    pub(crate) fn from(&self) -> Vec<usize> {
        match self {
            Self::Law(_) => Vec::new(),
            Self::Add { to, times, .. } => vec![*to, *times],
            Self::Put { what, into } => vec![*what, *into],
            Self::Component(both) => both.to_vec(),
            Self::Integrate { of, .. }
            | Self::Vanish { of, .. }
            | Self::Square(of)
            | Self::Tangent(of)
            | Self::Collect { of, .. }
            | Self::Solve { of, .. } => vec![*of],
        }
    }
}

/// The integral of a law beside its value, and what was stated before of the ends of its range; none where there is no integral, or its
/// ends are named by what the solution does not state before.
fn shown_integral(
    system: &System,
    instance: &Instance,
    statement: &Statement,
    [left, value]: [&Expr; 2],
    before: &Stated,
) -> Option<(Shown, Option<Stated>)> {
    let mut integral = instance.integral.clone()?;
    // The sides may have changed their signs.
    if matches!(statement, Statement::Equal { right, .. } if right != value) {
        integral.integrand = (-integral.integrand).simplify();
    }
    let place = |tag: &usize| {
        before.iter().find(|(place, _)| system.equations.get(**place).is_some_and(|equation| equation.tag == *tag))
    };
    let ends = instance.ends.iter().map(|tag| place(tag).map(|(place, number)| (*place, *number)));
    Some((Shown::Integral { of: left.clone(), integral }, Some(ends.collect::<Option<Stated>>()?)))
}

/// The step that a law shows of itself, and that an integral in it is then worked out.
fn shown_step(
    instance: &Instance,
    statement: &Statement,
    value: &Expr,
    gives: bool,
) -> Option<(Shown, Option<Stated>)> {
    let shown = instance.shown.clone()?;
    // The sides may have changed their signs.
    let is_turned = matches!(statement, Statement::Equal { right, .. } if right != value);
    match shown {
        Shown::Integral { .. } => Some((shown, Some(Stated::new()))),
        // Where more is to be found than its left side, the equation itself is what is put elsewhere.
        Shown::Balance(_) => gives.then_some((shown, None)),
        Shown::Series(_) | Shown::Areas(_) => (!is_turned).then_some((shown, None)),
    }
}

/// A term in which each quantity given piece by piece, between bounds whose values are known beforehand, is replaced by the piece
/// that holds in every variant.
fn decided(system: &System, term: &Expr) -> Expr {
    let Expr::Piecewise(piecewise) = term else { return term.map_children(|part| decided(system, part)) };
    let value = |term: &Expr| {
        let known = term.substitute(&|symbol| system.values.get(&symbol).cloned()).simplify();
        known.as_number().cloned()
    };
    let at = value(&piecewise.variable);
    let holds = |until: &Option<Expr>| {
        let Some(until) = until else { return Some(true) };
        Some(at.clone()? <= value(until)?)
    };
    // An open bound before the piece that holds leaves all of it open.
    let holding =
        piecewise.pieces.iter().map(|(until, piece)| (holds(until), piece)).find(|(holds, _)| *holds != Some(false));
    match holding {
        Some((Some(true), piece)) => decided(system, piece),
        _ => term.clone(),
    }
}

/// Whether a step only evaluates what its equation already states: `T_1 = ...`.
pub(crate) fn is_definition(step: &Step, left: &Expr, right: &Expr) -> bool {
    let [Root { values }] = &step.roots[..] else { return false };
    let [(unknown, Closed::Formula(formula))] = &values[..] else { return false };
    *left == Expr::from(*unknown) && formula == right
}
