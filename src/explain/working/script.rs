//! Steps of a plan as they are whatever the numbers are: laws and reasons, equations in symbols, moves of algebra.

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_laws::Law;
use momentous_laws::geometry;
use momentous_laws::kinematics;
use momentous_laws::motion;
use momentous_model::Because;
use momentous_model::Instance;
use momentous_model::Integral;
use momentous_model::Series;
use momentous_model::Shown;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_solve::Closed;
use momentous_solve::Move;
use momentous_solve::Root;
use momentous_solve::Statement;
use momentous_solve::Step;

use super::super::Block;
use super::super::Detail;
use super::super::terms::algebra;
use super::super::terms::display::Display;
use super::super::terms::display::has_pieces;
use super::super::terms::substitution::without;
use super::super::terms::term::Term;
use super::super::wording::capitalised;
use super::derivation::Derivation;
use super::derivation::Line;
use super::derivation::Origin;
use super::derivation::Solving;
use super::derivation::Stated;
use super::derivation::is_definition;
use super::needed;
use super::sentence;

/// One step, as far as no number changes it.
#[derive(Debug)]
pub(crate) struct Script {
    /// Whether what it finds stands with the givens, where the reader has it from: a given by another name, or what the sheet prints.
    pub is_given: bool,
    /// How its equations are solved.
    pub solving: Solving,
    /// Its equations in symbols.
    pub derivation: Derivation,
    /// Laws, and how their equations are solved.
    pub opening: Vec<Opening>,
    /// For each root what is found.
    pub roots: Vec<Vec<SolvedUnknown>>,
}

impl Script {
    /// The values of the root of that place that are printed, each with how it is found.
    pub(crate) fn printed<'s>(
        &'s self,
        (place, root): (usize, &'s Root),
    ) -> impl Iterator<Item = (Symbol, &'s Closed, &'s SolvedUnknown)> {
        let values = root.values.iter().zip(self.roots.get(place).into_iter().flatten());
        let printed = values.filter(|(_, answer)| answer.is_printed);
        printed.map(|((unknown, closed), answer)| (*unknown, closed, answer))
    }
}

/// How an unknown is found.
#[derive(Debug)]
pub(crate) struct SolvedUnknown {
    /// From which equations, and what must not be zero for that.
    pub words: Option<Block>,
    /// The formula that it equals.
    pub formula: Formula,
    /// Whether it is printed: in a short solution, where it is asked or something printed follows from it.
    pub is_printed: bool,
}

/// The formula of an unknown.
#[derive(Debug)]
pub(crate) enum Formula {
    /// The same in every solution; nothing where no formula gives it.
    Fixed(Option<Box<Term>>),
    /// It hangs on the numbers.
    Varies,
}

/// A part of what stands before the results of a step.
#[derive(Debug)]
pub(crate) enum Opening {
    /// A law: why it applies here, and its equation, unless what is found says it at once.
    Law { reason: Block, equation: Option<Block> },
    /// It is the same in every solution.
    Written(Block),
    /// The sides of an equation that is stated piece by piece, in the piece that holds here.
    Piece([Expr; 2]),
    /// A move whose words hang on the numbers; its place in the step.
    Move(usize),
}

/// The scripts of the steps of the answer plan.
pub(crate) fn scripts(display: Display<'_>, detail: Detail) -> Vec<Script> {
    let (mut next, mut stated) = (1, Stated::new());
    let zeros = match detail {
        Detail::Short => display.worked.zeros().filter(|symbol| display.is_nothing(*symbol)).collect(),
        Detail::Full => BTreeSet::new(),
    };
    let writer = Writer { display, detail, zeros };
    let later = needed::later(display.worked);
    let steps = display.worked.leaf().answer_steps().iter().zip(&later);
    let write = |(step, later)| {
        let script = writer.script(step, &mut next, &stated, later);
        if !script.is_given {
            stated.extend(script.derivation.stated());
        }
        script
    };
    steps.map(write).collect()
}

struct Writer<'a> {
    display: Display<'a>,
    detail: Detail,
    /// What is given as zero and is left out of terms in symbols.
    zeros: BTreeSet<Symbol>,
}

