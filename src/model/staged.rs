//! Names of quantities that belong to a stage, with the stage in brackets and without.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_expr::SymbolTable;
use momentous_quantity::Dimension;
use momentous_scene::Scene;

use super::Builder;
use super::Instant;
use super::Model;
use super::Name;
use super::check;
use super::name::component_name;
use super::wording::of_several_stages;

/// A name under `given` that the scene does not make by itself, as the scene spells it.
struct GivenName {
    name: Name,
    dimension: Dimension,
}

/// The quantities of stages that a name without a stage may mean.
pub(super) fn in_stages(symbols: &SymbolTable, names: &[Name], name: &Name) -> Vec<Symbol> {
    let spelling = name.to_string();
    let is_meant = |symbol: &Symbol| {
        let other = &names[symbol.index()];
        other.stage.is_some() && Name { stage: None, ..other.clone() }.to_string() == spelling
    };
    if name.stage.is_some() { Vec::new() } else { symbols.iter().map(|(symbol, _)| symbol).filter(is_meant).collect() }
}

impl<'s> Builder<'s> {
    /// A scene with the equations of its stages, in which each given is the quantity that its name would ask for.
    pub(super) fn with_givens(scene: &'s Scene, given: &[(String, Dimension)], unmeasured: &BTreeSet<String>) -> Self {
        let empty = Self::new(scene);
        let may_be_made = |(name, dimension): &&(String, Dimension)| {
            !check::is_structural(scene, name) && !check::is_angular_impulse(scene, name, *dimension)
        };
        let spelt =
            |(name, dimension): &(String, Dimension)| GivenName { name: empty.spelt(name), dimension: *dimension };
        let mut names: Vec<GivenName> = given.iter().filter(may_be_made).map(spelt).collect();
        let build = |names: &[GivenName]| {
            let mut builder = Self::new(scene);
            builder.unmeasured.clone_from(unmeasured);
            builder.given = given.iter().map(|(name, _)| name.clone()).collect();
            builder.given.extend(names.iter().map(|given| given.name.to_string()));
            for given in names {
                builder.symbol_of(given.name.clone(), given.dimension, "");
            }
            builder.stages();
            builder.hold_the_guided();
            builder
        };
        // The stages show which of them has a quantity; then it is given under its name there.
        let mut builder = build(&names);
        if builder.puts_in_its_stage(&mut names) {
            builder = build(&names);
        }
        let early = builder.read_early();
        if early.is_empty() {
            return builder;
        }
        names.extend(early);
        build(&names)
    }

    /// The names that stand in a term before the place that says what they are, as in `exhaust: v, flow: rho*A*v`.
    fn read_early(&self) -> Vec<GivenName> {
        let told = |name: &String| {
            let symbol = self.symbols.find(name).filter(|symbol| self.free.contains(symbol))?;
            Some(GivenName { name: self.name(symbol).clone(), dimension: self.symbols.entry(symbol).dimension })
        };
        self.early.iter().filter_map(told).collect()
    }

    /// A name of the author's own, spelt as the scene would spell it.
    fn spelt(&self, written: &str) -> Name {
        let bracketed = Name::parse(written).filter(|name| name.stage.is_some());
        let mut name = bracketed.unwrap_or_else(|| Name::written(written));
        if let Some(stage) = name.stage.as_ref().and_then(|stage| self.timeline.stage(self.scene, stage)) {
            name.stage = self.stage_label(stage);
        }
        if let Some(Instant::Named(instant)) = &name.instant
            && let Some(number) = self.timeline.instant(instant)
        {
            name.instant = Some(Instant::Number(number));
        }
        name
    }

    /// Gives the names that nothing uses the stage that alone has such a quantity; whether there are any.
    fn puts_in_its_stage(&self, given: &mut [GivenName]) -> bool {
        let mut changes = false;
        for given in given {
            let symbol = self.symbols.find(&given.name.to_string());
            if symbol.is_some_and(|symbol| self.is_used(symbol)) {
                continue;
            }
            if let [only] = in_stages(&self.symbols, &self.names, &given.name)[..] {
                given.name = self.name(only).clone();
                changes = true;
            }
        }
        changes
    }

    /// Whether a stage names a quantity, or has it in a term.
    fn is_used(&self, symbol: Symbol) -> bool {
        let ways = self.choices.iter().flatten().flat_map(|way| &way.equations);
        self.symbols.is_described(symbol)
            || self.system.equations.iter().chain(ways).any(|equation| equation.symbols().contains(&symbol))
    }

    /// The names with a stage in brackets that a name without one could mean.
    pub(super) fn names_in_stages(&mut self, name: &str) -> Vec<String> {
        let is_bare = Name::parse(name).is_some_and(|name| name.stage.is_none());
        if !is_bare || self.scene.stages.len() < 2 {
            return Vec::new();
        }
        // What is tried leaves no faults behind.
        let faults = self.faults.len();
        let letters: Vec<&str> = self.axes.iter().map(|(axis, _)| axis.letter()).collect();
        let labels: Vec<String> = (0..self.scene.stages.len()).filter_map(|stage| self.stage_label(stage)).collect();
        let known = labels.into_iter().map(|label| format!("{name}[{label}]")).filter(|name| {
            let mut parts = letters.iter().map(|letter| component_name(name, letter));
            self.resolve(name).is_some() || !name.contains('.') && parts.any(|part| self.resolve(&part).is_some())
        });
        let known = known.collect();
        self.faults.truncate(faults);
        known
    }

    /// Whether a name may stand for something of the author's own: it has no stage in brackets, and lacks none.
    #[must_use]
    pub fn may_be_chosen(&mut self, name: &str) -> bool {
        !name.contains('[') && self.names_in_stages(name).is_empty()
    }
}

impl Model {
    /// Why a given is none of the quantities that its name could mean, as advice: it lacks the stage, or no such stage has it. `None`
    /// for what the scene names and what is the author's own.
    #[must_use]
    pub fn belongs_to_no_stage(&self, symbol: Symbol) -> Option<String> {
        if self.symbols.is_described(symbol) {
            return None;
        }
        let name = self.name(symbol);
        if let Some(stage) = &name.stage {
            return Some(format!("no stage `{stage}` has such a quantity: remove it, or name the stage that has it"));
        }
        let known = in_stages(&self.symbols, &self.names, name);
        let names = known.iter().map(|symbol| self.name(*symbol).to_string());
        (known.len() > 1).then(|| of_several_stages(names))
    }
}
