//! A compiled problem: its equations, what is known, and its forms, each with its plans.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::OnceLock;

use momentous_expr::Math;
use momentous_expr::Notation;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_laws::Law;
use momentous_model::Instant;
use momentous_model::Model;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_model::Warning;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::UnitSystem;

use super::super::consequences::following::Followings;
use super::super::consequences::mistake::Mistakes;
use super::super::language::allowed::Meant;
use super::super::language::form::Question;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::questions::part::AskedUnit;
use super::super::questions::part::NumberPart;
use super::super::questions::part::Part;
use super::super::questions::part::PartKind;
use super::super::questions::part::VectorPart;
use super::super::reading::load::Loaded;
use super::super::sampling::stream::Streams;
use super::form_cache::FormCache;
use super::on_demand::Formulas;
use super::on_demand::Samples;
use super::on_demand::Sensitivities;
use super::regimes::Leaf;
use super::regimes::Regimes;

/// The parts of a compiled file.
pub(super) struct Built {
    pub model: Model,
    pub known: Vec<Known>,
    pub forms: Vec<Form>,
    pub streams: Streams,
    pub units: UnitSystem,
    pub notation: Notation,
}

/// A problem that can be drawn and solved; made only by [`super::super::compile`].
#[derive(Clone, Debug)]
pub struct Problem {
    loaded: Loaded,
    model: Model,
    known: Vec<Known>,
    forms: Vec<Form>,
    streams: Streams,
    units: UnitSystem,
    notation: Notation,
    /// How the name of each quantity is set; found when it is first wanted.
    names: Vec<OnceLock<Math>>,
}

/// One way in which a problem is asked, planned.
#[derive(Clone, Debug)]
pub struct Form {
    /// The question of the file.
    pub question: Question,
    /// The givens, in the order of the file: the same quantities in every form.
    pub known: Vec<Known>,
    /// The questions.
    pub parts: Vec<Part>,
    /// The findings of `momentous check` that the author means.
    pub meant: Vec<Meant>,
    /// What the author allows of what is unphysical.
    pub(crate) allowed: Vec<Warning>,
    /// The symbols that the student is told, and the solver takes as known.
    pub told: BTreeSet<Symbol>,
    /// The quantities whose values the sheet prints, given or derived.
    pub printed: BTreeSet<Symbol>,
    /// Those of the told quantities that the words and numbers of the sheet tell: neither what is drawn and not printed, nor what
    /// may be anything.
    pub on_sheet: BTreeSet<Symbol>,
    /// Those of the told quantities whose values the sheet does not tell: they may be anything, or are known by their symbols
    /// only.
    pub free: BTreeSet<Symbol>,
    /// The givens that are expressions of what may be anything: the sheet prints the expression, `3m`, in place of a value.
    pub(crate) by_formula: BTreeSet<Symbol>,
    /// The quantities that are solved first and then given.
    pub reveal: Vec<Reveal>,
    /// Solves what is revealed.
    pub forward: Option<Regimes>,
    /// Solves what is asked.
    pub solver: Regimes,
    /// Solves the sides of a claim from a trial value of the quantity whose range is asked.
    pub(crate) trials: Vec<(Symbol, Regimes)>,
    /// Solves what weight does in short contacts, where the answers need it not.
    pub(crate) weighed: Option<Regimes>,
    /// The consequences of the common mistakes; planned when a wrong answer first asks for them.
    pub(crate) mistakes: Mistakes,
    /// The consequences of slips in one line; planned when no common mistake explains a wrong answer.
    pub(crate) slips: Mistakes,
    /// How answers move with the values on the way; worked out when a wrong answer first asks for it.
    pub(crate) sensitivities: Sensitivities,
    /// The consequences of earlier answers; planned when a wrong answer first asks for them.
    pub(crate) followings: Followings,
    /// The formulas of what is asked; composed when one is first wanted.
    pub(crate) formulas: Formulas,
    /// Values of its givens near which formulas are compared; drawn when a formula is first marked.
    pub(crate) samples: Samples,
    /// The common part of all explanations of the form; worked out when one is first wanted.
    pub cache: FormCache,
    /// The equations with which the lines of a student's work are compared; worked out when one is first judged.
    pub work: FormCache,
}

/// A value that is solved first and then given, rounded as it is printed.
#[derive(Clone, Debug)]
pub struct Reveal {
    /// Its name.
    pub name: String,
    /// Its quantity.
    pub symbol: Symbol,
    /// The unit in which it is given.
    pub unit: Unit,
    /// To how many figures.
    pub figures: usize,
}

impl Form {
    /// The quantities that are asked.
    pub fn wanted(&self) -> impl Iterator<Item = Symbol> {
        self.parts.iter().flat_map(|part| part.kind.wanted())
    }

    /// Whether so many solutions are what it asks for: one, or any number where every one is asked for.
    pub(crate) fn accepts(&self, solutions: usize) -> bool {
        solutions == 1 || solutions > 1 && self.question.roots.is_some()
    }