impl Writer<'_> {
    /// The script of a step after others that have stated equations; its first equation that is referred to has the number `next`.
    fn script(&self, step: &Step, next: &mut u32, before: &Stated, later: &BTreeSet<Symbol>) -> Script {
        let solving = self.solving(step);
        let mut derivation = Derivation::of(self.display, step, before, solving);
        derivation.number(next);
        let is_given = renamed(self.display, step).is_some() || printed(self.display, step).is_some();
        let mut opening = Vec::new();
        for line in &derivation.lines {
            match line.origin {
                Origin::Law(equation) => opening.extend(self.law(step, equation, line)),
                // A root is taken of what stands above.
                Origin::Collect { .. } if self.is_plain_square(step) => {}
                _ => opening
                    .extend(written(sentence::blocks(self.display, &derivation, line, &|term| self.plain(step, term)))),
            }
        }
        for (place, step_move) in step.moves.iter().enumerate() {
            match step_move {
                // Without what is zero, the line of the derivation says it already.
                Move::Quadratic { unknown, .. } if self.detail == Detail::Short && self.display.is_free(*unknown) => {}
                Move::Quadratic { .. } => opening.push(Opening::Move(place)),
                Move::Numeric { unknown }
                    if is_stated_piecewise(self.display, step)
                        || formula_of_equation(self.display, step, *unknown).is_none() =>
                {
                    opening.push(Opening::Move(place));
                }
                _ => {}
            }
        }
        let printed_answer = |((unknown, closed), is_printed): (&(Symbol, Closed), bool)| {
            let solved = self.solved(step, &derivation, *unknown, closed);
            let is_repeated = self.is_repeated(step, &derivation, *unknown, &solved);
            let is_new = solving == Solving::InSymbols && !is_repeated;
            let adds = !(is_repeated && self.display.is_free(*unknown));
            SolvedUnknown { is_printed: is_new || is_printed && adds, ..solved }
        };
        let printed = |root: &Root| needed::printed(root, later);
        let roots =
            step.roots.iter().map(|root| root.values.iter().zip(printed(root)).map(printed_answer).collect()).collect();
        Script { is_given, solving, derivation, opening, roots }
    }

    /// A short solution computes with numbers unless a formula is asked or letters stay open.
    fn solving(&self, step: &Step) -> Solving {
        let is_formula = |part: &Part| matches!(part.kind, PartKind::Formula(_));
        let asks_formula = self.display.worked.form.parts.iter().any(is_formula);
        let has_numbers = || step.unknowns.iter().all(|unknown| self.display.has_number(*unknown));
        if self.detail == Detail::Short && !asks_formula && has_numbers() {
            Solving::InNumbers
        } else {
            Solving::InSymbols
        }
    }

    /// Whether the quadratic equation of a step has a term of first degree that goes with what is given as zero.
    fn is_plain_square(&self, step: &Step) -> bool {
        step.moves.iter().any(|step_move| match step_move {
            Move::Quadratic { b, .. } => !b.is_zero() && self.plain(step, b).is_zero(),
            _ => false,
        })
    }

    /// Whether a short solution just wrote what an unknown equals that is not asked for, to put it into another equation.
    fn is_repeated(&self, step: &Step, derivation: &Derivation, unknown: Symbol, solved: &SolvedUnknown) -> bool {
        let Formula::Fixed(Some(term)) = &solved.formula else { return false };
        let is_asked = needed::asked(self.display.worked).contains(&unknown);
        let lines = derivation.lines.iter().filter(|line| matches!(line.origin, Origin::Solve { .. }));
        let mut written = lines.filter(|line| line.left == Expr::from(unknown));
        self.detail == Detail::Short
            && !is_asked
            && written.any(|line| (self.plain(step, &line.right) - term.expr.clone()).simplify().is_zero())
    }

    /// A term in symbols without what is given as zero.
    fn plain(&self, step: &Step, term: &Expr) -> Expr {
        let has_zeros = term.symbols().iter().any(|symbol| self.zeros.contains(symbol));
        if !has_zeros || self.solving(step) == Solving::InNumbers {
            return term.clone();
        }
        algebra::positive_first(&without(term, &|symbol| self.zeros.contains(&symbol)))
    }

    fn solved(&self, step: &Step, derivation: &Derivation, unknown: Symbol, closed: &Closed) -> SolvedUnknown {
        let formula = self.formula(step, unknown, closed);
        let value = match &formula {
            Formula::Fixed(Some(term)) => Some(&term.expr),
            Formula::Fixed(None) | Formula::Varies => None,
        };
        let words = value.and_then(|value| sentence::before_result(self.display, derivation, unknown, value));
        SolvedUnknown { words, formula, is_printed: true }
    }

    fn formula(&self, step: &Step, unknown: Symbol, closed: &Closed) -> Formula {
        let formula = match closed {
            Closed::Formula(formula) if has_pieces(formula) => return Formula::Varies,
            Closed::Formula(formula) => Some(algebra::positive_first(&self.plain(step, formula))),
            _ if is_stated_piecewise(self.display, step) => return Formula::Varies,
            _ => formula_of_equation(self.display, step, unknown),
        };
        Formula::Fixed(formula.map(|formula| Box::new(self.display.term(formula))))
    }

    /// The law, why it applies here, and its equation in symbols.
    fn law(&self, step: &Step, equation: usize, line: &Line) -> Vec<Opening> {
        let leaf = self.display.worked.leaf();
        let Some(stated) = leaf.system.equations.get(equation) else { return Vec::new() };
        let Some(instance) = self.display.worked.problem.model().instances.get(stated.tag) else { return Vec::new() };
        let reason = Block::text(&reason(self.display, instance, &stated.statement));
        let closes = step.equations.len() == 1;
        if line.shown.is_none() && closes && is_definition(step, &line.left, &line.right) {
            return vec![Opening::Law { reason, equation: None }];
        }
        let lines = vec![stated_with(self.display, line, &|term| self.plain(step, term))];
        let equation = Some(Block::Equation { lines, number: line.number });
        let mut opening = vec![Opening::Law { reason, equation }];
        if let (Statement::Equal { left, right }, None) = (&stated.statement, &line.shown) {
            let sides = [left, right].map(Clone::clone);
            opening.extend(sides.iter().any(has_pieces).then_some(Opening::Piece(sides)));
        }
        opening
    }
}

