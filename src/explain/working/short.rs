//! The steps of a short solution: each law, the numbers put into it, and what follows.

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_laws::geometry;
use momentous_laws::geometry::ROTATION;
use momentous_laws::kinematics::STRANDS;
use momentous_laws::kinematics::TOGETHER;
use momentous_laws::separation::GUIDE;
use momentous_model::Because;
use momentous_model::Instance;
use momentous_solve::Closed;
use momentous_solve::Equation;
use momentous_solve::Statement;
use momentous_solve::Step;

use super::super::Block;
use super::super::terms::algebra::divides_by_zero;
use super::super::terms::algebra::positive_first;
use super::super::terms::display::Display;
use super::super::terms::display::has_pieces;
use super::super::terms::term::Term;
use super::super::wording::capitalised;
use super::bracket;
use super::counting;
use super::derivation::Line;
use super::derivation::Origin;
use super::derivation::Solving;
use super::naming;
use super::naming::OtherName;
use super::needed;
use super::on_paper::as_on_paper;
use super::on_paper::only_evaluates;
use super::on_paper::quadratic_of;
use super::quadratic;
use super::quadratic::Short;
use super::script;
use super::script::Formula;
use super::script::Script;
use super::sentence;
use super::steps::Steps;
use super::steps::taken;
use momentous_scene::list;

/// The widest row that holds several results, in widths of a digit.
const WIDEST_ROW: f64 = 38.0;

/// How the quadrant of an angle is found.
const QUADRANT: &str = "The signs of both components give the quadrant.";

/// The same where the arctangent would divide by zero.
const RIGHT_ANGLE: &str = "One component is zero, so the angle to its axis is a right one.";

/// What stands before the size of a vector with one component.
const ONLY_COMPONENT: &str = "There is no other component:";

/// The letters of axes in reasons.
const AXES: [&str; 5] = ["x", "y", "z", "n", "t"];

/// By how much, relative to its size, a root may differ from the negative of another one.
const MIRRORED: f64 = 1e-9;

/// How many known quantities of a law make a line with their numbers worth its place.
const FEWEST_NUMBERS: usize = 2;

/// Writes the steps of one plan for a variant, with numbers as soon as no symbol is asked.
pub(crate) struct ShortSteps<'a> {
    display: Display<'a>,
    /// Writes the steps that are solved in symbols.
    in_symbols: Steps<'a>,
    /// The symbols asked.
    asked: BTreeSet<Symbol>,
    /// The last reason given, with neither bodies nor axes named.
    reason: String,
    /// The last cause given, from which a law follows.
    cause: Option<String>,
    /// All reasons given.
    reasons: BTreeSet<String>,
}

impl<'a> ShortSteps<'a> {
    pub(crate) fn new(display: Display<'a>) -> Self {
        Self {
            display,
            in_symbols: Steps::new(display),
            asked: needed::asked(display.worked),
            reason: String::new(),
            cause: None,
            reasons: BTreeSet::new(),
        }
    }

    /// One step, as blocks.
    pub(crate) fn step(&mut self, position: usize, step: &Step, script: &Script) -> Vec<Block> {
        if let Some(other) = naming::other_name(self.display, step).filter(|_| !script.is_given) {
            return self.another_name(&other);
        }
        match script.solving {
            Solving::InSymbols => self.in_symbols.step(position, step, script),
            Solving::InNumbers if script.is_given || self.is_plain_zero(step) => Vec::new(),
            Solving::InNumbers => self.in_numbers(position, step, script),
        }
    }

    /// What another quantity is called, unless that stands with the answer or the one name stands for the other.
    fn another_name(&mut self, other: &OtherName) -> Vec<Block> {
        let name = self.display.name(other.unknown);
        if self.display.has_other_name(other.unknown) || naming::stands_with_answer(self.display, other.unknown) {
            return Vec::new();
        }
        let parts = [name, other.symbols.clone(), self.display.quantity(other.unknown)];
        let lines = vec![Math::chain(parts, Operator::Equals)];
        let reason = other.is_size.then(|| Block::text(ONLY_COMPONENT));
        reason.into_iter().chain([Block::Equation { lines, number: None }]).collect()
    }

