//! The steps of the plan with their numbers: what the script of a way says, and what each variant fills in.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_problem::Dead;
use momentous_problem::FormulaPart;
use momentous_problem::PartKind;
use momentous_solve::Closed;
use momentous_solve::Move;
use momentous_solve::Root;
use momentous_solve::Step;

use super::super::Block;
use super::super::Inline;
use super::super::terms::algebra;
use super::super::terms::display::Display;
use super::super::terms::display::number_math;
use super::super::terms::display::printed;
use super::super::terms::entry::Item;
use super::super::terms::printed;
use super::super::terms::term::Term;
use super::super::wording::join;
use super::bracket;
use super::counting;
use super::quadratic;
use super::script::Formula;
use super::script::Opening;
use super::script::Script;
use super::script::formula_of_equation;

/// The widest root that is written in symbols, in widths of a digit.
const WIDEST_ROOT: f64 = 75.0;

/// The sentence where a formula gives further values that are none.
const NOT_REAL: &str = "No other value is a real number.";

/// How the quadrant of an angle is found.
const QUADRANT: &str = "Choose the quadrant from the signs of the components: if the denominator is negative, add 180° to the \
    calculator's arctangent or subtract 180° from it; if it is zero, the angle is ±90°.";

/// The sentence said once of the lines with numbers.
pub(crate) const WITHOUT_ZEROS: &str = "Terms that are zero are left out of the lines with numbers.";

/// Writes the steps of one plan for a variant.
pub(crate) struct Steps<'a> {
    pub display: Display<'a>,
    /// Whether the angle of a point has been explained.
    pub angle_explained: bool,
    /// Whether it has been said that zeros are left out.
    pub zeros_explained: bool,
    /// The open letters of which it has been said that they drop out.
    pub dropped: BTreeSet<Symbol>,
}

impl<'a> Steps<'a> {
    pub(crate) fn new(display: Display<'a>) -> Self {
        Self { display, angle_explained: false, zeros_explained: false, dropped: BTreeSet::new() }
    }

    /// One step, as blocks.
    pub(crate) fn step(&mut self, position: usize, step: &Step, script: &Script) -> Vec<Block> {
        if script.is_given {
            return Vec::new();
        }
        let mut blocks = Vec::new();
        let mut solved = None;
        for opening in &script.opening {
            match opening {
                Opening::Law { reason, equation, .. } => {
                    blocks.push(reason.clone());
                    blocks.extend(equation.clone());
                }
                Opening::Written(block) => blocks.push(block.clone()),
                Opening::Piece(sides) => blocks.extend(self.piece(sides)),
                Opening::Move(place) => match step.moves.get(*place) {
                    Some(Move::Numeric { unknown }) => {
                        let formula = formula_of_equation(self.display, step, *unknown);
                        let block =
                            formula.is_none().then(|| bracket::found(self.display, &script.derivation, *unknown));
                        blocks.extend(block);
                    }
                    Some(Move::Quadratic { unknown, a, b, c, .. }) => {
                        let shown = quadratic::solution(self.display, *unknown, [a, b, c]);
                        if let Some(shown) = shown {
                            solved = Some(*unknown).filter(|unknown| !self.display.is_free(*unknown));
                            blocks.extend(shown);
                        }
                    }
                    _ => {}
                },
            }
        }
        if let Some(root) = taken(self.display, position, step) {
            for (unknown, closed, answer) in script.printed(root) {
                if solved != Some(unknown) {
                    blocks.extend(answer.words.clone());
                    self.result(&mut blocks, step, (unknown, closed), &answer.formula);
                }
            }
        }
        let dead = self.display.worked.variant.dead().iter().filter(|dead| dead.step == Some(position));
        blocks.extend(self.rejected(step, dead));
        blocks
    }

    /// The piece that holds for these numbers of an equation that is stated piece by piece.
    pub(super) fn piece(&self, sides: &[Expr; 2]) -> Vec<Block> {
        let pieces = sides.each_ref().map(|side| self.display.piece_that_holds(side));
        let Some(condition) = pieces.into_iter().flatten().next() else { return Vec::new() };
        let words = vec![Inline::Text("Here ".into()), Inline::Math(condition), Inline::Text(", so that".into())];
        let [left, right] = sides.each_ref().map(|side| self.display.resolved(side));
        let lines = vec![self.display.equation(&left, &right)];
        vec![Block::Paragraph(words), Block::Equation { lines, number: None }]
    }

    /// The value of an unknown, and what must be said with it.
    fn result(&mut self, blocks: &mut Vec<Block>, step: &Step, root: (Symbol, &Closed), formula: &Formula) {
        let (unknown, closed) = root;
        let trials = counting::trials(self.display, unknown, closed);
        if !trials.is_empty() {
            blocks.extend(trials);
            return;
        }
        let general;
        let formula = match formula {
            Formula::Fixed(formula) => formula.as_deref(),
            Formula::Varies => {
                general = self.formula(step, unknown, closed);
                general.as_ref()
            }
        };
        blocks.push(self.value(unknown, formula));
        blocks.extend(formula.into_iter().flat_map(|formula| self.left_out(unknown, formula)).map(Block::Paragraph));
        blocks.extend(self.put_together(unknown, formula));
        blocks.extend(self.afterwards(unknown, formula, QUADRANT));
    }