/// An equation in symbols, with the step that it follows from where that is shown; each term is simplified first.
pub(super) fn stated_with(display: Display<'_>, line: &Line, simplified: &dyn Fn(&Expr) -> Expr) -> Math {
    let symbolic = |term: &Expr| display.symbolic(&simplified(term));
    let [left, right] = [&line.left, &line.right].map(symbolic);
    match &line.shown {
        None => Math::relation(left, line.relation, right),
        Some(Shown::Integral { of: quantity, integral: shown }) => {
            Math::relation(symbolic(quantity), line.relation, integral(display, shown, simplified))
        }
        Some(Shown::Series(shown)) => Math::chain([left, series(shown, &symbolic), right], Operator::Equals),
        Some(Shown::Areas(areas)) => {
            Math::relation(left, Operator::Equals, Math::chain(areas.iter().map(symbolic), Operator::Plus))
        }
        Some(Shown::Balance(sides)) => {
            let [before, after] = sides.each_ref().map(symbolic);
            Math::relation(before, Operator::Equals, after)
        }
    }
}

/// `factor (e + e^2 + ...)`.
fn series(series: &Series, symbolic: &dyn Fn(&Expr) -> Math) -> Math {
    let dots = Math::Text("...".to_owned());
    let terms = series.terms.iter().map(symbolic).chain([dots]).chain(series.last.as_ref().map(symbolic));
    let sum = Math::Bracketed(Arc::new(Math::chain(terms, Operator::Plus)));
    Math::Row(vec![symbolic(&series.factor), Math::Operator(Operator::Juxtapose), sum])
}

/// An integral in symbols.
fn integral(display: Display<'_>, integral: &Integral, simplified: &dyn Fn(&Expr) -> Expr) -> Math {
    let symbolic = |term: &Expr| Arc::new(display.symbolic(&simplified(term)));
    let integrand = symbolic(&integral.integrand);
    let integrand = match &integral.integrand {
        Expr::Sum(_) => Arc::new(Math::Squared(integrand)),
        _ => integrand,
    };
    let variable = Arc::new(display.name(integral.variable));
    Math::Integral(symbolic(&integral.low), symbolic(&integral.high), integrand, variable)
}

fn written(blocks: Vec<Block>) -> impl Iterator<Item = Opening> {
    blocks.into_iter().map(Opening::Written)
}

