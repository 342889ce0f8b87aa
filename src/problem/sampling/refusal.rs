//! Why numbers are refused: they have no solution, or several, or one in which what is asked has no meaning.

use momentous_expr::Symbol;
use momentous_model::Reason;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_solve::Bounded;
use momentous_solve::Cause;
use momentous_solve::Step;

use super::super::compiling::regimes::Dead;
use super::super::questions::choices::choice::ChoicePart;
use super::super::questions::part::AskedUnit;
use super::super::questions::part::Part;
use super::super::questions::part::PartKind;
use super::no_variant::Rejection;
use super::sampler::Sampler;
use super::variant::Worked;

/// A bound between two solutions is written with no more decimals than this.
const MOST_DECIMALS: usize = 9;

impl Sampler<'_> {
    /// Why the numbers solved last have no admissible solution.
    pub(super) fn why(&self) -> Option<Rejection> {
        let several = self.scratch.survivors(&self.form.solver);
        if let Some(rival) = &self.rival {
            let [taken, other] = rival.words.clone();
            return Some(Rejection::GoesOtherwise { taken, other });
        }
        if self.form.accepts(several) {
            if let Some(refused) = self.refused() {
                return Some(refused);
            }
            if let Some(part) = self.ill_chosen() {
                return Some(Rejection::IllChosen(part.to_owned()));
            }
        } else if several > 1 {
            return Some(Rejection::Several(several));
        }
        let asked = (&self.scratch, &self.form.solver);
        let (scratch, regimes) = match (&self.form.forward, &self.form.weighed) {
            (_, Some(weighed)) if several == 1 => (&self.weighing, weighed),
            (Some(forward), _) if asked.0.dead(asked.1).is_empty() => (&self.forward, forward),
            _ => asked,
        };
        let model = self.problem.model();
        let tells_ways = |position: &usize| {
            let conditions = &regimes.leaf(*position).system.conditions;
            scratch.dead_of(regimes, *position).into_iter().any(|dead| {
                let Cause::Condition(index) = dead.cause else { return false };
                conditions
                    .get(index)
                    .and_then(|condition| model.reasons.get(condition.tag))
                    .is_some_and(Reason::tells_ways)
            })
        };
        // A way that the values do not lead to says nothing of why the one to which they lead has no solution.
        let taken = if several == 0 { (0..regimes.leaves().len()).find(|index| !tells_ways(index)) } else { None };
        let position = taken.unwrap_or_else(|| scratch.leaf());
        let (dead, leaf) = (scratch.dead_of(regimes, position), regimes.leaf(position));
        // What was followed furthest was nearest to a solution; of two, the one that the author asks for.
        let is_other = |dead: &Dead| {
            let Cause::Condition(position) = dead.cause else { return false };
            let condition = leaf.system.conditions.get(position);
            let reason = condition.and_then(|condition| model.reasons.get(condition.tag));
            matches!(reason, Some(Reason::OtherSolutionAsked))
        };
        let is_negative = |dead: &Dead| matches!(dead.cause, Cause::NotPositive);
        let nearness = |dead: &&Dead| (dead.step.unwrap_or(usize::MAX), !is_other(dead), !is_negative(dead));
        let furthest = dead.iter().rev().max_by_key(nearness);
        let lost = furthest.and_then(|dead| {
            let step = leaf.audit.plan.steps.get(dead.step?).filter(|_| matches!(dead.cause, Cause::NotReal))?;
            step.unknowns.iter().copied().find(|unknown| self.directions.contains(unknown))
        });
        if let Some(direction) = lost {
            return Some(self.no_direction(direction));
        }
        let step = furthest.and_then(|dead| leaf.audit.plan.steps.get(dead.step?));
        let reason = match furthest?.cause {
            Cause::Condition(position) => {
                let condition = leaf.system.conditions.get(position)?;
                self.broken(model.reasons.get(condition.tag)?.clone(), model.stage_of_condition(condition.tag))
            }
            Cause::Equation(position) => {
                let equation = leaf.system.equations.get(position)?;
                let names =
                    equation.symbols().into_iter().map(|symbol| format!("`{}`", model.symbols.entry(symbol).name));
                let law = model.instances.get(equation.tag)?.law.name;
                Rejection::Contradiction { law, names: names.collect::<Vec<_>>().join(", ") }
            }
            Cause::RuledOut(position) => self.broken(model.passages.get(position)?.reason.clone(), None),
            Cause::NotReal => Rejection::NotReal(self.named(step, |_| true)),
            Cause::NotPositive => {
                Rejection::NotPositive(self.named(step, |symbol| leaf.system.positive.contains(&symbol)))
            }
        };
        let range = self.form.parts.iter().find_map(|part| match &part.kind {
            PartKind::Range(range) => Some(range.number.symbol),
            _ => None,
        });
        Some(match range {
            Some(symbol) => {
                Rejection::Boundary { name: model.symbols.entry(symbol).name.clone(), reason: Box::new(reason) }
            }
            None => reason,
        })
    }

    /// The quantities for which a solution was sought when it was given up, as they are written.
    fn named(&self, step: Option<&Step>, is_meant: impl Fn(Symbol) -> bool) -> Vec<String> {
        let unknowns = step.into_iter().flat_map(|step| step.unknowns.iter().copied());
        let name = |symbol: Symbol| format!("`{}`", self.problem.model().symbols.entry(symbol).name);
        unknowns.filter(|symbol| is_meant(*symbol)).map(name).collect()
    }

    /// A condition of the first number that is asked that one of two solutions breaks; none where both have it alike.
    pub(crate) fn between_solutions(&self) -> Option<String> {
        let variant = self.keep(None);
        let worked = Worked { problem: self.problem, form: self.form, variant: &variant };
        let numbers = self.form.parts.iter().flat_map(|part| part.kind.numbers());
        numbers.into_iter().find_map(|number| {
            let AskedUnit::Unit(unit) = &number.unit else { return None };
            let values = worked.answers(number);
            let [one, other, ..] = values[..] else { return None };
            let (low, high) = (one.value.min(other.value), one.value.max(other.value));
            let middle = f64::midpoint(low, high);
            let written = (0..MOST_DECIMALS).map(|decimals| format!("{middle:.decimals$}"));
            let written = if low < 0.0 && high > 0.0 {
                "0".to_owned()
            } else {
                let lies_between =
                    |text: &String| text.parse::<f64>().is_ok_and(|number| low < number && number < high);
                written.into_iter().find(lies_between)?
            };
            let name = &self.problem.model().symbols.entry(number.symbol).name;
            Some(format!("{name} > {written} {unit}").trim_end().to_owned())
        })
    }

    /// A condition that is broken, and what its stage can do about it.
    fn broken(&self, reason: Reason, stage: Option<usize>) -> Rejection {
        let scene = &self.problem.loaded().draft.scene;
        let is_told = scene.stages.len() < 2 || reason.names_its_stage();
        let entry = stage.and_then(|stage| scene.stages.get(stage));
        let has_direction = matches!(entry, Some(Stage::Slide(_) | Stage::Push(_) | Stage::Swing(_)));
        Rejection::Condition {
            key: (has_direction && reason.is_of_direction()).then_some("direction"),
            stage: stage.filter(|_| !is_told).map(|stage| self.problem.model().phrase(scene, stage)),
            reason,
        }
    }

    /// One solution, or any number of them where every one is asked for; and nothing that is asked is without a meaning there.
    pub(super) fn is_admissible(&self, solutions: usize) -> bool {
        (self.form.accepts(solutions) || self.is_asked_alike())
            && self.rival.is_none()
            && self.has_intervals()
            && self.refused().is_none()
    }

    /// Whether fixed numbers have several solutions, and what is asked is the same in all of them: a swing that passes a place on its
    /// way up and on its way down has one speed there.
    pub(super) fn is_asked_alike(&self) -> bool {
        let alike = |symbol: Symbol| {
            let others = self.scratch.other_values(&self.form.solver, symbol);
            let is_same = |first: Bounded| {
                others.iter().all(|other| (other.value - first.value).abs() <= first.error + other.error)
            };
            self.answer(symbol).is_some_and(is_same)
        };
        let is_number = |part: &Part| matches!(part.kind, PartKind::Number(_) | PartKind::Vector(_));
        self.form.question.roots.is_none()
            && !self.is_drawn
            && self.scratch.survivors(&self.form.solver) > 1
            && self.form.parts.iter().all(is_number)
            && self.form.wanted().all(alike)
    }

    /// Why numbers that have a solution are refused nevertheless.
    fn refused(&self) -> Option<Rejection> {
        let name = |symbol: Symbol| self.problem.model().symbols.entry(symbol).name.clone();
        let zero_unit = || self.zero_unit().map(|unit| Rejection::ZeroUnit(name(unit)));
        let lost = || self.lost_direction().map(|direction| self.no_direction(direction));
        let undefined = || self.undefined().map(|asked| Rejection::Undefined(name(asked)));
        let vanishing = || self.vanishing().map(|asked| self.nothing(asked));
        let unprinted = || self.unprinted().map(|printed| Rejection::Unprinted(name(printed)));
        let misfit = || self.misfit().map(Rejection::Options);
        let turned = || self.turned_back().map(|reason| self.broken(reason.clone(), None));
        zero_unit()
            .or_else(lost)
            .or_else(undefined)
            .or_else(vanishing)
            .or_else(unprinted)
            .or_else(turned)
            .or_else(misfit)
    }

    /// Whether every range that is asked has one boundary, with a side on which it holds.
    fn has_intervals(&self) -> bool {
        self.form.trials.is_empty() || {
            let variant = self.keep(None);
            Worked { problem: self.problem, form: self.form, variant: &variant }.has_intervals()
        }
    }

    /// Why a choice cannot be offered with these numbers.
    fn misfit(&self) -> Option<String> {
        let offers = self.form.parts.iter().filter_map(|part| match &part.kind {
            PartKind::Choice(ChoicePart::Settled(_) | ChoicePart::Judged(_) | ChoicePart::Physical(_)) => None,
            PartKind::Choice(choice) => Some(choice),
            _ => None,
        });
        let mut offers = offers.peekable();
        offers.peek()?;
        let variant = self.keep(None);
        let worked = Worked { problem: self.problem, form: self.form, variant: &variant };
        offers.find_map(|offer| offer.refused(&worked))
    }

    /// A quantity in terms of which an answer is asked, and which is not certain to differ from zero.
    fn zero_unit(&self) -> Option<Symbol> {
        let is_zero = |unit: &Symbol| self.answer(*unit).is_some_and(Bounded::is_zero);
        self.units.iter().copied().find(is_zero)
    }

    /// A direction that is asked of what has none: in as many digits as there are, it may point anywhere.
    fn lost_direction(&self) -> Option<Symbol> {
        let is_lost = |symbol: &Symbol| self.answer(*symbol).is_some_and(|value| value.error > 1.0);
        self.directions.iter().copied().find(is_lost)
    }

    /// A number that is asked and has no bound in as many digits as there are: what it is divided by may be nothing.
    fn undefined(&self) -> Option<Symbol> {
        let mut asked = self.form.parts.iter().flat_map(|part| part.kind.numbers()).map(|number| number.symbol);
        asked.find(|symbol| self.answer(*symbol).is_some_and(|value| !value.error.is_finite()))
    }

    /// A mass or a duration that is asked and comes out as nothing: its equations then hold for any mass, or nothing has happened yet.
    fn vanishing(&self) -> Option<Symbol> {
        let (model, positive) = (self.problem.model(), &self.form.solver.leaf(self.scratch.leaf()).system.positive);
        let mut asked = self.form.parts.iter().flat_map(|part| part.kind.numbers()).map(|number| number.symbol);
        asked.find(|symbol| {
            let dimension = model.symbols.entry(*symbol).dimension;
            let never_is = [Dimension::MASS, Dimension::TIME].contains(&dimension) && positive.contains(symbol);
            never_is && self.answer(*symbol).is_some_and(Bounded::is_zero)
        })
    }

    fn nothing(&self, asked: Symbol) -> Rejection {
        let entry = self.problem.model().symbols.entry(asked);
        let name = entry.name.clone();
        if entry.dimension == Dimension::TIME { Rejection::NoTime(name) } else { Rejection::Vanishing(name) }
    }

    /// A quantity whose value a text prints, and which has none.
    fn unprinted(&self) -> Option<Symbol> {
        let has_value = |symbol: &Symbol| {
            let forward = || self.form.forward.as_ref().and_then(|forward| self.forward.value(forward, *symbol));
            self.answer(*symbol).or_else(forward).is_some_and(|number| number.value.is_finite())
        };
        self.printed.iter().copied().find(|symbol| !has_value(symbol))
    }

    fn no_direction(&self, direction: Symbol) -> Rejection {
        Rejection::NoDirection(self.problem.model().symbols.entry(direction).meaning.clone())
    }
}