    /// The remarks on an angle: that whole turns are taken off, and once how its quadrant is found.
    pub(super) fn afterwards(&mut self, unknown: Symbol, formula: Option<&Term>, quadrant: &str) -> Vec<Block> {
        let mut blocks = Vec::new();
        let is_turned = |value: f64| self.display.worked.whole_turns(unknown, value) != 0.0;
        if self.display.worked.variant.value(unknown).is_some_and(|number| is_turned(number.value)) {
            blocks.push(Block::text("Less a whole turn of 360° this is the same direction."));
        }
        let wants_quadrant = |formula: &Term| formula.has_angle && self.display.is_outside_arctangent(&formula.expr);
        if !self.angle_explained && formula.is_some_and(wants_quadrant) {
            self.angle_explained = true;
            blocks.push(Block::text(quadrant));
        }
        blocks
    }

    /// The remark where zeros or letters drop out for the first time.
    fn left_out(&mut self, unknown: Symbol, formula: &Term) -> Vec<Vec<Inline>> {
        let display = self.display;
        if display.is_free(unknown) || display.is_exact_multiple(unknown) {
            return Vec::new();
        }
        let left = display.letters_of(&unknown.into()).unwrap_or_default();
        let letters = |symbol: &Symbol| display.letters_of(&(*symbol).into()).unwrap_or_default().into_keys();
        let mut dropped: Vec<Symbol> =
            display.without_zeros(&formula.expr).symbols().iter().flat_map(letters).collect();
        dropped.retain(|letter| !left.contains_key(letter) && self.dropped.insert(*letter));
        let mut said = Vec::new();
        if !dropped.is_empty() {
            let verb = if dropped.len() > 1 { " cancel." } else { " cancels." };
            let names = dropped.iter().map(|letter| vec![Inline::Math(display.name(*letter))]).collect();
            said.push([vec![Inline::Text("Here ".into())], join(names), vec![Inline::Text(verb.into())]].concat());
        }
        if display.has_zeros(formula) && !matches!(formula.expr, Expr::Symbol(_)) && !self.zeros_explained {
            self.zeros_explained = true;
            said.push(vec![Inline::Text(WITHOUT_ZEROS.into())]);
        }
        said
    }

    /// The formula of an unknown for these numbers.
    pub(crate) fn formula(&self, step: &Step, unknown: Symbol, closed: &Closed) -> Option<Term> {
        let formula = match closed {
            // The plan's form of a root guards against rounding, which symbols need not.
            Closed::Formula(Expr::Piecewise(_)) if self.display.is_free(unknown) => self.in_givens(unknown),
            Closed::Formula(formula) => Some(algebra::positive_first(&self.display.resolved(formula))),
            _ => formula_of_equation(self.display, step, unknown),
        };
        formula.map(|formula| self.display.term(formula))
    }

    /// The formula that is asked, with the results of the steps before put in.
    fn put_together(&self, unknown: Symbol, formula: Option<&Term>) -> Vec<Block> {
        let Some(whole) = self.whole(unknown, formula.map(|formula| &formula.expr)) else { return Vec::new() };
        if formula.is_some_and(|formula| self.without_zeros(formula) == whole) {
            return Vec::new();
        }
        let mut lines = vec![self.display.equation(&unknown.into(), &whole)];
        let multiple = self.formula_part(unknown).filter(|part| part.in_terms_of.is_some());
        let multiple = multiple.and_then(|part| printed::formula(self.display, part));
        let multiple = multiple.filter(|math| *math != self.display.symbolic(&whole));
        lines.extend(multiple.map(|math| Math::Row(vec![Math::Operator(Operator::Equals), math])));
        vec![Block::text("Substituting the earlier results:"), Block::Equation { lines, number: None }]
    }

    /// The formula of what is asked as one in what is given, where the last step has another.
    pub(crate) fn whole(&self, unknown: Symbol, formula: Option<&Expr>) -> Option<Expr> {
        self.formula_part(unknown)?;
        let whole = self.in_givens(unknown).filter(|whole| formula != Some(whole))?;
        // Then its value is the whole formula.
        let is_printed = !self.display.is_free(unknown) && whole.all_symbols(&|symbol| self.display.is_open(symbol));
        (!is_printed).then_some(whole)
    }

    /// The part that asks for an unknown as a formula.
    fn formula_part(&self, unknown: Symbol) -> Option<&FormulaPart> {
        self.display.worked.form.parts.iter().find_map(|part| match &part.kind {
            PartKind::Formula(part) if part.symbol == unknown => Some(part),
            _ => None,
        })
    }

