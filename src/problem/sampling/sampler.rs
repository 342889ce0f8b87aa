//! Drawing variants: numbers from their streams, revealed values rounded as they are printed, everything else solved.

use crate::expr::Symbol;
use crate::model::QuantityKind;
use crate::model::Reason;
use crate::quantity::Decimal;
use crate::quantity::Printed;
use crate::quantity::Unit;
use crate::solve::Bounded;
use crate::solve::Cause;
use crate::solve::Equation;
use crate::solve::Precision;
use crate::solve::Real;

use super::super::compiling::input::Input;
use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Scratch;
use super::super::language::domain::Domain;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::questions::decision::ChoicePart;
use super::super::questions::part::PartKind;
use super::no_variant::MOST_ATTEMPTS;
use super::no_variant::NoVariant;
use super::no_variant::Rejection;
use super::stream::Words;
use super::variant::Variant;
use super::variant::Worked;
use super::variant::factor;

/// Draws variants of one form, reusing its own memory; each thread takes its own.
pub struct Sampler<'p> {
    problem: &'p Problem,
    form: &'p Form,
    position: usize,
    words: Words,
    drawn: Vec<u64>,
    inputs: Vec<Input>,
    domains: Vec<Option<Domain>>,
    scratch: Scratch,
    forward: Scratch,
    weighing: Scratch,
    /// The quantities in terms of which answers are asked.
    units: Vec<Symbol>,
    /// The directions that are asked.
    directions: Vec<Symbol>,
    /// The known quantities that the form tells, with their positions.
    told: Vec<(usize, &'p Known)>,
    rejected: u64,
}

impl<'p> Sampler<'p> {
    /// A sampler of the form at that position.
    ///
    /// # Errors
    /// [`NoVariant::NoForm`] where there is none.
    pub fn new(problem: &'p Problem, form: usize) -> Result<Self, NoVariant> {
        Self::with_precision(problem, form, Precision::OnDemand)
    }

    /// The same with replays of that precision. What is accepted and found does not depend on it, but for the bounds on
    /// errors.
    ///
    /// # Errors
    /// [`NoVariant::NoForm`] where there is none.
    pub fn with_precision(problem: &'p Problem, form: usize, precision: Precision) -> Result<Self, NoVariant> {
        let own = problem.forms().get(form).ok_or(NoVariant::NoForm)?;
        let count = problem.model().symbols.len();
        Ok(Self {
            problem,
            form: own,
            position: form,
            words: problem.streams().words(),
            drawn: vec![0; own.known.len()],
            inputs: Input::all(problem, own, count),
            domains: domains(own, count),
            scratch: Scratch::new(precision),
            forward: Scratch::new(precision),
            weighing: Scratch::new(precision),
            units: own.units().collect(),
            directions: directions(problem, own),
            told: own.known.iter().enumerate().filter(|(_, known)| own.told.contains(&known.symbol)).collect(),
            rejected: 0,
        })
    }

    /// How many attempts were rejected so far.
    #[must_use]
    pub fn rejected(&self) -> u64 {
        self.rejected
    }

    /// Draws and solves a seed without keeping the variant; the certificate is within [`Self::answer`].
    ///
    /// # Errors
    /// [`NoVariant::Exhausted`] where no attempt was admissible.
    pub fn draw(&mut self, seed: u64) -> Result<(), NoVariant> {
        for attempt in 0..MOST_ATTEMPTS {
            self.draw_attempt(seed, attempt);
            let count = self.solve();
            if self.is_admissible(count) && self.discriminates(seed) {
                return Ok(());
            }
            self.rejected += 1;
        }
        Err(NoVariant::Exhausted(self.why()))
    }

    /// A quantity of the variant drawn last, in SI units, with a bound on its error.
    #[must_use]
    pub fn answer(&self, symbol: Symbol) -> Option<Bounded> {
        self.scratch
            .value(&self.form.solver, symbol)
            .or_else(|| self.inputs.get(symbol.index()).and_then(Input::bounded))
    }

    /// The variant of a seed.
    ///
    /// # Errors
    /// [`NoVariant::Exhausted`] where no attempt was admissible.
    pub fn variant(&mut self, seed: u64) -> Result<Variant, NoVariant> {
        self.draw(seed)?;
        Ok(self.keep(Some(seed)))
    }

    /// The variant in which these quantities have these values instead of drawn ones.
    ///
    /// # Errors
    /// [`NoVariant::Solutions`] where the values leave none, or several admissible solutions.
    pub fn with_values(&mut self, seed: u64, values: &[(Symbol, Decimal, Unit)]) -> Result<Variant, NoVariant> {
        self.draw_attempt(seed, 0);
        for (symbol, value, unit) in values {
            if let Some(input) = self.inputs.get_mut(symbol.index()) {
                *input = Input::of(value, unit);
            }
        }
        let count = self.solve();
        if !self.is_admissible(count) {
            return Err(NoVariant::Solutions { count, reason: self.why() });
        }
        let mut variant = self.keep(None);
        for own in values {
            variant.given.retain(|(symbol, ..)| *symbol != own.0);
            variant.given.push(own.clone());
        }
        Ok(variant)
    }

