//! The state of a model while it is built: symbols, equations and why each may be used.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::ops::Range;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::SymbolTable;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::Law;
use momentous_laws::Sides;
use momentous_quantity::Dimension;
use momentous_quantity::Quantity;
use momentous_quantity::dimension_name;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Senses;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Relation;
use momentous_solve::Statement;
use momentous_solve::System;

use super::ActingForce;
use super::Because;
use super::ContactWeight;
use super::Flowing;
use super::Impulse;
use super::Influence;
use super::Instance;
use super::Integral;
use super::Name;
use super::Omission;
use super::Passage;
use super::PrintedGraph;
use super::QuantityKind;
use super::Reason;
use super::Slope;
use super::alternative::Alternative;
use super::bounce_terms::BounceTerms;
use super::displacement::Displacement;
use super::frame::Frame;
use super::left_alone::LeftAlone;
use super::name::Meaning;
use super::stored::Stored;
use super::taut_string::TautString;
use super::timeline::Timeline;
use super::turned::Turned;

/// The cost of an equation in a plan.
pub(super) const LAW_COST: u32 = 10;
/// The cost of an equation that says the same as others in a way that is taught second.
pub(super) const SECOND_COST: u32 = 11;

/// A model in the making. Stages add to it, and so does every name that somebody mentions.
pub struct Builder<'s> {
    pub(super) scene: &'s Scene,
    /// The instant at which the stage begins that is being written.
    pub(super) begins: usize,
    /// Bodies on which something acts in a stage that does not name them.
    pub(super) unheld: Vec<LeftAlone>,
    pub(super) timeline: Timeline,
    pub(super) axes: Vec<(Axis, Senses)>,
    pub(super) symbols: SymbolTable,
    /// The name behind each symbol.
    pub(super) names: Vec<Name>,
    /// The whole vector behind each component.
    pub(super) vectors: BTreeMap<Symbol, Meaning>,
    pub(super) instances: Vec<Instance>,
    pub(super) reasons: Vec<Reason>,
    pub(super) reasons_of_stages: Vec<Range<usize>>,
    pub(super) system: System,
    pub(super) choices: Vec<Vec<Alternative>>,
    pub(super) distances: Vec<Equation>,
    pub(super) displacements: Vec<Displacement>,
    pub(super) omissions: Vec<Omission>,
    pub(super) impulses: Vec<Impulse>,
    pub(super) weights: Vec<ContactWeight>,
    pub(super) forces: Vec<ActingForce>,
    pub(super) influences: Vec<Influence>,
    pub(super) flowing: Vec<Flowing>,
    pub(super) slopes: Vec<Slope>,
    pub(super) bounce_terms: Vec<BounceTerms>,
    pub(super) passages: Vec<Passage>,
    pub(super) graph: Option<PrintedGraph>,
    /// How long each stage lasts, where that is used.
    pub(super) lasting: Vec<Option<Expr>>,
    pub(super) turned: Vec<Turned>,
    pub(super) stored: Vec<Stored>,
    pub(super) literals: Vec<(Symbol, Quantity)>,
    pub(super) frames: Vec<Option<Frame>>,
    /// The strings that were jerked taut.
    pub(super) strings: Vec<TautString>,
    /// The components along the axes from which a direction follows.
    pub(super) directions: BTreeMap<Symbol, [Expr; 2]>,
    pub(super) defined: BTreeSet<String>,
    pub(super) free: BTreeSet<Symbol>,
    /// Numbers of something, which are whole.
    pub(super) counts: BTreeSet<Symbol>,
    pub(super) given: BTreeSet<String>,
    pub(super) expressions: BTreeMap<Symbol, Expr>,
    /// Names that are asked and whose dimension only their place can say.
    pub(super) unmeasured: BTreeSet<String>,
    /// Names in terms that were read before the place that says what they are, or that no place says.
    pub(super) early: BTreeSet<String>,
    /// The names that the author wrote at a place of the scene, each with the first such place.
    pub(super) named: BTreeMap<Symbol, Path>,
    pub(super) mentions: BTreeMap<String, Symbol>,
    pub(super) words: Vec<(String, Path)>,
    pub(super) faults: Vec<Fault>,
}

impl<'s> Builder<'s> {
    /// Whether the motion has a direction across it, in which weight acts: a scene in space has none.
    pub(super) fn weight_acts_across(&self) -> bool {
        self.scene.plane == Plane::Horizontal && self.axes.len() < 3
    }

    /// Leaves out what acts across a motion on level ground: all of it where the motion is along a line, else the weight.
    pub(super) fn leave_out_what_acts_across(&mut self) {
        match self.axes.len() {
            _ if !self.weight_acts_across() => {}
            1 => self.not_needed(
                "weight and everything else that acts across the motion",
                "it has no component along the motion",
            ),
            _ => self.not_needed("weight", "it acts at right angles to the plane of the motion"),
        }
    }