    /// Whether a quantity is given as one that may be anything.
    pub(crate) fn is_any(&self, symbol: Symbol) -> bool {
        self.known.iter().any(|known| known.symbol == symbol && matches!(known.origin, Origin::Any))
    }

    /// Whether a quantity has a value whichever way the scene goes: it is told, or the answers or their checks find it.
    pub(crate) fn finds(&self, symbol: Symbol) -> bool {
        let by = |leaf: &Leaf| leaf.audit.plan.steps.iter().any(|step| step.unknowns.contains(&symbol));
        !self.is_any(symbol) && (self.told.contains(&symbol) || self.solver.leaves().iter().all(by))
    }

    /// Whether a quantity is told or asked, or found on the way to an answer.
    fn speaks_of(&self, symbol: Symbol) -> bool {
        let finds = |leaf: &Leaf| leaf.answer_steps().iter().any(|step| step.unknowns.contains(&symbol));
        self.on_sheet.contains(&symbol)
            || self.wanted().any(|other| other == symbol)
            || self.solver.leaves().iter().any(finds)
    }

    /// The quantities in terms of which answers are asked.
    pub fn units(&self) -> impl Iterator<Item = Symbol> {
        let numbers = self.parts.iter().flat_map(|part| part.kind.numbers());
        numbers.filter_map(|number| match &number.unit {
            AskedUnit::InTermsOf(symbol, _) => Some(*symbol),
            AskedUnit::Unit(_) => None,
        })
    }

    /// The number of different sets of numbers that a form can draw, before any is rejected.
    #[must_use]
    pub fn combinations(&self) -> u128 {
        let counts = self.known.iter().filter_map(|known| match &known.origin {
            Origin::Drawn(domain) => Some(u128::from(domain.count())),
            _ => None,
        });
        counts.fold(1, u128::saturating_mul)
    }

    /// The givens used by the answer plans, and by what is to be decided.
    #[must_use]
    pub fn needed(&self) -> BTreeSet<Symbol> {
        let mut needed = BTreeSet::new();
        for leaf in self.solver.leaves() {
            let equations = leaf.answer_steps().iter().flat_map(|step| &step.equations);
            for equation in equations.filter_map(|position| leaf.system.equations.get(*position)) {
                needed.extend(equation.symbols().intersection(&self.told).copied());
            }
        }
        let choices = self.parts.iter().filter_map(|part| match &part.kind {
            PartKind::Choice(choice) => Some(choice.depends_on()),
            _ => None,
        });
        needed.extend(choices.flatten().filter(|symbol| self.told.contains(symbol)));
        needed
    }
}

