//! The next step, taken from the steps of the solution: a law that no line holds yet, or how an answer is worked out.

use std::collections::BTreeSet;

use momentous_expr::{Expr, Leaf, LeafKind, Math, Operator, Symbol};
use momentous_model::Because;
use momentous_problem::PartKind;
use momentous_quantity::round_to_figures;
use momentous_solve::Statement;

use super::ground::StatedEquation;
use super::judge::Judge;
use super::printing::{plain_number, with_single_brackets};
use super::report::NextStep;
use super::verdict::list;

/// A step tells of no more equations.
const MOST_EQUATIONS: usize = 4;
/// Values are the same within this share.
const SAME: f64 = 1e-12;

impl Judge<'_> {
    /// The step in which a law is used.
    pub(crate) fn step_of_law(&self, position: usize) -> NextStep {
        let model = self.worked.problem.model();
        let stated = &self.ground.equations[position];
        let instance = &model.instances[stated.tag];
        let scene = &self.worked.problem.loaded().draft.scene;
        let during = instance.stage.map_or_else(String::new, |stage| format!(" for {}", model.phrase(scene, stage)));
        let because = match &instance.because {
            Because::Definition => String::new(),
            reason => format!(": {reason}"),
        };
        let equation = self.equation(stated);
        let text = |numbers: bool| {
            equation.as_ref().map_or_else(String::new, |[left, right]| {
                format!("{} = {}", self.text(left, numbers), self.text(right, numbers))
            })
        };
        NextStep {
            principle: format!("Use {}{during}{because}.{}", instance.law.name, self.counted_as(stated)),
            equation: text(false),
            numbers: text(true),
            math: equation.as_ref().map(|[left, right]| self.math([left, right])),
        }
    }

    /// The step in which an answer is worked out.
    pub(crate) fn step_of_answer(&self, wanted: Symbol) -> NextStep {
        let name = self.worked.problem.name_of(wanted);
        let numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        let number = numbers.into_iter().find(|number| number.symbol == wanted);
        let value = number.and_then(|number| {
            let value = round_to_figures(self.worked.answer(number).for_print(), number.figures)?;
            let value = if self.turned.contains(&wanted) { -value } else { value };
            Some(
                format!("{name} = {} {}", plain_number(&value), self.worked.problem.unit_name(number))
                    .trim_end()
                    .to_owned(),
            )
        });
        let formula = self.worked.form.parts.iter().find_map(|part| match &part.kind {
            PartKind::Formula(formula) if formula.symbol == wanted => self.worked.formula(formula),
            _ => None,
        });
        let value = value.or_else(|| {
            let [_, formula] = self.as_counted([&wanted.into(), &formula?]);
            Some(format!("{name} = {}", self.text(&formula, false)))
        });
        let (equations, laws) = self.behind(wanted);
        let with = if laws.is_empty() { String::new() } else { format!(", with {}", list(&laws)) };
        let text = |[left, right]: &[Expr; 2]| format!("{} = {}", self.text(left, false), self.text(right, false));
        NextStep {
            principle: format!("Solve the equations for {name}{with}."),
            equation: equations.iter().map(text).collect::<Vec<_>>().join("; "),
            numbers: value.into_iter().collect(),
            math: match equations.as_slice() {
                [[left, right]] => Some(self.math([left, right])),
                _ => None,
            },
        }
    }

    /// The equations of the solution from which an answer comes and that are no steps of their own, with the names of their laws; where
    /// there are none, the equations of the step that gives it.
    fn behind(&self, wanted: Symbol) -> (Vec<[Expr; 2]>, Vec<&'static str>) {
        let steps = self.worked.leaf().answer_steps();
        let given = self.answers_given();
        let stated = |place: &usize| self.ground.equations.iter().find(|stated| stated.place == *place);
        let (mut open, mut taken) = (vec![wanted], BTreeSet::new());
        while let Some(symbol) = open.pop() {
            let Some(at) = steps.iter().position(|step| step.unknowns.contains(&symbol)) else { continue };
            if taken.insert(at) {
                let symbols =
                    steps[at].equations.iter().filter_map(stated).flat_map(|stated| stated.residual.symbols());
                open.extend(symbols.filter(|symbol| !self.ground.told.contains(symbol) && !given.contains(symbol)));
            }
        }
        let all: Vec<&StatedEquation> = taken.iter().flat_map(|at| &steps[*at].equations).filter_map(stated).collect();
        let mut naming: Vec<&StatedEquation> = all.into_iter().filter(|stated| stated.is_naming).collect();
        let naming = naming.split_off(naming.len().saturating_sub(MOST_EQUATIONS));
        let model = self.worked.problem.model();
        let mut laws: Vec<&'static str> = Vec::new();
        for name in naming.iter().filter_map(|stated| Some(model.instances.get(stated.tag)?.law.name)) {
            if !laws.contains(&name) {
                laws.push(name);
            }
        }
        let last = || steps.iter().filter(|step| step.unknowns.contains(&wanted)).flat_map(|step| &step.equations);
        let shown = if naming.is_empty() { last().filter_map(stated).collect() } else { naming };
        (shown.into_iter().filter_map(|stated| self.equation(stated)).collect(), laws)
    }

    /// The sides of an equation as the student counts.
    fn equation(&self, stated: &StatedEquation) -> Option<[Expr; 2]> {
        match self.ground.system.equations.get(stated.place).map(|equation| &equation.statement) {
            Some(Statement::Equal { left, right }) => Some(self.as_counted([left, right])),
            _ => None,
        }
    }

    /// Which direction counts as positive, where it matters and no line has been written yet.
    fn counted_as(&self, stated: &StatedEquation) -> String {
        if !self.accepted.is_empty() || !self.turned.is_empty() {
            return String::new();
        }
        let place = self.ground.place(&self.base);
        let is_against = |symbol: &Symbol| place.value(*symbol).is_some_and(|value| value.value < 0.0);
        let senses = stated.residual.symbols().into_iter().filter(is_against).find_map(|symbol| self.senses(symbol));
        senses.map_or_else(String::new, |[positive, _]| format!(" Positive is {positive}."))
    }

    /// The number of the sheet for a quantity: its own, or that of a given whose value it has in every variant, or its opposite.
    fn printed_value(&self, symbol: Symbol) -> Option<(momentous_quantity::Decimal, momentous_quantity::Unit)> {
        let is_printed = |symbol: &Symbol| self.worked.form.printed.contains(symbol);
        if let Some(given) = self.worked.variant.given(symbol).filter(|_| is_printed(&symbol)) {
            return Some(given);
        }
        // What a law gives is still to be found.
        let steps = self.worked.leaf().answer_steps();
        let step = steps.iter().find(|step| step.unknowns.contains(&symbol))?;
        let is_naming =
            |place: &usize| self.ground.equations.iter().any(|stated| stated.place == *place && stated.is_naming);
        if !step.equations.iter().all(is_naming) {
            return None;
        }
        let dimension = |symbol: Symbol| self.worked.problem.model().symbols.entry(symbol).dimension;
        let places = || self.ground.places().chain([self.ground.place(&self.base)]);
        let told = self.ground.told.iter().copied().filter(is_printed);
        let is_same = |other: &Symbol, sign: f64| {
            let value =
                |place: super::ground::Place<'_>, symbol| place.value(symbol).map_or(f64::NAN, |number| number.value);
            places().all(|place| {
                let (one, other) = (value(place, symbol), sign * value(place, *other));
                one != 0.0 && (one - other).abs() <= SAME * other.abs()
            })
        };
        told.filter(|other| dimension(*other) == dimension(symbol)).find_map(|other| {
            let sign = [1.0, -1.0].into_iter().find(|sign| is_same(&other, *sign))?;
            let (value, unit) = self.worked.variant.given(other)?;
            Some((if sign < 0.0 { -value } else { value }, unit))
        })
    }

    /// An equation as mathematics in the letters of the sheet.
    fn math(&self, sides: [&Expr; 2]) -> Math {
        let problem = self.worked.problem;
        let letter = |symbol: Symbol| Leaf { math: problem.math_of(symbol), kind: LeafKind::Name };
        let [left, right] = sides.map(|side| self.resolved(side).layout(&letter));
        Math::relation(left, Operator::Equals, right)
    }

    /// The sides of an equation with each quantity as the student counts it, and both with the other sign where fewer signs stand in them then.
    fn as_counted(&self, sides: [&Expr; 2]) -> [Expr; 2] {
        let turn = |symbol: Symbol| self.turned.contains(&symbol).then(|| -Expr::from(symbol));
        let turned = sides.map(|side| side.substitute(&turn));
        let opposite = [&turned[0], &turned[1]].map(|side| match side {
            Expr::Sum(terms) => Expr::sum(terms.iter().map(|term| -term.clone())),
            other => -other.clone(),
        });
        let signs =
            |sides: &[Expr; 2]| -> usize { sides.iter().map(|side| self.text(side, false).matches('-').count()).sum() };
        if !self.turned.is_empty() && signs(&opposite) < signs(&turned) { opposite } else { turned }
    }

    /// A term as a student would type it, with the values of what is given or without: those that the sheet prints.
    pub(crate) fn text(&self, term: &Expr, numbers: bool) -> String {
        let problem = self.worked.problem;
        let text = self.resolved(term).text_with(&|symbol| {
            let entry = problem.model().symbols.entry(symbol);
            let given = numbers.then(|| self.printed_value(symbol)).flatten();
            let given =
                given.map(|(value, unit)| if self.turned.contains(&symbol) { (-value, unit) } else { (value, unit) });
            match given {
                Some((value, unit)) if unit.is_none() => format!("({})", plain_number(&value)),
                Some((value, unit)) => format!("({} {unit})", plain_number(&value)),
                None if problem.model().literals.iter().any(|(literal, _)| *literal == symbol) => {
                    format!("({})", entry.name)
                }
                None => entry.name.clone(),
            }
        });
        with_single_brackets(&text)
    }

    /// A term with each quantity that is given piece by piece as the piece that holds.
    fn resolved(&self, term: &Expr) -> Expr {
        let Expr::Piecewise(piecewise) = term else { return term.map_children(|part| self.resolved(part)) };
        let place = self.ground.place(&self.base);
        let value = |symbol: Symbol| place.value(symbol).map_or(f64::NAN, |number| number.value);
        let at = piecewise.variable.evaluate(&value);
        let holds = |until: &Option<Expr>| until.as_ref().is_none_or(|until| at <= until.evaluate(&value));
        let piece = piecewise.pieces.iter().find(|(until, _)| holds(until));
        piece.map_or_else(|| term.clone(), |(_, piece)| self.resolved(piece))
    }
}