    /// An empty model of a scene that has been checked.
    pub(super) fn new(scene: &'s Scene) -> Self {
        Self {
            scene,
            begins: 1,
            unheld: Vec::new(),
            timeline: Timeline::new(scene),
            axes: scene.axes.rectangular(),
            symbols: SymbolTable::default(),
            names: Vec::new(),
            vectors: BTreeMap::new(),
            instances: Vec::new(),
            reasons: Vec::new(),
            reasons_of_stages: Vec::new(),
            system: System::default(),
            choices: Vec::new(),
            distances: Vec::new(),
            displacements: Vec::new(),
            omissions: Vec::new(),
            impulses: Vec::new(),
            weights: Vec::new(),
            forces: Vec::new(),
            influences: Vec::new(),
            flowing: Vec::new(),
            slopes: Vec::new(),
            bounce_terms: Vec::new(),
            passages: Vec::new(),
            graph: None,
            lasting: vec![None; scene.stages.len()],
            turned: Vec::new(),
            stored: Vec::new(),
            literals: Vec::new(),
            frames: vec![None; scene.stages.len()],
            strings: Vec::new(),
            directions: BTreeMap::new(),
            defined: BTreeSet::new(),
            free: BTreeSet::new(),
            counts: BTreeSet::new(),
            given: BTreeSet::new(),
            expressions: BTreeMap::new(),
            unmeasured: BTreeSet::new(),
            early: BTreeSet::new(),
            named: BTreeMap::new(),
            mentions: BTreeMap::new(),
            words: Vec::new(),
            faults: Vec::new(),
        }
    }

    /// The symbol of that name, made if need be.
    pub(super) fn symbol(&mut self, name: Name, meaning: impl Into<String>) -> Symbol {
        let dimension = name.kind.dimension();
        self.symbol_of(name, dimension, meaning)
    }

    /// The same, where the kind of quantity does not say its dimension.
    pub(super) fn symbol_of(&mut self, quantity: Name, dimension: Dimension, meaning: impl Into<String>) -> Symbol {
        let (name, meaning) = (quantity.to_string(), meaning.into());
        let symbol = self.symbols.intern(SymbolEntry { name: name.clone(), dimension, meaning: String::new() });
        match self.names.get_mut(symbol.index()) {
            None => self.names.push(quantity),
            Some(known) if matches!(known.kind, QuantityKind::Own(_)) => *known = quantity,
            Some(_) => {}
        }
        let given = self.symbols.entry(symbol).dimension;
        if given != dimension && self.given.contains(&name) && self.defined.insert(format!("clash {name}")) {
            let [expected, found] = [dimension, given].map(dimension_name);
            let message = format!("`{name}` is {expected} in this scene, but its unit is one of {found}");
            let path = Path::root().key("given").key(name.as_str());
            let is_weight = (dimension, given) == (Dimension::MASS, Dimension::FORCE);
            let help = if is_weight {
                "a weight is no mass: choose a unit such as `kg`, `lbm` or `slug`"
            } else {
                "change the unit"
            };
            self.faults.push(Fault::new(Code::Dimension, message).help(help).at_path(path));
        }
        self.made_by_the_scene(symbol, &meaning);
        if self.symbols.entry(symbol).meaning.is_empty() {
            self.symbols.describe(symbol, meaning);
        }
        symbol
    }

    /// The same, for a quantity that is positive in every admissible solution.
    pub(super) fn positive(&mut self, name: Name, meaning: impl Into<String>) -> Symbol {
        let symbol = self.symbol(name, meaning);
        self.system.positive.insert(symbol);
        symbol
    }

    /// The same, for a vector or for the component of it that the name says.
    pub(super) fn component(&mut self, name: Name, vector: Meaning) -> Symbol {
        let which = name.component.as_ref().map_or_else(String::new, |letter| format!("the {letter}-component of "));
        let symbol = self.symbol(name, format!("{which}{vector}"));
        self.vectors.insert(symbol, vector);
        symbol
    }

    /// The way in which a body stands still all through a stage: its choice, counted from 0, and what happens there.
    #[must_use]
    pub fn stands_still(&self, body: &str, stage: usize) -> Option<(usize, &str)> {
        let is_meant = |way: &&Alternative| way.still.as_ref().is_some_and(|still| still.0 == stage && still.1 == body);
        self.choices
            .iter()
            .enumerate()
            .find_map(|(choice, ways)| Some((choice, ways.iter().find(is_meant)?.what.as_str())))
    }

    /// The name of a quantity, taken apart.
    #[must_use]
    pub fn name(&self, symbol: Symbol) -> &Name {
        &self.names[symbol.index()]
    }