    fn in_numbers(&mut self, position: usize, step: &Step, script: &Script) -> Vec<Block> {
        let is_together = self.is_linear_system(step);
        let mut blocks = Vec::new();
        for line in &script.derivation.lines {
            blocks.extend(self.line(step, script, line, is_together));
        }
        let Some(root) = taken(self.display, position, step) else { return blocks };
        let from = from(script);
        if is_together {
            blocks.extend(from.map(|from| Block::text(&format!("{from}:"))));
            blocks.push(self.results(script.printed(root).map(|(unknown, ..)| unknown)));
            return blocks;
        }
        let quadratic = quadratic_of(self.display, step).and_then(|(unknown, way)| match way {
            Short::Equation(terms) => Some((unknown, quadratic::in_numbers(self.display, unknown, &terms)?)),
            Short::Root(_) => None,
        });
        match &quadratic {
            Some((_, equations)) => blocks.extend(Self::quadratic(from, equations)),
            None => blocks.extend(from.map(|from| Block::text(&format!("{from}:")))),
        }
        let solved = quadratic.map(|(unknown, _)| unknown);
        for (unknown, closed, answer) in script.printed(root) {
            if solved != Some(unknown) {
                self.result(&mut blocks, (step, script), (unknown, closed), &answer.formula);
            }
        }
        blocks.extend(self.rejected(position, step));
        blocks
    }

    /// Whether a step only says in other axes, of a body that is held, or of one that moves as another does, that a component which nobody asks
    /// for is zero.
    fn is_plain_zero(&self, step: &Step) -> bool {
        let plain = [ROTATION.id, GUIDE.id, TOGETHER.id, STRANDS.id];
        let is_plain = |place: &usize| self.law(*place).is_some_and(|(_, instance)| plain.contains(&instance.law.id));
        step.equations.iter().all(is_plain)
            && step.unknowns.iter().all(|unknown| self.display.is_nothing(*unknown) && !self.asked.contains(unknown))
    }

    /// Why the other roots are no solutions, unless that goes without saying.
    fn rejected(&self, position: usize, step: &Step) -> Vec<Block> {
        let worked = self.display.worked;
        let value = |unknown: &Symbol| worked.variant.value(*unknown).map_or(f64::NAN, |number| number.value);
        let taken: Vec<f64> = step.unknowns.iter().map(value).collect();
        let is_negative = taken.first().is_some_and(|first| *first < 0.0);
        let mut blocks = Vec::new();
        for dead in worked.variant.dead().iter().filter(|dead| dead.step == Some(position)) {
            let values = || dead.values.iter().map(|value| value.value);
            let is_mirrored =
                values().zip(&taken).all(|(other, mirrored)| (other + mirrored).abs() <= MIRRORED * mirrored.abs());
            if is_mirrored && is_negative {
                blocks.push(Block::text(&format!("The positive root is not the answer: {}.", worked.why_dead(dead))));
            } else if !is_mirrored && values().all(f64::is_finite) {
                blocks.extend(self.in_symbols.rejected(step, std::iter::once(dead)));
            }
        }
        blocks
    }

    /// A law with its reason, in symbols and, where several are solved together, with numbers; an integral worked out.
    fn line(&mut self, step: &Step, script: &Script, line: &Line, is_together: bool) -> Vec<Block> {
        let display = self.display;
        let without_zeros = |side: &Expr| display.without_known_zeros(side, &step.unknowns);
        let Origin::Law(place) = line.origin else {
            return sentence::blocks(display, &script.derivation, line, &without_zeros);
        };
        let Some((equation, instance)) = self.law(place) else { return Vec::new() };
        let reason = script::reason(display, instance, &equation.statement);
        let mut blocks: Vec<Block> = self.because(&reason, instance).into_iter().collect();
        if line.shown.is_none() && only_evaluates(step, [&line.left, &line.right]) {
            return blocks;
        }
        let sides = [&line.left, &line.right].map(without_zeros);
        if line.number.is_none() && self.leaves_nothing(&sides) {
            return blocks;
        }
        let symbols = script::stated_with(display, line, &without_zeros);
        match is_together.then(|| self.with_numbers(step, line.relation, &sides)).flatten() {
            Some(numbers) => {
                blocks.push(Block::Equation { lines: vec![symbols], number: None });
                blocks.push(Block::Equation { lines: vec![numbers], number: line.number });
            }
            None => blocks.push(Block::Equation { lines: vec![symbols], number: line.number }),
        }
        if let (Statement::Equal { left, right }, None) = (&equation.statement, &line.shown) {
            let sides = [left, right].map(Clone::clone);
            blocks.extend(sides.iter().any(has_pieces).then(|| self.in_symbols.piece(&sides)).into_iter().flatten());
        }
        blocks
    }

