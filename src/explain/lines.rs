//! The equations of a solution as text, with what each came from: for programs that check a solution or build on it.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_expr::Expr;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::Instance;
use momentous_problem::Worked;
use momentous_solve::Closed;
use momentous_solve::Move;
use momentous_solve::Step;

use super::Detail;
use super::cache::SolutionCache;
use super::computed;
use super::terms::display::Display;
use super::terms::display::PrintedTerms;
use super::terms::display::has_pieces;
use super::working::derivation;
use super::working::derivation::Origin;
use super::working::divisors;
use super::working::quadratic;
use super::working::script::Formula;
use super::working::script::Script;
use super::working::steps::Steps;
use super::working::steps::taken;

/// One equation of a worked solution.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Line {
    /// Its place, counted from 1.
    pub line: usize,
    /// The number beside it, where a sentence of the solution refers to it.
    pub number: Option<u32>,
    /// The left side, as an author would type it.
    pub left: String,
    /// How the sides compare.
    pub relation: &'static str,
    /// The right side; none where no formula gives the left one.
    pub right: Option<String>,
    /// How it came about.
    pub operation: Operation,
    /// The places of the lines that it came from.
    pub from: Vec<usize>,
    /// The factor of a multiplication.
    pub factor: Option<String>,
    /// The divisors, none of which is zero.
    pub not_zero: Vec<String>,
    /// The law that it states, by its id.
    pub law: Option<&'static str>,
    /// The number that it gives, as the solution prints it.
    pub value: Option<String>,
}

/// How an equation of a solution came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Operation {
    /// A law states it.
    Law,
    /// The second line, times the factor, was added to the first.
    Add,
    /// The factor is zero for the values given, and the term of the line that holds it was left out.
    Vanish,
    /// The quantity on the left side of the first line was put into the second.
    Substitute,
    /// Both sides were squared; neither is negative.
    Square,
    /// It was divided by the cosine of the angle, so that the tangent is left.
    Tangent,
    /// It was multiplied by the factor, and all terms were brought to the left side.
    Collect,
    /// The piece that holds for these numbers was taken.
    Piece,
    /// It was solved for the quantity on the left side.
    Solve,
    /// One of the roots of a quadratic equation was taken.
    Quadratic,
    /// Two components were squared and added.
    Magnitude,
    /// One component was divided by the other.
    Angle,
    /// The integral was worked out.
    Integrate,
    /// Whole numbers were tried one after the other.
    Count,
    /// No formula gives it: it was found numerically.
    Numeric,
    /// The values found before were put in.
    Together,
}

/// The equations of the worked solution of a variant, in their order.
#[must_use]
pub fn lines(worked: Worked<'_>) -> Vec<Line> {
    let cache = SolutionCache::of(worked);
    let shown = PrintedTerms::default();
    let way = cache.way(worked);
    let display = Display { worked, manners: &way.manners, shown: &shown };
    shown.figures.get_or_init(|| computed::figures(display, way, Detail::Full));
    let steps = Steps::new(display);
    let mut list = List { display, steps, lines: Vec::new(), laws: BTreeMap::new(), results: Vec::new() };
    let scripts = way.scripts(display, Detail::Full);
    for (position, (step, script)) in worked.leaf().answer_steps().iter().zip(scripts).enumerate() {
        list.step(position, step, script);
    }
    list.lines
}

struct List<'a> {
    display: Display<'a>,
    steps: Steps<'a>,
    lines: Vec<Line>,
    /// The places of the lines that state laws, by the places of their equations in the system.
    laws: BTreeMap<usize, usize>,
    /// The places of the lines that give quantities.
    results: Vec<usize>,
}

