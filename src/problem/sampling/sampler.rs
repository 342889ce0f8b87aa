//! Drawing variants: numbers from their streams, revealed values rounded as they are printed, everything else solved.

use std::collections::BTreeMap;

use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_quantity::Decimal;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_solve::Bounded;
use momentous_solve::Precision;
use momentous_solve::Real;

use super::super::compiling::input::Input;
use super::super::compiling::inputs::inputs;
use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Scratch;
use super::super::language::domain::Domain;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::language::text::Text;
use super::no_variant::MOST_ATTEMPTS;
use super::no_variant::NoVariant;
use super::other_way::Rival;
use super::stream::Scheme;
use super::stream::Words;
use super::variant::Variant;
use super::variant::Worked;
use super::variant::factor;

/// Draws variants of one form, reusing its own memory; each thread takes its own.
pub struct Sampler<'p> {
    pub(super) problem: &'p Problem,
    pub(super) form: &'p Form,
    position: usize,
    words: Words,
    drawn: Vec<u64>,
    pub(super) inputs: Vec<Input>,
    pub(super) domains: Vec<Option<Domain>>,
    pub(super) scratch: Scratch,
    pub(super) forward: Scratch,
    pub(super) weighing: Scratch,
    /// The quantities in terms of which answers are asked.
    pub(super) units: Vec<Symbol>,
    /// The directions that are asked.
    pub(super) directions: Vec<Symbol>,
    /// The quantities that its texts print and nobody tells: they are solved.
    pub(super) printed: Vec<Symbol>,
    /// The known quantities that the form tells, with their positions.
    pub(super) told: Vec<(usize, &'p Known)>,
    /// Inputs that were changed by hand, as they were before.
    changed: Vec<(usize, Input)>,
    /// Whether any of its numbers is drawn.
    pub(super) is_drawn: bool,
    /// Another way in which the scene could go with the numbers solved last.
    pub(super) rival: Option<Rival>,
    rejected: u64,
    indistinct: BTreeMap<&'p str, u64>,
    ill_chosen: BTreeMap<&'p str, u64>,
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
        let planned = problem.forms().get(form).ok_or(NoVariant::NoForm)?;
        let count = problem.model().symbols.len();
        Ok(Self {
            problem,
            form: planned,
            position: form,
            words: problem.streams().words(),
            drawn: vec![0; planned.known.len()],
            inputs: inputs(problem, planned),
            domains: domains(planned, count),
            scratch: Scratch::new(precision),
            forward: Scratch::new(precision),
            weighing: Scratch::new(precision),
            units: planned.units().collect(),
            directions: directions(problem, planned),
            printed: printed(problem, planned),
            told: planned.known.iter().enumerate().filter(|(_, known)| planned.told.contains(&known.symbol)).collect(),
            changed: Vec::new(),
            is_drawn: planned.known.iter().any(|known| matches!(known.origin, Origin::Drawn(_))),
            rival: None,
            rejected: 0,
            indistinct: BTreeMap::new(),
            ill_chosen: BTreeMap::new(),
        })
    }

    /// The number of attempts that were rejected so far.
    #[must_use]
    pub fn rejected(&self) -> u64 {
        self.rejected
    }

    /// How many of them because rounding on the way would shift an answer too far, by the part that is asked.
    #[must_use]
    pub fn rejected_as_ill_chosen(&self) -> &BTreeMap<&'p str, u64> {
        &self.ill_chosen
    }

    /// How many of them because a mistake that the author wants to see would give right answers only, by the mistake.
    #[must_use]
    pub fn rejected_as_indistinct(&self) -> &BTreeMap<&'p str, u64> {
        &self.indistinct
    }

    /// Draws and solves a seed without keeping the variant; the certificate is within [`Self::answer`].
    ///
    /// # Errors
    /// [`NoVariant::Exhausted`] where no attempt was admissible.
    pub fn draw(&mut self, seed: u64) -> Result<(), NoVariant> {
        self.draw_by(seed, Scheme::default())
    }

    fn draw_by(&mut self, seed: u64, scheme: Scheme) -> Result<(), NoVariant> {
        // Where nothing is drawn, every attempt has the same numbers.
        let attempts = if self.is_drawn { MOST_ATTEMPTS } else { 1 };
        for attempt in 0..attempts {
            self.draw_attempt(seed, attempt);
            let count = self.solve();
            if self.is_admissible(count) && self.discriminates() && self.is_markable(scheme) {
                return Ok(());
            }
            self.rejected += 1;
        }
        Err(NoVariant::Exhausted(self.why()))
    }

    /// The way in which the scene goes with the numbers solved last.
    pub(crate) fn leaf(&self) -> usize {
        self.scratch.leaf()
    }

    /// A quantity of the variant drawn last, in SI units, with a bound on its error.
    #[must_use]
    pub fn answer(&self, symbol: Symbol) -> Option<Bounded> {
        self.answer_in(0, symbol)
    }

    /// The same in the solution at that position.
    pub(super) fn answer_in(&self, solution: usize, symbol: Symbol) -> Option<Bounded> {
        self.scratch
            .value_in(&self.form.solver, solution, symbol)
            .or_else(|| self.inputs.get(symbol.index()).and_then(Input::bounded))
    }

    /// The variant of a seed.
    ///
    /// # Errors
    /// [`NoVariant::Exhausted`] where no attempt was admissible.
    pub fn variant(&mut self, seed: u64) -> Result<Variant, NoVariant> {
        self.variant_by(seed, Scheme::default())
    }

    /// The variant of a seed as it was drawn by a version of the program.
    ///
    /// # Errors
    /// [`NoVariant::Exhausted`] where no attempt was admissible.
    pub fn variant_by(&mut self, seed: u64, scheme: Scheme) -> Result<Variant, NoVariant> {
        self.draw_by(seed, scheme)?;
        Ok(Variant { scheme, ..self.keep(Some(seed)) })
    }

    /// The variant in which these quantities have these values instead of drawn ones.
    ///
    /// # Errors
    /// [`NoVariant::Solutions`] where the values leave none, or several admissible solutions.
    pub fn with_values(&mut self, seed: u64, values: &[(Symbol, Decimal, Unit)]) -> Result<Variant, NoVariant> {
        self.draw_attempt(seed, 0);
        for (symbol, value, unit) in values {
            if let Some(input) = self.inputs.get_mut(symbol.index()) {
                self.changed.push((symbol.index(), std::mem::replace(input, Input::of(value, unit))));
            }
        }
        let count = if self.form.reveal.iter().all(|reveal| values.iter().any(|(symbol, ..)| *symbol == reveal.symbol))
        {
            self.solve_sheet()
        } else {
            self.solve()
        };
        if !self.is_admissible(count) {
            return Err(NoVariant::Solutions { count, reason: self.why() });
        }
        let mut variant = self.keep(None);
        for drawn in values {
            match variant.given.iter_mut().find(|(symbol, ..)| *symbol == drawn.0) {
                Some(given) => *given = drawn.clone(),
                None => variant.given.push(drawn.clone()),
            }
        }
        Ok(variant)
    }

    /// Whether every mistake that the author wants to see changes some answer.
    fn discriminates(&mut self) -> bool {
        let wanted = &self.problem.loaded().draft.discriminate;
        if wanted.is_empty() {
            return true;
        }
        let Some(mistake) = self.with_worked(|worked| wanted.iter().find(|mistake| !worked.tells_apart(mistake)))
        else {
            return true;
        };
        *self.indistinct.entry(mistake.as_str()).or_insert(0) += 1;
        false
    }

    /// Whether a student who rounds on the way can be told from one who is wrong. Numbers that the author fixed stay as they are.
    fn is_markable(&mut self, scheme: Scheme) -> bool {
        if scheme < Scheme::Markable || !self.is_drawn {
            return true;
        }
        let Some(part) = self.ill_chosen() else { return true };
        *self.ill_chosen.entry(part).or_insert(0) += 1;
        false
    }

    /// The part whose answer rounding on the way shifts too far, with the numbers solved last.
    pub(super) fn ill_chosen(&self) -> Option<&'p str> {
        let part = |worked: &Worked<'_>| self.form.parts.iter().find(|part| worked.is_ill_chosen(part));
        self.with_worked(part).map(|part| part.id.as_str())
    }

    fn with_worked<T>(&self, read: impl FnOnce(&Worked<'_>) -> T) -> T {
        let variant = self.keep(None);
        read(&Worked { problem: self.problem, form: self.form, variant: &variant })
    }

    fn draw_attempt(&mut self, seed: u64, attempt: u64) {
        while let Some((index, before)) = self.changed.pop() {
            if let Some(input) = self.inputs.get_mut(index) {
                *input = before;
            }
        }
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
        self.solve_sheet()
    }

    /// Solves what is asked, from what the sheet tells.
    fn solve_sheet(&mut self) -> usize {
        self.scratch.run(&self.form.solver, &self.inputs, &self.domains);
        self.rule_out_ways_back();
        let count = self.scratch.survivors(&self.form.solver);
        self.rival = if count > 0 { self.find_rival() } else { None };
        match &self.form.weighed {
            Some(weighed) if count > 0 && self.weighing.run(weighed, &self.inputs, &self.domains) == 0 => 0,
            _ => count,
        }
    }

    /// The values asked in each further solution, where there is one.
    fn others(&self) -> Vec<(Symbol, Vec<Bounded>)> {
        let rival = self.rival.iter().flat_map(|rival| &rival.values);
        if self.rival.is_none() && (self.scratch.survivors(&self.form.solver) < 2 || self.is_asked_alike()) {
            return Vec::new();
        }
        let others = |symbol| {
            let further = rival.clone().filter(|(listed, _)| *listed == symbol).map(|(_, value)| *value);
            (
                symbol,
                self.scratch.other_values(&self.form.solver, symbol).into_iter().chain(further).collect::<Vec<_>>(),
            )
        };
        self.form.wanted().map(others).filter(|(_, values)| !values.is_empty()).collect()
    }

    pub(super) fn keep(&self, seed: Option<u64>) -> Variant {
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
            scheme: Scheme::default(),
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

/// The quantities whose values the texts and hints of a form print, and which are solved.
fn printed(problem: &Problem, form: &Form) -> Vec<Symbol> {
    let hints = form.question.hints.iter().map(|(_, hint)| hint);
    let texts = [&problem.loaded().draft.text, &form.question.text].into_iter().chain(hints);
    let printed = texts.flat_map(Text::placeholders).filter(|placeholder| placeholder.filter.needs_value());
    printed
        .filter_map(|placeholder| problem.model().symbol_of(&placeholder.name))
        .filter(|symbol| !form.told.contains(symbol))
        .collect()
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
