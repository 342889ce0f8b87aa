//! Advice to an author where a form cannot be solved. Whatever is advised has been tried: with it, there is a plan.

use std::cell::Cell;
use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Model;
use momentous_model::QuantityKind;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_solve::Equation;
use momentous_solve::Planner;
use momentous_solve::Reason;
use momentous_solve::Stuck;
use momentous_solve::System;

use super::any;
use super::regimes::Leaf;
use super::regimes::Unplanned;

/// The most ways out that a message names: each costs a plan.
const MOST_WAYS: usize = 4;

/// The most plans that are tried for one message: where nothing closes the equations, each is a whole search.
const MOST_TRIALS: usize = 8;

/// The most quantities that are named together.
const MOST_TOGETHER: usize = 3;

/// A form that has no plan.
struct Lacking<'a> {
    model: &'a Model,
    system: &'a System,
    stuck: &'a Stuck,
    wanted: &'a [Symbol],
}

/// The remedies open to an author.
#[derive(Default)]
struct Ways {
    /// Sets of quantities that let everything be found, if one of them is told as well.
    also: Vec<Vec<Symbol>>,
    /// Quantities to be told, each in place of a given.
    instead: Vec<(Symbol, Symbol)>,
    /// A quantity that has to be told, and on whose value nothing depends that is asked: the size of an orbit of which only the
    /// shape is told.
    open: Option<Symbol>,
}

/// Why a form cannot be solved, in the author's terms.
pub(crate) fn fault(planner: &mut Planner, model: &Model, unplanned: &Unplanned) -> Fault {
    let (stuck, system, wanted) = match unplanned {
        Unplanned::Stuck { stuck, system, wanted } => (stuck, system, wanted),
        Unplanned::Unknown(message) => return Fault::new(Code::Stuck, message.clone()),
    };
    let lacking = Lacking { model, system, stuck, wanted };
    let ways = lacking.ways(planner);
    lacking.fault(&ways)
}