/// The sides of the only equation of a step.
fn sides<'a>(display: Display<'a>, step: &Step) -> Option<[&'a Expr; 2]> {
    let [equation] = step.equations[..] else { return None };
    match &display.worked.leaf().system.equations.get(equation)?.statement {
        Statement::Equal { left, right } => Some([left, right]),
        Statement::FirstInteger { .. } => None,
    }
}

/// The symbol that the author writes as an expression of other givens and the sheet prints: to its reader, a given like the
/// others.
pub(crate) fn printed(display: Display<'_>, step: &Step) -> Option<Symbol> {
    related(display, step).map(|(unknown, _)| unknown).filter(|unknown| display.worked.form.printed.contains(unknown))
}

/// The other name that a step gives to a quantity: the new name, and the given, perhaps with a minus, or zero.
pub(crate) fn renamed<'a>(display: Display<'a>, step: &'a Step) -> Option<(Symbol, &'a Expr)> {
    let (unknown, formula) = related(display, step)?;
    let given = match formula {
        formula if formula.is_zero() => return Some((unknown, formula)),
        Expr::Symbol(given) => *given,
        Expr::Product(factors) => match &factors[..] {
            [sign, Expr::Symbol(given)] if *sign == Expr::integer(-1) => *given,
            _ => return None,
        },
        _ => return None,
    };
    let is_given = display.worked.variant.all_given().iter().any(|(given_symbol, ..)| *given_symbol == given);
    is_given.then_some((unknown, formula))
}

/// A quantity that a step finds from what the author states alone, a relation or where a motion ends, and its formula.
fn related<'a>(display: Display<'a>, step: &'a Step) -> Option<(Symbol, &'a Expr)> {
    let ([equation], [Root { values }]) = (&step.equations[..], &step.roots[..]) else { return None };
    let [(unknown, Closed::Formula(formula))] = &values[..] else { return None };
    let stated = display.worked.leaf().system.equations.get(*equation)?;
    let instance = display.worked.problem.model().instances.get(stated.tag)?;
    let is_stated = [geometry::RELATION.id, kinematics::UNTIL.id].contains(&instance.law.id);
    is_stated.then_some((*unknown, formula))
}

/// Whether the only equation of a step is stated piece by piece.
fn is_stated_piecewise(display: Display<'_>, step: &Step) -> bool {
    sides(display, step).is_some_and(|sides| sides.into_iter().any(has_pieces))
}

/// The formula of an unknown where its equation, for these numbers, is linear in it.
pub(super) fn formula_of_equation(display: Display<'_>, step: &Step, unknown: Symbol) -> Option<Expr> {
    let [left, right] = sides(display, step)?.map(|side| display.resolved(side));
    let (factors, rest) = (left - right).simplify().linear_coefficients(&[unknown])?;
    let factor = factors.into_iter().next().filter(|factor| !factor.is_zero())?;
    Some((-rest / factor).simplify())
}

/// Laws that only count or add: the reason says all that there is to say, and no book knows a law of that name.
const SAID_BY_ITS_REASON: [&Law; 7] = [
    &geometry::RELATION,
    &geometry::COUNTED,
    &geometry::HEIGHT_IN_BOWL,
    &geometry::BOUNDARY,
    &kinematics::UNTIL,
    &kinematics::CLOCK,
    &motion::ALL_FORCES,
];

/// Why an equation holds, as what stands before it.
pub(super) fn reason(display: Display<'_>, instance: &Instance, statement: &Statement) -> String {
    let law = instance.law.name;
    if let (true, Statement::Equal { left: Expr::Symbol(asked), .. }) =
        (instance.law.id == geometry::ASKED.id, statement)
    {
        return format!("{}:", capitalised(&display.worked.problem.model().symbols.entry(*asked).meaning));
    }
    let because = capitalised(&instance.because.to_string());
    match (statement, &instance.because) {
        (Statement::FirstInteger { .. }, _) => format!("{because}:"),
        (_, Because::Definition) if instance.law.id == geometry::RELATION.id => "The data give:".to_owned(),
        (_, Because::Fact(_)) if SAID_BY_ITS_REASON.iter().any(|law| law.id == instance.law.id) => {
            format!("{because}:")
        }
        (_, Because::Definition) => format!("By {law}:"),
        (_, Because::Fact(_)) => format!("{because}, so by {law}:"),
        // One "so" to a sentence.
        (_, Because::Conclusion(..)) => format!("{because}. By {law}:"),
    }
}