    /// Why the numbers solved last have no admissible solution.
    fn why(&self) -> Option<Rejection> {
        let several = self.scratch.survivors(&self.form.solver);
        if several > 1 {
            return Some(Rejection::Several(several));
        }
        if let (1, Some(unit)) = (several, self.zero_unit()) {
            return Some(Rejection::ZeroUnit(self.problem.model().symbols.entry(unit).name.clone()));
        }
        if let (1, Some(direction)) = (several, self.lost_direction()) {
            return Some(self.no_direction(direction));
        }
        if let (1, Some(undefined)) = (several, self.undefined()) {
            return Some(Rejection::Undefined(self.problem.model().symbols.entry(undefined).name.clone()));
        }
        if let (1, Some(misfit)) = (several, self.misfit()) {
            return Some(Rejection::Options(misfit));
        }
        let mut dead = self.scratch.dead(&self.form.solver);
        let mut regimes = &self.form.solver;
        if let (true, Some(forward)) = (dead.is_empty(), &self.form.forward) {
            dead = self.forward.dead(forward);
            regimes = forward;
        }
        if let (1, Some(weighed)) = (several, &self.form.weighed) {
            dead = self.weighing.dead(weighed);
            regimes = weighed;
        }
        let leaf = regimes.leaf(0);
        let model = self.problem.model();
        // What was followed furthest was nearest to a solution.
        let furthest = dead.iter().rev().max_by_key(|dead| dead.step.unwrap_or(usize::MAX));
        let lost = furthest.and_then(|dead| {
            let step = leaf.audit.plan.steps.get(dead.step?).filter(|_| matches!(dead.cause, Cause::NotReal))?;
            step.unknowns.iter().copied().find(|unknown| self.directions.contains(unknown))
        });
        if let Some(direction) = lost {
            return Some(self.no_direction(direction));
        }
        let reason = furthest.map(|dead| match dead.cause {
            Cause::Condition(position) => {
                let condition = leaf.system.conditions.get(position);
                let reason = condition.and_then(|condition| model.reasons.get(condition.tag));
                Rejection::Condition(reason.map_or_else(String::new, Reason::to_string))
            }
            Cause::Equation(position) => {
                let equation = leaf.system.equations.get(position);
                let instance = equation.and_then(|equation| model.instances.get(equation.tag));
                let names = equation.map(Equation::symbols).unwrap_or_default();
                let names = names.into_iter().map(|symbol| format!("`{}`", model.symbols.entry(symbol).name));
                let law = instance.map_or("one of the equations", |own| own.law.name);
                Rejection::Contradiction { law, names: names.collect::<Vec<_>>().join(", ") }
            }
            Cause::NotReal => Rejection::NotReal,
            Cause::NotPositive => Rejection::NotPositive,
        })?;
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

    /// One solution, or any number of them where every one is asked for; and nothing is asked in terms of zero.
    fn is_admissible(&self, solutions: usize) -> bool {
        let told = self.zero_unit().is_none() && self.lost_direction().is_none() && self.undefined().is_none();
        self.form.accepts(solutions) && told && self.has_intervals() && self.misfit().is_none()
    }

    /// Whether every range that is asked has one boundary, with a side on which it holds.
    fn has_intervals(&self) -> bool {
        self.form.trials.is_empty() || {
            let variant = self.keep(None);
            Worked { problem: self.problem, form: self.form, variant: &variant }.has_intervals()
        }
    }

    /// Why the author's own options cannot be offered with these numbers.
    fn misfit(&self) -> Option<String> {
        let offers = self.form.parts.iter().filter_map(|part| match &part.kind {
            PartKind::Choice(choice @ (ChoicePart::Offered(_) | ChoicePart::Pictured(_))) => Some(choice),
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
        let is_lost = |own: &Symbol| self.answer(*own).is_some_and(|value| value.error > 1.0);
        self.directions.iter().copied().find(is_lost)
    }

    /// A number that is asked and has no bound in as many digits as there are: what it is divided by may be nothing.
    fn undefined(&self) -> Option<Symbol> {
        let mut asked = self.form.parts.iter().flat_map(|part| part.kind.numbers()).map(|number| number.symbol);
        asked.find(|symbol| self.answer(*symbol).is_some_and(|value| !value.error.is_finite()))
    }

    fn no_direction(&self, direction: Symbol) -> Rejection {
        Rejection::NoDirection(self.problem.model().symbols.entry(direction).meaning.clone())
    }

    /// Whether every mistake that the author wants to see changes some answer.
    fn discriminates(&self, seed: u64) -> bool {
        let wanted = &self.problem.loaded().draft.discriminate;
        if wanted.is_empty() {
            return true;
        }
        let variant = self.keep(Some(seed));
        let worked = Worked { problem: self.problem, form: self.form, variant: &variant };
        wanted.iter().all(|mistake| worked.tells_apart(mistake))
    }

    fn draw_attempt(&mut self, seed: u64, attempt: u64) {
        for (known, drawn) in self.form.known.iter().zip(&mut self.drawn) {
            let (Origin::Drawn(domain), Some(stream)) = (&known.origin, known.stream) else { continue };
            *drawn = domain.pick(self.words.word(stream, seed, attempt));
            if let Some(input) = self.inputs.get_mut(known.symbol.index()) {
                input.draw(domain, *drawn);
            }
        }
    }

    /// Solves what is revealed, then what is asked; gives the number of admissible solutions.
    fn solve(&mut self) -> usize {
        if let Some(forward) = &self.form.forward {
            let count = self.forward.run(forward, &self.inputs, &self.domains);
            if count != 1 {
                return count;
            }
            for reveal in &self.form.reveal {
                let value = self.forward.value(forward, reveal.symbol);
                let size = factor(reveal.unit.factor().to_f64());
                let printed = value.and_then(|value| Printed::new(value.div(&size).for_print(), reveal.figures));
                let (Some(printed), Some(input)) = (printed, self.inputs.get_mut(reveal.symbol.index())) else {
                    return 0;
                };
                *input = Input::of(&printed.to_decimal(), &reveal.unit);
            }
        }
        let count = self.scratch.run(&self.form.solver, &self.inputs, &self.domains);
        match &self.form.weighed {
            Some(weighed) if count > 0 && self.weighing.run(weighed, &self.inputs, &self.domains) == 0 => 0,
            _ => count,
        }
    }

    /// What is asked in each further solution, where there is one.
    fn others(&self) -> Vec<(Symbol, Vec<Bounded>)> {
        if self.scratch.survivors(&self.form.solver) < 2 {
            return Vec::new();
        }
        let others = |symbol| (symbol, self.scratch.other_values(&self.form.solver, symbol));
        self.form.wanted().map(others).filter(|(_, values)| !values.is_empty()).collect()
    }

    fn keep(&self, seed: Option<u64>) -> Variant {
        let literals = &self.problem.model().literals;
        let mut given = Vec::with_capacity(self.told.len() + self.form.reveal.len() + literals.len());
        for (position, known) in &self.told {
            let value = match (&known.origin, self.drawn.get(*position)) {
                (Origin::Drawn(domain), Some(drawn)) => domain.value(*drawn),
                (Origin::Fixed(value), _) => value.clone(),
                (Origin::Any | Origin::Drawn(_), _) => continue,
            };
            given.push((known.symbol, value, known.unit.clone()));
        }
        for reveal in &self.form.reveal {
            if let Some(value) = self.inputs.get(reveal.symbol.index()).and_then(Input::decimal) {
                given.push((reveal.symbol, value, reveal.unit.clone()));
            }
        }
        for (symbol, quantity) in literals {
            given.push((*symbol, quantity.value.clone(), quantity.unit.clone()));
        }
        let count = self.problem.model().symbols.len();
        let mut values = self.scratch.values(&self.form.solver, count);
        for symbol in self.form.solver.inputs() {
            let input = self.inputs.get(symbol.index()).and_then(Input::bounded);
            if let (Some(place), Some(input)) = (values.get_mut(symbol.index()), input) {
                *place = Some(input);
            }
        }
        let forward = self.form.forward.as_ref().map(|forward| self.forward.values(forward, count));
        let weighed = self.form.weighed.as_ref().map(|weighed| self.weighing.values(weighed, count));
        Variant {
            form: self.position,
            seed,
            given,
            values,
            forward: forward.unwrap_or_default(),
            weighed: weighed.unwrap_or_default(),
            others: self.others(),
            leaf: self.scratch.leaf(),
            roots: self.scratch.roots(&self.form.solver),
            dead: self.scratch.dead(&self.form.solver),
        }
    }
}

/// The directions that a form asks for.
fn directions(problem: &Problem, form: &Form) -> Vec<Symbol> {
    let is_direction = |symbol: &Symbol| {
        matches!(problem.model().name(*symbol).kind, QuantityKind::Direction(_) | QuantityKind::CountedDirection(_))
    };
    let numbers = form.parts.iter().flat_map(|part| part.kind.numbers()).map(|number| number.symbol);
    numbers.filter(is_direction).collect()
}

/// The domain of each drawn symbol.
fn domains(form: &Form, count: usize) -> Vec<Option<Domain>> {
    let mut domains = vec![None; count];
    for known in &form.known {
        if let (Origin::Drawn(domain), Some(place)) = (&known.origin, domains.get_mut(known.symbol.index())) {
            *place = Some(domain.clone());
        }
    }
    domains
}