    /// The vector of which a quantity is a component.
    #[must_use]
    pub fn vector_of(&self, component: Symbol) -> Option<String> {
        self.vectors.get(&component).map(Meaning::to_string)
    }

    /// Adds one use of a law.
    pub(super) fn law(&mut self, law: &'static Law, stage: Option<usize>, because: impl Into<Because>, sides: Sides) {
        self.law_at(LAW_COST, law, stage, because, sides);
    }

    /// Adds one use of a law at a cost of its own.
    pub(super) fn law_at(
        &mut self,
        cost: u32,
        law: &'static Law,
        stage: Option<usize>,
        because: impl Into<Because>,
        sides: Sides,
    ) {
        let equation = self.stated(cost, law, stage, because, sides, None);
        self.system.equations.push(equation);
    }

    /// One use of a law as an equation that is not yet part of the system.
    pub(super) fn stated(
        &mut self,
        cost: u32,
        law: &'static Law,
        stage: Option<usize>,
        because: impl Into<Because>,
        (left, right): Sides,
        integral: Option<Integral>,
    ) -> Equation {
        let tag = self.instance(law, stage, because, integral);
        Equation { statement: Statement::Equal { left, right }, tag, cost }
    }

    /// One use of a law, by its position in [`Model::instances`](super::Model::instances).
    pub(super) fn instance(
        &mut self,
        law: &'static Law,
        stage: Option<usize>,
        because: impl Into<Because>,
        integral: Option<Integral>,
    ) -> usize {
        self.instances.push(Instance { law, because: because.into(), stage, integral, shown: None, ends: Vec::new() });
        self.instances.len() - 1
    }

    /// A condition of every admissible solution, with what to say of a root that breaks it.
    pub(super) fn require(&mut self, left: Expr, relation: Relation, right: Expr, reason: Reason) {
        let condition = self.condition(left, relation, right, reason);
        self.system.conditions.push(condition);
    }

    /// A condition that is not yet part of the system.
    pub(super) fn condition(&mut self, left: Expr, relation: Relation, right: Expr, reason: Reason) -> Condition {
        let tag = self.reasons.len();
        self.reasons.push(reason);
        Condition { left, relation, right, tag }
    }

    /// The name of a body in a sentence.
    pub(super) fn called(&self, body: &str) -> String {
        self.scene.called(body)
    }

    /// A body as it does something, the verb for one body and for several: `the boat moves`.
    pub(super) fn does(&self, body: &str, verb: [&str; 2]) -> String {
        self.scene.does(body, verb)
    }

    /// The bodies of which a body consists that a stage makes or divides.
    pub(super) fn parts_of(&self, union: &str) -> Vec<String> {
        self.scene.parts_of(union).into_iter().map(str::to_owned).collect()
    }

    /// A velocity component at an instant; under the instant since which the body has it.
    pub(super) fn velocity(&mut self, body: &str, instant: usize, axis: Axis) -> Expr {
        self.has_not_fallen(body, instant);
        let since = self.timeline.naming_instant(body, instant);
        let name = Name::of(QuantityKind::Velocity, body).at(since).along(self.letter(axis));
        self.velocity_named(name, body, since).into()
    }

    /// The symbol of that name for the velocity of a body since an instant, or for a component of it.
    pub(super) fn velocity_named(&mut self, name: Name, body: &str, since: usize) -> Symbol {
        if let Some(known) = self.symbols.find(&name.to_string()).filter(|known| self.symbols.is_described(*known)) {
            return known;
        }
        let whose = format!("of {} {}", self.called(body), self.when(since));
        self.component(name, Meaning { noun: "the velocity", of: whose })
    }

    /// An axis as it stands in the names of components; none where there is only one.
    pub(super) fn letter(&self, axis: Axis) -> Option<&'static str> {
        (self.axes.len() > 1).then_some(axis.letter())
    }

    /// The same in the words that follow what has the component: ` along x`.
    pub(super) fn along(&self, axis: Axis) -> String {
        self.letter(axis).map_or_else(String::new, |letter| format!(" along {letter}"))
    }

    /// All velocity components at an instant, in the order of the axes.
    pub(super) fn velocities(&mut self, body: &str, instant: usize) -> Vec<Expr> {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        axes.into_iter().map(|axis| self.velocity(body, instant, axis)).collect()
    }

    /// The acceleration of free fall.
    pub(super) fn gravity(&mut self) -> Expr {
        self.positive(Name::of(QuantityKind::Gravity, ""), "the acceleration of free fall").into()
    }

    /// When an instant is, as an adverbial phrase: `just after the impact`.
    pub(super) fn when(&self, instant: usize) -> String {
        super::wording::when(self.scene, instant)
    }

    /// A stage as a noun phrase: `the impact`, `the second impact`.
    pub(super) fn stage_phrase(&self, stage: usize) -> String {
        super::wording::stage(self.scene, stage)
    }
}