    /// The reason of a law: none where it is that of the law before, the law's name alone where the reason was given earlier or another law
    /// just followed from the same cause, and that it is the same where it differs from the last by those whom it names.
    fn because(&mut self, reason: &str, instance: &Instance) -> Option<Block> {
        let scene = &self.display.worked.problem.loaded().draft.scene;
        let unnamed = scene.bodies.keys().fold(reason.to_owned(), |text, body| {
            let name = scene.called(body);
            text.replace(&capitalised(&name), "_").replace(&name, "_")
        });
        let unnamed = AXES.iter().fold(unnamed, |text, axis| text.replace(&format!(" along {axis}"), " along _"));
        let is_like_the_last = unnamed == self.reason;
        let is_new = self.reasons.insert(reason.to_owned());
        self.reason = unnamed;
        let cause = match &instance.because {
            Because::Fact(fact) => Some(fact.clone()),
            Because::Definition | Because::Conclusion(..) => None,
        };
        let follows_again = cause.is_some() && cause == self.cause;
        self.cause = cause;
        match (is_like_the_last, is_new && !follows_again) {
            (true, true) => Some(Block::text("In the same way:")),
            (true, false) => None,
            (false, true) => Some(Block::text(reason)),
            (false, false) if instance.law.id == geometry::RELATION.id => Some(Block::text(reason)),
            (false, false) => Some(Block::text(&format!("By {}:", instance.law.name))),
        }
    }

    /// Whether an equation says of one quantity that a multiple of it is zero, as its value does at once.
    fn leaves_nothing(&self, sides: &[Expr; 2]) -> bool {
        let symbols: BTreeSet<Symbol> = sides.iter().flat_map(Expr::symbols).collect();
        sides.iter().any(Expr::is_zero)
            && symbols.len() == 1
            && symbols.iter().all(|symbol| self.display.is_nothing(*symbol))
    }

    /// A law with numbers for what is known; nothing where that is too little to be worth a line.
    fn with_numbers(&self, step: &Step, relation: Operator, sides: &[Expr; 2]) -> Option<Math> {
        let symbols: BTreeSet<Symbol> = sides.iter().flat_map(Expr::symbols).collect();
        let known = symbols.iter().filter(|symbol| !step.unknowns.contains(symbol)).count();
        let [left, right] = sides.each_ref().map(|side| self.display.with_known_numbers(side, &step.unknowns));
        (known >= FEWEST_NUMBERS).then(|| Math::relation(left, relation, right))
    }

    fn law(&self, place: usize) -> Option<(&'a Equation, &'a Instance)> {
        let worked = self.display.worked;
        let equation = worked.leaf().system.equations.get(place)?;
        Some((equation, worked.problem.model().instances.get(equation.tag)?))
    }

    /// Whether several equations that are linear in the unknowns are solved together.
    fn is_linear_system(&self, step: &Step) -> bool {
        let is_linear = |place: &usize| match self.law(*place).map(|(equation, _)| &equation.statement) {
            Some(Statement::Equal { left, right }) => {
                let difference = (left.clone() - right.clone()).simplify();
                !has_pieces(&difference) && difference.linear_coefficients(&step.unknowns).is_some()
            }
            _ => false,
        };
        step.equations.len() > 1 && step.roots.len() == 1 && step.equations.iter().all(is_linear)
    }

    /// The values of several unknowns, as many on a row as fit; those that are alike together.
    fn results(&self, unknowns: impl Iterator<Item = Symbol>) -> Block {
        let display = self.display;
        let mut rows: Vec<(f64, Vec<Math>)> = Vec::new();
        let mut alike: Vec<(Math, Vec<Math>)> = Vec::new();
        for unknown in unknowns {
            let (name, value) = (display.name(unknown), display.quantity(unknown));
            match alike.iter_mut().find(|(other, _)| *other == value) {
                Some((_, names)) => names.push(name),
                None => alike.push((value, vec![name])),
            }
        }
        for (value, names) in alike {
            let value = Math::chain(names.into_iter().chain([value]), Operator::Equals);
            let width = value.width();
            match rows.last_mut() {
                Some((total, row)) if *total + width <= WIDEST_ROW => {
                    row.extend([Math::Text(",\u{2003}".to_owned()), value]);
                    *total += width;
                }
                _ => rows.push((width, vec![value])),
            }
        }
        Block::Equation { lines: rows.into_iter().map(|(_, row)| Math::Row(row)).collect(), number: None }
    }

