//! The facts of a model in the making that the reader of questions needs.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolTable;
use momentous_fault::Segment;
use momentous_laws::Law;
use momentous_quantity::Decimal;
use momentous_quantity::Quantity;
use momentous_scene::Axis;
use momentous_scene::Scene;
use momentous_solve::System;

use super::Builder;
use super::Impulse;
use super::Influence;

impl<'s> Builder<'s> {
    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// Every body's short name, those that impacts make included.
    pub fn bodies(&self) -> impl Iterator<Item = &str> {
        self.timeline.bodies()
    }

    /// Whether a term is written as zero, with a unit or without.
    #[must_use]
    pub fn is_nothing(&self, term: &Expr) -> bool {
        let value = |symbol: &Symbol| {
            self.literals.iter().find(|(literal, _)| literal == symbol).map(|(_, quantity)| &quantity.value)
        };
        term.is_zero() || matches!(term, Expr::Symbol(symbol) if value(symbol).is_some_and(Decimal::is_zero))
    }

    /// The stage that a quantity belongs to by its name, or in whose description the author named it, as a noun phrase.
    #[must_use]
    pub fn stage_phrase_of(&self, symbol: Symbol) -> Option<String> {
        let by_name = || self.timeline.stage(self.scene, self.name(symbol).stage.as_deref()?);
        let by_place = || {
            self.named.get(&symbol)?.segments().into_iter().find_map(|step| match step {
                Segment::Index(index) => Some(index),
                Segment::Key(_) | Segment::Name(_) => None,
            })
        };
        by_name().or_else(by_place).map(|stage| self.stage_phrase(stage))
    }

    /// The name of a body in a sentence.
    #[must_use]
    pub fn name_of(&self, body: &str) -> String {
        self.called(body)
    }

    /// A stage as a noun phrase: `the impact`.
    #[must_use]
    pub fn phrase_of(&self, stage: usize) -> String {
        self.stage_phrase(stage)
    }

    /// The position of the stage of that name.
    #[must_use]
    pub fn stage_of(&self, name: &str) -> Option<usize> {
        self.timeline.stage(self.scene, name)
    }

    /// Whether a symbol stands for a number with a unit that the author wrote: `2 m/s`.
    #[must_use]
    pub fn is_literal(&self, symbol: Symbol) -> bool {
        self.literals.iter().any(|(literal, _)| *literal == symbol)
    }

    /// The letters of the scene's axes, in order.
    #[must_use]
    pub fn axis_letters(&self) -> Vec<&'static str> {
        self.axes.iter().map(|(axis, _)| axis.letter()).collect()
    }

    /// The momentum along each axis of what is told of `mass_of`, with the velocity that `body` has at an instant.
    #[must_use]
    pub fn momentum_with(&mut self, mass_of: &str, body: &str, instant: usize) -> Vec<Expr> {
        let mass = self.mass_of(mass_of, instant);
        self.velocities_of(body, instant).into_iter().map(|velocity| mass.clone() * velocity).collect()
    }

    /// The velocity of a body along each axis at an instant.
    #[must_use]
    pub fn velocities_of(&mut self, body: &str, instant: usize) -> Vec<Expr> {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        axes.into_iter().map(|axis| self.velocity(body, instant, axis)).collect()
    }

    /// The mass of a body at an instant.
    #[must_use]
    pub fn mass_of(&mut self, body: &str, instant: usize) -> Expr {
        self.mass_at(body, instant)
    }

    /// The body with which another moves at an instant: itself, or what it is a part of.
    #[must_use]
    pub fn moves_with(&self, body: &str, instant: usize) -> Option<String> {
        let alive = self.timeline.alive(instant);
        let holds =
            |whole: &&&str| self.scene.members(whole).contains(&body) || self.scene.division_of(whole).contains(&body);
        let itself = alive.iter().find(|living| **living == body);
        itself.or_else(|| alive.iter().find(holds)).map(|name| (*name).to_owned())
    }

    /// The impulses of all stages so far.
    #[must_use]
    pub fn impulses(&self) -> &[Impulse] {
        &self.impulses
    }

    /// The influences of the stages that last, so far.
    #[must_use]
    pub fn influences(&self) -> &[Influence] {
        &self.influences
    }

    /// From when to when a stage lasts by its own clock, as far as that is used.
    #[must_use]
    pub fn span_of(&self, stage: usize) -> Option<[Expr; 2]> {
        let pushed = self.forces.iter().find(|force| force.stage == stage).map(|force| force.during.clone());
        let lasting = || Some([Expr::zero(), self.lasting.get(stage)?.clone()?]);
        pushed.or_else(lasting)
    }

    /// The equations so far, with the conditions under which they hold.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The stage in which an equation or a condition of that tag is used; none for one that holds at an instant.
    #[must_use]
    pub fn stage_of_law(&self, tag: usize) -> Option<usize> {
        self.instances.get(tag)?.stage
    }

    /// Values with units that the author wrote into terms.
    #[must_use]
    pub fn literals(&self) -> &[(Symbol, Quantity)] {
        &self.literals
    }

    /// The table of symbols so far.
    #[must_use]
    pub fn symbols(&self) -> &SymbolTable {
        &self.symbols
    }

    /// The laws of the scene, once for each use.
    pub fn laws(&self) -> impl Iterator<Item = &'static Law> {
        self.instances.iter().map(|instance| instance.law)
    }
}