impl List<'_> {
    fn step(&mut self, position: usize, step: &Step, script: &Script) {
        if script.is_given {
            return;
        }
        let before = self.lines.len();
        for line in &script.derivation.lines {
            self.derived(before, script, line);
        }
        let mut pieces = Vec::new();
        for (place, line) in script.derivation.lines.iter().enumerate() {
            let is_stated = matches!(line.origin, Origin::Law(_)) && line.relation == Operator::Equals;
            if is_stated && [&line.left, &line.right].into_iter().any(has_pieces) && self.instance(line).is_some() {
                let [left, right] = [&line.left, &line.right].map(|side| self.display.resolved(side));
                pieces.push(self.push(&left, Some(&right), Operation::Piece, vec![before + place + 1]));
            }
        }
        let Some(root) = taken(self.display, position, step) else { return };
        for (unknown, closed, printed) in script.printed(root) {
            let substituted;
            let formula = match &printed.formula {
                Formula::Fixed(term) => term.as_ref().map(|term| &term.expr),
                Formula::Varies => {
                    substituted = self.steps.formula(step, unknown, closed);
                    substituted.as_ref().map(|term| &term.expr)
                }
            };
            let sources = script.derivation.sources.get(&unknown).map(Vec::as_slice).unwrap_or_default();
            let from = if pieces.is_empty() {
                sources.iter().map(|place| before + place + 1).collect()
            } else {
                pieces.clone()
            };
            let (operation, formula, not_zero) = self.found(step, script, root.0, (unknown, closed), formula);
            self.result(unknown, formula.as_ref(), operation, from, &not_zero);
        }
    }

    /// The law that a line states.
    fn instance(&self, line: &derivation::Line) -> Option<&Instance> {
        let Origin::Law(equation) = line.origin else { return None };
        let stated = self.display.worked.leaf().system.equations.get(equation)?;
        self.display.worked.problem.model().instances.get(stated.tag)
    }

    fn derived(&mut self, before: usize, script: &Script, line: &derivation::Line) {
        let (operation, factor) = match &line.origin {
            Origin::Law(_) => (Operation::Law, None),
            Origin::Add { factor, .. } => (Operation::Add, Some(factor)),
            Origin::Vanish { zero, .. } => (Operation::Vanish, Some(zero)),
            Origin::Put { .. } => (Operation::Substitute, None),
            Origin::Integrate { .. } => (Operation::Integrate, None),
            Origin::Square(_) => (Operation::Square, None),
            Origin::Tangent(_) => (Operation::Tangent, None),
            Origin::Collect { factor, .. } => (Operation::Collect, Some(factor)),
            Origin::Component(_) | Origin::Solve { .. } => (Operation::Solve, None),
        };
        let not_zero = match &line.origin {
            Origin::Solve { of, unknown } => {
                let source: Vec<_> = script.derivation.lines.get(*of).into_iter().collect();
                divisors::of_solution(&source, *unknown, &line.right)
            }
            Origin::Component(_) | Origin::Tangent(_) => divisors::of_term(&line.right),
            _ => factor.map(divisors::of_term).unwrap_or_default(),
        };
        let sources = line.origin.from().into_iter().map(|place| before + place + 1);
        let ends = match &line.origin {
            Origin::Integrate { ends, .. } => Some(ends.keys().filter_map(|place| self.laws.get(place).copied())),
            _ => None,
        };
        let from = sources.chain(ends.into_iter().flatten()).collect();
        let integral = line.integral().map(|integral| {
            let [integrand, low, high] =
                [&integral.integrand, &integral.low, &integral.high].map(|term| self.text(term));
            format!("integral({integrand}, {}, {low}, {high})", self.text(&integral.variable.into()))
        });
        let law = self.instance(line).map(|instance| instance.law.id);
        let (factor, not_zero) = (factor.map(|factor| self.text(factor)), self.texts(&not_zero));
        // The line says what is printed.
        let [left, right] = match &line.shown {
            Some(momentous_model::Shown::Balance(sides)) => sides.clone(),
            Some(momentous_model::Shown::Areas(areas)) => [line.left.clone(), Expr::sum(areas.iter().cloned())],
            Some(momentous_model::Shown::Integral { .. } | momentous_model::Shown::Series(_)) | None => {
                [line.left.clone(), line.right.clone()]
            }
        };
        let place = self.push(&left, Some(&right), operation, from);
        if let Origin::Law(equation) = line.origin {
            self.laws.insert(equation, place);
        }
        let latest = &mut self.lines[place - 1];
        latest.right = integral.or(latest.right.take());
        latest.relation = sign(line.relation);
        (latest.number, latest.factor, latest.not_zero, latest.law) = (line.number, factor, not_zero, law);
    }

    /// How a quantity is found from its sources, the formula as it is taught, and what was divided by.
    fn found(
        &self,
        step: &Step,
        script: &Script,
        root: usize,
        (unknown, closed): (Symbol, &Closed),
        formula: Option<&Expr>,
    ) -> (Operation, Option<Expr>, Vec<Expr>) {
        let sources = script.derivation.sources_of(unknown);
        let Some(formula) = formula else {
            let counted = matches!(closed, Closed::FirstInteger { .. });
            return (if counted { Operation::Count } else { Operation::Numeric }, None, Vec::new());
        };
        let formula = formula.clone();
        if let Some(taught) = quadratic::root(step, unknown, root, &formula) {
            if self.display.is_free(unknown) {
                return (Operation::Together, Some(formula), Vec::new());
            }
            return (Operation::Quadratic, Some(taught.value), divisors::of_coefficient(&taught.leading));
        }
        if let [Move::Polar { magnitude, .. }] = &step.moves[..] {
            let operation = if unknown == *magnitude { Operation::Magnitude } else { Operation::Angle };
            return (operation, Some(formula), Vec::new());
        }
        if sources.iter().any(|line| line.integral().is_some()) {
            return (Operation::Integrate, Some(formula), Vec::new());
        }
        let not_zero = divisors::of_solution(&sources, unknown, &formula);
        (Operation::Solve, Some(formula), not_zero)
    }

    /// The line that gives a quantity: one that is there already, or a new one.
    fn result(
        &mut self,
        unknown: Symbol,
        formula: Option<&Expr>,
        operation: Operation,
        from: Vec<usize>,
        not_zero: &[Expr],
    ) {
        let display = self.display;
        let [left, right] = [Some(self.text(&unknown.into())), formula.map(|formula| self.text(formula))];
        let same = |line: &Line| Some(&line.left) == left.as_ref() && line.right == right;
        let stated = from.first().copied().filter(|place| self.lines.get(place - 1).is_some_and(same));
        let place = stated.unwrap_or_else(|| {
            let place = self.push(&unknown.into(), formula, operation, from);
            let not_zero = self.texts(not_zero);
            self.lines[place - 1].not_zero = not_zero;
            place
        });
        let value = display.has_number(unknown).then(|| typed(&display.quantity(unknown).plain()));
        self.lines[place - 1].value = value;
        self.results.push(place);
        if let Some(whole) = self.steps.whole(unknown, formula) {
            self.push(&unknown.into(), Some(&whole), Operation::Together, self.results.clone());
        }
    }

    fn push(&mut self, left: &Expr, right: Option<&Expr>, operation: Operation, from: Vec<usize>) -> usize {
        let line = self.lines.len() + 1;
        self.lines.push(Line {
            line,
            number: None,
            left: self.text(left),
            relation: sign(Operator::Equals),
            right: right.map(|side| self.text(side)),
            operation,
            from,
            factor: None,
            not_zero: Vec::new(),
            law: None,
            value: None,
        });
        line
    }

    fn text(&self, term: &Expr) -> String {
        let model = self.display.worked.problem.model();
        term.text_with(&|symbol| {
            let name = &model.symbols.entry(symbol).name;
            // A value with its unit, such as 60 deg, is one factor.
            let is_literal = model.literals.iter().any(|(literal, _)| *literal == symbol);
            if is_literal { format!("({name})") } else { name.clone() }
        })
    }

    fn texts(&self, terms: &[Expr]) -> Vec<String> {
        terms.iter().map(|term| self.text(term)).collect()
    }
}

/// A printed quantity as it is typed.
fn typed(printed: &str) -> String {
    printed.replace('\u{2212}', "-").replace('\u{a0}', " ")
}

/// A relation as it is typed.
fn sign(relation: Operator) -> &'static str {
    match relation {
        Operator::Less => "<",
        Operator::AtMost => "<=",
        Operator::Greater => ">",
        Operator::AtLeast => ">=",
        Operator::Differs => "!=",
        _ => "=",
    }
}