    fn in_givens(&self, unknown: Symbol) -> Option<Expr> {
        let worked = self.display.worked;
        let whole = worked.in_givens(unknown, &worked.alphabet().values)?;
        Some(algebra::positive_first(&whole))
    }

    /// `unknown = formula = numbers = value`.
    fn value(&self, unknown: Symbol, formula: Option<&Term>) -> Block {
        let name = self.display.name(unknown);
        let equation = |lines| Block::Equation { lines, number: None };
        let value = || self.display.quantity(unknown);
        let Some(formula) = formula else { return equation(vec![Math::relation(name, Operator::Equals, value())]) };
        // The speed on a line is written as what it is: |v| = |-5 m/s|.
        if name == formula.symbols && !self.display.is_free(unknown) {
            let numbers = self.display.substituted(formula).into_iter().chain([value()]);
            return equation(vec![Math::chain([name].into_iter().chain(numbers), Operator::Equals)]);
        }
        let mut lines = vec![Math::relation(name, Operator::Equals, formula.symbols.clone())];
        let also = |math| Math::Row(vec![Math::Operator(Operator::Equals), math]);
        if self.display.is_free(unknown) {
            let rest = self.without_zeros(formula);
            lines.extend((rest != formula.expr).then(|| also(self.display.symbolic(&rest))));
        }
        if self.display.is_free(unknown) || formula.expr.is_zero() {
            return equation(lines);
        }
        let (mut numbers, value) = (self.display.substituted(formula), value());
        if let Some(whole) = self.in_what_is_told(unknown) {
            lines.push(Math::Row(vec![Math::Operator(Operator::Equals), self.display.symbolic(&whole)]));
            numbers = Some(self.display.as_told(&whole));
        }
        let is_exact = self.display.is_exact_multiple(unknown);
        let numbers =
            numbers.filter(|numbers| *numbers != formula.symbols && numbers.latex() != value.latex() && !is_exact);
        match numbers {
            // The equation from which it comes stands just above, with the same symbols.
            Some(numbers) if is_too_wide(&formula.symbols) => {
                lines = vec![Math::relation(self.display.name(unknown), Operator::Equals, numbers)];
            }
            numbers => lines.extend(numbers.map(also)),
        }
        if lines.len() > 1 || formula.symbols != value {
            lines.push(also(value));
        }
        equation(lines)
    }

    fn without_zeros(&self, formula: &Term) -> Expr {
        algebra::positive_first(&self.display.without_zeros(&formula.expr))
    }

    /// The formula in the givens of what does not come out of the rounded results before.
    pub(super) fn in_what_is_told(&self, unknown: Symbol) -> Option<Expr> {
        let figures = self.display.shown.figures.get().filter(|figures| figures.from_givens.contains(&unknown));
        figures.and_then(|_| self.display.in_what_is_told(unknown))
    }

    /// The roots that are not solutions, each with its reason.
    pub(super) fn rejected<'d>(&self, step: &Step, dead: impl Iterator<Item = &'d Dead>) -> Vec<Block> {
        let worked = self.display.worked;
        let mut blocks = Vec::new();
        for dead in dead {
            if !dead.values.iter().all(|value| value.for_print().is_finite()) {
                let block = Block::text(NOT_REAL);
                if !blocks.contains(&block) {
                    blocks.push(block);
                }
                continue;
            }
            let reason = worked.why_dead(dead);
            let values: Vec<Vec<Inline>> = step
                .unknowns
                .iter()
                .zip(&dead.values)
                .map(|(unknown, value)| {
                    let unit = &self.display.manner(*unknown).measured;
                    let shown = value.for_print() / self.display.size(unit);
                    let number = printed(shown, self.display.figures(Item::OtherRoot(*unknown), shown));
                    let number = unit.put(number_math(number));
                    vec![Inline::Math(Math::relation(self.display.name(*unknown), Operator::Equals, number))]
                })
                .collect();
            let in_symbols = step.unknowns.iter().any(|unknown| self.display.is_free(*unknown));
            if in_symbols {
                blocks.push(Block::text(&format!("The other root is not the answer: {reason}.")));
                continue;
            }
            let mut words = vec![Inline::Text("The other root, ".into())];
            words.extend(join(values));
            words.push(Inline::Text(format!(", is not the answer: {reason}.")));
            blocks.push(Block::Paragraph(words));
        }
        blocks
    }
}

/// Whether no page holds a formula: a root cannot be broken.
fn is_too_wide(formula: &Math) -> bool {
    matches!(formula, Math::Root(_)) && formula.width() > WIDEST_ROOT
}

/// The root of a step that was taken, and its place.
pub(crate) fn taken<'s>(display: Display<'_>, position: usize, step: &'s Step) -> Option<(usize, &'s Root)> {
    let choice = display.worked.variant.roots().get(position).copied().unwrap_or(0);
    step.roots.get(choice).map(|root| (choice, root)).or_else(|| step.roots.first().map(|root| (0, root)))
}
