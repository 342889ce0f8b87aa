//! A finished model: a scene as equations, with the reason for each.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::ops::Range;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolTable;
use momentous_laws::geometry;
use momentous_quantity::Quantity;
use momentous_scene::Scene;
use momentous_solve::Equation;
use momentous_solve::Statement;
use momentous_solve::System;

use super::ActingForce;
use super::Alternative;
use super::ContactWeight;
use super::Flowing;
use super::Frame;
use super::Impulse;
use super::Instance;
use super::Name;
use super::Omission;
use super::Passage;
use super::PrintedGraph;
use super::Reason;
use super::Slope;
use super::TautString;
use super::wording;

/// A scene as equations: the symbols, the system, and why each equation may be used.
#[derive(Clone, Debug)]
pub struct Model {
    /// The quantities.
    pub symbols: SymbolTable,
    pub(super) names: Vec<Name>,
    /// The equations that hold whatever happens. Their tags count [`Model::instances`].
    pub system: System,
    /// For each stage that can go several ways, the ways.
    pub choices: Vec<Vec<Alternative>>,
    /// Distances by the mean velocity: they follow from the other equations too, unless the net force is zero.
    pub distances: Vec<Equation>,
    /// Which law each equation is, and why it applies.
    pub instances: Vec<Instance>,
    /// The reasons to give where a condition is broken; conditions' tags count these.
    pub reasons: Vec<Reason>,
    /// Which of the reasons belong to each stage.
    pub(super) reasons_of_stages: Vec<Range<usize>>,
    /// The omissions made on purpose.
    pub omissions: Vec<Omission>,
    /// The impulses of each stage.
    pub impulses: Vec<Impulse>,
    /// The weights that act in short contacts of known duration.
    pub weights: Vec<ContactWeight>,
    /// The forces of each push.
    pub forces: Vec<ActingForce>,
    /// The slopes of floors.
    pub slopes: Vec<Slope>,
    /// The ways that bodies have to go through to the end.
    pub passages: Vec<Passage>,
    /// The force that the sheet tells by its graph.
    pub graph: Option<PrintedGraph>,
    /// The streams that meet bodies.
    pub flowing: Vec<Flowing>,
    /// Values that the author wrote into terms: known, and the same in every variant.
    pub literals: Vec<(Symbol, Quantity)>,
    /// The axes n and t of each stage that has them.
    pub frames: Vec<Option<Frame>>,
    /// The strings that are jerked taut.
    pub strings: Vec<TautString>,
    /// Names that terms introduced without defining them: to be given, or asked.
    pub free: BTreeSet<Symbol>,
    /// The expressions that questions call by names of their own.
    pub expressions: BTreeMap<Symbol, Expr>,
    pub(super) mentions: BTreeMap<String, Symbol>,
}

impl Model {
    /// Every quantity that an equation or a condition of the scene refers to.
    #[must_use]
    pub fn mentioned(&self) -> BTreeSet<Symbol> {
        let ways = || self.choices.iter().flatten();
        let equations = self.system.equations.iter().chain(ways().flat_map(|way| &way.equations));
        let conditions = self.system.conditions.iter().chain(ways().flat_map(|way| &way.conditions));
        let sides = conditions.flat_map(|condition| [condition.left.symbols(), condition.right.symbols()]);
        equations.map(Equation::symbols).chain(sides).flatten().collect()
    }

    /// The name of a quantity, taken apart.
    #[must_use]
    pub fn name(&self, symbol: Symbol) -> &Name {
        &self.names[symbol.index()]
    }

    /// The quantity that a mentioned name stands for, in whichever spelling it was mentioned.
    #[must_use]
    pub fn symbol_of(&self, name: &str) -> Option<Symbol> {
        self.mentions.get(name).copied().or_else(|| self.symbols.find(name))
    }

    /// The term that the problem states a quantity to be.
    #[must_use]
    pub fn stated(&self, symbol: Symbol) -> Option<&Expr> {
        self.system.equations.iter().find_map(|equation| match &equation.statement {
            Statement::Equal { left: Expr::Symbol(defined), right } if *defined == symbol => {
                let is_stated =
                    self.instances.get(equation.tag).is_some_and(|instance| instance.law.id == geometry::RELATION.id);
                is_stated.then_some(right)
            }
            _ => None,
        })
    }

    /// The stream of a stage.
    #[must_use]
    pub fn flowing_in(&self, stage: usize) -> Option<&Flowing> {
        self.flowing.iter().find(|flowing| flowing.stage == stage)
    }

    /// The stage to which the condition with that tag belongs; none where it belongs to the problem as a whole.
    #[must_use]
    pub fn stage_of_condition(&self, tag: usize) -> Option<usize> {
        self.reasons_of_stages.iter().position(|range| range.contains(&tag))
    }

    /// When an instant of the scene is, as an adverbial phrase: `just after the impact`.
    #[must_use]
    pub fn when(&self, scene: &Scene, instant: usize) -> String {
        wording::when(scene, instant)
    }

    /// A stage of the scene as a noun phrase: `the impact`.
    #[must_use]
    pub fn phrase(&self, scene: &Scene, stage: usize) -> String {
        wording::stage(scene, stage)
    }

    /// The system of every combination of ways in which the stages can go, with what happens in each.
    #[must_use]
    pub fn systems(&self) -> Vec<(Vec<String>, System)> {
        let mut all = vec![(Vec::new(), self.system.clone())];
        for ways in &self.choices {
            let extend = |(words, system): &(Vec<String>, System)| {
                let one = |way: &Alternative| {
                    let mut system = system.clone();
                    system.equations.extend(way.equations.iter().cloned());
                    system.conditions.extend(way.conditions.iter().cloned());
                    (words.iter().cloned().chain([way.what.clone()]).collect(), system)
                };
                ways.iter().map(one).collect::<Vec<_>>()
            };
            all = all.iter().flat_map(extend).collect();
        }
        all
    }
}