impl Problem {
    /// The laws in a form's answer plans, each once, in the order of their use.
    #[must_use]
    pub fn laws(&self, form: &Form) -> Vec<&'static Law> {
        let mut laws: Vec<&'static Law> = Vec::new();
        for leaf in form.solver.leaves() {
            for position in leaf.answer_steps().iter().flat_map(|step| &step.equations) {
                let equation = leaf.system.equations.get(*position);
                let law =
                    equation.and_then(|equation| self.model.instances.get(equation.tag)).map(|instance| instance.law);
                laws.extend(law.filter(|law| !laws.contains(law)));
            }
        }
        laws
    }

    pub(super) fn new(loaded: Loaded, built: Built) -> Self {
        let Built { model, known, forms, streams, units, notation } = built;
        let names = vec![OnceLock::new(); model.symbols.len()];
        Self { loaded, model, known, forms, streams, units, notation, names }
    }

    /// The file as it was loaded.
    #[must_use]
    pub fn loaded(&self) -> &Loaded {
        &self.loaded
    }

    /// The problem's identity: `impact/two-carts`.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.loaded.draft.id
    }

    /// The identity from which its numbers and the seeds of students are drawn: the one before it was renamed.
    #[must_use]
    pub fn drawn_as(&self) -> &str {
        self.loaded.draft.drawn_as()
    }

    /// Its title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.loaded.draft.title
    }

    /// The scene as equations.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The letters that the course writes.
    #[must_use]
    pub fn notation(&self) -> &Notation {
        &self.notation
    }

    /// The name of a quantity as the course writes it.
    #[must_use]
    pub fn name_of(&self, symbol: Symbol) -> String {
        self.notation.name(&self.model.symbols.entry(symbol).name)
    }

    /// The unit in which a number is asked, or the quantity that stands in its place.
    #[must_use]
    pub fn unit_name(&self, number: &NumberPart) -> String {
        match &number.unit {
            AskedUnit::Unit(unit) => unit.to_string(),
            AskedUnit::InTermsOf(symbol, _) => self.name_of(*symbol),
        }
    }

    /// The name of a quantity as the course writes it, typeset.
    #[must_use]
    pub fn math_of(&self, symbol: Symbol) -> Math {
        let set = || {
            let math = self.notation.math(&self.set_apart(symbol));
            if self.is_speed_on_line(symbol) { Math::Bars(Arc::new(math)) } else { math }
        };
        self.names.get(symbol.index()).map_or_else(set, |name| name.get_or_init(set).clone())
    }

    /// The name of a vector that is asked, typeset.
    #[must_use]
    pub fn math_of_vector(&self, id: &str, vector: &VectorPart) -> Math {
        let name = match vector.components.first().and_then(|first| self.stage_shown(first.symbol)) {
            Some(stage) => self.notation.math(&format!("{}@{stage}", id.split_once('[').map_or(id, |(name, _)| name))),
            None => self.notation.math(id),
        };
        name.bold()
    }

    /// The stage of a quantity that has to be told apart from the same one of another stage: some form speaks of both.
    fn stage_shown(&self, symbol: Symbol) -> Option<&str> {
        let name_of_symbol = self.model.name(symbol);
        let stage = name_of_symbol.stage.as_deref()?;
        // These show their stages anyway; a named instant stands in the same place.
        let is_told_apart = matches!(name_of_symbol.kind, QuantityKind::Duration | QuantityKind::TerminalSpeed)
            || matches!(name_of_symbol.instant, Some(Instant::Named(_)));
        let bare = Name { stage: None, ..name_of_symbol.clone() };
        let alike = |other: &Symbol| {
            let name = self.model.name(*other);
            name.stage.is_some() && name.stage != name_of_symbol.stage && Name { stage: None, ..name.clone() } == bare
        };
        let others: Vec<Symbol> = self.model.symbols.iter().map(|(other, _)| other).filter(alike).collect();
        let both = |form: &Form| form.speaks_of(symbol) && others.iter().any(|other| form.speaks_of(*other));
        (!is_told_apart && self.forms.iter().any(both)).then_some(stage)
    }

    /// The name under which a quantity is typeset: a period has a letter of its own beside kinetic energies, and a quantity that
    /// several stages have is told apart by its stage.
    fn set_apart(&self, symbol: Symbol) -> Cow<'_, str> {
        let name = self.model.name(symbol);
        let is_energy = |(symbol, entry): (Symbol, &SymbolEntry)| {
            self.model.name(symbol).kind.is_kinetic_energy() && entry.dimension == Dimension::ENERGY
        };
        if name.kind == QuantityKind::Period && self.model.symbols.iter().any(is_energy) {
            return Name { kind: QuantityKind::Own("tau".to_owned()), ..name.clone() }.to_string().into();
        }
        if let Some(stage) = self.stage_shown(symbol) {
            return format!("{}@{stage}", Name { stage: None, ..name.clone() }).into();
        }
        self.model.symbols.entry(symbol).name.as_str().into()
    }

    /// Whether a quantity is a speed whose velocity is a single number: both would be written with the same letter.
    fn is_speed_on_line(&self, symbol: Symbol) -> bool {
        let is_line = self.loaded.draft.scene.axes.rectangular().len() == 1;
        is_line && self.model.name(symbol).kind == QuantityKind::Speed
    }

    /// The givens, in the order of the file.
    #[must_use]
    pub fn known(&self) -> &[Known] {
        &self.known
    }

    /// The forms, in the order of the file; at least one.
    #[must_use]
    pub fn forms(&self) -> &[Form] {
        &self.forms
    }

    /// The same problem with other points for the parts of a form, in their order.
    #[must_use]
    pub fn with_points(mut self, form: usize, points: &[u32]) -> Self {
        let parts = self.forms.get_mut(form).map(|form| form.parts.iter_mut()).into_iter().flatten();
        parts.zip(points).for_each(|(part, points)| part.points = *points);
        self
    }

    /// The position of the form of that name; of the first one where no name is said.
    #[must_use]
    pub fn form(&self, name: Option<&str>) -> Option<usize> {
        match name {
            None => Some(0),
            Some(name) => self.forms.iter().position(|form| form.question.name.as_deref() == Some(name)),
        }
    }

    /// The mark of the secret with which its givens are drawn, where there is one.
    #[must_use]
    pub fn secret_mark(&self) -> Option<&str> {
        self.streams.mark.as_deref()
    }

    /// The code of a variant: the same each time, another for another seed, form or state of the file.
    #[must_use]
    pub fn code(&self, form: usize, seed: u64) -> String {
        let name = self.forms().get(form).and_then(|form| form.question.name.as_deref()).unwrap_or_default();
        self.streams.code(&[self.loaded.digest.as_bytes(), name.as_bytes(), &seed.to_le_bytes()])
    }

    /// The streams from which its givens are drawn.
    #[must_use]
    pub fn streams(&self) -> &Streams {
        &self.streams
    }

    /// The unit system of its defaults.
    #[must_use]
    pub fn units(&self) -> UnitSystem {
        self.units
    }

    /// The unit in which a quantity is given, where it is.
    #[must_use]
    pub fn unit_given(&self, symbol: Symbol) -> Option<Unit> {
        let known = self.known.iter().find(|known| known.symbol == symbol).map(|known| known.unit.clone());
        let literal =
            || self.model.literals.iter().find(|(literal, _)| *literal == symbol).map(|(_, value)| value.unit.clone());
        known.or_else(literal)
    }
}