    /// A quadratic equation with its numbers, and both roots.
    fn quadratic(from: Option<String>, equations: &[Math; 2]) -> Vec<Block> {
        let is = match from {
            Some(from) => format!("{from}, a quadratic equation:"),
            None => "With numbers, a quadratic equation:".to_owned(),
        };
        let mut blocks = vec![Block::text(&is)];
        blocks.extend(equations.iter().map(|line| Block::Equation { lines: vec![line.clone()], number: None }));
        blocks
    }

    /// The value of an unknown, and what must be said with it.
    fn result(
        &mut self,
        blocks: &mut Vec<Block>,
        (step, script): (&Step, &Script),
        root: (Symbol, &Closed),
        formula: &Formula,
    ) {
        let (unknown, closed) = root;
        let trials = counting::trials(self.display, unknown, closed);
        if !trials.is_empty() {
            blocks.extend(trials);
            return;
        }
        let varying;
        let formula = match formula {
            _ if let Some(term) = as_on_paper(self.display, step, script, unknown, formula) => {
                varying = Some(term);
                varying.as_ref()
            }
            Formula::Fixed(formula) => formula.as_deref(),
            Formula::Varies => {
                varying = self.in_symbols.formula(step, unknown, closed);
                varying.as_ref()
            }
        };
        if formula.is_none() {
            blocks.push(bracket::found(self.display, &script.derivation, unknown));
        }
        let is_law = |line: &Line| matches!(line.origin, Origin::Law(_)) && line.shown.is_none();
        let lines = script.derivation.lines.iter();
        let states_law = lines.filter(|line| is_law(line)).any(|line| only_evaluates(step, [&line.left, &line.right]));
        blocks.push(self.value(unknown, formula, states_law));
        let is_right = formula.is_some_and(|formula| divides_by_zero(&self.display.without_zeros(&formula.expr)));
        blocks.extend(self.in_symbols.afterwards(unknown, formula, if is_right { RIGHT_ANGLE } else { QUADRANT }));
    }

    /// `unknown = numbers = value`, the formula before the numbers where it is the law itself.
    fn value(&self, unknown: Symbol, formula: Option<&Term>, states_law: bool) -> Block {
        let display = self.display;
        let (name, value) = (display.name(unknown), display.quantity(unknown));
        let mut parts = vec![name.clone()];
        if let Some(formula) = formula {
            let (symbols, numbers) = match self.in_symbols.in_what_is_told(unknown) {
                Some(whole) => (Some(display.symbolic(&whole)), Some(display.as_told(&whole))),
                None => {
                    let rest = positive_first(&display.without_zeros(&formula.expr));
                    let symbols = if display.has_zeros(formula) {
                        symbolic_size(display, &rest)
                    } else {
                        formula.symbols.clone()
                    };
                    let is_said = states_law && !rest.is_zero() && !divides_by_zero(&rest);
                    (is_said.then_some(symbols), display.substituted(formula))
                }
            };
            let is_exact = display.is_exact_multiple(unknown) || formula.expr.is_zero();
            let numbers = numbers
                .filter(|numbers| Some(numbers) != symbols.as_ref() && numbers.latex() != value.latex() && !is_exact);
            parts.extend(symbols.filter(|symbols| *symbols != name && *symbols != value));
            parts.extend(numbers);
        }
        parts.push(value);
        Block::Equation { lines: vec![Math::chain(parts, Operator::Equals)], number: None }
    }
}

/// A term in symbols; the root of a square as the size of what is squared.
fn symbolic_size(display: Display<'_>, term: &Expr) -> Math {
    if let Expr::Power(root) = term
        && root.1 == Expr::ratio(1, 2)
        && let Expr::Power(square) = &root.0
        && square.1 == Expr::integer(2)
    {
        return Math::Bars(Arc::new(display.symbolic(&square.0)));
    }
    display.symbolic(term)
}

/// `From (1) and (2)`, where a step solves several equations.
fn from(script: &Script) -> Option<String> {
    let laws = script.derivation.lines.iter().filter(|line| matches!(line.origin, Origin::Law(_)));
    let numbers: Vec<String> = laws.filter_map(|line| Some(format!("({})", line.number?))).collect();
    (numbers.len() > 1).then(|| format!("From {}", list(&numbers)))
}