impl Lacking<'_> {
    fn ways(&self, planner: &mut Planner) -> Ways {
        match &self.stuck.reason {
            Reason::Underdetermined { enough, .. } => {
                let also = self.also(planner, enough);
                let is_fixed = || {
                    self.stuck.remaining.iter().all(|symbol| planner.is_fixed(self.system, &self.stuck.known, *symbol))
                };
                let alone = also.iter().filter_map(|set| if let [only] = set[..] { Some(only) } else { None });
                let alone: Vec<Symbol> = if is_fixed() { alone.collect() } else { Vec::new() };
                // Of quantities none of which matters, one may be the easiest to prove it of.
                let open = alone.into_iter().find(|symbol| self.does_not_matter(planner, *symbol));
                Ways { also, open, ..Ways::default() }
            }
            Reason::NoTactic { equations, unknowns } => match self.open_scale(planner, equations, unknowns) {
                Some(open) => Ways { open: Some(open), ..Ways::default() },
                None => Ways { instead: self.instead(planner, equations, unknowns), ..Ways::default() },
            },
            Reason::Contradiction { .. } => Ways::default(),
        }
    }

    fn plans_with(&self, planner: &mut Planner, also: &[Symbol]) -> Result<(), Stuck> {
        let known = self.stuck.known.iter().chain(also).copied().collect();
        planner.plan(self.system, &known, self.wanted).map(drop)
    }

    /// Whether nothing that is asked depends on a quantity, once it is told.
    fn does_not_matter(&self, planner: &mut Planner, symbol: Symbol) -> bool {
        let known: BTreeSet<Symbol> = self.stuck.known.iter().copied().chain([symbol]).collect();
        planner.plan(self.system, &known, self.wanted).is_ok_and(|plan| {
            let audit = planner.audit(self.system, &known, &plan);
            let leaf = Leaf { words: Vec::new(), in_common: 0, system: self.system.clone(), audit };
            self.wanted.iter().all(|wanted| any::is_independent(&leaf, *wanted, symbol))
        })
    }

    /// Sets of quantities with which there is a plan: those that are enough by counting, with what else they turn out to need.
    fn also(&self, planner: &mut Planner, enough: &[Vec<Symbol>]) -> Vec<Vec<Symbol>> {
        let can_be_said =
            |set: &&Vec<Symbol>| set.iter().all(|symbol| !self.model.symbols.entry(*symbol).name.contains(' '));
        let mut ways: Vec<Vec<Symbol>> = Vec::new();
        for set in enough.iter().filter(can_be_said) {
            if ways.len() == MOST_WAYS {
                break;
            }
            if self.plans_with(planner, set).is_ok() {
                ways.push(set.clone());
            }
        }
        if ways.is_empty() {
            ways.extend(enough.iter().filter(can_be_said).find_map(|set| self.completed(planner, set)));
        }
        ways
    }

    /// A set of quantities with what else it needs, one after the other.
    fn completed(&self, planner: &mut Planner, set: &[Symbol]) -> Option<Vec<Symbol>> {
        let mut all = set.to_vec();
        while all.len() < MOST_TOGETHER {
            let next = match self.plans_with(planner, &all).err()?.reason {
                Reason::Underdetermined { enough, .. } => enough.into_iter().next()?,
                Reason::NoTactic { unknowns, .. } => {
                    let open = unknowns.into_iter().filter(|symbol| !self.wanted.contains(symbol));
                    let mut trials = open.map(|symbol| [&all[..], &[symbol]].concat());
                    return trials.find(|trial| self.plans_with(planner, trial).is_ok());
                }
                Reason::Contradiction { .. } => return None,
            };
            all.extend(next);
            if self.plans_with(planner, &all).is_ok() {
                return Some(all);
            }
        }
        None
    }

    /// A quantity left open by equations that no tactic closes, with which the rest is found.
    fn open_scale(&self, planner: &mut Planner, equations: &[usize], unknowns: &[Symbol]) -> Option<Symbol> {
        let (system, known) = (self.system, &self.stuck.known);
        // These equations alone: others, such as that of the time along an orbit, have no derivative at its ends.
        let block = equations.iter().filter_map(|position| system.equations.get(*position)).cloned().collect();
        let block = system.with(block);
        let is_fixed = |planner: &Planner, symbol: &Symbol| planner.is_fixed(&block, known, *symbol);
        if !unknowns.iter().filter(|symbol| self.wanted.contains(symbol)).all(|symbol| is_fixed(planner, symbol)) {
            return None;
        }
        let lets_find = |symbol: &&Symbol| {
            !self.wanted.contains(symbol) && !is_fixed(planner, symbol) && self.does_not_matter(planner, **symbol)
        };
        unknowns.iter().rev().find(lets_find).copied()
    }

    /// Quantities that let the rest be found where no tactic closes some equations, each with a given whose place it has to take.
    fn instead(&self, planner: &mut Planner, equations: &[usize], unknowns: &[Symbol]) -> Vec<(Symbol, Symbol)> {
        let (model, system, stuck) = (self.model, self.system, self.stuck);
        let within =
            equations.iter().filter_map(|position| system.equations.get(*position)).flat_map(Equation::symbols);
        let can_be_left_out = |symbol: &Symbol| {
            let is_number = model.literals.iter().any(|(literal, _)| literal == symbol);
            stuck.known.contains(symbol) && !is_number && model.name(*symbol).kind != QuantityKind::Gravity
        };
        let givens: BTreeSet<Symbol> = within.filter(can_be_left_out).collect();
        let trials = Cell::new(0);
        let replaced = |symbol: &Symbol| {
            // What is told of masses mostly stays: later symbols are those of the motion.
            let mut givens = givens.iter().rev().copied().take_while(|_| trials.get() < MOST_TRIALS);
            let given = givens.find(|given| {
                trials.set(trials.get() + 1);
                let known = stuck.known.iter().copied().filter(|symbol| symbol != given).chain([*symbol]).collect();
                planner.plan(system, &known, self.wanted).is_ok()
            })?;
            Some((*symbol, given))
        };
        unknowns.iter().filter(|symbol| !self.wanted.contains(symbol)).filter_map(replaced).take(MOST_WAYS).collect()
    }

    /// A given whose name differs from that of a missing quantity in capitals only, and that one.
    fn other_case(&self, enough: &[Vec<Symbol>]) -> Option<[&str; 2]> {
        let name = |symbol: &Symbol| self.model.symbols.entry(*symbol).name.as_str();
        let alike = |missing: &Symbol| {
            let mut given = self.stuck.known.iter().map(name);
            let given = given.find(|given| given.eq_ignore_ascii_case(name(missing)) && *given != name(missing))?;
            Some([given, name(missing)])
        };
        enough.iter().flatten().find_map(alike)
    }

    fn fault(&self, ways: &Ways) -> Fault {
        let any = |symbol: &Symbol| {
            let unit = coherent_unit(self.model.symbols.entry(*symbol).dimension, UnitSystem::Si);
            format!("`{}: any {unit}`", self.model.symbols.entry(*symbol).name)
        };
        let name = |symbol: &Symbol| format!("`{}`", self.model.symbols.entry(*symbol).name);
        let names = |symbols: &[Symbol]| symbols.iter().map(name).collect::<Vec<_>>().join(", ");
        let laws = |equations: &[usize]| {
            let law = |position: &usize| {
                let equation = self.system.equations.get(*position)?;
                self.model.instances.get(equation.tag).map(|instance| instance.law.name)
            };
            equations.iter().filter_map(law).collect::<Vec<_>>().join(", ")
        };
        match &self.stuck.reason {
            Reason::Underdetermined { wanted, enough } => {
                let follow = if wanted.len() == 1 { "does not follow" } else { "do not follow" };
                let message = format!("{} {follow} from what is given", names(wanted));
                let known: Vec<Symbol> = self.stuck.known.iter().copied().collect();
                let help = if ways.also.is_empty() {
                    format!("the givens are {}; describe the scene further, or give more values", names(&known))
                } else {
                    let also: Vec<String> = ways.also.iter().map(|set| names(set)).collect();
                    let any = |open| format!("; its value does not matter: {} will do", any(&open));
                    let any = ways.open.map_or_else(String::new, any);
                    let meant = self.other_case(enough).map_or_else(String::new, |[given, missing]| {
                        format!("; did you mean `{given}` by `{missing}`? Capitals count")
                    });
                    format!("give also {}{any}{meant}", also.join(", or "))
                };
                Fault::new(Code::UnderDetermined, message).help(help)
            }
            Reason::NoTactic { equations, unknowns } => {
                let message = format!("no known method gives {} from {}", names(unknowns), laws(equations));
                let help = match (&ways.open, &ways.instead[..]) {
                    (Some(open), _) => {
                        format!("{} is open, and what is asked does not depend on it: give {}", name(open), any(open))
                    }
                    (None, []) => "describe the scene by other quantities, or ask for another".to_owned(),
                    (None, ways) => {
                        let way = |(symbol, given): &(Symbol, Symbol)| {
                            format!("{} in place of {}", name(symbol), name(given))
                        };
                        format!("give {}", ways.iter().map(way).collect::<Vec<_>>().join(", or "))
                    }
                };
                Fault::new(Code::Stuck, message).help(help)
            }
            Reason::Contradiction { equations } => {
                let message = format!("the givens contradict each other in {}", laws(equations));
                Fault::new(Code::OverDetermined, message).help("remove one of the givens that these laws connect")
            }
        }
    }
}
